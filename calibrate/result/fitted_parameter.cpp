#include "calibrate/result/fitted_parameter.hpp"

namespace plastica::calibrate {

std::string FittedParameter::name() const { return path.substr(path.rfind('.') + 1); }

}  // namespace plastica::calibrate
