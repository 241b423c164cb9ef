#pragma once

#include <vector>

#include "plastica/model/field.hpp"

/// Segments that are short where the bending of a beam changes fast.
namespace plastica::sweeps {

/// Lengths of graded segments as fractions of the beam's.
///
/// A chain bends at its joints alone: what bends the beam over a segment of length h, the curvature
/// k, is taken as its trapezoid. A point at a distance d beyond moves by k d h for it, so that this
/// is off by h^3 (k d)''/12, of which -h^3 k'/6 is there whatever the distance. The sum of
/// h^3 |k'| = integral of h^2 |k'| is least for a given number, the integral of 1/h, where
/// h ~ |k'|^(-1/3). Where the curvature hardly changes the segments stay within some three times
/// the mean, and the places where the scene needs an end (`needed_ends`) or has a probe have one.
/// @param scene  with the segments of `bent`
/// @param bent   largest rotation of each of its joints [rad] (n_joints)
/// @param segments  how many there shall be
/// @return (segments), sum 1; empty if the curvature does not change, or there are too few for the
///         places
std::vector<double> graded_fractions(const Scene& scene, const std::vector<double>& bent,
                                     int segments);

/// Each segment divided into equal parts.
std::vector<double> divided_evenly(const std::vector<double>& fractions, int parts);

}  // namespace plastica::sweeps
