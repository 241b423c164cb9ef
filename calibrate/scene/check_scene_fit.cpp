#include "calibrate/scene/check_scene_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plastica::calibrate {
namespace {

[[noreturn]] void refuse(const Parameter& p, std::string_view value, std::string_view rule) {
  throw InputError(p.where, p.field->path, value, rule);
}

void require(bool holds, std::string_view field, double value, std::string_view rule) {
  if (!holds) throw InputError({}, field, fmt::format("{:g}", value), rule);
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

}  // namespace

void check_scene_fit(const SceneTarget& target, const SceneFitOptions& options) {
  bool any_free = false;
  for (const Parameter& p : options.parameters) {
    if (p.field->kind != FieldKind::Number) refuse(p, "", "is no number that a fit could move");
    const auto same = [&](const Parameter& other) { return other.field == p.field; };
    if (std::count_if(options.parameters.begin(), options.parameters.end(), same) > 1) {
      refuse(p, "", "is given twice");
    }
    switch (p.role) {
      case ParameterRole::Free:
        check_free(p);
        any_free = true;
        break;
      case ParameterRole::Fixed:
        if (!p.value) refuse(p, "", "is fixed and needs a value");
        break;
      case ParameterRole::Tied: refuse(p, "", "cannot be tied in the fit of a scene");
    }
    if (p.role == ParameterRole::Free && is_break(p) && !target.broke) {
      refuse(p, "", "cannot be fitted: the target does not say where it broke");
    }
  }
  if (!any_free) throw InputError({}, "fit.parameters", "", "at least one must be free");
  require(options.evaluations >= 1, "evaluations", options.evaluations, "must be at least 1");
  require(options.starts >= 1, "starts", options.starts, "must be at least 1");
  require(options.tolerance > 0.0, "tolerance", options.tolerance, "must be above 0");

  const std::size_t n = target.abscissa.size();
  if (n == 0 || target.ordinate.size() != n) {
    throw InputError({}, "target", target.name, "needs as many ordinates as abscissas, and any");
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (std::isfinite(target.abscissa[i]) && std::isfinite(target.ordinate[i]) &&
        (i == 0 || target.abscissa[i] >= target.abscissa[i - 1])) {
      continue;
    }
    throw InputError({}, "target", target.name,
                     fmt::format("must be finite and never go back, and does at sample {}", i));
  }
  for (const double factor : {target.abscissa_factor, target.ordinate_factor}) {
    require(std::isfinite(factor) && factor != 0.0, "factor", factor, "must be finite and not 0");
  }
  if (target.noise) require(*target.noise > 0.0, "noise", *target.noise, "must be above 0");
}

}  // namespace plastica::calibrate
