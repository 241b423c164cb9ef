#include <algorithm>
#include <cmath>

#include "plastica/coupon/shape.hpp"
#include "plastica/theory/uniaxial.hpp"
#include "sweeps/stability/base_scene.hpp"
#include "sweeps/stability/scene_parts.hpp"

namespace plastica::sweeps::stability {
namespace {

/// A coupon that is strained to `load` times the nominal yield strain, back to as much below zero,
/// and to zero.
StabilityCase coupon(const Knobs& knobs, Deformation deformation) {
  StabilityCase made = parts::beam(knobs, Level::Auto, YieldModel::Interaction);
  Scene& scene = made.setup.scene;
  const bool twists = deformation == Deformation::Torsion;
  const double stiffness =
      twists ? resolved_shear_modulus(scene.material) : scene.material.youngs_modulus;
  const double strain = knobs.load * parts::kNominalYield / stiffness;
  scene.drive.deformation = deformation;
  for (const double factor : {0.0, 0.5, 1.0, 0.5, -1.0, 0.0})
    scene.drive.strain.push_back(factor * strain);
  scene.probes = {{"stress", ProbeQuantity::Stress}};
  return made;
}

StabilityCase ideal(const Knobs& knobs, Deformation deformation) {
  StabilityCase made = coupon(knobs, deformation);
  const Scene& scene = made.setup.scene;
  const bool twists = deformation == Deformation::Torsion;
  const double stiffness =
      twists ? resolved_shear_modulus(scene.material) : scene.material.youngs_modulus;
  const double yield =
      twists ? resolved_shear_yield_stress(scene.material) : scene.material.yield_stress;
  double stress = 0.0;
  double before = 0.0;
  for (std::size_t i = 0; i < scene.drive.strain.size(); ++i) {
    stress = std::clamp(stress + stiffness * (scene.drive.strain[i] - before), -yield, yield);
    before = scene.drive.strain[i];
    // A stress that has come back to zero is a difference of large ones.
    made.expected.references.push_back({.what = "stress",
                                        .probe = 0,
                                        .sample = i,
                                        .value = stress,
                                        .size = std::min(yield, knobs.load * parts::kNominalYield),
                                        .tolerance = 1e-9});
  }
  return made;
}

StabilityCase tension(const Knobs& knobs) { return ideal(knobs, Deformation::Tension); }
StabilityCase bending(const Knobs& knobs) { return ideal(knobs, Deformation::Bending); }
StabilityCase torsion(const Knobs& knobs) { return ideal(knobs, Deformation::Torsion); }

StabilityCase linear(const Knobs& knobs) {
  StabilityCase made = coupon(knobs, Deformation::Tension);
  Scene& scene = made.setup.scene;
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 0.1 * knobs.youngs_modulus;
  scene.material.hardening.kinematic_fraction = 0.5;
  const double stress = theory::bilinear_stress(scene.drive.strain[2], knobs.youngs_modulus,
                                                knobs.yield_stress, 0.1 * knobs.youngs_modulus);
  made.expected.references = {
      {.what = "stress", .probe = 0, .sample = 2, .value = stress, .tolerance = 1e-9}};
  return made;
}

StabilityCase voce(const Knobs& knobs) {
  StabilityCase made = coupon(knobs, Deformation::Tension);
  Material& material = made.setup.scene.material;
  Hardening& hardening = material.hardening;
  hardening.law = HardeningLaw::VoceChaboche;
  hardening.saturation_stress = 100e6;
  hardening.saturation_rate = 20.0;
  hardening.backstress_modulus = {20e9, 2e9, 0.0};
  hardening.backstress_rate = {200.0, 10.0, 0.0};
  const double stress = theory::tension_stress(made.setup.scene.drive.strain[2], material);
  made.expected.references = {
      {.what = "stress", .probe = 0, .sample = 2, .value = stress, .tolerance = 1e-6}};
  return made;
}

StabilityCase breaks(const Knobs& knobs) {
  StabilityCase made = ideal(knobs, Deformation::Tension);
  made.setup.scene.material.break_strain =
      0.25 * knobs.load * parts::kNominalYield / knobs.youngs_modulus;
  const double plastic =
      made.setup.scene.drive.strain[2] - knobs.yield_stress / knobs.youngs_modulus;
  made.expected.breaks = plastic > *made.setup.scene.material.break_strain * (1.0 + 1e-9);
  made.expected.references.clear();
  return made;
}

}  // namespace

std::vector<BaseScene> coupon_scenes() {
  Knobs plastic;
  plastic.load = 4.0;
  const std::vector<std::string_view> axes{"modulus", "yield",       "poisson",
                                           "load",    "slenderness", "length"};
  using Pairs = std::vector<std::pair<std::string_view, std::string_view>>;
  const Pairs pairs{{"modulus", "yield"}, {"modulus", "load"}};
  const auto scene = [&](std::string_view name, StabilityCase (*make)(const Knobs&)) {
    return BaseScene{name, Level::Coupon, Analysis::Statics, make, plastic, axes, pairs};
  };
  return {scene("coupon tension", tension),        scene("coupon bending", bending),
          scene("coupon torsion", torsion),        scene("coupon linear hardening", linear),
          scene("coupon Voce and Chaboche", voce), scene("coupon break", breaks)};
}

}  // namespace plastica::sweeps::stability
