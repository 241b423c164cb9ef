#pragma once

#include <optional>
#include <span>
#include <vector>

#include "calibrate/inference/scene_work.hpp"
#include "calibrate/inference/segments_error.hpp"
#include "calibrate/problem/scene_problem.hpp"

namespace plastica::calibrate {

/// A fit that is done, to be repeated with other segments.
struct FitToRemesh {
  const SceneProblem& problem;  ///< with the scales that the noise left
  const SceneFitOptions& options;
  std::span<const double> x;                    ///< its solution (n)
  std::span<const FittedParameter> parameters;  ///< what it reports (n_free)
  /// Of a break limit what each target counts in its mean; empty of what is searched (n_free,
  /// n_targets).
  std::span<const std::vector<double>> fractions;
};

/// Repeats a fit with half and with twice the segments of all its chains, from its solution, with
/// its weights and scales. A repetition that cannot be made is left out and said so.
/// @return empty if all targets are coupons, which have no segments
std::optional<SceneSegments> fit_remeshed(const FitToRemesh& fit, SceneWork& work);

}  // namespace plastica::calibrate
