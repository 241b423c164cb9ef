#include "plastica/run/response.hpp"

#include <algorithm>
#include <cmath>

namespace plastica {

double ledger_error(std::span<const Energies> samples) {
  double largest = 0.0;
  double wrong = 0.0;
  for (const Energies& energy : samples) {
    wrong = std::max({wrong, std::fabs(energy.residual), -energy.numerical});
    for (const double entry : {energy.elastic, energy.kinetic, energy.plastic, energy.damping,
                               energy.numerical, energy.impact, energy.fracture, energy.external}) {
      largest = std::max(largest, std::fabs(entry));
    }
  }
  return largest > 0.0 ? wrong / largest : 0.0;
}

}  // namespace plastica
