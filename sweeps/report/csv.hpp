#pragma once

#include <iosfwd>

#include "sweeps/store/sweep_record.hpp"

namespace plastica::sweeps {

// Numbers are in SI with all their digits, units in the header as "value [m]"; what there is not is
// an empty cell.

/// A row per case: its id, a column per axis, status, reason, level, value, reference, error and
/// what the case took.
void write_cases_csv(std::ostream& out, const SweepRecord& record);

/// The curves, a row per sample: the id of its case, time and value.
/// @throws InputError if the sweep compares no curves
void write_sweep_curves_csv(std::ostream& out, const SweepRecord& record);

}  // namespace plastica::sweeps
