#pragma once

#include <cstddef>
#include <vector>

#include "plastica/report/beam_pose.hpp"

/// Beams as flat faces seen from a side; not installed.
namespace plastica::report {

/// One visible face.
struct Face {
  std::vector<Point2> corners;
  double depth = 0.0;  ///< of its middle
  double light = 1.0;  ///< fraction of its colour, 0.7 … 1
  std::size_t joint = 0;
};

using Lines = std::vector<std::vector<Point2>>;

/// A drawn beam: faces from the farthest to the nearest, and the lines on top of them.
struct BeamSolid {
  std::vector<Face> faces;
  Lines edges;     ///< along the beam, and around its free ends
  Lines segments;  ///< between two segments
  Lines cuts;      ///< around the ends that a cut has made
};

/// Draws each segment as a box or prism; its two halves belong to the joints at their ends.
/// @param thickness  how many times as thick as the section is
BeamSolid beam_solid(const BeamPose& pose, const Eye& eye, double thickness);

}  // namespace plastica::report
