#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/engine/engine_beam.hpp"

namespace plastica::calibrate {

/// What a beam can be written for.
enum class EngineFormat {
  Csv,       ///< a row per joint
  Mjcf,      ///< MuJoCo: bodies and hinges with springs
  Agx,       ///< AGX Dynamics: a Python module of lock joints
  Bullet,    ///< Bullet 3: a C++ header of a multibody and its springs
  Chrono,    ///< Project Chrono 9: a C++ header of mates and bushings
  OpenSees,  ///< Tcl: zero-length hinges that yield and break
};

/// The words of the formats, in the order of EngineFormat: "csv", "mjcf", "agx", "bullet",
/// "chrono", "opensees".
std::span<const std::string_view> engine_formats();

/// The beam's notes and those of a format: what of it cannot be used as it is.
std::vector<std::string> engine_notes(const EngineBeam& beam, EngineFormat format);

/// The beam as the text of a format. Equations, units and notes are in its comments; every number
/// has its first 14 digits. What an engine cannot take (of yielding, breaking) is there as
/// numbers, and a comment says so.
/// @throws InputError for OpenSees if the beam carries point masses; for Bullet if it is held off
///         its start, or not at all
std::string engine_text(const EngineBeam& beam, EngineFormat format);

}  // namespace plastica::calibrate
