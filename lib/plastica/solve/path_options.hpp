#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "plastica/model/rules.hpp"
#include "plastica/solve/newton_work.hpp"
#include "plastica/solve/path_result.hpp"

namespace plastica::solve {

/// Below this fraction of the first slope of time over the control point's displacement, and
/// downwards, a path carries no more load.
inline constexpr double kLimitSlope = 1e-3;

/// A path whose slope falls to less than this part of the step before bends.
inline constexpr double kBend = 0.1;

/// A path that comes to its limit from a slope below this nears it by and by, as fibres yield.
inline constexpr double kGradual = 20.0 * kLimitSlope;

/// A limit load is bracketed within this fraction of it.
inline constexpr double kLimitWidth = 1e-4;

/// Where nothing yields and a joint has turned further than this [rad], an arc may have come back
/// on the path that it should follow: the beam is too coarse to show a limit.
inline constexpr double kLargeRotation = 1.2;

/// A bifurcation is bracketed within this fraction of the time, and then told by the determinant.
inline constexpr double kCriticalWidth = 1e-3;
/// As many are looked for.
inline constexpr std::size_t kMaxCritical = 16;

/// A segment may turn in a step by this times what a joint may: small turns of many joints add up
/// to another equilibrium.
inline constexpr double kSegmentRotation = 5.0;

/// A step whose turns per unit of time grow by more than this is looked at closely.
inline constexpr double kGrowth = 2.5;

/// A step that turns by more than this times what its tangents give has left the path.
inline constexpr double kJump = 3.0;

/// Turns below this tell nothing of the path [rad].
inline constexpr double kNoRotation = 1e-6;

/// How a path is to be followed.
struct PathOptions {
  NewtonOptions newton{};
  std::vector<double> stops{};   ///< times at which a step must end, rising; the last is the end
  std::vector<bool> recorded{};  ///< which of them are recorded
  PathControl control = PathControl::Auto;
  int steps = 20;                 ///< recorded steps of displacement and arc-length control
  double largest_rotation = 0.2;  ///< of a joint in a step [rad]
  double smallest_step = 1e-6;    ///< of the first step [1]
  /// Whether the control point is a guess that may give way to one that moves.
  bool finds_control = false;
  /// Displacement control: where the control point is taken, from where it starts.
  std::array<double, 3> control_motion{};
};

/// Whether a load or motion changes its rate at a time.
template <class L>
bool is_corner(const chain::Chain<L>& chain, double time, double tolerance) {
  for (const History& history : chain.histories) {
    // Smooth ones have corners at their ends alone; what goes on has none at its end.
    const std::size_t corners = history.time.size() - (history.continues ? 1 : 0);
    const std::size_t step = history.slope.empty() ? 1 : corners - 1;
    for (std::size_t i = 0; i < corners; i += step) {
      if (std::fabs(history.time[i] - time) < tolerance) return true;
    }
  }
  return false;
}

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
  /// Unstable modes that the chain itself does not have: out of its plane.
  virtual int unstable_beside(const NewtonWork<L, kElastic>& /*w*/) { return 0; }
  /// Of their determinant; see `log_determinant`.
  virtual double log_determinant_beside(const NewtonWork<L, kElastic>& /*w*/) { return 0.0; }
  /// Keeps the mode of a bifurcation just beyond the equilibrium in `w`, which holds the tangent.
  virtual void note_mode(bool /*out_of_plane*/, NewtonWork<L, kElastic>& /*w*/,
                         std::vector<double>& /*mode*/) {}
  /// @return whether there is room for more
  virtual bool record(const NewtonWork<L, kElastic>& w) = 0;
};

}  // namespace plastica::solve
