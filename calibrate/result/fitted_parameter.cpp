#include "calibrate/result/fitted_parameter.hpp"

#include <cmath>

namespace plastica::calibrate {

std::string FittedParameter::name() const { return std::string(last_part(path)); }

bool FittedParameter::is_break() const {
  const Field* field = find_field_or_null(path);
  return field != nullptr && calibrate::is_break(*field);
}

double FittedParameter::scatter_error() const { return std::hypot(noise_error, sampling_error); }

double FittedParameter::model_error() const {
  return std::isfinite(misfit_error) ? std::hypot(noise_error, misfit_error) : noise_error;
}

}  // namespace plastica::calibrate
