#pragma once

namespace plastica::theory {

// Elastic-perfectly-plastic torsion of a solid circle from the virgin state. twist_ratio = twist
// over the twist at first yield, tau_y/(G R) per length; torques over that at first yield,
// pi R^3 tau_y/2. Source: Prager & Hodge, Theory of Perfectly Plastic Solids, 1951;
// derived by integrating tau = min(G r twist, tau_y) over the circle.

/// T/T_y = (4/3)(1 - 1/(4 t^3)) for t > 1; odd; tends to 4/3.
double torque_ratio_circle(double twist_ratio);

/// Twist that stays after elastic unloading, over the twist at first yield: t - T/T_y.
double residual_twist_ratio_circle(double twist_ratio);

/// Radius of the elastic core over R: 1/|t|, at most 1.
double elastic_core_ratio_circle(double twist_ratio);

}  // namespace plastica::theory
