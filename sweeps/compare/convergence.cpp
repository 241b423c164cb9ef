#include "sweeps/compare/convergence.hpp"

namespace plastica::sweeps {

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
  if (!out.stops_at.empty()) {
    out.pairwise.resize(sizes.empty() ? 0 : sizes.size() - 1);
    if (values.size() >= 3) out.grid = theory::grid_convergence(value_sizes, values);
    return out;
  }
  out.fit = theory::observed_order(sizes, errors);
  out.pairwise = theory::pairwise_orders(sizes, errors);
  if (values.size() >= 3) out.grid = theory::grid_convergence(value_sizes, values);
  return out;
}

}  // namespace plastica::sweeps
