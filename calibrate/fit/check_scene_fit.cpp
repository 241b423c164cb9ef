#include "calibrate/fit/check_scene_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calibrate/fit/require.hpp"
#include "calibrate/inference/scene_errors.hpp"
#include "calibrate/search/optimizer.hpp"

namespace plastica::calibrate {
namespace {

[[noreturn]] void refuse(const Parameter& p, std::string_view value, std::string_view rule) {
  throw InputError(p.where, p.field->path, value, rule);
}

void check_free(const Parameter& p) {
  if (!p.lower || !p.upper) refuse(p, "", "needs a lower and an upper bound to be fitted");
  for (const auto& value : {p.lower, p.upper, p.value}) {
    if (value) check_field(*p.field, *value, p.where);
  }
  if (!(*p.lower < *p.upper)) {
    refuse(p, fmt::format("[{:g}, {:g}]", *p.lower, *p.upper),
           "the lower bound must be below the upper one");
  }
  if (p.value && (*p.value < *p.lower || *p.value > *p.upper)) {
    refuse(p, fmt::format("{:g}", *p.value), "the start must lie between the bounds");
  }
  if (p.scale == ParameterScale::Logarithmic && *p.lower <= 0.0) {
    refuse(p, fmt::format("{:g}", *p.lower), "a logarithmic scale needs a lower bound above 0");
  }
}

void check_tie(const Parameter& p, const std::vector<Parameter>& all) {
  const auto base = std::find_if(all.begin(), all.end(),
                                 [&](const Parameter& other) { return other.field == p.tied_to; });
  if (is_break(p) || (base != all.end() && is_break(*base))) {
    refuse(p, "", "cannot be tied in a fit through scenes: a break strain is set, not searched");
  }
  if (base == all.end() || base->role == ParameterRole::Tied) {
    refuse(p, "", "must be tied to a parameter of the fit that is not tied itself");
  }
}

}  // namespace

bool are_of_one_kind(const SceneTarget& a, const SceneTarget& b) {
  return a.kind == b.kind && a.driven == b.driven && a.abscissa_probe == b.abscissa_probe &&
         a.ordinate_probe == b.ordinate_probe && a.ordinate_is == b.ordinate_is;
}

namespace {

void check_intervals(const IntervalOptions& how, std::span<const WeightedTarget> targets) {
  check_intervals(how);
  for (const WeightedTarget& weighted : targets) {
    require(static_cast<std::size_t>(how.block) <= weighted.target.ordinate.size(),
            "bootstrap_block", how.block,
            fmt::format("must be no more than the samples of {}", weighted.target.name));
  }
  if (how.specimens == 0) return;
  require(targets.size() > 1, "bootstrap_specimens", how.specimens,
          "needs several targets that share the parameters");
  for (const WeightedTarget& weighted : targets) {
    const auto alike = std::ranges::count_if(targets, [&](const WeightedTarget& other) {
      return are_of_one_kind(weighted.target, other.target);
    });
    require(alike > 1, "bootstrap_specimens", how.specimens,
            fmt::format("needs several targets of each kind, and {} is the only one that measures "
                        "its probe over its abscissa",
                        weighted.target.name));
  }
}

void check_target(const SceneTarget& target) {
  const std::size_t n = target.abscissa.size();
  if (n == 0 || target.ordinate.size() != n) {
    throw InputError({}, "target", target.name, "needs as many ordinates as abscissas, and any");
  }
  for (std::size_t i = 0; i < n; ++i) {
    const bool goes_on =
        i == 0 || is_driven(target.kind) || target.abscissa[i] >= target.abscissa[i - 1];
    if (std::isfinite(target.abscissa[i]) && std::isfinite(target.ordinate[i]) && goes_on) continue;
    throw InputError({}, "target", target.name,
                     fmt::format("must be finite and never go back, and does at sample {}", i));
  }
  for (const double factor : {target.abscissa_factor, target.ordinate_factor}) {
    require(std::isfinite(factor) && factor != 0.0, "factor", factor, "must be finite and not 0");
  }
  if (target.noise) require(*target.noise > 0.0, "noise", *target.noise, "must be above 0");
}

}  // namespace

void check_scene_fit(std::span<const WeightedTarget> targets, const SceneFitOptions& options) {
  if (targets.empty()) throw InputError({}, "target", "", "a fit needs at least one");
  bool any_free = false;
  const bool any_broke =
      std::any_of(targets.begin(), targets.end(),
                  [](const WeightedTarget& weighted) { return weighted.target.broke.has_value(); });
  for (const Parameter& p : options.parameters) {
    if (p.field->kind != FieldKind::Number) refuse(p, "", "is no number that a fit could move");
    const auto same = [&](const Parameter& other) { return other.field == p.field; };
    if (std::count_if(options.parameters.begin(), options.parameters.end(), same) > 1) {
      refuse(p, "", "is given twice");
    }
    check_prior(p);
    switch (p.role) {
      case ParameterRole::Free:
        check_free(p);
        any_free = true;
        break;
      case ParameterRole::Fixed:
        if (!p.value) refuse(p, "", "is fixed and needs a value");
        break;
      case ParameterRole::Tied: check_tie(p, options.parameters); break;
    }
    const bool of_the_break = is_break(p) || is_hinge_length(p);
    if (p.role == ParameterRole::Free && of_the_break && !any_broke) {
      refuse(p, "", "cannot be fitted: the target does not say where it broke");
    }
  }
  const auto is_free = [&](auto&& which) {
    return std::ranges::any_of(options.parameters, [&](const Parameter& p) {
      return p.role == ParameterRole::Free && which(p);
    });
  };
  if (is_free(is_hinge_length) &&
      is_free([](const Parameter& p) { return p.field->material == MaterialField::BreakStrain; })) {
    throw InputError({}, "rules.hinge_length", "",
                     "cannot be fitted beside material.break_strain: a break tells only what both "
                     "make together");
  }
  if (!any_free) throw InputError({}, "fit.parameters", "", "at least one must be free");
  check_law_parameters(options.parameters, targets.front().setup.scene.material, options.laws);
  require(options.evaluations >= 1, "evaluations", options.evaluations, "must be at least 1");
  if (std::ranges::find(algorithm_names(), options.algorithm) == algorithm_names().end()) {
    throw InputError({}, "fit.algorithm", options.algorithm, "is not the name of an algorithm");
  }
  require(options.starts >= 1, "starts", options.starts, "must be at least 1");
  require(options.screen >= 0, "screen", options.screen, "must be at least 0");
  require(options.tolerance > 0.0, "tolerance", options.tolerance, "must be above 0");
  require(options.confidence > 0.0 && options.confidence < 1.0, "confidence", options.confidence,
          "must be between 0 and 1");
  check_intervals(options.intervals, targets);
  for (const WeightedTarget& weighted : targets) {
    check_target(weighted.target);
    require(weighted.weight > 0.0 && std::isfinite(weighted.weight), "weight", weighted.weight,
            "must be above 0");
    const std::vector<double>& x = weighted.target.abscissa;
    if (options.objective == Objective::Path &&
        std::ranges::minmax(x).min == std::ranges::minmax(x).max) {
      throw InputError({}, "fit.objective", "path",
                       weighted.target.name + ": its abscissa never changes, so there is no path");
    }
  }
}

void check_break_levels(const SceneProblem& problem, const SceneFitOptions& options) {
  for (const Parameter& p : options.parameters) {
    if (p.role != ParameterRole::Free || !is_break(p)) continue;
    bool any = false;
    for (std::size_t i = 0; i < problem.targets().size(); ++i) {
      if (!breaks_by(p, problem.model(i), problem.targets()[i])) continue;
      any = true;
      if (problem.model(i).takes_a_limit()) continue;
      refuse(p, "", "cannot be fitted: regions of other materials cover the whole beam");
    }
    if (any) continue;
    throw InputError(p.where, p.field->path, "",
                     p.field->material == MaterialField::BreakStrain
                         ? "is fitted where the beam bends in a plane (solver.level)"
                         : "is fitted where the beam is twisted alone (solver.level)");
  }
}

}  // namespace plastica::calibrate
