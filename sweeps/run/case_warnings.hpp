#pragma once

#include <string>
#include <vector>

#include "sweeps/plan/sweep.hpp"

namespace plastica::sweeps {

/// What a reader must not overlook of the scenes of a sweep: what `scene_warnings` says of its
/// cases (of sixteen of many, the first and the last among them), alike ones once; and where a
/// frequency is that of a plane, or of a twist, out of which the beam swings more slowly. What only
/// a run shows is not in it.
std::vector<std::string> case_warnings(const Sweep& sweep, const CaseTable& cases);

}  // namespace plastica::sweeps
