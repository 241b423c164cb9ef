#include "calibrate/inference/scene_segments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "calibrate/inference/not_a_number.hpp"
#include "calibrate/inference/scene_errors.hpp"
#include "calibrate/trial/remesh.hpp"
#include "plastica/base/check.hpp"

namespace plastica::calibrate {
namespace {

std::string_view word_of(Division division) {
  return division == Division::Half ? "half" : "twice";
}

/// A repetition with another number of segments: a row of the parameters' values [SI], NaN at a
/// bound (n_free), or none and one sentence why.
using Repetition = TaskRecord;

std::vector<WeightedTarget> divided_targets(std::span<const WeightedTarget> targets,
                                            Division division) {
  std::vector<WeightedTarget> made(targets.begin(), targets.end());
  for (WeightedTarget& weighted : made) {
    if (weighted.setup.scene.is_coupon()) continue;
    try {
      weighted.setup = remeshed(weighted, division);
    } catch (const InputError& error) {
      if (targets.size() == 1) throw;
      throw InputError({}, weighted.target.name + ": " + error.field(), error.value(),
                       error.rule());
    }
  }
  return made;
}

/// The solution of a repetition, from that of the fit.
LeastSquares solved(SceneProblem& problem, const FitToRemesh& fit) {
  problem.set_noise(fit.problem.noise());
  LeastSquaresProblem squares = problem.squares();
  squares.start.assign(fit.x.begin(), fit.x.end());
  LeastSquaresOptions how;
  how.max_evaluations = fit.options.evaluations;
  how.x_tolerance = fit.options.tolerance;
  return minimize_squares(squares, how);
}

double searched_value(const SceneProblem& problem, std::size_t k, double x) {
  const LeastSquaresProblem& squares = problem.squares();
  const double reach = 1e-9 * (squares.upper[k] - squares.lower[k]);
  const bool at_bound = x <= squares.lower[k] + reach || x >= squares.upper[k] - reach;
  return at_bound ? kNan : problem.parameters().value(k, x);
}

double break_value(const std::vector<std::vector<SceneCurve>>& curves,
                   const std::vector<double>& fractions, const FittedParameter& parameter) {
  double value = 0.0;
  for (std::size_t t = 0; t < fractions.size(); ++t) {
    if (fractions[t] == 0.0) continue;
    const StrainAtBreak& strain = curves[t][0].strain;
    value += fractions[t] * limit_within(strain, std::isnan(strain.after));
  }
  return value > parameter.lower && value < parameter.upper ? value : kNan;
}

Repetition repeated(const FitToRemesh& fit, Division division) {
  const std::vector<WeightedTarget> targets = divided_targets(fit.problem.targets(), division);
  SceneProblem problem(targets, fit.options);
  const LeastSquares found = solved(problem, fit);
  Repetition made;
  if (found.outcome == LeastSquaresOutcome::NoStart) {
    made.text = "the scene gives no curve: " + problem.reason();
  } else if (found.outcome == LeastSquaresOutcome::EvaluationsReached) {
    made.text = "the search ended at its evaluations";
  } else {
    const auto curves = problem.curves(found.x, 1);
    std::size_t next = 0;
    std::vector<double>& values = made.rows.emplace_back();
    for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
      const bool searched = fit.fractions[i].empty();
      values.push_back(searched ? searched_value(problem, next, found.x[next])
                                : break_value(curves, fit.fractions[i], fit.parameters[i]));
      next += searched ? 1 : 0;
    }
  }
  made.runs = problem.counters();
  return made;
}

Repetition attempted(const FitToRemesh& fit, Division division) {
  try {
    return repeated(fit, division);
  } catch (const InputError& error) {
    Repetition none;
    none.text = error.what();
    return none;
  }
}

}  // namespace

std::optional<SceneSegments> fit_remeshed(const FitToRemesh& fit, SceneWork& work) {
  const std::span<const WeightedTarget> targets = fit.problem.targets();
  SceneSegments segments;
  double order = 0.0;
  for (const WeightedTarget& weighted : targets) {
    if (weighted.setup.scene.is_coupon()) continue;
    const double own = order_of_joints(weighted.setup.scene);
    if (segments.segments == 0) segments.segments = weighted.setup.scene.beam.segments;
    order = order == 0.0 ? own : std::min(order, own);
  }
  if (segments.segments == 0) return std::nullopt;
  // One after the other: each has all threads for its own runs.
  constexpr Division kDivisions[] = {Division::Half, Division::Twice};
  const std::vector<Repetition> made =
      work.make({"segments", std::size(kDivisions)},
                [&](std::size_t i) { return attempted(fit, kDivisions[i]); });
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (!made[i].rows.empty()) continue;
    segments.note +=
        fmt::format("{}no fit with {} the segments: {}", segments.note.empty() ? "" : "; ",
                    word_of(kDivisions[i]), made[i].text);
  }
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    const FittedParameter& parameter = fit.parameters[i];
    const auto value = [&](const Repetition& one) {
      return one.rows.empty() ? kNan : one.rows.front()[i];
    };
    // What no curve determines may be anything.
    const bool known = !parameter.at_bound() && std::isfinite(parameter.noise_error);
    segments.parameters.push_back(
        known ? segments_error(value(made[0]), parameter.value, value(made[1]), order)
              : SegmentsError{});
  }
  return segments;
}

}  // namespace plastica::calibrate
