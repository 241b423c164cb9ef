#include "calibrate/fit/scene_fit_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "calibrate/inference/moved_by_segments.hpp"
#include "calibrate/inference/shared_offset.hpp"
#include "calibrate/problem/target_noise.hpp"
#include "plastica/base/listed.hpp"

namespace plastica::calibrate {

std::string warning_of_end(LeastSquaresOutcome outcome, int evaluations) {
  if (outcome != LeastSquaresOutcome::EvaluationsReached) return {};
  return fmt::format(
      "the search ended at its {} evaluations (fit.evaluations): better values may be near",
      evaluations);
}

std::string warning_of_noise(const SceneTarget& target, StatedNoise is, double left) {
  if (is == StatedNoise::Fits) return {};
  return fmt::format("{}: a noise of {:.3g} is stated, but the residuals are of {:.3g} (SI)",
                     target.name, *target.noise, left);
}

std::string warning_of_sign(const SceneTarget& target, const std::vector<double>& fitted) {
  constexpr double kAgainst = -0.9;
  double both = 0.0, measured = 0.0, made = 0.0;
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    both += fitted[i] * target.ordinate[i];
    measured += target.ordinate[i] * target.ordinate[i];
    made += fitted[i] * fitted[i];
  }
  if (!(both < kAgainst * std::sqrt(measured * made))) return {};
  return fmt::format(
      "{}: the scene's curve runs against the measured one; if the machine counts the other way, "
      "ordinate.factor = {:g} turns it",
      target.name, -target.ordinate_factor);
}

std::string warning_of_offset(const SceneProblem& problem, std::size_t t,
                              std::span<const double> slopes, std::span<const double> residual) {
  const SceneTarget& target = problem.targets()[t].target;
  const std::size_t n = problem.parameters().size(), first = problem.first_residual(t);
  const std::size_t samples = target.ordinate.size();
  const double unit = problem.scale(t);
  const SharedOffset offset = shared_offset(slopes.subspan(first * n, n == 0 ? 0 : samples * n),
                                            residual.subspan(first, samples), problem.weights(t));
  constexpr double kMatters = 1e-3;  // of the largest ordinate
  const bool matters = unit * std::abs(offset.value) > kMatters * largest_size(target.ordinate);
  if (!offset.stands_out() || !matters) return {};
  return fmt::format(
      "{}: taking {:.3g} (SI) off each measured ordinate would lower its squared residuals by "
      "{:.0f} %: was it set to zero before the test? Parameters make up for what was not",
      target.name, unit * offset.value, 100.0 * offset.of_squares);
}

std::string warning_of_path(const SceneTarget& target, const SceneCurve& fitted) {
  if (!fitted.is_extended) return {};
  return fmt::format(
      "{}: with the fitted values the scene's path ends before the measured one; it "
      "was compared where the ramps go on beyond the scene's end",
      target.name);
}

std::string warning_of_segments(const SceneFitResult& result, double within) {
  const SegmentsTrial trial = moved_by_segments(result);
  if (!(within > 0.0) || trial.moved <= within) return {};
  const std::string asked = fmt::format("fit.within asks for {:.3g} %", 100.0 * within);
  return std::isfinite(trial.moved)
             ? fmt::format("{} is moved by the segments by up to {:.2g} % of it: {}",
                           last_part(trial.parameter), 100.0 * trial.moved, asked)
             : fmt::format("what the segments do is not known: {}; {}", trial.reason, asked);
}

void warn_of_scenes(const SceneProblem& problem, std::span<const WeightedTarget> targets,
                    std::span<const double> point, std::vector<std::string>& warnings) {
  constexpr std::size_t kShownTargets = 3;
  std::vector<std::pair<std::string, std::vector<std::string>>> said;  // with the targets' names
  for (std::size_t t = 0; t < targets.size(); ++t) {
    for (std::string& warning : problem.warnings_of(t, point)) {
      auto known =
          std::ranges::find_if(said, [&](const auto& one) { return one.first == warning; });
      if (known == said.end()) {
        said.emplace_back(std::move(warning), std::vector<std::string>{});
        known = std::prev(said.end());
      }
      known->second.push_back(targets[t].target.name);
    }
  }
  for (const auto& [warning, names] : said) {
    const bool of_all = names.size() == targets.size();
    warnings.push_back(
        (of_all ? "the scene: " : "the scene of " + listed(names, kShownTargets) + ": ") + warning);
  }
}

}  // namespace plastica::calibrate
