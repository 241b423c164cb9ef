#include "calibrate/problem/scene_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace plastica::calibrate {

bool is_hinge_length(const Parameter& p) { return p.field->path == "rules.hinge_length"; }

SceneParameters::SceneParameters(std::span<const Parameter> parameters, const Setup& setup) {
  for (const Parameter& p : parameters) {
    if (p.role != ParameterRole::Free || is_break(p)) continue;
    Coordinate c{.lower = *p.lower, .upper = *p.upper, .size = *p.upper - *p.lower};
    c.logarithmic = p.scale == ParameterScale::Logarithmic ||
                    (p.scale == ParameterScale::Auto && *p.lower > 0.0);
    const FieldValue scene = p.field->get(setup);
    const double middle =
        c.logarithmic ? std::sqrt(*p.lower * *p.upper) : 0.5 * (*p.lower + *p.upper);
    const double* given = std::get_if<double>(&scene);
    const double start = p.value ? *p.value : given != nullptr ? *given : middle;
    c.start = std::clamp(start, *p.lower, *p.upper);
    searched_.push_back({&p, c});
    fields_.push_back(p.field);
  }
  for (const Parameter& p : parameters) {
    if (p.role != ParameterRole::Tied) continue;
    const auto base = std::find_if(searched_.begin(), searched_.end(), [&](const Searched& s) {
      return s.parameter->field == p.tied_to;
    });
    if (base == searched_.end()) continue;  // to a fixed one: fixed itself
    ties_.push_back({static_cast<std::size_t>(base - searched_.begin()), p.factor});
    fields_.push_back(p.field);
  }
}

std::vector<double> SceneParameters::point_at(const StartPoint& values) const {
  std::vector<double> x(size(), 0.0);
  for (std::size_t i = 0; i < size(); ++i) {
    const Parameter& p = parameter(i);
    for (const auto& [field, value] : values) {
      if (field == p.field) x[i] = coordinate(i).at(std::clamp(value, *p.lower, *p.upper));
    }
  }
  return x;
}

std::vector<double> SceneParameters::values(std::span<const double> x) const {
  std::vector<double> values;
  values.reserve(fields_.size());
  for (std::size_t i = 0; i < size(); ++i) values.push_back(value(i, x[i]));
  for (const Tie& tie : ties_) values.push_back(tie.factor * values[tie.to]);
  return values;
}

}  // namespace plastica::calibrate
