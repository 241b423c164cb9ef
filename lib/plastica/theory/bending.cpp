#include "plastica/theory/bending.hpp"

#include <cmath>
#include <numbers>

#include "plastica/base/domain.hpp"

namespace plastica::theory {

double moment_ratio_rectangle(double k) {
  if (std::abs(k) <= 1.0) return k;
  return std::copysign(1.5 * (1.0 - 1.0 / (3.0 * k * k)), k);
}

double curvature_ratio_rectangle(double m) {
  require_domain(std::abs(m) < 1.5, "a moment_ratio within +-1.5");
  if (std::abs(m) <= 1.0) return m;
  return std::copysign(1.0 / std::sqrt(3.0 - 2.0 * std::abs(m)), m);
}

double moment_ratio_circle(double k) {
  if (std::abs(k) <= 1.0) return k;
  const double c = 1.0 / std::abs(k);
  const double s = std::sqrt(1.0 - c * c);
  const double core = (std::asin(c) - c * s * (1.0 - 2.0 * c * c)) / (8.0 * c);
  const double rest = s * s * s / 3.0;
  return std::copysign(16.0 / std::numbers::pi * (core + rest), k);
}

double moment_ratio_round_tube(double k, double q) {
  require_domain(q >= 0.0 && q < 1.0, "a radius_ratio >= 0, < 1");
  const double q3 = q * q * q;
  return (moment_ratio_circle(k) - q3 * moment_ratio_circle(k * q)) / (1.0 - q3 * q);
}

double moment_ratio_rectangular_tube(double k, double q, double breadth_ratio) {
  require_domain(q >= 0.0 && q < 1.0, "a depth_ratio >= 0, < 1");
  require_domain(breadth_ratio >= 0.0 && breadth_ratio < 1.0, "a breadth_ratio >= 0, < 1");
  const double hole = breadth_ratio * q * q;
  return (moment_ratio_rectangle(k) - hole * moment_ratio_rectangle(k * q)) / (1.0 - hole * q);
}

}  // namespace plastica::theory
