#pragma once

#include "sweeps/plan/sweep.hpp"

/// Axes over fields that are of one kind of section or of one hardening law.
namespace plastica::sweeps {

/// Refuses an axis over a field that no case's shape or law has, which would move nothing, and a
/// shape that some case has while dimensions which it needs are neither the scene's nor an axis'.
/// @throws InputError at the axis
void check_kind_axes(const Sweep& sweep);

/// Whether a field is a dimension of some shape.
bool is_section_dimension(const Field& field);

}  // namespace plastica::sweeps
