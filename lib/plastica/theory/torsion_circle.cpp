#include "plastica/theory/torsion_circle.hpp"

#include <algorithm>
#include <cmath>

namespace plastica::theory {

double torque_ratio_circle(double t) {
  if (std::abs(t) <= 1.0) return t;
  return std::copysign(4.0 / 3.0 * (1.0 - 0.25 / std::abs(t * t * t)), t);
}

double residual_twist_ratio_circle(double t) { return t - torque_ratio_circle(t); }

double elastic_core_ratio_circle(double t) { return 1.0 / std::max(std::abs(t), 1.0); }

}  // namespace plastica::theory
