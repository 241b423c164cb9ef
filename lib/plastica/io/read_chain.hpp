#pragma once

#include "plastica/io/toml.hpp"
#include "plastica/model/field.hpp"

/// What a scene file says of a chain beyond the fields of the field table; not installed.
/// `read_scene_file` documents the keys.
namespace plastica::io {

/// Lengths of segments and joints and the shape of the axis, from [beam].
void read_beam(const TomlTable& root, Setup& setup);

/// [[region]], on top of the scene's section and material.
void read_regions(const TomlTable& root, Setup& setup);

/// [[support]], [[load]], [[mass]], gravity, [[initial_motion]], [[cut]], `solver.control_at` and
/// `solver.control_motion`.
void read_actions(const TomlTable& root, Setup& setup);

/// [[probe]].
/// @param coupon  whether the scene is one, which has no places
std::vector<Probe> read_probes(const TomlTable& root, bool coupon);

}  // namespace plastica::io
