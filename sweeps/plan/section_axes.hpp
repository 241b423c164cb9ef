#pragma once

#include "sweeps/plan/sweep.hpp"

namespace plastica::sweeps {

/// Refuses an axis over a dimension that no case's section has, which would move nothing, and a
/// shape that some case has while dimensions which it needs are neither the scene's nor an axis'.
/// @throws InputError at the axis
void check_section_axes(const Sweep& sweep);

/// Whether a field is a dimension of some shape.
bool is_section_dimension(const Field& field);

}  // namespace plastica::sweeps
