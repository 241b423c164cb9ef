#include "plastica/theory/elastica.hpp"

#include <algorithm>
#include <cmath>

#include "plastica/base/domain.hpp"

namespace plastica::theory {
namespace {

/// The arguments spread over their mean by less than this leave a series remainder of its sixth
/// power, about 1e-16.
constexpr double kSpread = 2e-3;

/// sqrt(alpha) that bends the tip to sin(slope) = tanh u.
double root_of_load(double u) {
  const double s = std::tanh(u);
  const double rest = 2.0 / (std::exp(2.0 * u) + 1.0);  // 1 - s, without cancellation
  return std::sqrt(2.0 * s) * carlson_rf(rest, rest * (1.0 + s), 1.0 + s);
}

}  // namespace

double carlson_rf(double x, double y, double z) {
  for (;;) {
    const double mean = (x + y + z) / 3.0;
    const double a = 1.0 - x / mean, b = 1.0 - y / mean, c = 1.0 - z / mean;
    if (std::max({std::abs(a), std::abs(b), std::abs(c)}) < kSpread) {
      const double e2 = a * b - c * c, e3 = a * b * c;
      return (1.0 + e2 * (e2 / 24.0 - 0.1 - 3.0 / 44.0 * e3) + e3 / 14.0) / std::sqrt(mean);
    }
    const double shift = std::sqrt(x * y) + std::sqrt(y * z) + std::sqrt(z * x);
    x = 0.25 * (x + shift);
    y = 0.25 * (y + shift);
    z = 0.25 * (z + shift);
  }
}

double carlson_rd(double x, double y, double z) {
  double sum = 0.0;
  double weight = 1.0;
  for (;;) {
    const double mean = (x + y + 3.0 * z) / 5.0;
    const double a = 1.0 - x / mean, b = 1.0 - y / mean, c = 1.0 - z / mean;
    if (std::max({std::abs(a), std::abs(b), std::abs(c)}) < kSpread) {
      const double ab = a * b, cc = c * c;
      const double e2 = ab - 6.0 * cc, e3 = (3.0 * ab - 8.0 * cc) * c, e4 = 3.0 * (ab - cc) * cc;
      const double e5 = ab * cc * c;
      const double series = 1.0 - 3.0 / 14.0 * e2 + e3 / 6.0 + 9.0 / 88.0 * e2 * e2 -
                            3.0 / 22.0 * e4 - 9.0 / 52.0 * e2 * e3 + 3.0 / 26.0 * e5;
      return 3.0 * sum + weight * series / (mean * std::sqrt(mean));
    }
    const double shift = std::sqrt(x * y) + std::sqrt(y * z) + std::sqrt(z * x);
    sum += weight / (std::sqrt(z) * (z + shift));
    weight *= 0.25;
    x = 0.25 * (x + shift);
    y = 0.25 * (y + shift);
    z = 0.25 * (z + shift);
  }
}

ElasticaTip elastica_tip_force(double load) {
  require_domain(load >= 0.0 && load <= 1e4, "load >= 0.0 && load <= 1e4");
  if (load == 0.0) return {};
  const double root = std::sqrt(load);
  double low = 0.0;
  double high = 1.0;
  while (root_of_load(high) < root) high *= 2.0;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (root_of_load(middle) < root ? low : high) = middle;
  }
  const double u = high;
  const double s = std::tanh(u);
  const double rest = 2.0 / (std::exp(2.0 * u) + 1.0);
  const double both = rest * (1.0 + s);  // 1 - s^2
  const double F = carlson_rf(rest, both, 1.0 + s);
  const double D = carlson_rd(rest, 1.0 + s, both);
  return {.slope = 2.0 * std::atan(std::tanh(0.5 * u)),
          .deflection = std::sqrt(2.0 * s) * s / root * (F - both / 3.0 * D),
          .position = std::sqrt(2.0 * s) / root};
}

ElasticaTip elastica_tip_moment(double angle) {
  if (angle == 0.0) return {};
  const double half = std::sin(0.5 * angle);
  return {.slope = angle,
          .deflection = 2.0 * half * half / angle,  // 1 - cos, without cancellation
          .position = std::sin(angle) / angle};
}

}  // namespace plastica::theory
