#pragma once

#include "plastica/io/scene_store.hpp"
#include "plastica/report/json_values.hpp"

namespace plastica::report {

/// A block of a page (web_blocks.hpp): the beam in its frames, to be turned and played; its moments
/// at the frame shown, and its histories, in which that time is marked; not installed.
/// @param record  of a chain with a frame at least
Json web_beam(const io::SceneRecord& record);

}  // namespace plastica::report
