#include "plastica/theory/report_formulas.hpp"

#include <algorithm>
#include <cmath>

namespace plastica::theory::report {

double bending_stiffness(double youngs_modulus, double second_moment, double length_a,
                         double length_b) {
  return youngs_modulus * second_moment / (length_a + length_b);
}

double torsion_stiffness(double youngs_modulus, double poisson_ratio, double second_moment,
                         double length_a, double length_b) {
  return youngs_modulus * second_moment / (2.0 * (length_a + length_b) * (1.0 + poisson_ratio));
}

double torsion_second_moment(double second_moment_x, double second_moment_y) {
  return std::max(second_moment_x, second_moment_y);
}

double bending_cap_x(double yield_stress, double second_moment_x, double width) {
  return yield_stress * second_moment_x / width;
}

double bending_cap_y(double yield_stress, double second_moment_y, double height) {
  return yield_stress * second_moment_y / height;
}

double torsion_cap(double shear_yield_stress, double width, double height) {
  const double longer = std::max(width, height);
  const double shorter = std::min(width, height);
  return shear_yield_stress * width * width * height * height / (3.0 * longer + 1.8 * shorter);
}

double bending_strain_x(double width, double angle, double length) {
  return bending_strain(width, angle, length);
}

double bending_strain_y(double height, double angle, double length) {
  return bending_strain(height, angle, length);
}

double torsion_strain(double longer_side, double angle, double length) {
  return longer_side / 2.0 * angle / length;
}

double bending_strain(double height, double angle, double length) {
  const double half = height / 2.0;
  return std::sqrt(2.0 * half * half * (1.0 - std::cos(angle))) / length;
}

}  // namespace plastica::theory::report
