#include "sweeps/compare/extrapolation.hpp"

#include <algorithm>
#include <cmath>

#include "plastica/theory/convergence.hpp"
#include "sweeps/compare/error_notes.hpp"
#include "sweeps/compare/finest_lines.hpp"

namespace plastica::sweeps {
namespace {

/// Coarser sizes of an axis are left out: the law holds for small ones.
constexpr std::size_t kSizes = 4;
constexpr std::size_t kLeastSizes = 3;

/// The finest sizes of an axis among some cases, from the finest on.
std::vector<double> finest_sizes(const ReferenceSets& sets, const std::vector<std::size_t>& cases,
                                 std::size_t axis) {
  std::vector<double> all;
  all.reserve(cases.size());
  for (const std::size_t i : cases) all.push_back(sets.size_at(i, axis));
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end(), same_size), all.end());
  if (all.size() > kSizes) all.resize(kSizes);
  return all;
}

/// Cases with a number and the finest words.
std::vector<std::size_t> cases_to_fit(const ReferenceSets& sets, const ReferenceSet& set,
                                      const std::vector<CaseResult>& results) {
  std::vector<std::size_t> kept;
  for (const std::size_t i : set.cases) {
    const bool finest = std::all_of(set.words.begin(), set.words.end(),
                                    [&](std::size_t a) { return sets.finest_word_at(i, a); });
    const bool alike = !set.finest || end_alike(results[i], results[*set.finest]);
    if (results[i].value && has_outcome(results[i]) && finest && alike) kept.push_back(i);
  }
  return kept;
}

Extrapolated extrapolate_one(const ReferenceSets& sets, std::vector<std::size_t> cases,
                             std::size_t axis, const std::vector<CaseResult>& results) {
  std::stable_sort(cases.begin(), cases.end(), [&](std::size_t a, std::size_t b) {
    return sets.size_at(a, axis) > sets.size_at(b, axis);
  });
  std::vector<double> sizes;
  std::vector<double> values;
  for (const std::size_t i : cases) {
    if (!sizes.empty() && same_size(sizes.back(), sets.size_at(i, axis))) continue;
    sizes.push_back(sets.size_at(i, axis));
    values.push_back(*results[i].value);
  }
  Extrapolated out{true, extrapolated_along(sizes, values), {}, {}};
  if (!out.value) {
    out.reason = kNothingExtrapolated;
  } else if (sizes.size() >= kLeastSizes) {
    // What the safety factor adds to the distance of the finest from its limit; and where an order
    // between 1 and 2 is really one of each, what that makes of the limit.
    const auto grid =
        theory::grid_convergence(sizes, values, {.highest_order = theory::kHighestOrder});
    const double margin = (grid.safety_factor - 1.0) * std::abs(*out.value - values.back());
    const std::size_t coarsest = sizes.size() - kLeastSizes;
    const double other = theory::limit_of_two_orders(std::span(sizes).subspan(coarsest),
                                                     std::span(values).subspan(coarsest));
    out.uncertainty = std::max(margin, grid.safety_factor * std::abs(other - *out.value));
  }
  return out;
}

}  // namespace

std::optional<double> extrapolated_along(const std::vector<double>& sizes,
                                         const std::vector<double>& values) {
  if (sizes.size() < kLeastSizes) return std::nullopt;
  const auto grid =
      theory::grid_convergence(sizes, values, {.highest_order = theory::kHighestOrder});
  if (grid.kind == theory::ConvergenceKind::Unchanged) return values.back();
  // Of values that go to and fro an order says little: of equal swings it is 0, and its limit far.
  if (grid.kind != theory::ConvergenceKind::Monotone) return std::nullopt;
  return grid.extrapolated;
}

Extrapolated extrapolate(const Sweep& sweep, const ReferenceSets& sets, const ReferenceSet& set,
                         const std::vector<CaseResult>& results) {
  std::vector<std::size_t> axes = free_axes(sweep, set);
  const std::vector<std::size_t> cases = cases_to_fit(sets, set, results);
  if (axes.empty() || cases.empty()) return {};
  if (axes.size() == 1) return extrapolate_one(sets, cases, axes.front(), results);
  std::vector<std::vector<double>> finest;
  std::string fewer;
  for (const std::size_t a : axes) {
    finest.push_back(finest_sizes(sets, cases, a));
    if (finest.back().size() >= kLeastSizes) continue;
    fewer += (fewer.empty() ? "" : ", ") + std::string(sweep.axes[a].field->path);
  }
  if (!fewer.empty()) return {};
  std::vector<double> sizes;
  std::vector<double> values;
  for (const std::size_t i : cases) {
    std::vector<double> row;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const double size = sets.size_at(i, axes[k]);
      const bool fine = std::any_of(finest[k].begin(), finest[k].end(),
                                    [&](double one) { return same_size(one, size); });
      if (fine) row.push_back(size);
    }
    if (row.size() < axes.size()) continue;
    sizes.insert(sizes.end(), row.begin(), row.end());
    values.push_back(*results[i].value);
  }
  Extrapolated out{true, {}, {}, {}};
  if (const auto limit = fit_limit(sizes, axes.size(), values)) {
    out.value = limit->value;
    out.uncertainty = limit->uncertainty;
  } else {
    out.reason = "nothing can be extrapolated: the values do not converge in all of " +
                 paths_of(sweep, axes);
  }
  return out;
}

}  // namespace plastica::sweeps
