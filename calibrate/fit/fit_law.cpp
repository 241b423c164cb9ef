#include "calibrate/fit/fit_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "calibrate/fit/search_target.hpp"
#include "calibrate/problem/parameter_set.hpp"
#include "calibrate/search/ladder.hpp"

namespace plastica::calibrate {
namespace {

/// A stress, modulus or rate of this fraction of the smallest usual one has no visible effect.
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
      if (const auto least = min_effect_value(p, lower, mine->upper)) p.value = least;
    }
  }
}

/// Where the law's search begins besides its start.
std::vector<StartPoint> starts_of(const Target& target, const FitOptions& own,
                                  const FitResult& simpler) {
  std::vector<SearchedParameter> searched;
  const ParameterSet set(target, own);
  for (const std::size_t i : set.active()) {
    const ResolvedParameter& p = set.all()[i];
    if (!p.is_break) searched.push_back({&own.parameters[i], p.lower, p.upper});
  }
  return starts_from_simpler(searched, [&](std::string_view path) {
    const auto found = std::ranges::find(simpler.parameters, path, &FittedParameter::path);
    return found == simpler.parameters.end() ? std::nullopt : std::optional(found->value);
  });
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

namespace {

/// As `fit_law`, without priors.
/// @param warning   is set where a simpler law that it contains ends with a smaller misfit
/// @param searched  as of `search_target`
FitResult search_law(const Target& target, const FitOptions& options, Law law, Told told,
                     std::string& warning, std::optional<Misfit>* searched) {
  FitOptions own = options_of(law, options, target.loading);
  Law simpler = law;
  if (!has_simpler(law, simpler)) return search_target(target, own, told, {}, searched);
  const FitResult below = search_law(target, options, simpler, Told::ForSearch, warning, nullptr);
  warning.clear();
  const bool fitted = below.status == FitStatus::Fitted;
  FitResult result =
      search_target(target, own, told,
                    fitted ? starts_of(target, own, below) : std::vector<StartPoint>(), searched);
  if (result.status != FitStatus::Fitted) return result;
  result.simpler_evaluations = below.evaluations() + below.simpler_evaluations;
  if (!fitted) return result;
  const auto worse = [&] { return result.cost > below.cost * (1.0 + kNoBetter); };
  for (const bool no_effect : {false, true}) {
    if (!worse()) return result;
    start_from(below, result, no_effect, own);
    FitResult again = search_target(target, own, told, {}, searched);
    again.simpler_evaluations = result.simpler_evaluations;
    if (again.status == FitStatus::Fitted && again.cost < result.cost) {
      put_before(std::move(result), again);
      result = std::move(again);
    } else if (again.trace.active == result.trace.active) {
      put_before(std::move(again), result);
    }
  }
  if (worse()) {
    warning = fmt::format(
        "{} ends with a larger misfit than {}, which it contains: its search has not found its "
        "best",
        name_of(law), name_of(simpler));
  }
  return result;
}

}  // namespace

FitResult fit_law(const Target& target, const FitOptions& options, Law law) {
  std::string warning;
  const FitOptions own = options_of(law, options, target.loading);
  const FitPriors priors(target, own);
  std::optional<Misfit> searched;
  FitResult result = search_law(target, options, law, priors.told(), warning, &searched);
  if (searched) weigh_priors(target, own, priors, *searched, result);
  if (!warning.empty()) result.warnings.push_back(std::move(warning));
  return result;
}

}  // namespace plastica::calibrate
