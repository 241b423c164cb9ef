#include "calibrate/fit/fit_law.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "calibrate/fit/fit.hpp"

namespace plastica::calibrate {
namespace {

/// A cost above the simpler law's by more than this share of it is not the least.
constexpr double kNoBetter = 1e-6;
/// A stress, modulus or rate of this share of the least usual one has no effect that shows.
constexpr double kNothing = 1e-6;

/// Lets a search begin where a simpler law's ended; what the law has beyond that one begins where
/// it always does, or where it has next to no effect.
/// @param own  a fit of the law itself, for the bounds that it had
void start_from(const FitResult& simpler, const FitResult& own, bool no_effect,
                FitOptions& options) {
  for (Parameter& p : options.parameters) {
    if (p.role != ParameterRole::Free) continue;
    const auto found = std::ranges::find(simpler.parameters, p.field->path, &FittedParameter::path);
    if (found != simpler.parameters.end()) {
      p.value =
          std::clamp(found->value, p.lower.value_or(found->value), p.upper.value_or(found->value));
    } else if (no_effect) {
      const auto mine = std::ranges::find(own.parameters, p.field->path, &FittedParameter::path);
      if (mine == own.parameters.end()) continue;
      // A bound that nobody gave gives way to a start beyond it.
      const double lower = p.lower.value_or(kNothing * mine->lower);
      if (const auto least = least_effect(p, lower, mine->upper)) p.value = least;
    }
  }
}

/// The work of one search stands before that of another one of the same parameters, whose result
/// it is.
void put_before(FitResult&& first, FitResult& second) {
  first.stages.insert(first.stages.end(), second.stages.begin(), second.stages.end());
  second.stages = std::move(first.stages);
  Trace& trace = first.trace;
  trace.values.insert(trace.values.end(), second.trace.values.begin(), second.trace.values.end());
  trace.costs.insert(trace.costs.end(), second.trace.costs.begin(), second.trace.costs.end());
  second.trace = std::move(trace);
}

}  // namespace

FitOptions options_of(Law law, const FitOptions& options, Loading loading) {
  FitOptions own = options;
  const std::vector<Law> laws{law};
  own.parameters =
      parameters_of(law, loading, parameters_of(laws, options.parameters), options.parameters);
  Hardening& hardening = own.setup.scene.material.hardening;
  hardening = hardening_of(law, hardening);
  return own;
}

FitResult fit_law(const Target& target, const FitOptions& options, Law law) {
  FitOptions own = options_of(law, options, target.loading);
  own.intervals = {};  // of the fit that is kept alone: `fit_cases` adds them
  FitResult result = fit_target(target, own);
  Law simpler = law;
  if (result.status != FitStatus::Fitted || !has_simpler(law, simpler)) return result;
  const FitResult below = fit_law(target, options, simpler);
  result.simpler_evaluations = below.evaluations() + below.simpler_evaluations;
  if (below.status != FitStatus::Fitted) return result;
  const auto worse = [&] { return result.cost > below.cost * (1.0 + kNoBetter); };
  for (const bool no_effect : {false, true}) {
    if (!worse()) return result;
    start_from(below, result, no_effect, own);
    FitResult again = fit_target(target, own);
    again.simpler_evaluations = result.simpler_evaluations;
    if (again.status == FitStatus::Fitted && again.cost < result.cost) {
      put_before(std::move(result), again);
      result = std::move(again);
    } else if (again.trace.active == result.trace.active) {
      put_before(std::move(again), result);
    }
  }
  if (worse()) {
    result.warnings.push_back(
        fmt::format("{} ends with a larger misfit than {}, which it contains: its search has not "
                    "found its best",
                    name_of(law), name_of(simpler)));
  }
  return result;
}

}  // namespace plastica::calibrate
