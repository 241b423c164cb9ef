#pragma once

#include <string>

#include "calibrate/engine/engine_beam.hpp"

/// A writer for each format; not installed.
namespace plastica::calibrate {

/// The step of an MJCF file [s]: the scene's, or where a support off the start is welded, what an
/// explicit step can take; the joints' damping goes with it.
/// @param joint  takes the name of the joint that limits it; empty: none does
double mjcf_time_step(const EngineBeam& beam, std::string* joint = nullptr);

std::string csv_text(const EngineBeam& beam);
std::string mjcf_text(const EngineBeam& beam);
std::string agx_text(const EngineBeam& beam);
std::string chrono_text(const EngineBeam& beam);
std::string opensees_text(const EngineBeam& beam);

}  // namespace plastica::calibrate
