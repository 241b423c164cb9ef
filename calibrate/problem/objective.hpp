#pragma once

#include <vector>

namespace plastica::calibrate {

/// How the misfit between model and curve is counted; r = model - measured.
enum class Objective {
  /// f = sum |dx_i| (r_i^2 + r_{i-1}^2)/2 / sum |dx_i| over the measured path, x the strain of a
  /// specimen or the abscissa of a beam: does not depend on how densely the curve is sampled.
  Path,
  /// f = sum w_i r_i^2 / sum w_i over the samples; w_i = weight_i/noise^2, where a weight or a
  /// noise that is not given is 1.
  LeastSquares,
};

/// Half of the path on both sides of each sample, (|dx_i| + |dx_{i+1}|)/2: the weights that make a
/// sum over samples that integral (n).
std::vector<double> path_weights(const std::vector<double>& x);

/// What the samples of a beam's curve count beside each other: 1, or along the path their part of
/// it over the mean, at least 1e-6: one that stands still has a residual to be told from it (n).
std::vector<double> sample_weights(const std::vector<double>& x, Objective objective);

}  // namespace plastica::calibrate
