#include "calibrate/result/fit_outcome.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace plastica::calibrate {

std::string_view name_of(FitStatus status) {
  switch (status) {
    case FitStatus::Fitted: return "fitted";
    case FitStatus::Failed: return "failed";
    case FitStatus::Rejected: return "rejected";
  }
  return "unknown";
}

double FitOutcome::held_out_misfit() const {
  if (held_out.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (const double part : held_out) sum += part;
  return std::sqrt(sum / static_cast<double>(held_out.size()));
}

const FittedParameter* FitOutcome::find_parameter(std::string_view name) const {
  for (const FittedParameter& parameter : parameters) {
    if (parameter.path == name || parameter.name() == name) return &parameter;
  }
  return nullptr;
}

const FittedParameter& FitOutcome::parameter(std::string_view name) const {
  if (const FittedParameter* found = find_parameter(name)) return *found;
  throw std::out_of_range("no parameter " + std::string(name));
}

std::vector<const FittedParameter*> FitOutcome::free_parameters() const {
  std::vector<const FittedParameter*> free;
  for (const FittedParameter& parameter : parameters) {
    if (parameter.role == ParameterRole::Free) free.push_back(&parameter);
  }
  return free;
}

}  // namespace plastica::calibrate
