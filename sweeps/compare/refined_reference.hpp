#pragma once

#include <span>
#include <string>
#include <vector>

#include "sweeps/compare/comparer.hpp"

/// References that a sweep finds in its own cases; not installed.
namespace plastica::sweeps {

struct RefinedSweep {
  const Sweep& sweep;
  const CaseTable& cases;
  const std::vector<RefinementGroup>& groups;
  std::span<const std::string> ids;  ///< of the runs; may be empty
};

/// Compares with the finest, or with what is extrapolated: in all axes that refine where a set of
/// cases allows it, else along the refined axis.
void compare_refined(const RefinedSweep& of, Comparer& comparer);

}  // namespace plastica::sweeps
