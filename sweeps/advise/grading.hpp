#pragma once

#include <vector>

#include "plastica/model/field.hpp"

/// Segments that are not all alike: short where the bending of a beam changes fast, or with ends at
/// the probes.
namespace plastica::sweeps {

/// Lengths of graded segments as fractions of the beam's.
///
/// A chain bends at its joints alone: what bends the beam over a segment of length h, the curvature
/// k, is taken as its trapezoid. A point at a distance d beyond moves by k d h for it, so that this
/// is off by h^3 (k d)''/12, of which -h^3 k'/6 is there whatever the distance. The sum of
/// h^3 |k'| = integral of h^2 |k'|, which bounds what that term does, is least for a given number,
/// the integral of 1/h, where h ~ |k'|^(-1/3). Where the curvature hardly changes the segments stay
/// within some three times the mean, and the places where the scene needs an end (`needed_ends`), a
/// probe, a cut or an end of what moves at first have one.
/// @param scene  with the segments of `bent`
/// @param bent   largest rotation of each of its joints [rad] (n_joints)
/// @param segments  how many there shall be
/// @return (segments), sum 1; empty if the curvature does not change, or there are too few for the
///         places
std::vector<double> graded_fractions(const Scene& scene, const std::vector<double>& bent,
                                     int segments);

/// Whether a segment ends at each probe of a joint. Within a segment such a probe is of the nearest
/// joint: off by half a segment, and by nothing between two runs that have the same nearest one.
bool ends_at_probes(const Scene& scene);

/// As many segments, even between the places where the scene needs an end or has a probe of a
/// joint, as fractions of the beam's length (segments); empty if they end there anyway, or there
/// are too few.
std::vector<double> fractions_that_end_at_probes(const Scene& scene);

/// Each segment divided into equal parts.
std::vector<double> divided_evenly(const std::vector<double>& fractions, int parts);

/// The scene with each segment divided into equal parts, and an end at each probe of a joint. So
/// many segments alone would not do: between places where the scene needs ends they are dealt out
/// by length, and a short stretch keeps its one segment for long. Where even segments have all
/// these ends they are even.
/// @param scene  that lets its segments be divided: not with EndRule::Half or ThreeHalves, of which
///               it is the scene with so many more segments
/// @param parts  >= 1
Scene with_divided_segments(const Scene& scene, int parts);

}  // namespace plastica::sweeps
