#pragma once

#include <array>

namespace plastica::theory {

// A chain of N equal rigid segments that a moment at its end rolls up: every joint of tributary
// length h = L/N turns by beta = M h/(E I), the half joint at the clamp by beta/2. Lengths over L;
// the clamp is at the origin, the undeformed beam lies along x and bends towards y.

/// A joint of the chain: node k of N, 0 at the clamp, N at the tip; (x, y) [1].
///
/// Segment i is turned by (i - 1/2) beta, so the nodes are sums of cosines and sines:
/// x = R sin(k beta), y = R (1 - cos(k beta)), R = 1/(2 N sin(beta/2)). They lie on a circle that
/// touches the beam's axis at the clamp, larger than the continuous beam's 1/(N beta) by
/// 1 + beta^2/24; a full turn closes a regular polygon exactly.
/// @param segments      N >= 1
/// @param end_rotation  N beta = M L/(E I) [rad], |end_rotation| < 2 pi N
/// @param node          k, 0 … N
std::array<double, 2> polygon_node(int segments, double end_rotation, int node);

/// Radius of the circle through the nodes, over L [1]; end_rotation > 0.
double polygon_radius(int segments, double end_rotation);

}  // namespace plastica::theory
