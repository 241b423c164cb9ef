#pragma once

#include <string>

#include "plastica/io/scene_store.hpp"

namespace plastica::report {

/// What ran, defaults included, a labelled line each: material with E and yield stress, section,
/// how joints yield, regions, supports and loads in their units.
std::string setup_text(const io::SceneRecord& record);

}  // namespace plastica::report
