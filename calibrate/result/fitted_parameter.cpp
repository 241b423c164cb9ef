#include "calibrate/result/fitted_parameter.hpp"

#include <cmath>

namespace plastica::calibrate {

std::string FittedParameter::name() const { return std::string(last_part(path)); }

bool FittedParameter::is_break() const {
  const Field* field = find_field_or_null(path);
  return field != nullptr && calibrate::is_break(*field);
}

void FittedParameter::follow(const FittedParameter& base, double factor) {
  identified = base.identified;
  if (!base.has_error()) return;
  const double size = std::abs(factor);
  standard_error = size * base.standard_error;
  noise_error = size * base.noise_error;
  sampling_error = size * base.sampling_error;
  misfit_error = size * base.misfit_error;
  degrees_of_freedom = base.degrees_of_freedom;
  interval_low = factor * (factor > 0.0 ? base.interval_low : base.interval_high);
  interval_high = factor * (factor > 0.0 ? base.interval_high : base.interval_low);
}

double FittedParameter::scatter_error() const { return std::hypot(noise_error, sampling_error); }

double FittedParameter::model_error() const {
  return std::isfinite(misfit_error) ? std::hypot(noise_error, misfit_error) : noise_error;
}

}  // namespace plastica::calibrate
