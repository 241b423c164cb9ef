#include "calibrate/report/outcome_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "calibrate/report/parameter_words.hpp"
#include "plastica/report/table.hpp"

namespace plastica::calibrate::report {

using plastica::report::Ink;
using plastica::report::kWidth;
using plastica::report::Table;

std::string parameters_text(
    const FitOutcome& fit, const ReportOptions& options, const Ink& ink,
    const std::function<std::vector<std::string>(const FittedParameter&)>& notes_on) {
  if (fit.parameters.empty()) return {};
  using enum Table::Align;
  Table table({{"", Left},
               {"value ± error", PlusMinus},
               {"", Left},
               {fmt::format("{:.4g} % interval", 100.0 * options.confidence), Range},
               {"verdict", Left}});
  for (const FittedParameter& parameter : fit.parameters) {
    const DisplayUnit unit = display_unit(parameter);
    // Of a break limit that no break shows, what the fit began with is no value.
    const bool is_start = parameter.is_break() && parameter.role == ParameterRole::Free &&
                          !parameter.identified && !parameter.at_bound();
    table.add({short_name(parameter.path), is_start ? "-" : value_text(parameter, unit),
               is_start ? "" : std::string(unit.name), interval_text(parameter, unit),
               verdict_text(parameter)});
    if (!notes_on) continue;
    for (std::string& note : notes_on(parameter)) table.add_note(std::move(note));
  }
  return '\n' + ink.heading("Parameters\n") + table.text(2, kWidth);
}

std::vector<StrongCorrelation> strong_correlations(const std::vector<const FittedParameter*>& of,
                                                   const std::vector<double>& correlation) {
  const std::size_t n = of.size();
  std::vector<StrongCorrelation> all;
  if (correlation.size() != n * n) return all;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      const double value = correlation[a * n + b];
      if (std::fabs(value) > kStrongCorrelation) all.push_back({of[a], of[b], value});
    }
  }
  return all;
}

std::string correlations_text(const std::vector<StrongCorrelation>& all, const Ink& ink) {
  Table table({{"", Table::Align::Left}, {"", Table::Align::Right}});
  for (const StrongCorrelation& pair : all) {
    table.add({short_name(pair.a->path) + ", " + short_name(pair.b->path),
               fmt::format("{:+.3f}", pair.value)});
  }
  if (table.rows() == 0) return {};
  const std::string heading = fmt::format("Correlations above {}\n", kStrongCorrelation);
  return '\n' + ink.heading(heading) + table.text(2, kWidth);
}

std::string warnings_text(std::initializer_list<const std::vector<std::string>*> lists,
                          const Ink& ink) {
  std::string text;
  for (const std::vector<std::string>* list : lists) {
    for (const std::string& warning : *list) text += wrapped("  ! ", printable(warning), kWidth);
  }
  return text.empty() ? text : '\n' + ink.bad("Warnings\n") + text;
}

}  // namespace plastica::calibrate::report
