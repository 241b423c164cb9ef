#include "calibrate/problem/parameter_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "calibrate/search/start_values.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// A lower bound that leaves room below an upper one that is given alone.
double room_below(double upper) { return upper > 0.0 ? upper / 30.0 : upper * 30.0; }

ResolvedParameter resolve(const Parameter& p, const CurveSizes& sizes, const Target& target,
                          const FitOptions& options) {
  ResolvedParameter r;
  r.field = p.field;
  r.role = p.role;
  r.is_break = is_break(*p.field);
  r.factor = p.factor;
  if (p.role == ParameterRole::Fixed) {
    r.start = r.lower = r.upper = *p.value;
    return r;
  }
  if (p.role == ParameterRole::Tied) return r;

  const StartValue found = start_value(*p.field, sizes, target, options);
  r.lower = p.lower.value_or(p.upper ? std::min(found.lower, room_below(*p.upper)) : found.lower);
  r.upper = p.upper.value_or(p.lower ? std::max(found.upper, *p.lower * 30.0) : found.upper);
  if (p.value) {
    if (!p.lower) r.lower = std::min(r.lower, *p.value);
    if (!p.upper) r.upper = std::max(r.upper, *p.value);
  }
  r.lower = std::max(r.lower, p.field->range.low);
  r.upper = std::min(r.upper, p.field->range.high);
  if (!(r.lower < r.upper)) {
    throw InputError(p.where, p.name(), fmt::format("[{:g}, {:g}]", r.lower, r.upper),
                     "the bounds leave no room: give both");
  }
  if (p.scale == ParameterScale::Logarithmic && r.lower <= 0.0) {
    throw InputError(p.where, p.name(), fmt::format("{:g}", r.lower),
                     "a logarithmic scale needs a lower bound above 0");
  }
  r.start = std::clamp(p.value.value_or(found.start), r.lower, r.upper);
  const double useful = largest_useful_value(*p.field, target, options);
  const bool stops = !p.prior && useful > r.lower;  // a prior calls back
  r.search_upper = stops ? std::min(r.upper, useful) : r.upper;
  r.logarithmic =
      p.scale == ParameterScale::Logarithmic || (p.scale == ParameterScale::Auto && r.lower > 0.0);
  return r;
}

}  // namespace

ParameterSet::ParameterSet(const Target& target, const FitOptions& options) {
  const CurveSizes sizes = curve_sizes(target, options);
  all_.reserve(options.parameters.size());
  for (const Parameter& p : options.parameters) {
    all_.push_back(resolve(p, sizes, target, options));
  }
  resolve_ties(options);
  find_break_parameter(target, options);
  active_of_.reserve(all_.size());
  active_.reserve(all_.size());
  coordinates_.reserve(all_.size());
  for (std::size_t i = 0; i < all_.size(); ++i) {
    ResolvedParameter& r = all_[i];
    const bool decides = break_parameter_ && break_parameter_->index == i;
    r.idle = r.role == ParameterRole::Free && r.is_break &&
             !(decides && target.characteristics.observed_break && options.break_weight > 0.0);
    const bool moves = r.role == ParameterRole::Free && !r.idle;
    active_of_.push_back(moves ? active_.size() : kNone);
    if (!moves) continue;
    active_.push_back(i);
    const double size = r.start != 0.0 ? std::fabs(r.start) : r.upper - r.lower;
    coordinates_.push_back({r.start, r.lower, r.upper, r.logarithmic, size});
  }
}

void ParameterSet::resolve_ties(const FitOptions& options) {
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (all_[i].role != ParameterRole::Tied) continue;
    for (std::size_t j = 0; j < all_.size(); ++j) {
      if (all_[j].field == options.parameters[i].tied_to) all_[i].base = j;
    }
    all_[i].start = all_[i].factor * all_[all_[i].base].start;
  }
}

void ParameterSet::find_break_parameter(const Target& target, const FitOptions& options) {
  const auto index_of = [&](MaterialField field) {
    std::size_t i = 0;
    while (i < all_.size() && all_[i].field->material != field) ++i;
    return i;
  };
  const Scene& scene = options.setup.scene;
  const bool torsion = target.test == Test::Torsion;
  const std::size_t shear = index_of(MaterialField::BreakShearStrain);
  const bool by_shear = torsion && (shear < all_.size() || scene.material.break_shear_strain);
  std::size_t i = by_shear ? shear : index_of(MaterialField::BreakStrain);
  if (i == all_.size()) return;
  BreakParameter found;
  if (torsion && !by_shear && scene.formulas == Formulas::Mechanics) found.factor = std::sqrt(3.0);
  if (all_[i].role == ParameterRole::Tied) {
    found.factor *= all_[i].factor;
    i = all_[i].base;
  }
  found.index = i;
  break_parameter_ = found;
}

double ParameterSet::lower(std::size_t i) const { return coordinate(i, active_parameter(i).lower); }

double ParameterSet::upper(std::size_t i) const {
  return coordinate(i, active_parameter(i).search_upper);
}

void ParameterSet::expand(std::span<const double> active_values,
                          std::span<double> all_values) const {
  for (std::size_t i = 0; i < all_.size(); ++i) {
    all_values[i] = active_of_[i] == kNone ? all_[i].start : active_values[active_of_[i]];
  }
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (all_[i].role == ParameterRole::Tied) {
      all_values[i] = all_[i].factor * all_values[all_[i].base];
    }
  }
}

void ParameterSet::contract(std::span<const double> by_all, std::span<double> by_active) const {
  std::fill(by_active.begin(), by_active.end(), 0.0);
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const bool tied = all_[i].role == ParameterRole::Tied;
    const std::size_t active = active_of_[tied ? all_[i].base : i];
    if (active != kNone) by_active[active] += (tied ? all_[i].factor : 1.0) * by_all[i];
  }
}

}  // namespace plastica::calibrate
