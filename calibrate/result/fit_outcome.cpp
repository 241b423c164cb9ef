#include "calibrate/result/fit_outcome.hpp"

#include <algorithm>
#include <stdexcept>

#include "calibrate/inference/compare_laws.hpp"
#include "calibrate/result/result.hpp"

namespace plastica::calibrate {

std::string_view name_of(FitStatus status) {
  switch (status) {
    case FitStatus::Fitted: return "fitted";
    case FitStatus::Failed: return "failed";
    case FitStatus::Rejected: return "rejected";
  }
  return "unknown";
}

double FitOutcome::held_out_misfit() const { return unseen_misfit(held_out); }

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

std::size_t FitOutcome::free_count() const {
  return static_cast<std::size_t>(
      std::ranges::count(parameters, ParameterRole::Free, &FittedParameter::role));
}

std::vector<const FittedParameter*> FitResult::correlated_parameters() const {
  std::vector<const FittedParameter*> correlated;
  for (const std::uint32_t index : trace.active) {
    if (index < parameters.size()) correlated.push_back(&parameters[index]);
  }
  return correlated;
}

}  // namespace plastica::calibrate
