#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "calibrate/report/text.hpp"
#include "calibrate/result/fit_outcome.hpp"
#include "plastica/report/ink.hpp"

/// Sections that the report of every fit has; not installed. Each is empty where there is nothing
/// to say, and begins with an empty line.
namespace plastica::calibrate::report {

/// Values with errors, intervals and verdicts, a line each.
/// @param notes_on  what stands below a parameter's line; may be empty
std::string parameters_text(
    const FitOutcome& fit, const ReportOptions& options, const plastica::report::Ink& ink,
    const std::function<std::vector<std::string>(const FittedParameter&)>& notes_on = {});

/// A pair of parameters that the curves determine by their combination rather than by themselves.
struct StrongCorrelation {
  const FittedParameter* a = nullptr;
  const FittedParameter* b = nullptr;
  double value = 0.0;
};
/// Those beyond `kStrongCorrelation`. @param of  what the matrix is of (n)
std::vector<StrongCorrelation> strong_correlations(const std::vector<const FittedParameter*>& of,
                                                   const std::vector<double>& correlation);
std::string correlations_text(const std::vector<StrongCorrelation>& all,
                              const plastica::report::Ink& ink);

/// @tparam Result  of any kind of fit
template <typename Result>
std::vector<StrongCorrelation> strong_correlations(const Result& result) {
  return strong_correlations(result.correlated_parameters(), result.correlation);
}

std::string warnings_text(std::initializer_list<const std::vector<std::string>*> lists,
                          const plastica::report::Ink& ink);

}  // namespace plastica::calibrate::report
