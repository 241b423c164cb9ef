#include "plastica/theory/cantilever.hpp"

#include <algorithm>
#include <cmath>

#include "plastica/base/domain.hpp"

namespace plastica::theory {

double tip_deflection_ratio(double p) {
  require_domain(p >= 0.0 && p <= 1.5, "p >= 0.0 && p <= 1.5");
  if (p <= 1.0) return p;
  return (5.0 - (3.0 + p) * std::sqrt(3.0 - 2.0 * p)) / (p * p);
}

double plastic_zone_ratio(double p) { return std::max(0.0, 1.0 - 1.0 / std::max(p, 1.0)); }

double residual_tip_ratio(double p) { return tip_deflection_ratio(p) - p; }

}  // namespace plastica::theory
