#pragma once

#include <cstddef>
#include <vector>

#include "sweeps/advise/next_setting.hpp"
#include "sweeps/advise/outcome.hpp"

/// What runs have shown of the error along each axis; not installed.
namespace plastica::sweeps {

/// Changes along the axes of numbers, from which errors of other settings are foretold.
class AxisModels {
 public:
  explicit AxisModels(std::size_t axes) : seen_(axes), known_(axes) {}

  /// The error along an axis, of a change that was measured; notes it for later.
  /// @param size, finer_size  of the setting and of the run that is finer along the axis
  /// @param off  of the result, from the finer run's
  AxisError measured(std::size_t axis, double size, double finer_size, const Deviation& off);
  /// The error along an axis of two changes one after the other, where errors of order 1 and 2 may
  /// cancel: of each quantity the larger of what the order of both changes says, if that is one,
  /// and of `theory::limit_of_two_orders`. Noted in the place of what was seen at that size.
  /// @param size, finer_size, finest_size  of the three runs
  /// @param off, finer_off  of the first from the second, and of that from the third
  AxisError measured_twice(std::size_t axis, double size, double finer_size, double finest_size,
                           const Deviation& off, const Deviation& finer_off);
  /// The error that the last change of an axis foretells, at another size: with the order that was
  /// seen, else with 1 where it is finer and 2 where it is coarser, so that it is not too small.
  AxisError foretold(std::size_t axis, double size) const;
  /// Whether `foretold` can say something: a change of runs in which less moved than in others does
  /// not, since what stays at rest in coarse ones may move in finer ones.
  bool knows(std::size_t axis) const {
    return known_[axis] && seen_[axis].back().quantities >= most_quantities_;
  }
  /// A size over that of the last change.
  double ratio_to_last(std::size_t axis, double size) const {
    return size / seen_[axis].back().size;
  }
  /// After a change of words: what was seen tells orders, and errors only once they are measured
  /// anew.
  void doubt() {
    known_.assign(known_.size(), false);
    most_quantities_ = 0;
  }
  /// Forgets an axis: another method has another order.
  void forget(std::size_t axis) {
    seen_[axis].clear();
    known_[axis] = false;
  }

 private:
  struct Seen {
    double size = 0.0;
    AxisError error{};
    int quantities = 0;  ///< that were compared
    std::vector<SignedDeviation> parts{};
  };

  std::vector<std::vector<Seen>> seen_;  ///< by axis, in the order of the settings
  std::vector<bool> known_;
  int most_quantities_ = 0;  ///< that any change was of, since the last doubt
};

}  // namespace plastica::sweeps
