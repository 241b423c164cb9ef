#pragma once

#include <array>

#include "plastica/model/place.hpp"

namespace plastica {

/// A body that is fixed to the beam, its center of mass on the axis: an end plate, a motor.
///
/// It moves as the beam there does, and gravity acts on it.
struct PointMass {
  Place at{1.0, {}};
  double mass = 0.0;  ///< [kg], > 0, or 0 of one that has inertia alone
  /// Moments of inertia about its own center, >= 0 [kg m^2]. Its principal axes are the world's
  /// where the beam is undeformed, and turn with the beam.
  std::array<double, 3> inertia{};

  bool has_rotational_inertia() const { return inertia != std::array<double, 3>{}; }
};

}  // namespace plastica
