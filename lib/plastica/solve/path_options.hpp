#pragma once

#include <array>
#include <vector>

#include "plastica/model/rules.hpp"
#include "plastica/solve/newton_work.hpp"
#include "plastica/solve/path_result.hpp"

namespace plastica::solve {

/// How a path is to be followed.
struct PathOptions {
  NewtonOptions newton{};
  std::vector<double> stops{};   ///< times at which a step must end, rising; the last is the end
  std::vector<bool> recorded{};  ///< which of them are recorded
  PathControl control = PathControl::Auto;
  int steps = 20;               ///< recorded steps of displacement and arc-length control
  double largest_turn = 0.2;    ///< of a joint in a step [rad]
  double smallest_step = 1e-6;  ///< of the first step [1]
  /// Whether the control point is a guess that may give way to one that moves.
  bool finds_control = false;
  /// Displacement control: where the control point is taken, from where it starts.
  std::array<double, 3> control_motion{};
};

/// What an observer says of a converged step.
enum class Verdict {
  Accept,
  TooFar,  ///< try it again shorter, if that can be done
  End,     ///< the path ends here (a break)
};

/// Looks at the steps of a path.
template <class L, bool kElastic>
class PathObserver {
 public:
  virtual ~PathObserver() = default;
  /// Whether the last converged step does plastic work.
  virtual bool yields() const = 0;
  /// @param shortest  whether the step cannot be cut back any more
  virtual Verdict judge(const NewtonWork<L, kElastic>& w, bool shortest) = 0;
  /// After a step was accepted and its state committed.
  /// @return whether to go on; if not, the path is interrupted
  virtual bool accept(const NewtonWork<L, kElastic>& w) = 0;
  /// @return whether there is room for more
  virtual bool record(const NewtonWork<L, kElastic>& w) = 0;
};

}  // namespace plastica::solve
