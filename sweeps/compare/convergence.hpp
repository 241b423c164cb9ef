#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plastica/theory/convergence.hpp"
#include "sweeps/compare/comparison.hpp"

namespace plastica::sweeps {

/// How a group of cases converges with its refinement.
struct GroupConvergence {
  /// Of the errors against the sweep's reference; without an order where there are none. Errors
  /// against the finest case or the extrapolated value show the order only far from it.
  theory::OrderFit fit;
  /// Other axes in which the cases are coarser than their reference: errors stop at theirs, so that
  /// no order is taken. Empty: there are none.
  std::string stops_at{};
  std::vector<std::size_t> cases;               ///< that have an error, from coarse to fine (n)
  std::vector<std::optional<double>> pairwise;  ///< orders between them (n - 1)
  /// Of the three finest values; none of curves, of fewer than three values, and where cases are
  /// refused as not converged.
  std::optional<theory::GridConvergence> grid;
};

GroupConvergence convergence_of(const RefinementGroup& group,
                                const std::vector<CaseResult>& results,
                                const Comparison& comparison);

}  // namespace plastica::sweeps
