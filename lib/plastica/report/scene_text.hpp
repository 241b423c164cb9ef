#pragma once

#include <string>

#include "plastica/io/scene_store.hpp"

namespace plastica::report {

/// The report of a simulated scene, at most 100 columns wide (UTF-8): how it ended, level and why,
/// the break with every joint, probes, largest moment, stress and plastic strain and where,
/// reactions, energies, counters and warnings. The same for every run. Ends with a line end.
/// @param color  ANSI colours, for a terminal
std::string scene_report(const io::SceneRecord& record, bool color = false);

}  // namespace plastica::report
