#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "plastica/model/scene.hpp"

namespace plastica {

/// A place of a scene at which a segment is to end, and what the scene calls it.
struct NodePlace {
  double fraction = 0.0;  ///< of the length [1], 0 … 1
  const char* list = "";  ///< "region", with
  std::size_t index = 0;  ///< the number in it from 0, and
  const char* key = "";   ///< ".from"
};

/// Ends of regions, supports, loads, both ends of spread loads, point masses and the points of a
/// polyline, in the scene's order; not what is named by a segment, which ends there whatever its
/// length.
std::vector<NodePlace> node_places(const Scene& scene);

/// The fractions of the length at which segments have to end, rising: 0, what `node_places` says
/// (of those within 1e-9 of each other the first), 1.
std::vector<double> needed_ends(const Scene& scene);

/// Where the segments of a scene's beam end, as fractions of its length: 0 first, 1 last
/// (segments + 1).
///
/// Evenly, or as beam.segment_lengths says; with EndRule::Half the two end segments are half as
/// long as the others. Where, without beam.segment_lengths or joint_lengths, even segments would
/// not end at all `needed_ends`, each stretch between two of these has even segments of its own, as
/// many as make the longest of all as short as possible (of equally long ones the first stretch
/// gets one more). So regions and loads act where the scene says, and results depend continuously
/// on it. A scene with fewer segments than stretches, which `check_scene` refuses, is divided
/// evenly.
std::vector<double> segment_ends(const Scene& scene);

/// A place as a fraction of the length [1], 0 (start) … 1 (end). A fraction within 1e-9 of a
/// segment's end is that end, exactly: nobody writes 0.6666666667 to the last bit.
/// @param ends  of `segment_ends`; `place.segment` is within it
double fraction_of(const Place& place, std::span<const double> ends);

/// The number of the segment end at a place, 0 … segments; empty if the place is inside of a
/// segment.
std::optional<int> segment_end_at(const Place& place, std::span<const double> ends);

/// The number of the segment end that is nearest to a place, 0 … segments; the lower one of two.
int nearest_segment_end(const Place& place, std::span<const double> ends);

/// What ends that are held against rotation have, with `EndRule::Auto` resolved.
EndRule resolved_end_rule(const Scene& scene);

/// A point of the undeformed axis in world axes [m].
/// @param fraction  distance from the start along the axis over the length [1], 0 … 1
std::array<double, 3> axis_point(const Beam& beam, double fraction);

/// The sum over the legs of a polyline [m].
double polyline_length(std::span<const std::array<double, 3>> points);

}  // namespace plastica
