#pragma once

#include <string>
#include <vector>

#include "sweeps/compare/comparison.hpp"
#include "sweeps/compare/reference_sets.hpp"

/// What a user must know of errors that a sweep takes from its own cases; not installed.
namespace plastica::sweeps {

/// "beam.segments, solver.time_step".
std::string paths_of(const Sweep& sweep, const std::vector<std::size_t>& axes);

/// Adds to `Comparison::notes`: which axes the reference is refined in; which values have a
/// reference each; what is not in the errors, axes that lack and fields that no axis refines.
void add_error_notes(const Sweep& sweep, const CaseTable& cases, const ReferenceSets& sets,
                     Comparison& comparison);

}  // namespace plastica::sweeps
