#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "calibrate/engine/engine_beam.hpp"

/// What the writers of all formats share; not installed.
namespace plastica::calibrate {

/// Whether a unit vector is along no axis of the world, but for the rounding of a rotation.
template <class Vector>
bool is_oblique(const Vector& direction) {
  int along = 0;
  for (std::size_t k = 0; k < 3; ++k) along += std::fabs(direction[k]) > 1e-12 ? 1 : 0;
  return along > 1;
}

/// Notes what of a scene the numbers of its beam do not hold.
void add_scene_notes(const Scene& scene, const SolverOptions& options, EngineBeam& beam);

/// The beam, the equations of its numbers and its notes, as lines of a comment.
std::vector<std::string> comment_lines(const EngineBeam& beam);

/// The same with the comment sign of a format before each line, and a line end behind it.
std::string comment(const EngineBeam& beam, std::string_view sign);

/// A number as it was meant, with 14 digits at most: "46", where sums and products leave
/// 46.000000000000014. Reads back within 5e-14 of it.
std::string digits(double value);
/// Such texts with a separator between.
std::string digits(std::span<const double> values, std::string_view separator);

/// What a text shows of a value: of a number its digits.
inline std::string shown(double value) { return digits(value); }
template <typename Value>
const Value& shown(const Value& value) {
  return value;
}

/// `fmt::format` where each "{}" of a number has its digits.
template <typename... Values>
std::string written(std::string_view form, const Values&... values) {
  return fmt::format(fmt::runtime(form), shown(values)...);
}

/// The unit quaternion w, x, y, z of a frame.
std::array<double, 4> quaternion(const EngineAxes& axes);
/// A frame and a vector as seen from a frame.
EngineAxes seen_from(const EngineAxes& frame, const EngineAxes& axes);
std::array<double, 3> seen_from(const EngineAxes& frame, const std::array<double, 3>& vector);

/// Texts without line ends and without what ends a comment.
std::string one_line(std::string_view text);

}  // namespace plastica::calibrate
