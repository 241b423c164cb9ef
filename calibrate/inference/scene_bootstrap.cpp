#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

#include "calibrate/fit/check_scene_fit.hpp"
#include "calibrate/inference/fitted_scenes.hpp"
#include "calibrate/inference/parameter_profile.hpp"

namespace plastica::calibrate {
namespace {

/// One resample: what becomes of the residuals, and where and how much the breaks count.
struct Resample {
  std::vector<double> factor, shift;  ///< (m), see `changed`
  std::vector<double> place;          ///< of the breaks between their samples (n_targets)
  std::vector<double> count;          ///< of the targets (n_targets)
};

using Draw = std::function<Resample(Draws& draws)>;

std::vector<double> values_of(const FittedScenes& fitted, SceneProblem& problem,
                              std::span<const double> x, const Resample& resample) {
  std::vector<double> values;
  const bool broke = std::ranges::any_of(fitted.free(), &FittedScenes::FreeParameter::is_break);
  const auto curves = broke ? problem.curves(x, 1) : std::vector<std::vector<SceneCurve>>();
  for (const FittedScenes::FreeParameter& free : fitted.free()) {
    if (!free.is_break) {
      values.push_back(problem.parameters().value(free.coordinate, x[free.coordinate]));
      continue;
    }
    double sum = 0.0, total = 0.0;
    for (std::size_t t = 0; t < curves.size(); ++t) {
      const double fraction = free.limit.fractions[t] * resample.count[t];
      if (fraction == 0.0) continue;
      sum += fraction * strain_at_break(curves[t][0], resample.place[t]);
      total += fraction;
    }
    // Not a number if no target that broke was drawn.
    values.push_back(std::clamp(sum / total, *free.parameter->lower, *free.parameter->upper));
  }
  return values;
}

/// The targets of each kind of test: a resample has as many of each as there are.
std::vector<std::vector<std::size_t>> kinds_of(std::span<const WeightedTarget> targets) {
  std::vector<std::vector<std::size_t>> kinds;
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const auto kind = std::ranges::find_if(kinds, [&](const std::vector<std::size_t>& each) {
      return are_of_one_kind(targets[each.front()].target, targets[t].target);
    });
    if (kind == kinds.end()) {
      kinds.push_back({t});
    } else {
      kind->push_back(t);
    }
  }
  return kinds;
}

BootstrapResult bootstrap(const FittedScenes& fitted, std::string_view stage, int resamples,
                          int block, std::uint64_t seed, const Draw& draw, SceneWork& work) {
  // So many have one problem, which knows the curves that all of them begin with. How many share
  // one must not depend on the threads: the runs are counted.
  constexpr std::size_t kTogether = 8;
  const auto count = static_cast<std::size_t>(resamples);
  const std::size_t groups = (count + kTogether - 1) / kTogether;
  LeastSquaresOptions how;
  how.max_evaluations = fitted.options().evaluations;
  how.x_tolerance = fitted.options().tolerance;
  how.cost_tolerance =
      1e-8;  // a ten-thousandth of a standard error, or a thousandth of few samples
  const auto group_of = [&](std::size_t group) {
    const auto problem = fitted.copy();
    TaskRecord made;
    for (std::size_t b = group * kTogether; b < std::min(count, (group + 1) * kTogether); ++b) {
      Draws draws(seed, b);
      const Resample resample = draw(draws);
      LeastSquaresProblem squares = changed(problem->squares(), resample.factor, resample.shift);
      squares.start = fitted.best().x;
      const LeastSquares found = minimize_squares(squares, how);
      const bool none = found.outcome == LeastSquaresOutcome::NoStart;
      made.rows.push_back(none ? std::vector<double>()
                               : values_of(fitted, *problem, found.x, resample));
    }
    made.runs = problem->counters();
    return made;
  };
  const SceneWork::Stage all{stage, groups, fitted.options().threads, count};
  std::vector<std::vector<double>> values;
  for (TaskRecord& made : work.make(all, group_of)) {
    for (std::vector<double>& row : made.rows) values.push_back(std::move(row));
  }
  const std::vector<bool> known(fitted.free().size(), true);
  return bootstrap_of(values, known, block, fitted.options().confidence);
}

}  // namespace

BootstrapResult bootstrap_residuals(const FittedScenes& fitted, SceneWork& work) {
  const SceneProblem& problem = fitted.problem();
  const std::vector<double>& residual = fitted.best().residual;
  const std::size_t targets = problem.targets().size();
  const auto block = static_cast<std::size_t>(fitted.options().intervals.block);
  const Draw draw = [&](Draws& draws) {
    Resample resample;
    resample.factor.assign(residual.size(), 1.0);
    resample.count.assign(targets, 1.0);
    for (std::size_t t = 0; t < targets; ++t) {
      const std::size_t samples = problem.targets()[t].target.ordinate.size();
      const TargetNoise& noise = problem.noise()[t];
      std::vector<double> drawn;
      if (noise.is_from_elsewhere()) {
        // Its own residuals are too few to estimate its noise.
        for (std::size_t i = 0; i < samples; ++i) {
          drawn.push_back(problem.scale(t) * draws.normal());
        }
      } else {
        // Parameters took their part of them.
        const double inflation = std::sqrt(static_cast<double>(samples) / noise.degrees_left);
        drawn = drawn_residuals(problem.unscaled(t, residual), inflation, block, draws);
      }
      for (std::size_t i = 0; i < samples; ++i) {
        resample.shift.push_back(std::sqrt(problem.weights(t)[i]) / problem.scale(t) * drawn[i]);
      }
      resample.place.push_back(draws.uniform());
    }
    const std::size_t breaks = problem.known_breaks().size();
    while (resample.shift.size() < residual.size() - breaks) {
      resample.shift.push_back(draws.normal());
    }
    // A break is anywhere in its interval.
    while (resample.shift.size() < residual.size()) {
      resample.shift.push_back(std::sqrt(3.0) * (2.0 * draws.uniform() - 1.0));
    }
    // A drawn target is the fitted curve and what was drawn.
    for (std::size_t i = 0; i < residual.size(); ++i) resample.shift[i] -= residual[i];
    return resample;
  };
  const IntervalOptions& how = fitted.options().intervals;
  return bootstrap(fitted, "bootstrap", how.bootstrap, how.block, fitted.options().seed, draw,
                   work);
}

BootstrapResult bootstrap_specimens(const FittedScenes& fitted, SceneWork& work) {
  const SceneProblem& problem = fitted.problem();
  const std::vector<std::vector<std::size_t>> kinds = kinds_of(problem.targets());
  const std::size_t all = fitted.best().residual.size();
  const std::size_t targets = problem.targets().size();
  const Draw draw = [&](Draws& draws) {
    Resample resample;
    resample.count.assign(targets, 0.0);
    resample.place.assign(targets, 0.5);
    resample.shift.assign(all, 0.0);
    resample.factor.assign(all, 1.0);
    for (const std::vector<std::size_t>& kind : kinds) {
      for (std::size_t i = 0; i < kind.size(); ++i) {
        resample.count[kind[draws.below(kind.size())]] += 1.0;
      }
    }
    for (std::size_t t = 0; t < targets; ++t) {
      const std::size_t samples = problem.targets()[t].target.ordinate.size();
      std::fill_n(resample.factor.begin() + static_cast<std::ptrdiff_t>(problem.first_residual(t)),
                  samples, std::sqrt(resample.count[t]));
    }
    const auto breaks = problem.known_breaks();
    for (std::size_t k = 0; k < breaks.size(); ++k) {
      resample.factor[all - breaks.size() + k] = std::sqrt(resample.count[breaks[k].target]);
    }
    return resample;
  };
  // Other draws than those of the residuals.
  return bootstrap(fitted, "bootstrap of specimens", fitted.options().intervals.specimens, 1,
                   ~fitted.options().seed, draw, work);
}

}  // namespace plastica::calibrate
