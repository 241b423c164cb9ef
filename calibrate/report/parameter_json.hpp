#pragma once

#include "calibrate/report/described.hpp"
#include "calibrate/report/format.hpp"
#include "calibrate/result/fitted_parameter.hpp"

namespace plastica::calibrate::report {

/// What a summary for scripts says of a parameter; SI.
inline Json json_of(const FittedParameter& parameter) {
  Json object = {{"path", parameter.path},
                 {"unit", si_unit(parameter.dimension)},
                 {"role", word_of(parameter.role)}};
  JsonDescriber described(object, &parameter);
  kDescribeParameter(described);
  return object;
}

}  // namespace plastica::calibrate::report
