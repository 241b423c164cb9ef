#pragma once

#include <string>

#include "plastica/io/scene_store.hpp"
#include "plastica/report/ink.hpp"

/// The parts of a scene's text report that are about time; not installed.
namespace plastica::report {

/// How a motion is stepped and damped; empty for a path of equilibria.
std::string scheme_text(const io::SceneRecord& record);

/// What broke or was cut, and the fragments after that.
std::string events_text(const io::SceneRecord& record, const Ink& ink);

/// The energy balance at the last sample, and how far it is off.
std::string energy_text(const io::SceneRecord& record, const Ink& ink);

/// The strongest frequencies of displacement and velocity probes.
std::string frequency_text(const io::SceneRecord& record, const Ink& ink);

}  // namespace plastica::report
