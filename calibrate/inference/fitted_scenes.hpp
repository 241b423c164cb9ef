#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "calibrate/inference/scene_errors.hpp"
#include "calibrate/inference/scene_work.hpp"
#include "calibrate/problem/scene_problem.hpp"

namespace plastica::calibrate {

/// A fit through scenes, as what looks for its intervals begins from it.
class FittedScenes {
 public:
  /// @param problem  with the scales of the fit
  /// @param best  the solution, with its residuals over these scales
  /// All must outlive this.
  FittedScenes(SceneProblem& problem, const SceneFitOptions& options, const LeastSquares& best,
               SceneErrors& errors);

  const SceneProblem& problem() const { return problem_; }
  const SceneFitOptions& options() const { return options_; }
  const LeastSquares& best() const { return best_; }
  const SceneErrors& errors() const { return errors_; }

  struct FreeParameter {
    const Parameter* parameter = nullptr;
    bool is_break = false;
    std::size_t coordinate = 0;       ///< of one that is searched
    BreakLimit limit;                 ///< of a break
    Eigen::VectorXd gradient;         ///< of the coordinate or limit, by the coordinates (n)
    double degrees_of_freedom = 0.0;  ///< of the noise in it
  };
  /// The free ones, in the order of the options.
  const std::vector<FreeParameter>& free() const { return free_; }

  /// The problem once more, for one who works beside others: it runs its scenes on one thread, and
  /// counts them itself.
  std::unique_ptr<SceneProblem> copy() const;

 private:
  SceneProblem& problem_;
  const SceneFitOptions& options_;
  SceneFitOptions alone_;
  const LeastSquares& best_;
  SceneErrors& errors_;
  std::vector<FreeParameter> free_;
};

/// Permanent strain at the break of a target's curve: `place` 0 is where the target was intact for
/// sure, 1/2 the middle, 1 where it was broken for sure.
double strain_at_break(const SceneCurve& curve, double place);

/// Likelihood intervals of the free parameters, in their order. Points of a break's are those of
/// its value where the targets broke in the middle of their sampling intervals; its ends have the
/// sampling's fraction in them (theory::half_interval).
std::vector<LikelihoodProfile> profile_scenes(const FittedScenes& fitted, SceneWork& work);

/// Intervals from searches of resampled residuals, from the fitted parameters on.
///
/// Each target's own residuals are drawn, so that each keeps its noise, of which one that has too
/// few (TargetNoise::pooled) is drawn as normal; a prior's mean is drawn from the normal
/// distribution about the fitted value that it stands for; a break is anywhere between its samples.
/// Scales and the fractions of several breaks stay as they were fitted.
BootstrapResult bootstrap_residuals(const FittedScenes& fitted, SceneWork& work);

/// The same of resampled targets: a target counts as often as it is drawn. Of each kind of test
/// (are_of_one_kind) as many are drawn as there are, so that no resample is without one.
BootstrapResult bootstrap_specimens(const FittedScenes& fitted, SceneWork& work);

/// All that the options ask for; `warnings` gets what a reader must not overlook.
FitIntervals find_intervals(const FittedScenes& fitted, SceneWork& work,
                            std::vector<std::string>& warnings);

}  // namespace plastica::calibrate
