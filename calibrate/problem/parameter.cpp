#include "calibrate/problem/parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plastica::calibrate {
namespace {

[[noreturn]] void refuse(const Parameter& parameter, std::string_view value,
                         std::string_view rule) {
  throw InputError(parameter.where, parameter.name(), value, rule);
}

std::string text(double value) { return fmt::format("{:g}", value); }

void check_bounds(const Parameter& p) {
  for (const auto& bound : {p.lower, p.upper, p.value}) {
    if (bound) check_field(*p.field, *bound, p.where);
  }
  if (p.lower && p.upper && !(*p.lower < *p.upper)) {
    refuse(p, fmt::format("[{:g}, {:g}]", *p.lower, *p.upper),
           "the lower bound must be below the upper one");
  }
  if (p.value && p.lower && *p.value < *p.lower) {
    refuse(p, text(*p.value), "the start must not be below the lower bound");
  }
  if (p.value && p.upper && *p.value > *p.upper) {
    refuse(p, text(*p.value), "the start must not be above the upper bound");
  }
  if (p.scale == ParameterScale::Logarithmic && p.lower && *p.lower <= 0.0) {
    refuse(p, text(*p.lower), "a logarithmic scale needs a lower bound above 0");
  }
}

}  // namespace

std::string Parameter::name() const { return std::string(last_part(field->path)); }

bool is_break(const Field& field) {
  return field.material == MaterialField::BreakStrain ||
         field.material == MaterialField::BreakShearStrain;
}

void check_prior(const Parameter& p) {
  if (!p.prior) return;
  const auto refuse_prior = [&](std::string_view value, std::string_view rule) {
    throw InputError(p.where, p.field->path, value, rule);
  };
  if (is_break(p)) refuse_prior("", "cannot have a prior: a break strain is set, not searched");
  if (!std::isfinite(p.prior->mean)) {
    refuse_prior(text(p.prior->mean), "the prior's mean must be a finite number");
  }
  if (!(p.prior->standard_deviation > 0.0) || !std::isfinite(p.prior->standard_deviation)) {
    refuse_prior(text(p.prior->standard_deviation),
                 "the prior's standard deviation must be above 0");
  }
}

void check_parameters(const std::vector<Parameter>& parameters) {
  bool any_free = false;
  for (const Parameter& p : parameters) {
    if (!p.field->material) refuse(p, "", "is not a material field, so a fit cannot move it");
    const auto same = [&](const Parameter& other) { return other.field == p.field; };
    if (std::count_if(parameters.begin(), parameters.end(), same) > 1) {
      refuse(p, "", "is given twice");
    }
    switch (p.role) {
      case ParameterRole::Free:
        any_free = true;
        check_bounds(p);
        check_prior(p);
        break;
      case ParameterRole::Fixed:
        if (!p.value) refuse(p, "", "is fixed and needs a value");
        check_field(*p.field, *p.value, p.where);
        break;
      case ParameterRole::Tied: {
        const auto base = std::find_if(parameters.begin(), parameters.end(),
                                       [&](const auto& q) { return q.field == p.tied_to; });
        if (p.tied_to == p.field) refuse(p, "", "must not be tied to itself");
        if (base == parameters.end() || base->role == ParameterRole::Tied) {
          refuse(p, p.tied_to ? p.tied_to->path : "",
                 "must be tied to a free or fixed parameter of the fit");
        }
        break;
      }
    }
  }
  if (!any_free) throw InputError({}, "fit.parameters", "", "at least one must be free");
}

}  // namespace plastica::calibrate
