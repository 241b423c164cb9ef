#include "sweeps/compare/finest_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "plastica/theory/convergence.hpp"
#include "sweeps/compare/extrapolation.hpp"
#include "sweeps/run/first_break.hpp"

namespace plastica::sweeps {
namespace {

/// Order p of errors against the finest value, from (r3^p - 1)/(r2^p - 1) = e3/e2: what is left of
/// C h^p if the finest is taken for the limit. The left side rises with p.
/// @param r2, r3  sizes over that of the finest, 1 < r2 < r3
/// @param e2, e3  errors, with their signs
/// @return none of two signs, and outside of 0.5 … 2.5: more is luck, or errors of unlike orders
/// that cancel
std::optional<double> order_against_finest(double r2, double e2, double r3, double e3) {
  constexpr double kLow = 0.5;
  constexpr double kHigh = theory::kHighestOrder + theory::kBeyondHighestOrder;
  const auto excess = [&](double p) {
    return (std::pow(r3, p) - 1.0) / (std::pow(r2, p) - 1.0) - e3 / e2;
  };
  if (e2 == 0.0 || excess(kLow) > 0.0 || excess(kHigh) < 0.0) return std::nullopt;
  double low = kLow;
  double high = kHigh;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// How far the finest of a line is off. @param line  from the finest on, two cases or more
std::optional<double> error_along(const ReferenceSets& sets, const std::vector<std::size_t>& line,
                                  std::size_t axis, const Comparison& comparison) {
  constexpr double kSafety = 1.25;
  constexpr double kSafetyOfAssumed = 3.0;
  const auto ratio = [&](std::size_t k) {
    return sets.size_at(line[k], axis) / sets.size_at(line[0], axis);
  };
  const auto error = [&](std::size_t k) { return *comparison.error[line[k]]; };
  if (!comparison.error[line[1]]) return std::nullopt;
  const bool has_third = line.size() > 2 && comparison.error[line[2]];
  if (!has_third) return kSafetyOfAssumed * std::abs(error(1)) / (ratio(1) - 1.0);
  // Errors of values have a sign, so that those that go to and fro show no order.
  const auto order = order_against_finest(ratio(1), error(1), ratio(2), error(2));
  const double p = order ? std::min(*order, theory::kHighestOrder) : 1.0;
  // Of a pure power both say the same; a difference that is small by luck is outvoted.
  const double off = std::max(std::abs(error(1)) / (std::pow(ratio(1), p) - 1.0),
                              std::abs(error(2)) / (std::pow(ratio(2), p) - 1.0));
  const double both = theory::limit_of_two_orders(std::array{1.0, ratio(1), ratio(2)},
                                                  std::array{0.0, error(1), error(2)});
  return std::max((order ? kSafety : kSafetyOfAssumed) * off, kSafety * std::abs(both));
}

std::string outcome_of(const CaseResult& result) {
  if (result.break_joint >= 0) return fmt::format("{}", result.break_joint);
  return result.status == Status::Completed ? "none" : std::string(name_of(result.status));
}

}  // namespace

bool end_alike(const CaseResult& one, const CaseResult& other) {
  return one.status == other.status &&
         break_alike(one.break_place, one.segments, other.break_place, other.segments);
}

std::string other_end(const CaseResult& result, const CaseResult& reference) {
  const auto words = [](const CaseResult& one) {
    return one.break_joint >= 0 ? fmt::format("breaks at joint {}", one.break_joint)
                                : fmt::format("ends as {}", name_of(one.status));
  };
  return words(result) + ", the reference " + words(reference);
}

bool moves_with(const Sweep& sweep, std::size_t axis, std::size_t other) {
  const std::string& group = sweep.axes[axis].group;
  return axis == other || (!group.empty() && sweep.axes[other].group == group);
}

std::vector<std::size_t> free_axes(const Sweep& sweep, const ReferenceSet& set) {
  std::vector<std::size_t> axes;
  for (const std::size_t a : set.numbers) {
    const bool together = std::any_of(axes.begin(), axes.end(),
                                      [&](std::size_t b) { return moves_with(sweep, a, b); });
    if (!together) axes.push_back(a);
  }
  return axes;
}

std::vector<std::size_t> line_of_finest(const Sweep& sweep, const ReferenceSets& sets,
                                        const ReferenceSet& set, std::size_t axis,
                                        const std::vector<CaseResult>& results) {
  const std::size_t finest = *set.finest;
  std::vector<std::size_t> line;
  for (const std::size_t i : set.cases) {
    const bool on_line =
        has_outcome(results[i]) &&
        std::all_of(set.numbers.begin(), set.numbers.end(),
                    [&](std::size_t a) {
                      return moves_with(sweep, a, axis) ||
                             same_size(sets.size_at(i, a), sets.size_at(finest, a));
                    }) &&
        std::all_of(set.words.begin(), set.words.end(),
                    [&](std::size_t a) { return sets.finest_word_at(i, a); });
    if (on_line) line.push_back(i);
  }
  std::stable_sort(line.begin(), line.end(), [&](std::size_t a, std::size_t b) {
    return sets.size_at(a, axis) < sets.size_at(b, axis);
  });
  line.erase(std::unique(line.begin(), line.end(),
                         [&](std::size_t a, std::size_t b) {
                           return same_size(sets.size_at(a, axis), sets.size_at(b, axis));
                         }),
             line.end());
  return line;
}

std::string change_of_outcome(const Sweep& sweep, const ReferenceSets& sets,
                              const ReferenceSet& set, const std::vector<CaseResult>& results) {
  constexpr std::size_t kShown = 3;
  for (const std::size_t axis : free_axes(sweep, set)) {
    const auto line = line_of_finest(sweep, sets, set, axis, results);
    if (line.size() < 2 || end_alike(results[line[0]], results[line[1]])) continue;
    const bool breaks = results[line[0]].break_joint >= 0 || results[line[1]].break_joint >= 0;
    std::string all;
    for (std::size_t k = std::min(line.size(), kShown); k-- > 0;) {
      all += (all.empty() ? "" : ", ") + outcome_of(results[line[k]]);
    }
    return fmt::format("{} {} as {} is refined", breaks ? "breaks at joint" : "ends as", all,
                       sweep.axes[axis].field->path);
  }
  return {};
}

std::optional<double> error_of_finest(const Sweep& sweep, const ReferenceSets& sets,
                                      const ReferenceSet& set,
                                      const std::vector<CaseResult>& results,
                                      const Comparison& comparison) {
  double sum = 0.0;
  for (const std::size_t axis : free_axes(sweep, set)) {
    const auto line = line_of_finest(sweep, sets, set, axis, results);
    if (line.size() < 2) return std::nullopt;
    const auto off = error_along(sets, line, axis, comparison);
    if (!off) return std::nullopt;
    sum += *off;
  }
  return sum;
}

}  // namespace plastica::sweeps
