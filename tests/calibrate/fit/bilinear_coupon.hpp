#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/inference/bootstrap.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::testing {

/// Stress = 1.5 strain up to Y, then with the slope H, numbers taken as Pa: the curves of
/// ../shared/data/synthetic-bilinear.
struct Bilinear {
  double yield_stress = 0.15;
  double tangent_modulus = 0.1;
};
inline constexpr double kBilinearModulus = 1.5;

inline double bilinear_stress(const Bilinear& truth, double strain) {
  const double yield_strain = truth.yield_stress / kBilinearModulus;
  return strain < yield_strain
             ? kBilinearModulus * strain
             : truth.yield_stress + truth.tangent_modulus * (strain - yield_strain);
}

/// A coupon in tension, which a target drives by its strain.
inline Setup bilinear_coupon() {
  Setup setup;
  setup.scene.name = "bilinear";
  setup.scene.material.youngs_modulus = kBilinearModulus;
  setup.scene.material.yield_stress = Bilinear{}.yield_stress;
  setup.scene.material.hardening.law = HardeningLaw::Linear;
  setup.scene.material.hardening.tangent_modulus = Bilinear{}.tangent_modulus;
  setup.scene.drive.strain = {0.0, 1.0};
  setup.scene.probes = {{"stress", ProbeQuantity::Stress}};
  return setup;
}

/// 100 samples of strain 0 … 1.
inline calibrate::SceneTarget bilinear_target(const std::string& name, std::vector<double> stress) {
  calibrate::SceneTarget target;
  target.name = name;
  target.kind = calibrate::Abscissa::Strain;
  target.ordinate_probe = "stress";
  target.abscissa_is = Dimension::Strain;
  target.ordinate_is = Dimension::Stress;
  for (std::size_t i = 0; i < stress.size(); ++i) {
    target.abscissa.push_back(static_cast<double>(i) / static_cast<double>(stress.size() - 1));
  }
  target.ordinate = std::move(stress);
  return target;
}

/// The same, made with normal noise of a seed.
inline calibrate::SceneTarget noisy_bilinear(const Bilinear& truth, double noise,
                                             std::uint64_t seed, int samples = 100) {
  calibrate::Draws draws(seed, 0);
  std::vector<double> stress;
  for (int i = 0; i < samples; ++i) {
    stress.push_back(bilinear_stress(truth, i / (samples - 1.0)) + noise * draws.normal());
  }
  return bilinear_target("bilinear", std::move(stress));
}

inline calibrate::Parameter bounded(const std::string& name, double lower, double upper) {
  calibrate::Parameter p;
  p.field = &find_field(name);
  p.lower = lower;
  p.upper = upper;
  return p;
}

/// Yield stress and tangent modulus.
inline std::vector<calibrate::Parameter> yield_and_tangent() {
  return {bounded("yield_stress", 0.02, 1.0), bounded("tangent_modulus", 0.005, 1.0)};
}

}  // namespace plastica::testing
