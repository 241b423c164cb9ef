#pragma once

#include <utility>
#include <vector>

#include "plastica/run/simulate.hpp"

namespace plastica::testing {

inline constexpr double kE = 200e9;
inline constexpr double kNu = 0.3;
inline constexpr double kG = kE / 2.6;
inline constexpr double kYield = 300e6;

/// A steel-like coupon: a bar of 60 mm x 100 mm, all six probes, ideal plastic and unbreakable.
inline Scene coupon_scene(Deformation deformation, std::vector<double> strain) {
  Scene scene;
  scene.material.youngs_modulus = kE;
  scene.material.poisson_ratio = kNu;
  scene.material.yield_stress = kYield;
  scene.section.width = 0.06;
  scene.section.height = 0.1;
  scene.drive = {deformation, std::move(strain)};
  scene.probes = {{"strain", ProbeQuantity::Strain},
                  {"stress", ProbeQuantity::Stress},
                  {"plastic", ProbeQuantity::PlasticStrain},
                  {"accumulated", ProbeQuantity::AccumulatedStrain},
                  {"load", ProbeQuantity::Load},
                  {"dissipation", ProbeQuantity::Dissipation}};
  return scene;
}

/// The values of a quantity that the scene of `coupon_scene` probes.
inline const std::vector<double>& of(const Response& response, ProbeQuantity quantity) {
  return response.probes[static_cast<std::size_t>(quantity)];
}

inline double last(const Response& response, ProbeQuantity quantity) {
  return of(response, quantity).back();
}

/// The stress at the end of a path.
inline double last_stress(const Scene& scene) {
  return last(simulate(scene), ProbeQuantity::Stress);
}

}  // namespace plastica::testing
