#pragma once

#include <string>

#include "sweeps/store/sweep_record.hpp"

namespace plastica::sweeps {

/// The report of a sweep as people read it: what was compared with what; for each group of
/// refinement a table of its cases with value, error, pairwise order and cost, and under it order,
/// extrapolated value and grid convergence index.
/// @param most_cases  tables end after that many cases in all, and say so; 0: never
std::string sweep_report(const SweepRecord& record, std::size_t most_cases = 200);

}  // namespace plastica::sweeps
