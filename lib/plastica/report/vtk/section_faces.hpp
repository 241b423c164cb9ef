#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "plastica/model/section.hpp"
#include "plastica/report/beam_pose.hpp"

namespace plastica::report {

/// A cross section as what is swept along a segment: walls from edges, caps from faces of four
/// corners; not installed. Numbers are of `corners`.
struct SectionFaces {
  std::vector<Point2> corners;                    ///< x, y of the section [m]
  std::vector<std::array<std::size_t, 2>> edges;  ///< the material to the left, seen against z
  std::vector<std::array<std::size_t, 4>> faces;  ///< counterclockwise seen against z
};

/// A section's rectangles, whether they touch or not, without fillets; of a round one a ring of 16
/// corners on the circle, or two around a hole. A section that is given by its numbers is the
/// rectangle around it.
SectionFaces section_faces(const Section& section);

}  // namespace plastica::report
