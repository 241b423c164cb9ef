#include "calibrate/inference/fitted_scenes.hpp"

#include <algorithm>
#include <cmath>

namespace plastica::calibrate {

FittedScenes::FittedScenes(SceneProblem& problem, const SceneFitOptions& options,
                           const LeastSquares& best, SceneErrors& errors)
    : problem_(problem), options_(options), alone_(options), best_(best), errors_(errors) {
  alone_.threads = 1;
  std::size_t coordinate = 0;
  for (const Parameter& p : options.parameters) {
    if (p.role != ParameterRole::Free) continue;
    FreeParameter free;
    free.parameter = &p;
    free.is_break = calibrate::is_break(p);
    if (free.is_break) {
      free.limit = errors.break_limit(p);
      free.gradient = free.limit.slope;
    } else {
      free.coordinate = coordinate++;
      free.gradient = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(best.x.size()));
      free.gradient[static_cast<Eigen::Index>(free.coordinate)] = 1.0;
    }
    free.degrees_of_freedom = errors.degrees_of_freedom(free.gradient);
    free_.push_back(std::move(free));
  }
}

std::unique_ptr<SceneProblem> FittedScenes::copy() const {
  auto problem = std::make_unique<SceneProblem>(problem_.targets(), alone_);
  problem->set_noise(problem_.noise());
  return problem;
}

double strain_at_break(const SceneCurve& curve, double place) {
  const StrainAtBreak& strain = curve.strain;
  // Beyond the end of the path it goes on as before the middle.
  if (std::isnan(strain.after)) {
    return strain.at + (2.0 * place - 1.0) * (strain.at - strain.before);
  }
  return strain.before + place * (strain.after - strain.before);
}

FitIntervals find_intervals(const FittedScenes& fitted, SceneWork& work,
                            std::vector<std::string>& warnings) {
  const IntervalOptions& how = fitted.options().intervals;
  FitIntervals intervals;
  if (how.profile) intervals.profiles = profile_scenes(fitted, work);
  if (how.bootstrap > 0) intervals.residuals = bootstrap_residuals(fitted, work);
  if (how.specimens > 0) intervals.specimens = bootstrap_specimens(fitted, work);
  std::vector<std::string> names;
  for (const auto& free : fitted.free()) names.emplace_back(free.parameter->field->path);
  add_warnings(intervals, names, "search again from more starts (fit.starts)", warnings);
  return intervals;
}

}  // namespace plastica::calibrate
