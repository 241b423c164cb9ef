#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "calibrate/fit/scene_fit_hooks.hpp"
#include "calibrate/inference/intervals.hpp"
#include "calibrate/problem/law.hpp"
#include "calibrate/problem/objective.hpp"
#include "calibrate/problem/parameter.hpp"
#include "calibrate/result/scene_fit_result.hpp"
#include "calibrate/search/ladder.hpp"
#include "calibrate/target/scene_target.hpp"

namespace plastica::calibrate {

/// A measured curve and the scene that it is fitted through.
struct WeightedTarget {
  Setup setup;
  SceneTarget target;
  double weight = 1.0;  ///< of its squares, beside those of other targets, > 0
};

/// What a fit through scenes may move, and how long it searches.
struct SceneFitOptions {
  /// Numbers of the field table, which all targets share. Free ones need both bounds; their start
  /// is `value`, else what the first target's scene has, else the middle of the bounds.
  ///
  /// A break strain (`material.break_strain` of a beam that bends in a plane or is stretched,
  /// `material.break_shear_strain` of a twisted one) is not searched but set, within its bounds, to
  /// the permanent strain that the fitted model has where the target broke (see misfit.hpp), half
  /// way between that at its last intact sample and at its first broken one. No
  /// other may be tied to it, nor may it have a prior. The hinge length (`rules.hinge_length`),
  /// which curves do not depend on, is fitted to the break in its place, where the break strain is
  /// known and hinges do not harden (a hardening one spreads as far as its joint).
  std::vector<Parameter> parameters;
  /// Path: each sample counts by the abscissa that it stands for, its mean 1 (objective.hpp).
  Objective objective = Objective::LeastSquares;
  /// "auto": screening, starts and Gauss and Newton's steps, as said below. Any other name of
  /// `algorithm_names()`: that algorithm alone, from the first start.
  std::string algorithm = "auto";
  int evaluations = 200;    ///< largest number of points of a search, >= 1
  double tolerance = 1e-9;  ///< a step that moves no scaled parameter by more is the last [1], > 0
  /// Points of the global stage: Sobol's, within the bounds, of which the best that lie apart are
  /// starts beside the given one, >= 0; 0: the starts are Sobol's points as they come, and each
  /// search goes to its end.
  int screen = 64;
  /// Searches, side by side: the first from the given start; the best counts, >= 1. 1: no global
  /// stage. After a screening each takes some six steps, and the two best go on to their ends.
  int starts = 10;
  /// Starts besides these; what a point does not name begins at its start.
  std::vector<StartPoint> further_starts{};
  /// Laws that are compared (scene_laws.hpp); `fit` has that of the scenes.
  std::vector<Law> laws{};
  std::uint64_t seed = 1;    ///< of the points' scrambling, and of resamples
  double confidence = 0.95;  ///< of the intervals, within (0, 1)
  /// Whether the fit is repeated with half and with twice the segments, to say what they do to it.
  bool segments_error = true;
  /// What the segments may do to a value, over the value: more gets a warning [1]; 0: anything.
  double segments_within = 0.0;
  int threads = 1;              ///< 0: as many as the machine has; changes no bit
  IntervalOptions intervals{};  ///< besides those of the covariance
  SceneFitHooks hooks{};        ///< change none either
};

/// Fits fields of one or several scenes to measured curves, by least squares of the ordinates.
///
/// Targets are weighted by their noise: sum over targets of weight/noise^2 sum w_i r_i^2, w_i 1 or
/// the sample's part of the path. If a target
/// states none, the largest ordinate stands for it at first. Then the noise is estimated from the
/// residuals, with the degrees of freedom that the fit leaves to the target, and the fit is
/// repeated, four times at most, until the noise changes by less than 5 %. A target with fewer than
/// five degrees of freedom has the pooled noise of all targets, as a fraction of the largest
/// ordinate. Targets of one kind that may differ count alike, and the errors of what three and more
/// share are those of their scatter: unlike_targets.hpp.
///
/// Errors are those of Gauss and Newton: C = A^-1 B A^-1 with A = J^T W J, B = J^T W^2 J, J the
/// residuals' slopes over the noise by central differences and W the weights, given or of the path
/// (for weights of 1: A^-1). A prior counts as a residual. A break strain has g^T C g + (a -
/// b)^2/12, with g its slope by the parameters and a, b its values at both ends of the sampling
/// interval of the break; of several broken targets the mean, weighted by these. Where the model
/// cannot follow a curve the residuals are no noise and the errors are too small; what steps and
/// fibres do to the values is not in them, nor is what segments do: see `SceneSegments`.
/// @throws InputError for a scene, target or parameter that is bad input, and if the probe of an
///         abscissa turns round on the path from the start values; FitInterrupted by the hooks
SceneFitResult fit(std::span<const WeightedTarget> targets, const SceneFitOptions& options);

/// Refuses what `fit` would refuse before its first run. @throws InputError
void check_scenes(std::span<const WeightedTarget> targets, const SceneFitOptions& options);

/// The same as `fit` for one target.
SceneFitResult fit_scene(const Setup& setup, const SceneTarget& target,
                         const SceneFitOptions& options);

}  // namespace plastica::calibrate
