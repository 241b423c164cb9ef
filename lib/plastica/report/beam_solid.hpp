#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "plastica/io/scene_store.hpp"

/// Beams as flat faces seen from a side; not installed.
namespace plastica::report {

using Point3 = std::array<double, 3>;
using Point2 = std::array<double, 2>;

/// A direction to look along: how points in world axes fall on the picture.
struct Eye {
  Point3 right{};  ///< unit vectors in world axes
  Point3 up{};
  Point3 away{};  ///< from the viewer
  Point2 at(const Point3& point) const;
  double depth(const Point3& point) const;
};

/// One visible face.
struct Face {
  std::vector<Point2> corners;
  double depth = 0.0;  ///< of its middle
  double light = 1.0;  ///< share of its colour, 0.7 … 1
  std::size_t joint = 0;
};

/// A drawn beam: faces from the farthest to the nearest, and the edges on top of them.
struct BeamSolid {
  std::vector<Face> faces;
  std::vector<std::vector<Point2>> edges;
};

/// Position of a segment end of the sample; of the undeformed beam if `sample` is kUndeformed.
inline constexpr std::size_t kUndeformed = static_cast<std::size_t>(-1);
Point3 node_at(const io::SceneRecord& record, std::size_t sample, std::size_t node);
/// The axis as points on the picture.
std::vector<Point2> axis_of(const io::SceneRecord& record, std::size_t sample, const Eye& eye);

/// Draws each segment as a box or prism; its two halves belong to the joints at their ends.
/// @param thickness  how many times as thick as the section is
BeamSolid beam_solid(const io::SceneRecord& record, std::size_t sample, const Eye& eye,
                     double thickness);

}  // namespace plastica::report
