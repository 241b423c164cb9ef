#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/target/target.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::testing {

using namespace plastica::calibrate;

inline Parameter free_parameter(std::string_view name) {
  Parameter p;
  p.field = &find_field(name);
  return p;
}

inline Parameter free_parameter(std::string_view name, double start) {
  Parameter p = free_parameter(name);
  p.value = start;
  return p;
}

inline Parameter fixed_parameter(std::string_view name, double value) {
  Parameter p = free_parameter(name, value);
  p.role = ParameterRole::Fixed;
  return p;
}

inline Parameter tied_parameter(std::string_view name, std::string_view base, double factor) {
  Parameter p = free_parameter(name);
  p.role = ParameterRole::Tied;
  p.tied_to = &find_field(base);
  p.factor = factor;
  return p;
}

inline FitOptions fit_of(std::vector<Parameter> parameters) {
  FitOptions options;
  options.parameters = std::move(parameters);
  return options;
}

/// A fit of modulus, yield stress and all `more`; its setup holds the truth for `target_like`.
inline FitOptions fit_with(HardeningLaw law, std::vector<Parameter> more = {}) {
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  options.parameters.insert(options.parameters.end(), more.begin(), more.end());
  options.setup.scene.material.hardening.law = law;
  options.setup.scene.material.youngs_modulus = 190e9;
  options.setup.scene.material.yield_stress = 317e6;
  return options;
}

/// n strains from 0 to `last`, equally spaced, both included.
inline std::vector<double> ramp(std::size_t n, double last) {
  std::vector<double> strain(n);
  for (std::size_t i = 0; i < n; ++i) {
    strain[i] = last * static_cast<double>(i) / static_cast<double>(n - 1);
  }
  return strain;
}

/// Straight lines through `corners`, `n` samples each.
inline std::vector<double> path(const std::vector<double>& corners, std::size_t n) {
  std::vector<double> strain{0.0};
  double from = 0.0;
  for (const double to : corners) {
    for (std::size_t i = 1; i <= n; ++i) {
      strain.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(n));
    }
    from = to;
  }
  return strain;
}

/// min(E strain, Y): a monotonic curve of ideal plasticity.
inline std::vector<double> ideal_curve(const std::vector<double>& strain, double E, double Y) {
  std::vector<double> stress;
  for (const double e : strain) stress.push_back(std::min(E * e, Y));
  return stress;
}

/// A target as an import would hand it over; the modulus is a regression up to half the strength.
inline Target target_of(std::vector<double> strain, std::vector<double> stress,
                        Deformation test = Deformation::Tension) {
  Target target;
  target.name = "specimen";
  target.test = test;
  target.corrected = {std::move(strain), std::move(stress)};
  const Curve& curve = target.corrected;
  double strength = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    largest = std::max(largest, std::fabs(curve.strain[i]));
    if (std::fabs(curve.stress[i]) <= strength) continue;
    strength = std::fabs(curve.stress[i]);
    target.characteristics.strain_at_rm = std::fabs(curve.strain[i]);
  }
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < curve.size() && std::fabs(curve.stress[i]) < 0.5 * strength; ++i) {
    product += curve.strain[i] * curve.stress[i];
    square += curve.strain[i] * curve.strain[i];
  }
  if (square > 0.0) target.characteristics.youngs_modulus = product / square;
  target.characteristics.rm = strength;
  target.characteristics.largest_strain = largest;
  return target;
}

/// Lets a target break between its last sample and `first_broken`.
inline void break_at(Target& target, double first_broken, double permanent) {
  BreakObservation observed;
  observed.last_intact_strain = target.corrected.strain.back();
  observed.last_intact_stress = target.corrected.stress.back();
  observed.first_broken_strain = first_broken;
  observed.rule = "fall-to-zero";
  target.characteristics.observed_break = observed;
  target.characteristics.break_strain = observed.strain();
  target.characteristics.break_strain_plastic = permanent;
}

/// What a setup's beam, which never breaks, answers to a strain history.
inline std::vector<double> stress_of(const FitOptions& options, Deformation test,
                                     const std::vector<double>& strain) {
  Scene scene = options.setup.scene;
  scene.material.break_strain.reset();
  scene.material.break_shear_strain.reset();
  scene.drive = {test, strain};
  scene.probes = {{"stress", ProbeQuantity::Stress}};
  return simulate(scene, options.setup.solver).probes[0];
}

/// A target that a setup's beam follows exactly.
inline Target target_like(const FitOptions& truth, Deformation test, std::vector<double> strain) {
  std::vector<double> stress = stress_of(truth, test, strain);
  return target_of(std::move(strain), std::move(stress), test);
}

/// Seeded normal numbers, the same on every machine (Box and Muller).
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : random_(seed) {}
  double operator()(double deviation) {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return deviation * radius * std::cos(6.283185307179586 * uniform());
  }

 private:
  double uniform() { return (static_cast<double>(random_() >> 11U) + 0.5) * 0x1p-53; }
  std::mt19937_64 random_;
};

}  // namespace plastica::testing
