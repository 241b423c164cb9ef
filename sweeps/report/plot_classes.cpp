#include "sweeps/report/plot_classes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "plastica/report/format.hpp"

namespace plastica::sweeps {
namespace {

constexpr std::size_t kMaxClasses = 7;
constexpr std::string_view kRampLetters = ".:-=+*#";

std::string bound_text(double value) {
  return value >= 1e3 && value < 1e6 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

/// Classes of the size of the error in %, the finest first.
void classify_errors(const PlotCases& cases, CaseClasses& out) {
  const SweepRecord& record = cases.record;
  out.what = "size of the error of " + report::printable(record.quantity.name) + " [%]";
  double least = 0.0;
  double largest = 0.0;
  const auto percent_of = [&](std::size_t i) {
    return 100.0 * std::abs(record.comparison.error[i].value_or(0.0));
  };
  for (std::size_t i = 0; i < record.cases(); ++i) {
    if (!cases.picked[i] || percent_of(i) == 0.0) continue;
    least = least > 0.0 ? std::min(least, percent_of(i)) : percent_of(i);
    largest = std::max(largest, percent_of(i));
  }
  if (least == 0.0) return;
  const std::vector<double> bounds = bounds_between(least, largest);
  const std::size_t count = bounds.size() - 1;
  for (std::size_t k = 0; k < count; ++k) {
    const std::string name =
        (k == 0 ? "below " : bound_text(bounds[k]) + " … ") + bound_text(bounds[k + 1]) + " %";
    const double fraction =
        count == 1 ? 0.5 : static_cast<double>(k) / static_cast<double>(count - 1);
    out.classes.push_back({name, ramp_color(fraction), kRampLetters[k], fraction});
  }
  for (std::size_t i = 0; i < record.cases(); ++i) {
    if (!cases.picked[i] || !record.comparison.error[i]) continue;
    out.number[i] = report::significant(percent_of(i), 2);
    out.amount[i] = percent_of(i);
    const auto above = std::upper_bound(bounds.begin() + 1, bounds.end() - 1, percent_of(i));
    out.class_of[i] = static_cast<std::size_t>(above - bounds.begin()) - 1;
  }
}

/// Classes of equal width of the value.
void classify_values(const PlotCases& cases, CaseClasses& out) {
  const SweepRecord& record = cases.record;
  std::optional<double> low;
  std::optional<double> high;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    const auto& value = record.results[i].value;
    if (!cases.picked[i] || !value) continue;
    low = std::min(low.value_or(*value), *value);
    high = std::max(high.value_or(*value), *value);
  }
  if (!low) return;
  const ShownNumbers shown = shown_value(record, std::max(std::abs(*low), std::abs(*high)));
  out.what = shown.label;
  const std::size_t count = *high > *low ? kMaxClasses : 1;
  const double step = (*high - *low) / static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double from = *low + step * static_cast<double>(k);
    const double fraction = static_cast<double>(k) / (kMaxClasses - 1);
    out.classes.push_back({count == 1 ? bound_text(*low / shown.scale)
                                      : bound_text(from / shown.scale) + " … " +
                                            bound_text((from + step) / shown.scale),
                           ramp_color(fraction), kRampLetters[k], fraction});
  }
  for (std::size_t i = 0; i < record.cases(); ++i) {
    const auto& value = record.results[i].value;
    if (!cases.picked[i] || !value) continue;
    out.amount[i] = *value / shown.scale;
    out.number[i] = fmt::format("{:.3g}", *out.amount[i]);
    const double place = count == 1 ? 0.0 : (*value - *low) / step;
    out.class_of[i] = std::min(static_cast<std::size_t>(place), count - 1);
  }
}

/// What a case without an error is shown as.
std::string class_without_error(const SweepRecord& record, std::size_t i) {
  const std::string& reason = record.comparison.reason[i];
  if (reason.starts_with(kNotConverged)) return "not converged";
  if (reason.starts_with(kEndsOtherwise)) return "ends otherwise";
  if (reason == kIsReference || reason == kIsRunOfReference) return "reference";
  return std::string(name_of(record.results[i].status));
}

/// A class for each status of the cases that have none yet.
void classify_statuses(const PlotCases& cases, CaseClasses& out) {
  constexpr std::array<std::string_view, 5> kColors{"#B8B8B8", "#7A1F1F", "#D55E00", "#5A5A5A",
                                                    "#E8E8E8"};
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < cases.record.cases(); ++i) {
    if (!cases.picked[i] || out.class_of[i]) continue;
    const std::string name = class_without_error(cases.record, i);
    const auto [place, is_new] = known.emplace(name, out.classes.size());
    if (is_new) {
      const std::size_t k = known.size() - 1;
      out.classes.push_back({name, std::string(kColors[k % kColors.size()]), name.front()});
    }
    out.class_of[i] = place->second;
  }
}

}  // namespace

std::vector<double> bounds_between(double low, double high) {
  const std::array<std::vector<double>, 3> ladders{{{1.0, 2.0, 5.0}, {1.0, 3.0}, {1.0}}};
  std::vector<double> bounds;
  for (const std::vector<double>& ladder : ladders) {
    bounds.clear();
    const int first = static_cast<int>(std::floor(std::log10(low)));
    const int last = static_cast<int>(std::floor(std::log10(high))) + 1;
    for (int power = first; power <= last; ++power) {
      for (const double factor : ladder) bounds.push_back(factor * std::pow(10.0, power));
    }
    while (bounds.size() > 2 && bounds[1] <= low) bounds.erase(bounds.begin());
    while (bounds.size() > 2 && bounds[bounds.size() - 2] > high) bounds.pop_back();
    if (bounds.size() <= kMaxClasses + 1) break;
  }
  // What is finer than these shares the first class.
  if (bounds.size() > kMaxClasses + 1) {
    bounds.erase(bounds.begin(), bounds.end() - static_cast<std::ptrdiff_t>(kMaxClasses + 1));
  }
  return bounds;
}

CaseClasses classify(const PlotCases& cases) {
  CaseClasses out;
  out.class_of.resize(cases.record.cases());
  out.number.resize(cases.record.cases());
  out.amount.resize(cases.record.cases());
  out.of_errors = cases.record.has_errors();
  if (out.of_errors) {
    classify_errors(cases, out);
  } else {
    classify_values(cases, out);
  }
  classify_statuses(cases, out);
  return out;
}

}  // namespace plastica::sweeps
