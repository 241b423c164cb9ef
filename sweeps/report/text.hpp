#pragma once

#include <cstddef>
#include <string>

#include "sweeps/store/sweep_record.hpp"

namespace plastica::sweeps {

/// The report of a sweep as people read it: what was compared with what; for each group of
/// refinement a table of its cases with value, error, pairwise order and cost, and under it order,
/// extrapolated value and grid convergence index.
/// @param max_cases  tables end after that many cases in all, and quantiles of all cases follow;
///                    where nothing refines, quantiles stand for the table; 0: never
std::string sweep_report(const SweepRecord& record, std::size_t max_cases = 200);

/// All that is known of one case.
/// @param index  of the case, below record.cases()
std::string case_report(const SweepRecord& record, std::size_t index);

}  // namespace plastica::sweeps
