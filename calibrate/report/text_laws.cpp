#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/format.hpp"
#include "calibrate/report/law_choice.hpp"
#include "plastica/report/ink.hpp"
#include "plastica/report/table.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;
using plastica::report::Ink;
using plastica::report::kWidth;
using plastica::report::Table;
using Align = Table::Align;

/// Targets that have a table of their own at most.
constexpr std::size_t kMaxTables = 4;

std::string law_entry(std::string_view label, std::string_view text) {
  return wrapped(fmt::format("  {:<10}", label), text, kWidth);
}

/// What the table shows of a parameter.
struct LawParameter {
  std::string path;
  Dimension dimension = Dimension::None;
  double value = 0.0;
  double error = 0.0;  ///< NaN: none
  bool shown = true;

  std::string name() const { return printable(last_part(path)); }
};

std::vector<LawParameter> parameters_of(const FitRecord& record) {
  std::vector<LawParameter> all;
  for (const FittedParameter& p : record.result.parameters) {
    all.push_back({p.path, p.dimension, p.value, p.standard_error, p.has_error() || p.identified});
  }
  return all;
}

std::vector<LawParameter> parameters_of(const SceneFitRecord& record) {
  std::vector<LawParameter> all;
  for (const FittedParameter& p : record.result.parameters) {
    all.push_back({p.path, p.dimension, p.value, p.standard_error,
                   p.role == ParameterRole::Fixed || p.verdict() != Verdict::NotIdentified});
  }
  return all;
}

std::size_t samples_of(const FitRecord& record) { return record.result.samples; }
std::size_t samples_of(const SceneFitRecord& record) {
  std::size_t samples = 0;
  for (const TargetFit& of_target : record.result.targets) samples += of_target.samples;
  return samples;
}

template <typename Record>
using Records = std::vector<const Record*>;

/// The records in the order of a comparison.
template <typename Record>
Records<Record> ranked(const Records<Record>& records, const LawComparison& comparison) {
  Records<Record> sorted;
  for (const ComparedLaw& law : comparison.laws) {
    sorted.push_back(*std::ranges::find_if(
        records, [&](const Record* record) { return record->result.law == law.fit.law; }));
  }
  return sorted;
}

std::string cell_of(const LawParameter& p, const DisplayUnit& unit) {
  if (!p.shown) return "-";
  if (std::isfinite(p.error)) return with_error(p.value / unit.scale, p.error / unit.scale);
  return significant(p.value / unit.scale);
}

template <typename Record>
void add_parameters(const Records<Record>& records, Table& table) {
  std::vector<std::vector<LawParameter>> all;
  std::vector<LawParameter> largest;
  for (const Record* record : records) {
    all.push_back(parameters_of(*record));
    for (const LawParameter& p : all.back()) {
      const auto found = std::ranges::find(largest, p.path, &LawParameter::path);
      if (found == largest.end()) {
        largest.push_back(p);
      } else if (std::fabs(p.value) > std::fabs(found->value)) {
        found->value = p.value;
      }
    }
  }
  for (const LawParameter& typical : largest) {
    const DisplayUnit unit =
        display_unit_of(typical.path, typical.dimension, std::fabs(typical.value));
    std::vector<std::string> cells{typical.name(), std::string(unit.name)};
    for (const std::vector<LawParameter>& of_law : all) {
      const auto found = std::ranges::find(of_law, typical.path, &LawParameter::path);
      cells.push_back(found == of_law.end() ? "-" : cell_of(*found, unit));
    }
    table.add(std::move(cells));
  }
}

template <typename Cell>
void add_row(Table& table, std::string_view label, std::string_view unit,
             const LawComparison& comparison, const Cell& cell) {
  std::vector<std::string> cells{std::string(label), std::string(unit)};
  for (const ComparedLaw& law : comparison.laws) {
    cells.push_back(law.fit.fitted ? cell(law) : std::string("-"));
  }
  table.add(std::move(cells));
}

/// A criterion above the least of all.
template <typename Value>
void add_criterion(Table& table, std::string_view label, const LawComparison& comparison,
                   const Value& value) {
  double least = std::numeric_limits<double>::infinity();
  for (const ComparedLaw& law : comparison.laws) least = std::min(least, value(law));
  add_row(table, label, "", comparison, [&](const ComparedLaw& law) {
    const double above = value(law) - least;
    return std::isfinite(above) ? fmt::format("{:+.1f}", above) : std::string("-");
  });
}

double rms_of(const ComparedLaw& law, std::size_t curve) {
  return std::sqrt(law.fit.curves[curve].mean_square);
}

/// In the unit of the largest of a curve.
DisplayUnit unit_of(const LawComparison& comparison, Dimension dimension) {
  double most = 0.0;
  for (const ComparedLaw& law : comparison.laws) {
    if (law.fit.fitted) most = std::max(most, rms_of(law, 0));
  }
  return display_unit(dimension, most);
}

void add_rms(Table& table, const LawComparison& comparison, const DisplayUnit& unit) {
  add_row(table, "misfit, rms", unit.name, comparison,
          [&](const ComparedLaw& law) { return significant(rms_of(law, 0) / unit.scale, 4); });
}

void add_misfit(const Records<FitRecord>& /*records*/, const LawComparison& comparison,
                Table& table) {
  const DisplayUnit unit = unit_of(comparison, Dimension::Stress);
  add_rms(table, comparison, unit);
  add_row(table, "  its square f", fmt::format("{}²", unit.name), comparison,
          [&](const ComparedLaw& law) {
            const double rms = rms_of(law, 0) / unit.scale;
            return significant(rms * rms, 5);
          });
  add_row(table, "  of the largest stress", "%", comparison,
          [](const ComparedLaw& law) { return significant(100.0 * law.fit.misfit_fraction, 2); });
}

/// The misfit of each target as a fraction; of a lone one its size, too.
void add_misfit(const Records<SceneFitRecord>& records, const LawComparison& comparison,
                Table& table) {
  const std::vector<SceneTarget>& targets = records.front()->targets;
  if (targets.size() == 1) {
    add_rms(table, comparison, unit_of(comparison, targets.front().ordinate_is));
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    add_row(table,
            targets.size() == 1 ? "  of the largest value"
                                : fmt::format("misfit of {}", printable(targets[i].name)),
            "%", comparison, [&](const ComparedLaw& law) {
              const double largest = law.fit.curves[i].largest;
              return largest > 0.0 ? significant(100.0 * rms_of(law, i) / largest, 2)
                                   : std::string("-");
            });
  }
}

/// The misfit of what the laws have not seen, if it is known.
void add_unseen(Table& table, std::string_view label, const LawComparison& comparison,
                double ComparedLaw::*misfit) {
  const auto is_known = [&](const ComparedLaw& law) { return std::isfinite(law.*misfit); };
  if (std::ranges::none_of(comparison.laws, is_known)) return;
  add_row(table, label, "%", comparison, [&](const ComparedLaw& law) {
    return is_known(law) ? significant(100.0 * law.*misfit, 2) : std::string("-");
  });
}

template <typename Record>
void add_comparison(const Records<Record>& records, const LawComparison& comparison, Table& table) {
  table.add_line("");
  add_row(table, "parameters", "", comparison,
          [](const ComparedLaw& law) { return std::to_string(law.fit.parameters.size()); });
  for (const Verdict verdict :
       {Verdict::Identified, Verdict::Weak, Verdict::NotIdentified, Verdict::AtBound,
        Verdict::LimitedBySampling, Verdict::LimitedBySegments, Verdict::FromPrior}) {
    const auto count = [&](const ComparedLaw& law) {
      return std::ranges::count(law.fit.verdicts, verdict);
    };
    if (std::ranges::none_of(comparison.laws, [&](const auto& law) { return count(law) > 0; })) {
      continue;
    }
    add_row(table, fmt::format("  {}", calibrate::name_of(verdict)), "", comparison,
            [&](const ComparedLaw& law) { return std::to_string(count(law)); });
  }
  add_misfit(records, comparison, table);
  add_unseen(table, "  of parts held out", comparison, &ComparedLaw::held_out);
  add_unseen(table, "  of specimens not seen", comparison, &ComparedLaw::unseen);
  if (comparison.is_informed) {
    add_criterion(table, "AIC above the least", comparison,
                  [](const ComparedLaw& law) { return law.aic; });
    add_criterion(table, "AICc", comparison, [](const ComparedLaw& law) { return law.aicc; });
    add_criterion(table, "BIC", comparison, [](const ComparedLaw& law) { return law.bic; });
  }
  add_row(table, "evaluations", "", comparison,
          [](const ComparedLaw& law) { return std::to_string(law.fit.evaluations); });
  const auto any = [&](const auto& has) { return std::ranges::any_of(comparison.laws, has); };
  if (any([](const ComparedLaw& law) { return law.fit.runs > 0; })) {
    add_row(table, "runs of scenes", "", comparison,
            [](const ComparedLaw& law) { return std::to_string(law.fit.runs); });
  }
  if (any([](const ComparedLaw& law) { return std::isfinite(law.fit.seconds); })) {
    add_row(table, "time", "s", comparison, [](const ComparedLaw& law) {
      return std::isfinite(law.fit.seconds) ? significant(law.fit.seconds, 2) : std::string("-");
    });
  }
}

/// Why laws of a target were not fitted, an entry each.
/// @param name  of the target, before the law; empty: it is said already
template <typename Record>
std::string failures_of(const Records<Record>& records, const std::string& name) {
  std::string text;
  for (const Record* record : records) {
    const auto& result = record->result;
    if (result.status != FitStatus::Failed) continue;
    std::string failure = name.empty() ? "" : printable(name) + ", ";
    failure += fmt::format("{}: {}", calibrate::name_of(result.law), printable(result.reason));
    text += law_entry("failed", failure);
  }
  return text;
}

template <typename Record>
std::string target_text(const Records<Record>& records, const Ink& ink) {
  const LawComparison comparison = compare_laws(records);
  const Records<Record> sorted = ranked(records, comparison);
  std::vector<Table::Column> columns{{"", Align::Left}, {"", Align::Left}};
  for (const ComparedLaw& law : comparison.laws) {
    columns.push_back({std::string(calibrate::name_of(law.fit.law)), Align::Right});
  }
  Table table(std::move(columns));
  add_parameters(sorted, table);
  add_comparison(sorted, comparison, table);
  std::string text =
      ink.heading(fmt::format("Laws for {}, by {}\n", printable(name_of(*records.front())),
                              calibrate::name_of(comparison.ranked_by))) +
      table.text(2, kWidth) + failures_of(sorted, "");
  if (!comparison.advised) return text;
  text += law_entry(
      "samples",
      fmt::format("{}, worth {}, by weights and neighbours alike{}", samples_of(*sorted.front()),
                  significant(comparison.samples, 3),
                  comparison.is_informed ? ": what AIC and BIC count"
                                         : ": too few to compare by information (AIC, BIC)"));
  return text + law_entry("advised", comparison.advice);
}

double fraction_of(const FitRecord& record) { return record.result.misfit_fraction; }
double fraction_of(const SceneFitRecord& record) {
  double most = 0.0;
  for (const TargetFit& of_target : record.result.targets)
    most = std::max(most, of_target.misfit_fraction);
  return most;
}

/// A row each: misfit by law, and the law that is advised for that target.
template <typename Record>
std::string targets_text(const std::vector<Records<Record>>& targets, const ReportOptions& options,
                         const Ink& ink) {
  std::vector<Table::Column> columns{{"specimen", Align::Left}};
  for (const Record* record : targets.front()) {
    columns.push_back(
        {std::string(calibrate::name_of(record->result.law)), Align::Right, "% of largest"});
  }
  columns.push_back({"advised", Align::Left});
  Table table(std::move(columns));
  const std::size_t shown = options.specimens_shown == 0
                                ? targets.size()
                                : std::min(targets.size(), options.specimens_shown);
  for (std::size_t t = 0; t < shown; ++t) {
    std::vector<std::string> cells{printable(name_of(*targets[t].front()))};
    for (const Record* record : targets[t]) {
      const bool fitted = record->result.status == FitStatus::Fitted;
      cells.push_back(fitted ? significant(100.0 * fraction_of(*record), 2) : "-");
    }
    const LawComparison comparison = compare_laws(targets[t]);
    cells.emplace_back(comparison.advised
                           ? calibrate::name_of(comparison.laws[*comparison.advised].fit.law)
                           : "-");
    table.add(std::move(cells));
  }
  if (shown < targets.size()) {
    table.add_line(fmt::format("… {} left out …", counted(targets.size() - shown, "specimen")));
  }
  std::string failures;
  for (std::size_t t = 0; t < shown; ++t) {
    failures += failures_of(targets[t], name_of(*targets[t].front()));
  }
  return ink.heading("Misfit by law\n") + table.text(2, kWidth) + failures;
}

template <typename Record>
std::string report_of(std::span<const Record> records, const ReportOptions& options) {
  if (!compares_laws(records)) return {};
  const Ink ink(options.color);
  const std::vector<Records<Record>> targets = by_target(records);
  std::string text;
  if (targets.size() <= kMaxTables) {
    for (const Records<Record>& target : targets) {
      text += (text.empty() ? "" : "\n") + target_text(target, ink);
    }
  } else {
    text += targets_text(targets, options, ink);
  }
  if (targets.size() == 1) return text;
  const LawComparison all = compare_laws(records);
  if (all.advised) text += law_entry("for all", all.advice);
  return text;
}

}  // namespace

std::string laws_report(std::span<const FitRecord> records, const ReportOptions& options) {
  return report_of(records, options);
}

std::string laws_report(std::span<const SceneFitRecord> records, const ReportOptions& options) {
  return report_of(records, options);
}

}  // namespace plastica::calibrate
