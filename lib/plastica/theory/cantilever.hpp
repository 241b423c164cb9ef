#pragma once

namespace plastica::theory {

// Cantilever of rectangular section under a tip load, elastic-perfectly-plastic, small
// displacements. load_ratio = P/P_y, P_y = M_y/L; deflections over delta_y = P_y L^3/(3 E I).

/// delta/delta_y: p for p <= 1, else (5 - (3 + p) sqrt(3 - 2p))/p^2; 20/9 at the limit load p
/// = 1.5. Source: Prager & Hodge, Theory of Perfectly Plastic Solids, 1951: the
/// moment-curvature law of the rectangle integrated twice along the beam.
/// @param load_ratio  p [1], 0 <= p <= 1.5
double tip_deflection_ratio(double load_ratio);

/// Length of the plastic zone from the clamp over L: 1 - 1/p for p > 1, else 0.
double plastic_zone_ratio(double load_ratio);

/// Tip deflection that stays when the load is taken off, over delta_y: tip_deflection_ratio(p) - p.
/// Unloading is elastic everywhere, since no moment passes 1.5 M_y, less than the 2 M_y that yields
/// backwards.
/// @param load_ratio  p [1], 0 <= p <= 1.5
double residual_tip_ratio(double load_ratio);

}  // namespace plastica::theory
