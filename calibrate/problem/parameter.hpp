#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/model/field.hpp"

namespace plastica::calibrate {

/// "yield_stress" of "material.yield_stress". Numbers of the field table have no other with the
/// same one.
inline std::string_view last_part(std::string_view path) {
  return path.substr(path.rfind('.') + 1);
}

/// What a fit may do with a parameter.
enum class ParameterRole { Free, Fixed, Tied };

/// In which coordinate the optimizer moves a parameter. Auto: logarithmic if both bounds are
/// above zero, else linear.
enum class ParameterScale { Auto, Linear, Logarithmic };

/// What is known of a parameter before the fit: a normal distribution [SI].
struct Prior {
  double mean = 0.0;
  double standard_deviation = 0.0;  ///< > 0
};

/// One parameter of a fit, as a fit file states it. All values in SI.
struct Parameter {
  const Field* field = nullptr;  ///< a material field; its path is the parameter's name in files
  ParameterRole role = ParameterRole::Free;
  std::optional<double> value;  ///< Fixed: the value. Free: the start, else from the curve
  std::optional<double> lower;  ///< Free: bounds, within the field's range; unset: from the curve,
  std::optional<double> upper;  ///< wide enough to hold any curve of that kind
  ParameterScale scale = ParameterScale::Auto;
  const Field* tied_to = nullptr;  ///< Tied: value = factor * value of that parameter
  double factor = 1.0;
  std::optional<Prior> prior;  ///< Free, and no break strain
  SourceLocation where;        ///< for error lines

  /// The last part of its path: the name that reports use.
  std::string name() const;
};

/// Whether a field is a break strain, in tension or in torsion: a limit, which fits set rather than
/// search.
bool is_break(const Field& field);
inline bool is_break(const Parameter& p) { return is_break(*p.field); }

/// @throws InputError for a prior that is no normal distribution, or of a break strain
void check_prior(const Parameter& p);

/// Checks a fit's parameters: no field twice, values and bounds in range, lower below upper, start
/// between the bounds, ties to a parameter of the fit that is not tied itself, at least one free.
/// @throws InputError naming the parameter
void check_parameters(const std::vector<Parameter>& parameters);

}  // namespace plastica::calibrate
