#pragma once

#include <string>

#include "plastica/io/scene_store.hpp"
#include "plastica/report/ink.hpp"

/// The parts of a scene's text report that are about modes; not installed.
namespace plastica::report {

/// The load factors at which the beam buckles, where they were asked for.
std::string buckling_text(const io::SceneRecord& record, const Ink& ink);

/// The natural frequencies about the loaded state, where they were asked for.
std::string vibration_text(const io::SceneRecord& record, const Ink& ink);

}  // namespace plastica::report
