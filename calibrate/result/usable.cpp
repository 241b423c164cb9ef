#include "calibrate/result/usable.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plastica::calibrate {
namespace {

constexpr double kMostMisfit = 0.5;
constexpr std::size_t kMostAtBounds = 1;

/// Whether a bound is a place where a right value may lie.
bool may_end_at_bound(const FittedParameter& parameter) {
  const std::string name = parameter.name();
  return (parameter.at_lower && parameter.lower == 0.0) || name.starts_with("break_") ||
         name == "kinematic_fraction";
}

std::string why_unusable(const FitOutcome& outcome, double misfit) {
  if (!outcome.is_fitted()) return {};
  std::string why;
  if (misfit > kMostMisfit) {
    why = fmt::format("the misfit is {:.0f} % of the largest value, above {:.0f} %", 100.0 * misfit,
                      100.0 * kMostMisfit);
  }
  std::size_t count = 0;
  std::string names;
  for (const FittedParameter* parameter : outcome.free_parameters()) {
    if (!parameter->at_bound() || may_end_at_bound(*parameter)) continue;
    ++count;
    names += (names.empty() ? "" : ", ") + parameter->name();
  }
  if (count > kMostAtBounds) {
    why +=
        (why.empty() ? "" : "; ") + fmt::format("{} parameters ended at bounds: {}", count, names);
  }
  return why;
}

}  // namespace

std::string why_unusable(const FitResult& result) {
  return why_unusable(result, result.misfit_fraction);
}

std::string why_unusable(const SceneFitResult& result) {
  double misfit = 0.0;
  for (const TargetFit& of_target : result.targets) {
    misfit = std::fmax(misfit, of_target.misfit_fraction);
  }
  return why_unusable(result, misfit);
}

std::string why_no_answer(const FittedParameter& parameter) {
  const std::string name = parameter.name();
  if (parameter.role == ParameterRole::Fixed) return name + " is fixed: nothing was fitted";
  if (!parameter.identified) return name + " is not identified by the curves";
  const bool at_zero = parameter.at_lower && parameter.lower == 0.0;
  return parameter.at_bound() && !at_zero ? name + " ended at its bound" : std::string();
}

}  // namespace plastica::calibrate
