#include "sweeps/report/spread.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "plastica/report/format.hpp"
#include "plastica/report/table.hpp"
#include "sweeps/compare/convergence.hpp"
#include "sweeps/report/case_rows.hpp"

namespace plastica::sweeps {
namespace {

using report::Table;

constexpr std::size_t kReasons = 3;  ///< of a status

std::vector<double> ranks_of(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return values[a] != values[b] ? values[a] < values[b] : a < b;
  });
  std::vector<double> ranks(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t behind = first + 1;
    while (behind < order.size() && values[order[behind]] == values[order[first]]) ++behind;
    const double mean = 0.5 * static_cast<double>(first + behind - 1);
    for (std::size_t k = first; k < behind; ++k) ranks[order[k]] = mean;
    first = behind;
  }
  return ranks;
}

/// A row of the table of quantiles.
void add_spread(Table& table, const std::string& name, const std::string& unit,
                std::vector<double> numbers, std::optional<double> correlation) {
  if (numbers.empty()) return;
  std::sort(numbers.begin(), numbers.end());
  std::vector<std::string> cells{name, unit, fmt::format("{}", numbers.size())};
  for (const double q : {0.0, 0.05, 0.25, 0.5, 0.75, 0.95, 1.0}) {
    cells.push_back(fmt::format("{:.5g}", quantile(numbers, q)));
  }
  cells.push_back(correlation ? fmt::format("{:.3f}", *correlation) : "");
  table.add(std::move(cells));
}

/// The numbers of an axis, and the values of the cases that have both.
std::pair<std::vector<double>, std::vector<double>> pairs_of(const SweepRecord& record,
                                                             std::size_t axis) {
  std::pair<std::vector<double>, std::vector<double>> pairs;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    const auto* number = std::get_if<double>(&record.at(i, axis));
    if (number == nullptr || !record.results[i].value) continue;
    pairs.first.push_back(*number);
    pairs.second.push_back(*record.results[i].value);
  }
  return pairs;
}

void add_axes(Table& table, const SweepRecord& record) {
  for (const std::size_t a : varied_axes(record)) {
    const Field& field = *record.axes[a].field;
    if (field.kind == FieldKind::Choice) continue;
    std::vector<double> numbers;
    for (std::size_t i = 0; i < record.cases(); ++i) {
      if (const auto* number = std::get_if<double>(&record.at(i, a))) numbers.push_back(*number);
    }
    const auto [x, y] = pairs_of(record, a);
    add_spread(table, std::string(field.path), shown_unit_of(si_unit(field.dimension)),
               std::move(numbers), rank_correlation(x, y));
  }
}

void add_results(Table& table, const SweepRecord& record) {
  std::vector<double> values;
  std::vector<double> errors;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    if (record.results[i].value) values.push_back(*record.results[i].value);
    if (record.comparison.error[i]) errors.push_back(100.0 * std::abs(*record.comparison.error[i]));
  }
  add_spread(table, record.quantity.name, shown_unit_of(record.quantity.unit), std::move(values),
             {});
  add_spread(table, "size of the error", "%", std::move(errors), {});
  std::vector<double> orders;
  for (const RefinementGroup& group : record.groups) {
    const auto fit = convergence_of(group, record.results, record.comparison).fit;
    if (fit.order) orders.push_back(*fit.order);
  }
  add_spread(table, "order of a group", "", std::move(orders), {});
}

std::string failures_of(const SweepRecord& record) {
  struct Failures {
    std::size_t count = 0;
    std::vector<std::string> reasons{};
  };
  std::map<std::string, Failures> all;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    const CaseResult& result = record.results[i];
    if (usable(result.status)) continue;
    Failures& failures = all[std::string(name_of(result.status))];
    ++failures.count;
    const bool known = std::find(failures.reasons.begin(), failures.reasons.end(), result.reason) !=
                       failures.reasons.end();
    if (!known && failures.reasons.size() < kReasons) failures.reasons.push_back(result.reason);
  }
  std::string text;
  for (const auto& [status, failures] : all) {
    text += fmt::format("\n{} {}:\n", failures.count, status);
    for (const std::string& reason : failures.reasons) {
      text += report::wrapped("  - ", report::printable(reason), 100);
    }
  }
  return text;
}

/// The cases at both ends of the values.
std::string extremes_of(const SweepRecord& record) {
  std::optional<std::size_t> least;
  std::optional<std::size_t> largest;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    const auto& value = record.results[i].value;
    if (!value) continue;
    if (!least || *value < *record.results[*least].value) least = i;
    if (!largest || *value > *record.results[*largest].value) largest = i;
  }
  if (!least) return "";
  return fmt::format("  {} is least in case {}, largest in case {}\n", record.quantity.name,
                     record.ids[*least], record.ids[*largest]);
}

}  // namespace

double quantile(std::span<const double> sorted, double q) {
  const double place = q * static_cast<double>(sorted.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(place), sorted.size() - 1);
  if (k + 1 >= sorted.size()) return sorted.back();
  return sorted[k] + (place - static_cast<double>(k)) * (sorted[k + 1] - sorted[k]);
}

std::optional<double> rank_correlation(std::span<const double> x, std::span<const double> y) {
  const std::vector<double> a = ranks_of(x);
  const std::vector<double> b = ranks_of(y);
  const double mean = 0.5 * (static_cast<double>(a.size()) - 1.0);
  double ab = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean) * (b[i] - mean);
    aa += (a[i] - mean) * (a[i] - mean);
    bb += (b[i] - mean) * (b[i] - mean);
  }
  if (!(aa > 0.0 && bb > 0.0)) return std::nullopt;
  return ab / std::sqrt(aa * bb);
}

std::string spread_report(const SweepRecord& record) {
  const auto right = Table::Align::Right;
  Table table({{"", Table::Align::Left},
               {"", Table::Align::Left},
               {"cases"},
               {"min"},
               {"5 %"},
               {"25 %"},
               {"median"},
               {"75 %"},
               {"95 %"},
               {"max"},
               {"rank corr.", right}});
  add_axes(table, record);
  add_results(table, record);
  std::string text = table.text(2, 140) + extremes_of(record);
  const bool ranked = !varied_axes(record).empty();
  if (ranked) text += "  rank corr.: Spearman's rank correlation of the axis and the value\n";
  return text + failures_of(record);
}

}  // namespace plastica::sweeps
