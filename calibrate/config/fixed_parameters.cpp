#include "calibrate/config/fixed_parameters.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <map>

#include "calibrate/config/read_parameters.hpp"
#include "calibrate/config/write_target.hpp"
#include "plastica/io/units.hpp"

namespace plastica::calibrate {

std::string parameters_text(const std::vector<std::string>& fixed) {
  std::string text = "[fit.parameters]\n";
  std::map<const Field*, std::string> taken;
  for (const std::string& entry : fixed) {
    const std::size_t at = entry.find('=');
    if (at == std::string::npos || at == 0 || at + 1 == entry.size()) {
      throw InputError({}, "--fix", entry,
                       "must be NAME=VALUE, such as youngs_modulus=\"200 GPa\"");
    }
    const Field& field = parameter_field(entry.substr(0, at), {}, "--fix " + entry.substr(0, at));
    if (!taken.emplace(&field, entry).second) {
      throw InputError({}, "--fix", entry, "this parameter is fixed twice");
    }
    const std::string value = entry.substr(at + 1);
    try {
      check_field(field, io::parse_quantity(value, field.dimension));
    } catch (const InputError& error) {
      throw InputError({}, "--fix " + entry.substr(0, at), value, error.rule());
    }
    text += fmt::format("{} = {{ value = {}, fixed = true }}\n", toml_string(field.path),
                        toml_string(value));
  }
  bool any_free = false;
  for (const Parameter& parameter : default_parameters()) {
    if (taken.count(parameter.field) > 0) continue;
    text += parameter.name() + " = {}\n";
    any_free = true;
  }
  if (!any_free) {
    throw InputError({}, "--fix", fixed.back(), "leaves nothing to fit: all parameters are fixed");
  }
  return text;
}

}  // namespace plastica::calibrate
