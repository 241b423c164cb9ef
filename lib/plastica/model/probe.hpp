#pragma once

#include <string>

#include "plastica/base/quantity.hpp"

namespace plastica {

/// What a probe records at each sample of the drive.
enum class ProbeQuantity {
  Strain,             ///< as driven [1]
  Stress,             ///< of the extreme fibre [Pa]
  PlasticStrain,      ///< permanent strain, with sign [1]
  AccumulatedStrain,  ///< sum of |d plastic strain| [1]
  Load,               ///< force [N], bending moment or torque [N m]
  Dissipation,        ///< plastic work per volume at the extreme fibre [J/m^3 = Pa]
};

struct Probe {
  std::string name;  ///< unique within a scene
  ProbeQuantity quantity = ProbeQuantity::Stress;
};

}  // namespace plastica
