#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "plastica/model/scene.hpp"

namespace plastica {

/// Where the segments of a scene's beam end, as shares of its length: 0 first, 1 last
/// (segments + 1). With EndRule::Half the two end segments are half as long as the others.
std::vector<double> segment_ends(const Scene& scene);

/// A place as a share of the length [1], 0 (start) … 1 (end). A fraction within 1e-9 of a segment's
/// end is that end, exactly: nobody writes 0.6666666667 to the last bit.
/// @param ends  of `segment_ends`; `place.segment` is within it
double share_of(const Place& place, std::span<const double> ends);

/// The number of the segment end at a place, 0 … segments; empty if the place is inside of a
/// segment.
std::optional<int> segment_end_at(const Place& place, std::span<const double> ends);

/// The number of the segment end that is nearest to a place, 0 … segments; the lower one of two.
int nearest_segment_end(const Place& place, std::span<const double> ends);

/// A point of the undeformed axis in world axes [m].
/// @param share  distance from the start along the axis over the length [1], 0 … 1
std::array<double, 3> axis_point(const Beam& beam, double share);

/// The sum over the legs of a polyline [m].
double polyline_length(std::span<const std::array<double, 3>> points);

}  // namespace plastica
