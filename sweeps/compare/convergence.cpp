#include "sweeps/compare/convergence.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "plastica/theory/convergence.hpp"

namespace plastica::sweeps {
namespace {

/// Values that do not converge to the truth, or not yet, say nothing by how they differ.
std::optional<theory::GridConvergence> grid_of(const RefinementGroup& group,
                                               const Comparison& comparison,
                                               const std::vector<double>& sizes,
                                               const std::vector<double>& values) {
  const bool refused = std::any_of(group.cases.begin(), group.cases.end(), [&](std::size_t i) {
    return comparison.reason[i].starts_with(kNotConverged);
  });
  if (refused || values.size() < 3) return std::nullopt;
  return theory::grid_convergence(sizes, values, {.highest_order = theory::kHighestOrder});
}

}  // namespace

GroupConvergence convergence_of(const RefinementGroup& group,
                                const std::vector<CaseResult>& results,
                                const Comparison& comparison) {
  GroupConvergence out;
  if (group.size.empty()) return out;
  std::vector<double> sizes;
  std::vector<double> errors;
  std::vector<double> value_sizes;
  std::vector<double> values;
  for (const std::size_t k : group.distinct()) {
    const std::size_t i = group.cases[k];
    if (!comparison.coarser_in[i].empty()) out.stops_at = comparison.coarser_in[i];
    if (comparison.error[i]) {
      sizes.push_back(group.size[k]);
      errors.push_back(*comparison.error[i]);
      out.cases.push_back(i);
    }
    if (results[i].value) {
      value_sizes.push_back(group.size[k]);
      values.push_back(*results[i].value);
    }
  }
  out.grid = grid_of(group, comparison, value_sizes, values);
  if (!out.stops_at.empty()) {
    out.pairwise.resize(sizes.empty() ? 0 : sizes.size() - 1);
    return out;
  }
  out.fit = theory::observed_order(sizes, errors);
  out.pairwise = theory::pairwise_orders(sizes, errors);
  return out;
}

}  // namespace plastica::sweeps
