#pragma once

#include <string>
#include <vector>

#include "sweeps/compare/finest_lines.hpp"

namespace plastica::sweeps {

/// What of a scene the axes of a set do not refine, though they refine the rest, so that finer
/// cases agree and are wrong together; in words, empty: nothing was found.
/// - A stretch between two supports keeps its one segment, which does not bend; or one that is all
///   that bends.
/// - A probe of a joint reads the same joint, beside its place, in the two finest cases.
/// - The angle of one joint halves with the joint's length: it goes to nothing, and has no value of
///   the beam's to come to.
/// - The finest step is more than a fourth of a history's period: whole periods look like nothing.
/// @param set  with a finest case
std::string what_stays_coarse(const Sweep& sweep, const CaseTable& cases, const ReferenceSets& sets,
                              const ReferenceSet& set, const std::vector<CaseResult>& results);

}  // namespace plastica::sweeps
