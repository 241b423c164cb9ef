#pragma once

#include "plastica/run/batch.hpp"
#include "sweeps/plan/sweep.hpp"
#include "sweeps/run/case_result.hpp"

namespace plastica::sweeps {

/// What a batch gave for a case.
CaseResult result_of(const BatchRow& row, const Quantity& quantity);

/// The result of a case whose quantity is not simulated.
/// @param stop  once raised, a fit ends; may be null
/// @throws InputError for a rejected case, calibrate::FitInterrupted for a stopped one
CaseResult measure(const Sweep& sweep, const Setup& setup, StopFlag stop = nullptr);

/// The result of a case that was rejected.
CaseResult rejected(std::string reason);

}  // namespace plastica::sweeps
