#include "calibrate/result/result.hpp"

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

const FittedParameter& FitResult::parameter(std::string_view name) const {
  for (const FittedParameter& parameter : parameters) {
    if (parameter.name() == name) return parameter;
  }
  throw std::out_of_range("no parameter " + std::string(name));
}

std::vector<const FittedParameter*> FitResult::free_parameters() const {
  std::vector<const FittedParameter*> free;
  for (const FittedParameter& parameter : parameters) {
    if (parameter.role == ParameterRole::Free) free.push_back(&parameter);
  }
  return free;
}

}  // namespace plastica::calibrate
