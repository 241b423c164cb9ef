#pragma once

#include <algorithm>

#include "tests/calibrate/fit/targets.hpp"

namespace plastica::testing {

/// A bar with Voce hardening, stretched to 5 %, with a noise of 1 MPa.
inline calibrate::Target voce_target() {
  calibrate::FitOptions truth;
  Material& material = truth.setup.scene.material;
  material.youngs_modulus = 200e9;
  material.yield_stress = 300e6;
  material.hardening.law = HardeningLaw::VoceChaboche;
  material.hardening.saturation_stress = 150e6;
  material.hardening.saturation_rate = 60.0;
  calibrate::Target target = target_like(truth, Deformation::Tension, ramp(200, 0.05));
  Noise noise(7);
  for (double& stress : target.corrected.stress) stress += noise(1e6);
  return target;
}

/// A bar that softens: hardening of any kind makes it worse.
inline calibrate::Target softening_target() {
  calibrate::Target target = voce_target();
  for (std::size_t i = 0; i < target.corrected.size(); ++i) {
    const double strain = target.corrected.strain[i];
    target.corrected.stress[i] = std::min(200e9 * strain, 300e6 - 2e9 * strain);
  }
  return target;
}

}  // namespace plastica::testing
