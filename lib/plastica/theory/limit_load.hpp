#pragma once

#include "plastica/theory/beam_ends.hpp"

namespace plastica::theory {

// Plastic limit loads of beams of even section: ideal plasticity, small displacements, bending
// alone (no axial force). A mechanism turns plastic hinges with the moment M_p until nothing holds
// it elastically; the work of the load equals that of the hinges, and the mechanism that asks the
// least load is the true one. Source: Prager & Hodge, Theory of Perfectly Plastic Solids, 1951, and
// Neal, The Plastic Methods of Structural Analysis; derived in each doc.

/// Limit of a point force [N] at x = a; b = L - a.
///
/// One mechanism: the load moves by v, the parts turn by v/a and v/b; a hinge at the load and at
/// each clamp. P v = M_p times the turns:
/// clamped-free M_p/a; pinned-pinned M_p (1/a + 1/b), 4 M_p/L in the middle; clamped-pinned
/// M_p (2/a + 1/b), 6 M_p/L; clamped-clamped 2 M_p (1/a + 1/b), 8 M_p/L.
/// @param ends            any but FreeFree
/// @param plastic_moment  M_p [N m]
/// @param position        a [m], 0 < a <= L, below L if the end is held
double limit_force(BeamEnds ends, double plastic_moment, double length, double position);

/// Limit of an even load [N/m].
///
/// The inner hinge at x = c moves by v; the load does w v L/2. w = (2/L) M_p (n_0/c + n_1/(L - c)),
/// n = 2 at a clamped end, 1 at a pinned one, least over c: 2 (sqrt n_0 + sqrt n_1)^2 M_p/L^2.
/// So pinned-pinned 8, clamped-pinned 6 + 4 sqrt 2, clamped-clamped 16 M_p/L^2; clamped-free
/// 2 M_p/L^2 by equilibrium at the clamp.
double limit_distributed(BeamEnds ends, double plastic_moment, double length);

}  // namespace plastica::theory
