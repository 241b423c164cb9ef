#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "plastica/run/response.hpp"
#include "sweeps/plan/sweep.hpp"
#include "sweeps/run/case_result.hpp"

namespace plastica::sweeps {

/// The cases whose warnings are looked at: all, or sixteen of many, evenly, the first and the last
/// among them.
std::vector<std::size_t> watched_cases(std::size_t cases);

/// What a reader must not overlook of a run, see `run_warnings`; nothing of one that did not run.
std::vector<std::string> warnings_of_run(const Setup& setup, const Response& response);

/// What a reader must not overlook of a sweep: the warnings of its watched cases, alike ones once,
/// with which of these cases have them; and where a frequency is that of a plane, or of a twist,
/// out of which the beam swings more slowly.
/// @param results  (n_cases); what `CaseResult::warnings` has of one that ran, the scene alone says
///                 of others
std::vector<std::string> case_warnings(const Sweep& sweep, const CaseTable& cases,
                                       std::span<const CaseResult> results);

}  // namespace plastica::sweeps
