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
constexpr std::size_t kMostTables = 4;

std::string entry(std::string_view label, std::string_view text) {
  return wrapped(fmt::format("  {:<10}", label), text, kWidth);
}

const FittedParameter* find(const FitRecord& record, std::string_view name) {
  const auto& all = record.result.parameters;
  const auto found = std::ranges::find(all, name, &FittedParameter::name);
  return found == all.end() ? nullptr : &*found;
}

/// The records in the order of a comparison.
LawRecords ranked(const LawRecords& records, const LawComparison& comparison) {
  LawRecords sorted;
  for (const ComparedLaw& law : comparison.laws) {
    sorted.push_back(*std::ranges::find_if(
        records, [&](const FitRecord* record) { return record->result.law == law.fit.law; }));
  }
  return sorted;
}

void add_parameters(const LawRecords& records, Table& table) {
  std::vector<std::string> names;
  for (const FitRecord* record : records) {
    for (const FittedParameter& p : record->result.parameters) {
      if (std::ranges::find(names, p.name) == names.end()) names.push_back(p.name);
    }
  }
  for (const std::string& name : names) {
    FittedParameter typical;
    for (const FitRecord* record : records) {
      const FittedParameter* p = find(*record, name);
      if (p == nullptr) continue;
      const double size = std::max(std::fabs(typical.value), std::fabs(p->value));
      typical = *p;
      typical.value = size;
    }
    const DisplayUnit unit = display_unit(typical);
    std::vector<std::string> cells{printable(name), std::string(unit.name)};
    for (const FitRecord* record : records) {
      const FittedParameter* p = find(*record, name);
      std::string cell = "-";
      if (p != nullptr && p->standard_error) {
        cell = with_error(p->value / unit.scale, *p->standard_error / unit.scale);
      } else if (p != nullptr && p->identified) {
        cell = significant(p->value / unit.scale);
      }
      cells.push_back(std::move(cell));
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

std::string verdicts_of(const LawFit& fit, Verdict verdict) {
  return std::to_string(std::ranges::count(fit.verdicts, verdict));
}

void add_comparison(const LawRecords& records, const LawComparison& comparison, Table& table) {
  table.add_line("");
  add_row(table, "parameters", "", comparison,
          [](const ComparedLaw& law) { return std::to_string(law.fit.parameters.size()); });
  for (const Verdict verdict : {Verdict::Identified, Verdict::Weak, Verdict::NotIdentified,
                                Verdict::AtBound, Verdict::LimitedBySampling}) {
    const bool any = std::ranges::any_of(comparison.laws, [&](const ComparedLaw& law) {
      return std::ranges::find(law.fit.verdicts, verdict) != law.fit.verdicts.end();
    });
    if (!any) continue;
    add_row(table, fmt::format("  {}", name_of(verdict)), "", comparison,
            [&](const ComparedLaw& law) { return verdicts_of(law.fit, verdict); });
  }
  double most = 0.0;
  for (const FitRecord* record : records) most = std::max(most, record->result.misfit_rms);
  const DisplayUnit unit = display_unit(Dimension::Stress, most);
  const auto rms_of = [&](const ComparedLaw& law) {
    return std::sqrt(law.fit.curves.front().mean_square) / unit.scale;
  };
  add_row(table, "misfit, rms", unit.name, comparison,
          [&](const ComparedLaw& law) { return significant(rms_of(law), 4); });
  add_row(table, "  its square f", fmt::format("{}²", unit.name), comparison,
          [&](const ComparedLaw& law) { return significant(rms_of(law) * rms_of(law), 5); });
  add_row(table, "  of the largest stress", "%", comparison,
          [](const ComparedLaw& law) { return significant(100.0 * law.fit.misfit_share, 2); });
  add_criterion(table, "AIC above the least", comparison,
                [](const ComparedLaw& law) { return law.aic; });
  add_criterion(table, "AICc", comparison, [](const ComparedLaw& law) { return law.aicc; });
  add_criterion(table, "BIC", comparison, [](const ComparedLaw& law) { return law.bic; });
  add_row(table, "evaluations", "", comparison,
          [](const ComparedLaw& law) { return std::to_string(law.fit.evaluations); });
}

std::string target_text(const LawRecords& records, const Ink& ink) {
  const LawComparison comparison = compare_laws(records);
  const LawRecords sorted = ranked(records, comparison);
  std::vector<Table::Column> columns{{"", Align::Left}, {"", Align::Left}};
  for (const ComparedLaw& law : comparison.laws) {
    columns.push_back({std::string(name_of(law.fit.law)), Align::Right});
  }
  Table table(std::move(columns));
  add_parameters(sorted, table);
  add_comparison(sorted, comparison, table);
  const Target& target = records.front()->target;
  std::string text = ink.heading(fmt::format("Laws for {}, by BIC\n", printable(target.name))) +
                     table.text(2, kWidth);
  if (!comparison.advised) return text;
  text += entry("samples",
                fmt::format("{}, worth {} to AIC and BIC: weights and neighbours alike",
                            sorted.front()->result.samples, significant(comparison.samples, 3)));
  return text + entry("advised", comparison.advice);
}

/// A row each: misfit by law, and the law that is advised for that target.
std::string targets_text(const std::vector<LawRecords>& targets, const ReportOptions& options,
                         const Ink& ink) {
  std::vector<Table::Column> columns{{"specimen", Align::Left}};
  for (const FitRecord* record : targets.front()) {
    columns.push_back({std::string(name_of(record->result.law)), Align::Right, "% of largest"});
  }
  columns.push_back({"advised", Align::Left});
  Table table(std::move(columns));
  const std::size_t shown = options.specimens_shown == 0
                                ? targets.size()
                                : std::min(targets.size(), options.specimens_shown);
  for (std::size_t t = 0; t < shown; ++t) {
    std::vector<std::string> cells{printable(targets[t].front()->target.name)};
    for (const FitRecord* record : targets[t]) {
      const bool fitted = record->result.status == FitStatus::Fitted;
      cells.push_back(fitted ? significant(100.0 * record->result.misfit_share, 2) : "-");
    }
    const LawComparison comparison = compare_laws(targets[t]);
    cells.emplace_back(comparison.advised ? name_of(comparison.laws[*comparison.advised].fit.law)
                                          : "-");
    table.add(std::move(cells));
  }
  if (shown < targets.size()) {
    table.add_line(fmt::format("… {} left out …", counted(targets.size() - shown, "specimen")));
  }
  return ink.heading("Misfit by law\n") + table.text(2, kWidth);
}

}  // namespace

std::string laws_report(std::span<const FitRecord> records, const ReportOptions& options) {
  if (!compares_laws(records)) return {};
  const Ink ink(options.color);
  const std::vector<LawRecords> targets = by_target(records);
  std::string text;
  if (targets.size() <= kMostTables) {
    for (const LawRecords& target : targets) {
      text += (text.empty() ? "" : "\n") + target_text(target, ink);
    }
  } else {
    text += targets_text(targets, options, ink);
  }
  if (targets.size() == 1) return text;
  const LawComparison all = compare_laws(records);
  if (all.advised) text += entry("for all", all.advice);
  return text;
}

}  // namespace plastica::calibrate
