#include "calibrate/config/read_parameters.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "plastica/base/renamed.hpp"
#include "plastica/io/nearest_word.hpp"

namespace plastica::calibrate {
namespace {

using io::TomlTable;
using io::TomlValue;

constexpr std::string_view kAuto = "auto";

/// A material field by its path or its last part; of a fit through scenes any number by its path.
/// Old names are names, too.
const Field* parameter_field_or_null(std::string_view written, ParameterScope scope) {
  const std::string name = new_path(written);
  for (const Field& field : fields()) {
    if (field.material && (field.path == name || last_part(field.path) == name)) return &field;
    const bool any = scope == ParameterScope::Scene && field.kind == FieldKind::Number;
    if (any && field.path == name) return &field;
  }
  return nullptr;
}

/// A quantity that the field's range allows.
double value_of(const TomlValue& value, const Field& field) {
  const double number = value.quantity(field.dimension);
  try {
    check_field(field, number);
  } catch (const InputError& error) {
    throw value.error(error.rule());
  }
  return number;
}

std::optional<double> bound_of(const TomlValue& value, const Field& field) {
  if (value.is_string() && value.string() == kAuto) return std::nullopt;
  return value_of(value, field);
}

void read_bounds(const TomlValue& bounds, Parameter& parameter) {
  const std::vector<TomlValue> ends = bounds.array();
  if (ends.size() != 2) throw bounds.error("must be two values, [lower, upper]");
  parameter.lower = bound_of(ends[0], *parameter.field);
  parameter.upper = bound_of(ends[1], *parameter.field);
  if (parameter.lower && parameter.upper && *parameter.lower >= *parameter.upper) {
    throw bounds.error("the lower bound must be below the upper one");
  }
}

ParameterScale scale_of(const TomlValue& value) {
  static constexpr std::array<std::string_view, 3> kWords{kAuto, "linear", "logarithmic"};
  return static_cast<ParameterScale>(value.word(kWords));
}

/// What a parameter's table has; asks for every key, so that all of them are known.
struct Keys {
  explicit Keys(const TomlTable& table)
      : value(table.find("value")),
        fixed(table.find("fixed")),
        tie(table.find("tie")),
        factor(table.find("factor")),
        bounds(table.find("bounds")),
        start(table.find("start")),
        scale(table.find("scale")),
        prior(table.find("prior")) {}

  std::optional<TomlValue> value, fixed, tie, factor, bounds, start, scale, prior;
};

void refuse(const std::optional<TomlValue>& value, std::string_view rule) {
  if (value) throw value->error(rule);
}

/// { mean = ..., standard_deviation = ... }
Prior read_prior(const TomlValue& value, const Field& field) {
  if (is_break(field)) throw value.error("is none of a break strain, which is set, not searched");
  const TomlTable table = value.table();
  const TomlValue deviation = table.at("standard_deviation");
  const Prior prior{table.at("mean").quantity(field.dimension),
                    deviation.quantity(field.dimension)};
  if (!(prior.standard_deviation > 0.0)) throw deviation.error("must be above 0");
  return prior;
}

void read_free(const Keys& keys, Parameter& parameter) {
  refuse(keys.value, "needs fixed = true beside it; a free parameter's first value is its start");
  refuse(keys.factor, "belongs to a tie");
  if (keys.bounds) read_bounds(*keys.bounds, parameter);
  if (keys.start) {
    parameter.value = value_of(*keys.start, *parameter.field);
    const bool below = parameter.lower && *parameter.value < *parameter.lower;
    const bool above = parameter.upper && *parameter.value > *parameter.upper;
    if (below || above) throw keys.start->error("must be within the bounds");
  }
  if (keys.prior) parameter.prior = read_prior(*keys.prior, *parameter.field);
  if (!keys.scale) return;
  parameter.scale = scale_of(*keys.scale);
  const bool logarithmic = parameter.scale == ParameterScale::Logarithmic;
  const bool may_be_negative = parameter.field->range.low < 0.0 && !parameter.lower;
  if (logarithmic && (may_be_negative || (parameter.lower && *parameter.lower <= 0.0))) {
    throw keys.scale->error("needs a lower bound above 0");
  }
}

void read_tied(const Keys& keys, ParameterScope scope, Parameter& parameter) {
  constexpr std::string_view kRule = "cannot go with a tie";
  refuse(keys.prior, kRule);
  refuse(keys.bounds, kRule);
  refuse(keys.start, kRule);
  refuse(keys.scale, kRule);
  refuse(keys.value, kRule);
  refuse(keys.fixed, kRule);
  parameter.role = ParameterRole::Tied;
  const Field* other = parameter_field_or_null(keys.tie->new_path(keys.tie->string()), scope);
  if (other == nullptr) throw keys.tie->error("is not the name of a parameter");
  if (other == parameter.field) throw keys.tie->error("a parameter cannot be tied to itself");
  if (other->dimension != parameter.field->dimension) {
    throw keys.tie->error("is a " + std::string(name_of(other->dimension)) + ", " +
                          parameter.name() + " a " +
                          std::string(name_of(parameter.field->dimension)));
  }
  parameter.tied_to = other;
  if (keys.factor) {
    parameter.factor = keys.factor->number();
    if (parameter.factor == 0.0) throw keys.factor->error("must not be 0");
  }
}

void read_fixed(const Keys& keys, const TomlTable& table, Parameter& parameter) {
  constexpr std::string_view kRule = "cannot go with fixed = true";
  refuse(keys.prior, kRule);
  refuse(keys.bounds, kRule);
  refuse(keys.start, kRule);
  refuse(keys.scale, kRule);
  refuse(keys.factor, kRule);
  parameter.role = ParameterRole::Fixed;
  parameter.value = value_of(table.at("value"), *parameter.field);
}

Parameter read_parameter(const TomlValue& value, const Field& field, ParameterScope scope) {
  Parameter parameter;
  parameter.field = &field;
  parameter.where = value.where();
  if (!value.is_table()) {
    if (!value.is_string() && !value.is_number()) {
      throw value.error("must be a value, which fixes it, or a table such as { bounds = [...] }");
    }
    parameter.role = ParameterRole::Fixed;
    parameter.value = value_of(value, field);
    return parameter;
  }
  const TomlTable table = value.table();
  const Keys keys(table);
  if (keys.tie) {
    read_tied(keys, scope, parameter);
  } else if (keys.fixed && keys.fixed->boolean()) {
    read_fixed(keys, table, parameter);
  } else {
    read_free(keys, parameter);
  }
  return parameter;
}

/// Whether fields lie below a name: "hardening" below "material.".
bool is_folder(const std::string& path, ParameterScope scope) {
  return std::any_of(fields().begin(), fields().end(), [&](const Field& field) {
    return (field.material || scope == ParameterScope::Scene) && field.path.starts_with(path + ".");
  });
}

/// @param prefix  of a path that is written with dots, such as material.yield_stress
void collect(const TomlTable& table, const std::string& prefix, ParameterScope scope,
             std::vector<Parameter>& parameters) {
  for (const std::string& key : table.keys()) {
    const TomlValue value = table.at(key);
    const std::string name = prefix + key;
    if (value.is_table() && is_folder(name, scope)) {
      collect(value.table(), name + ".", scope, parameters);
      continue;
    }
    const Field& field = parameter_field(value.new_path(name), value.where(), value.key(), scope);
    for (const Parameter& other : parameters) {
      if (other.field == &field) {
        throw InputError(value.where(), value.key(), "",
                         "is the parameter of line " + std::to_string(other.where.line) + ", too");
      }
    }
    parameters.push_back(read_parameter(value, field, scope));
  }
}

void check_ties(const std::vector<Parameter>& parameters) {
  for (const Parameter& parameter : parameters) {
    if (parameter.role != ParameterRole::Tied) continue;
    const auto base = std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) {
      return p.field == parameter.tied_to;
    });
    if (base != parameters.end() && base->role != ParameterRole::Tied) continue;
    throw InputError(
        parameter.where, "fit.parameters." + parameter.name() + ".tie",
        last_part(parameter.tied_to->path),
        base == parameters.end() ? "is not one of the fit's parameters" : "is tied itself");
  }
}

bool is_given(const TomlTable& root, const std::vector<Parameter>& parameters,
              std::string_view name) {
  return material_gives(root, name) ||
         std::ranges::any_of(parameters, [&](const Parameter& parameter) {
           return last_part(parameter.field->path) == name;
         });
}

}  // namespace

bool material_gives(const TomlTable& root, std::string_view name) {
  const auto material = root.find("material");
  if (!material) return false;
  return !material->is_table() || material->table().contains("name") ||
         material->table().contains(name);
}

std::vector<Parameter> default_parameters() {
  std::vector<Parameter> parameters(3);
  parameters[0].field = find_field_or_null("material.youngs_modulus");
  parameters[1].field = find_field_or_null("material.yield_stress");
  parameters[2].field = find_field_or_null("material.break_strain");
  return parameters;
}

const Field& parameter_field(std::string_view name, const SourceLocation& where,
                             std::string_view key, ParameterScope scope) {
  if (const Field* field = parameter_field_or_null(name, scope)) return *field;
  std::vector<std::string> names;
  for (const Field& field : fields()) {
    if (field.material) names.emplace_back(last_part(field.path));
    if (field.path != name && last_part(field.path) != name) continue;
    const bool by_path = scope == ParameterScope::Scene && field.kind == FieldKind::Number;
    throw InputError(where, key, "",
                     by_path
                         ? "needs its whole path, in quotes: \"" + std::string(field.path) + "\""
                         : "is not a field that a fit can move");
  }
  std::string rule = "is not the name of a parameter";
  if (const auto nearest = io::nearest_word(last_part(name), names)) {
    rule += "; did you mean " + *nearest + "?";
  } else {
    rule += "; `plastica fields` lists them";
  }
  throw InputError(where, key, "", rule);
}

std::vector<Parameter> read_parameters(const TomlTable& fit, ParameterScope scope) {
  const auto table = fit.find_table("parameters");
  if (!table || table->keys().empty()) return default_parameters();
  std::vector<Parameter> parameters;
  collect(*table, "", scope, parameters);
  check_ties(parameters);
  const bool any_free = std::any_of(parameters.begin(), parameters.end(), [](const Parameter& p) {
    return p.role == ParameterRole::Free;
  });
  if (!any_free) {
    throw InputError(table->where(), table->key(), "", "needs at least one that is free");
  }
  return parameters;
}

void check_material_is_given(const TomlTable& root, const std::vector<Parameter>& parameters,
                             Deformation test) {
  const auto given = [&](std::string_view name) { return is_given(root, parameters, name); };
  const bool torsion = test == Deformation::Torsion;
  for (const auto& [name, shear_name] : {std::pair("youngs_modulus", "shear_modulus"),
                                         std::pair("yield_stress", "shear_yield_stress")}) {
    if (given(name) || (torsion && given(shear_name))) continue;
    throw InputError(root.where(), std::string("fit.parameters.") + name, "",
                     "is missing: make it a parameter, or give it in [material]");
  }
}

}  // namespace plastica::calibrate
