#pragma once

#include <string>
#include <string_view>

#include "calibrate/report/format.hpp"
#include "calibrate/result/fitted_parameter.hpp"

/// How a fitted parameter looks in everything that people read; not installed.
namespace plastica::calibrate::report {

/// "yield_stress" of "material.yield_stress", printable.
std::string short_name(std::string_view path);
/// The unit in which it is shown at its value.
DisplayUnit display_unit(const FittedParameter& parameter);

std::string_view word_of_bound(const FittedParameter& parameter);  ///< "lower", "upper", "" if off

/// "205.0 ± 1.2", or the value alone where there is no error.
std::string value_text(const FittedParameter& parameter, const DisplayUnit& unit);
/// "202.6 … 207.4"; empty without one.
std::string interval_text(const FittedParameter& parameter, const DisplayUnit& unit);
/// The word and the number behind it: "identified, error 0.59 %", "at bound, upper 380 MPa"; of
/// what was not judged its role.
std::string verdict_text(const FittedParameter& parameter);

}  // namespace plastica::calibrate::report
