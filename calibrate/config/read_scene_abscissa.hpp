#pragma once

#include "calibrate/target/scene_target.hpp"
#include "plastica/io/toml.hpp"

namespace plastica::calibrate {

/// Reads what the abscissa of a beam's curve is: its key is `probe`, `drive` or `time`.
/// @param[in,out] target  gets kind, probe or what it drives, and where that is said
/// @throws InputError
void read_scene_abscissa(const io::TomlTable& axis, SceneTarget& target);

}  // namespace plastica::calibrate
