#pragma once

#include <limits>
#include <span>
#include <vector>

namespace plastica::calibrate {

class SceneProblem;
struct WeightedTarget;

/// With fewer degrees of freedom a target is not weighted by its own estimated noise.
inline constexpr double kMinDegrees = 5.0;

/// The noise of one target, as a fit uses it.
struct TargetNoise {
  double deviation = 1.0;  ///< its residuals are divided by this [SI], > 0
  /// Of the estimate; infinite where the target states its noise.
  double degrees_of_freedom = std::numeric_limits<double>::infinity();
  double degrees_left = 0.0;  ///< that the fit leaves to the target's own residuals
  /// Whether it is the pooled noise: a fraction of the largest ordinate, the same for all targets.
  bool pooled = false;

  /// Whether the target's own residuals are too few to estimate it.
  bool is_from_elsewhere() const { return pooled || degrees_left < kMinDegrees; }
};

/// The noise of each target, estimated from its residuals or as the target states it.
///
/// The estimate is sqrt(cost_p/d_p) with d_p the degrees of freedom. A fit could meet a target with
/// fewer than five by chance, which then had all the weight. Such a target has the pooled noise
/// (unless it is the only one): its largest ordinate times the root mean square of the residuals of
/// all targets, each over the largest ordinate of its target.
/// @param costs  sums of the squared residuals of the targets, without weights and scales [SI^2]
/// @param degrees  degrees_left
/// @param before  the noise of the round before: what was pooled remains so
std::vector<TargetNoise> noise_of_targets(const SceneProblem& problem,
                                          std::span<const double> costs,
                                          std::span<const double> degrees,
                                          std::span<const TargetNoise> before);

/// Degrees of freedom of all noise that is estimated; infinite if all targets state theirs.
double degrees_of_freedom(std::span<const TargetNoise> noise);

/// The largest absolute value; 0 of none.
double largest_size(std::span<const double> values);

/// A target's largest ordinate [SI], 1 if all are 0.
double size_of(const WeightedTarget& weighted);

}  // namespace plastica::calibrate
