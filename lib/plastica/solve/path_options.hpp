#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "plastica/model/rules.hpp"
#include "plastica/solve/newton_work.hpp"
#include "plastica/solve/path_result.hpp"

namespace plastica::solve {

/// Below this fraction of the first slope of time over the control point's displacement, and
/// downwards, a path carries no more load.
inline constexpr double kLimitSlope = 1e-3;

/// Below this it carries little more: large turns bring slender beams more load beyond the limit
/// load of small ones.
inline constexpr double kPlateauSlope = 1.0 / 30.0;

/// A path whose slope falls to less than this part of the step before bends.
inline constexpr double kBend = 0.1;

/// A path that comes to its limit from a slope below this nears it by and by, as fibres yield.
inline constexpr double kGradual = 20.0 * kLimitSlope;

/// A step that would move the control point elastically by less than this part of what all loads
/// would move it by tells nothing of a slope: it may be rounding that moves it.
inline constexpr double kLeastPath = 1e-10;

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

/// Times nearer to each other than this fraction of the path's are the same.
inline constexpr double kSameTime = 1e-9;

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

/// How loads and motions go on at a time. A path at rest depends on where they go, and not on how
/// fast: where all that moves is faster or slower by one factor, it has no corner.
struct SpeedChange {
  /// That all speeds change by; below 0: all turn back; none: they change unlike each other.
  std::optional<double> factor;
  bool is_corner() const { return !factor || *factor < 0.0; }
};

template <class L>
SpeedChange speed_change(const chain::Chain<L>& chain, double time, double tolerance) {
  constexpr double kSame = 1e-6;  // of factors of points that are read in digits
  std::optional<double> common;
  for (const History& history : chain.histories) {
    const History::SlopeChange slope = history.slopes_about(time, tolerance);
    if (slope.ends) return {};
    const double product = slope.before * slope.after;
    if (slope.before == 0.0 && slope.after == 0.0) continue;
    if (!(product < 0.0 || product > 0.0)) return {};
    const double factor = slope.after / slope.before;
    if (common && !(std::fabs(factor - *common) <= kSame * std::fabs(factor))) return {};
    common = factor;
  }
  return {common.value_or(1.0)};
}

/// Whether something acts with its largest factor so far at a time, and with less from there on.
/// @param while_  over which that shows [s]
template <class L>
bool is_peak(const chain::Chain<L>& chain, double time, double while_) {
  return std::any_of(chain.histories.begin(), chain.histories.end(), [&](const History& history) {
    const double now = std::fabs(history.at(time));
    return std::fabs(history.at(time + while_)) < now &&
           (time < while_ || std::fabs(history.at(time - while_)) <= now);
  });
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
