#pragma once

#include <string>

#include "calibrate/engine/engine_beam.hpp"

/// A writer for each format; not installed.
namespace plastica::calibrate {

/// How a MuJoCo step stays stable, and what damps the joints.
std::string mjcf_step_note(const EngineBeam& beam);

/// That Bullet's step must be short enough for the springs.
std::string bullet_step_note(const EngineBeam& beam);

/// Whose step it is, and that Chrono was not run.
std::string chrono_step_note(const EngineBeam& beam);

std::string csv_text(const EngineBeam& beam);
std::string mjcf_text(const EngineBeam& beam);
std::string agx_text(const EngineBeam& beam);
std::string bullet_text(const EngineBeam& beam);
std::string chrono_text(const EngineBeam& beam);
std::string opensees_text(const EngineBeam& beam);

}  // namespace plastica::calibrate
