#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace plastica::calibrate {

/// How a fitted value goes with the number of segments.
enum class SegmentsTrend {
  Unknown,     ///< there is no other fit to compare with
  Settled,     ///< the values agree to a millionth
  Monotone,    ///< they approach one from one side, at an order that was observed
  Assumed,     ///< two values, taken to approach one at the order of the joints
  Oscillates,  ///< they approach one from both sides: no order is trusted
  Diverges,    ///< their differences do not fall as any order from 0.5 on has it
};

/// "monotone", "oscillates", …
std::string_view name_of(SegmentsTrend trend);

/// What the number of segments does to one fitted parameter, from fits of the same curves with
/// half, once and twice the segments (N/2, N, 2N) of every beam.
///
/// A coarse chain answers otherwise than the continuous beam, and the fitted number makes up for
/// it: f(N) = f_0 + C N^-p. With the observed order p, but no more than the joints have (2; 1 where
/// an end is rigidly clamped), f_0 = f(2N) + (f(2N) - f(N))/(2^p - 1). The errors are grid
/// convergence indices, F_s times the distance to f_0, with F_s = 1.25, or 3 if p was assumed or is
/// beyond the joints' by more than 1; of three values no less than 1.25 times the distance to the
/// limit of a N^-1 + b N^-2 (`theory::limit_of_two_orders`), since errors of both
/// orders may cancel between two numbers of segments, and no power says so. Where no order is
/// observed they are 3 times the spread of the values, and no less than a millionth of them: fits
/// know their values no better. Source: Roache, J. Fluids Eng. 116 (1994) 405.
struct SegmentsError {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  double at_half = kNone;   ///< with N/2 [SI]; NaN if there is no such fit or it is at a bound
  double at_own = kNone;    ///< with N: the parameter's value [SI]
  double at_twice = kNone;  ///< with 2N [SI]
  SegmentsTrend trend = SegmentsTrend::Unknown;
  double observed_order = kNone;  ///< of three values [1]; NaN where none is observed
  double order = kNone;           ///< p of f_0 [1]; NaN without one
  double safety_factor = kNone;   ///< F_s [1]
  /// f_0, what the continuous beam would give; without an order the value of most segments [SI].
  double extrapolated = kNone;
  double extrapolated_error = kNone;  ///< half its interval, F_s |f_0 - f(2N)| [SI]
  /// Half the interval about the value with N segments that holds f_0, F_s |f_0 - f(N)| [SI].
  double error = kNone;
};

/// The errors of fits with other segments.
struct SceneSegments {
  int segments = 0;  ///< N of the first beam
  /// Why there is no fit with N/2 or 2N, one sentence each; empty: there are both.
  std::string note;
  std::vector<SegmentsError> parameters;  ///< as `SceneFitResult::parameters`
};

/// Judges values by their trend.
/// @param at_half, at_own, at_twice  [SI]; NaN where there is none
/// @param joints_order  order of the joints [1], > 0
SegmentsError segments_error(double at_half, double at_own, double at_twice, double joints_order);

}  // namespace plastica::calibrate
