#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/inference/segments_error.hpp"
#include "calibrate/problem/objective.hpp"
#include "calibrate/result/fit_outcome.hpp"
#include "calibrate/search/least_squares.hpp"
#include "plastica/base/status.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::calibrate {

/// What a fit made of one target.
struct TargetFit {
  std::string name;
  Law law = Law::Ideal;  ///< its scene hardens by; one for all where laws are compared
  Level level = Level::Auto;
  std::size_t samples = 0;
  double cost = 0.0;  ///< sum of the squared residuals [SI^2]
  /// Standard deviation of the ordinate [SI]: errors are based on it and targets weighted by it. As
  /// the target states it, else estimated from residuals (target_noise.hpp).
  double noise = 0.0;
  double degrees_of_freedom = 0.0;  ///< of this; infinite where the target states it
  double misfit_fraction = 0.0;     ///< rms residual over the largest measured ordinate [1]
  /// Wald and Wolfowitz: probability of as few runs of residuals of one sign, if they were
  /// independent, or of so few of one sign [1]; NaN for fewer than 20. Small where the model
  /// cannot follow.
  double runs_test_p = 0.0;
  std::vector<double> fitted;  ///< the model's ordinate at the measured abscissa [SI] (n_samples)
  /// Standard error of each of these from the covariance, sqrt(diag(J C J^T)) [SI] (n_samples).
  std::vector<double> fitted_error;
  /// Permanent strain of the fitted model where the target broke [1]; NaN if it did not.
  double break_strain = 0.0;
};

/// One search of several. Ranked by their costs, they are the waterfall of the starts.
struct SceneStart {
  std::vector<double> from;  ///< values of the searched parameters [SI] (n)
  std::vector<double> to;    ///< where it ended [SI] (n); empty without a start
  /// There: sum of the squares over the noise, or over each target's largest ordinate while the
  /// noise was not known [1]; infinite without a start.
  double cost = 0.0;
  LeastSquaresOutcome outcome = LeastSquaresOutcome::NoStart;
  int evaluations = 0;
};

/// The result of a fit through scenes: Fitted or Failed. Its parameters are the free ones in the
/// order of the options, and then those that are fixed or tied.
struct SceneFitResult : FitOutcome {
  std::vector<TargetFit> targets;
  Objective objective = Objective::LeastSquares;  ///< by which the samples counted
  /// Sum of the squares of what parameters are off the means of their priors, over the standard
  /// deviations of these [1]; 0 without any.
  double prior_squared = 0.0;
  double degrees_of_freedom = 0.0;  ///< of an estimated noise; infinite if all targets have theirs
  std::vector<SceneStart> starts;   ///< in their order
  LeastSquaresOutcome outcome = LeastSquaresOutcome::NoStart;  ///< of the best search
  int runs = 0;                         ///< of scenes, those of differences and errors included
  int search_runs = 0;                  ///< of these, what the search took
  int failed_runs = 0;                  ///< of all, without a curve over the measured abscissa
  std::int64_t segment_iterations = 0;  ///< of all runs
  /// Where the options ask for it and a target was measured on a beam, no coupon.
  std::optional<SceneSegments> segments;

  int evaluations() const;  ///< of all searches
  /// Those that `correlation` is of.
  std::vector<const FittedParameter*> correlated_parameters() const { return free_parameters(); }
};

}  // namespace plastica::calibrate
