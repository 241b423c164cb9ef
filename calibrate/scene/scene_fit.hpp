#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/fit/least_squares.hpp"
#include "calibrate/fit/parameter.hpp"
#include "calibrate/fit/result.hpp"
#include "calibrate/scene/scene_target.hpp"

namespace plastica::calibrate {

/// What a fit of a scene may move, and how long it searches.
struct SceneFitOptions {
  /// Numbers of the field table. Free ones need both bounds; their start is `value`, else what the
  /// scene has, else the middle of the bounds. None may be tied.
  ///
  /// A break strain (`material.break_strain` of a planar beam, `material.break_shear_strain` of a
  /// twisted one) is not searched but set, within its bounds, to the permanent strain that the
  /// fitted model has where the target broke (see misfit.hpp).
  std::vector<Parameter> parameters;
  int evaluations = 200;    ///< largest number of runs of a search, >= 1
  double tolerance = 1e-9;  ///< a step that moves no scaled parameter by more is the last [1], > 0
  /// How many searches: the first from the start, others from points drawn within the bounds; the
  /// best counts, >= 1.
  int starts = 1;
  std::uint64_t seed = 1;  ///< of the drawn starts
};

/// One free parameter of a fitted scene.
struct SceneParameter {
  std::string path;             ///< "material.yield_stress"
  double value = 0.0;           ///< [SI]
  double standard_error = 0.0;  ///< from the noise [SI]; NaN if at a bound or not determined
  bool at_bound = false;
};

struct SceneFitResult {
  FitStatus status = FitStatus::Failed;    ///< Fitted or Failed
  std::string reason;                      ///< one sentence for Failed
  std::vector<SceneParameter> parameters;  ///< the free ones, in the order of the options
  double cost = 0.0;                       ///< sum of the squared residuals [SI]
  double noise = 0.0;                      ///< standard deviation that the errors stand on [SI]
  double degrees_of_freedom = 0.0;         ///< of an estimated noise; infinite if it was given
  double misfit_share = 0.0;               ///< rms residual over the largest measured ordinate [1]
  std::vector<double> fitted;  ///< the model's ordinate at the measured abscissa [SI] (n_samples)
  LeastSquaresOutcome outcome = LeastSquaresOutcome::NoStart;  ///< of the best search
  int runs = 0;                         ///< of the scene, those of differences and errors included
  int failed_runs = 0;                  ///< of these, without a curve over the measured abscissa
  std::int64_t segment_iterations = 0;  ///< of all runs

  /// The parameter of a path, or of its last part. @throws std::out_of_range
  const SceneParameter& parameter(std::string_view name) const;
};

/// Fits fields of a scene to a measured curve, by least squares of the ordinate.
///
/// Errors are those of Gauss and Newton with the noise s: C = s^2 (J^T J)^-1, J by central
/// differences; s is the target's, else s^2 = sum r_i^2/(n_samples - n). A break strain has
/// g^T C g + (e h)^2/3, with g its slope by the parameters, e by the abscissa, and h the half
/// interval of the break. Where the model cannot follow the curve the residuals are no noise and
/// the errors are too small; what segments, steps and fibres do to the values is not in them.
/// A confidence interval takes Student's factor of `degrees_of_freedom`.
/// @throws InputError for a scene, target or parameter that is bad input, and if the probe of the
///         abscissa turns round on the path from the start values
SceneFitResult fit_scene(const Setup& setup, const SceneTarget& target,
                         const SceneFitOptions& options);

}  // namespace plastica::calibrate
