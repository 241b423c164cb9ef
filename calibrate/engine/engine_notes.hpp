#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/engine/engine_beam.hpp"

/// What the writers of all formats share; not installed.
namespace plastica::calibrate {

/// Notes what of a scene the numbers of its beam do not hold.
void add_scene_notes(const Scene& scene, const SolverOptions& options, EngineBeam& beam);

/// The beam, the equations of its numbers and its notes, as lines of a comment.
std::vector<std::string> comment_lines(const EngineBeam& beam);

/// The same with the comment sign of a format before each line, and a line end behind it.
std::string comment(const EngineBeam& beam, std::string_view sign);

/// The shortest text that reads back as the same double.
std::string exact(double value);
/// Such texts with a separator between.
std::string exact(const std::array<double, 3>& values, std::string_view separator);

/// The unit quaternion w, x, y, z of a frame.
std::array<double, 4> quaternion(const EngineAxes& axes);
/// A frame and a vector as seen from a frame.
EngineAxes seen_from(const EngineAxes& frame, const EngineAxes& axes);
std::array<double, 3> seen_from(const EngineAxes& frame, const std::array<double, 3>& vector);

/// Texts without line ends and without what ends a comment.
std::string one_line(std::string_view text);

}  // namespace plastica::calibrate
