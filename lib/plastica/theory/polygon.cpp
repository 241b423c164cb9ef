#include "plastica/theory/polygon.hpp"

#include <cmath>

#include "plastica/base/domain.hpp"

namespace plastica::theory {

double polygon_radius(int segments, double end_rotation) {
  return 1.0 / (2.0 * segments * std::sin(0.5 * end_rotation / segments));
}

std::array<double, 2> polygon_node(int segments, double end_rotation, int node) {
  require_domain(segments >= 1 && node >= 0 && node <= segments,
                 "segments >= 1 && node >= 0 && node <= segments");
  if (end_rotation == 0.0) return {static_cast<double>(node) / segments, 0.0};
  const double angle = node * end_rotation / segments;
  const double radius = polygon_radius(segments, end_rotation);
  const double half = std::sin(0.5 * angle);
  return {radius * std::sin(angle), 2.0 * radius * half * half};
}

}  // namespace plastica::theory
