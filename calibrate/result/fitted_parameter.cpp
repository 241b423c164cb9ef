#include "calibrate/result/fitted_parameter.hpp"

namespace plastica::calibrate {

std::string FittedParameter::name() const { return std::string(last_part(path)); }

}  // namespace plastica::calibrate
