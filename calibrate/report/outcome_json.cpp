#include "calibrate/report/outcome_json.hpp"

#include <string>
#include <utility>
#include <vector>

#include "calibrate/report/described.hpp"
#include "calibrate/report/shown_intervals.hpp"

namespace plastica::calibrate::report {
namespace {

Json parameter_json(const FittedParameter& parameter) {
  Json object = {{"path", parameter.path},
                 {"unit", si_unit(parameter.dimension)},
                 {"role", word_of(parameter.role)}};
  return json_of(described(&parameter, kDescribeParameter), std::move(object));
}

/// Rows of the matrix; empty if the fit gave none.
Json correlation_json(const FitOutcome& outcome,
                      const std::vector<const FittedParameter*>& correlated) {
  std::vector<std::string> names;
  names.reserve(correlated.size());
  for (const FittedParameter* parameter : correlated) names.push_back(parameter->name());
  Json matrix = matrix_json(outcome.correlation, names.size());
  if (matrix.empty()) names.clear();
  return {{"parameters", std::move(names)}, {"matrix", std::move(matrix)}};
}

}  // namespace

Json matrix_json(std::span<const double> values, std::size_t n) {
  Json rows = Json::array();
  if (values.size() != n * n) return rows;
  for (std::size_t i = 0; i < n; ++i) rows.push_back(numbers(values.subspan(i * n, n)));
  return rows;
}

void add_outcome(Json& fit, const FitOutcome& outcome,
                 const std::vector<const FittedParameter*>& correlated) {
  Json parameters = Json::object();
  for (const FittedParameter& parameter : outcome.parameters) {
    parameters[parameter.name()] = parameter_json(parameter);
  }
  fit["parameters"] = std::move(parameters);
  fit["correlation"] = correlation_json(outcome, correlated);
  const FitIntervals& intervals = outcome.intervals;
  const bool any = !intervals.profiles.empty() || intervals.residuals.resamples > 0 ||
                   intervals.specimens.resamples > 0;
  if (any) fit["intervals"] = intervals_json(shown_intervals(outcome));
}

}  // namespace plastica::calibrate::report
