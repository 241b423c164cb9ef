#include "calibrate/inference/fit_intervals.hpp"

#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <string>
#include <vector>

#include "calibrate/inference/coupon_intervals.hpp"
#include "calibrate/search/fit_interrupted.hpp"

namespace plastica::calibrate {
namespace {

FitIntervals found_intervals(const Target& target, const FitOptions& options,
                             const FitResult& result, std::vector<std::string>& warnings) {
  const IntervalOptions& how = options.intervals;
  FitIntervals intervals;
  CouponProblem problem(target, options, result);
  if (!std::isfinite(problem.cost())) {
    warnings.emplace_back("there is no profile and no bootstrap: the model cannot be run again");
    return intervals;
  }
  if (how.profile) intervals.profiles = profile_coupon(problem, options.confidence);
  const std::size_t samples = problem.entered().size();
  if (how.bootstrap > 0 && static_cast<std::size_t>(how.block) > samples) {
    warnings.push_back(
        fmt::format("there is no bootstrap: blocks of {} residuals are longer than the {} samples",
                    how.block, samples));
  } else if (how.bootstrap > 0) {
    intervals.residuals = bootstrap_coupon(problem, options, result.seed);
  }
  std::vector<std::string> names;
  for (const FittedParameter* parameter : result.free_parameters()) {
    names.push_back(parameter->name());
  }
  add_warnings(intervals, names, "search longer (fit.stop)", warnings);
  return intervals;
}

}  // namespace

void add_intervals(const Target& target, const FitOptions& options, FitResult& result) {
  const IntervalOptions& how = options.intervals;
  if (result.status != FitStatus::Fitted || !(how.profile || how.bootstrap > 0)) return;
  std::vector<std::string> warnings;
  try {
    result.intervals = found_intervals(target, options, result, warnings);
  } catch (const FitInterrupted&) {
    throw;
  } catch (const std::exception& error) {
    // The fit stands.
    warnings.push_back(fmt::format("there is no profile and no bootstrap: {}", error.what()));
  }
  result.warnings.insert(result.warnings.end(), warnings.begin(), warnings.end());
}

}  // namespace plastica::calibrate
