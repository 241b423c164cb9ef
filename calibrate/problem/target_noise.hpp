#pragma once

#include <limits>
#include <span>
#include <vector>

namespace plastica::calibrate {

class SceneProblem;
struct WeightedTarget;

/// Fewer degrees of freedom say too little of a noise to weigh a target by it.
inline constexpr double kMinDegrees = 5.0;

/// What a fit takes the noise of one target to be.
struct TargetNoise {
  double deviation = 1.0;  ///< its residuals are divided by this [SI], > 0
  /// Of the estimate; infinite where the target states its noise.
  double degrees_of_freedom = std::numeric_limits<double>::infinity();
  double degrees_left = 0.0;  ///< that the fit leaves to the target's own residuals
  /// Whether it is the fraction of the largest ordinate that all targets have in common.
  bool pooled = false;

  /// Whether the target's own residuals say too little of it.
  bool is_from_elsewhere() const { return pooled || degrees_left < kMinDegrees; }
};

/// The noise of each target, estimated from its residuals or as the target states it.
///
/// sqrt(cost_p/d_p) with the degrees of freedom d_p. A target with fewer than five (unless it is
/// the only one) has no noise of its own to be weighed by, and could be met by chance and take all
/// the weight: its noise is the fraction of the largest ordinate that the residuals of all targets
/// have, each over its own.
/// @param costs  sums of the squared residuals of the targets, without weights and scales [SI^2]
/// @param degrees  degrees_left
/// @param before  what was taken before: who is pooled remains so
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
