#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>

#include "calibrate/target/curve.hpp"
#include "calibrate/target/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::testing {

/// An ideal-plastic tension test: clamp(E e) up to the break, then zero stress.
struct IdealPlastic {
  double modulus = 200e9;
  double yield_stress = 400e6;
  double permanent_break = 0.05;
  std::size_t elastic = 40;   ///< steps on the elastic part
  std::size_t plateau = 100;  ///< samples beyond it
  std::size_t broken = 3;
  double noise = 0.0;  ///< standard deviation over the yield stress

  double yield_strain() const { return yield_stress / modulus; }

  /// Evenly spaced on the elastic part and on the plateau; the break falls half a step after the
  /// last intact sample.
  calibrate::Curve curve(unsigned seed = 1) const {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, noise > 0.0 ? noise * yield_stress : 1.0);
    calibrate::Curve out;
    const auto add = [&](double strain, double stress) {
      out.strain.push_back(strain);
      out.stress.push_back(stress + (noise > 0.0 ? normal(random) : 0.0));
    };
    for (std::size_t i = 0; i <= elastic; ++i) {
      const double fraction = static_cast<double>(i) / static_cast<double>(elastic);
      add(fraction * yield_strain(), fraction * yield_stress);
    }
    const double step = permanent_break / (static_cast<double>(plateau) + 0.5);
    for (std::size_t i = 1; i <= plateau + broken; ++i) {
      add(yield_strain() + step * static_cast<double>(i), i <= plateau ? yield_stress : 0.0);
    }
    return out;
  }
  std::size_t intact() const { return elastic + 1 + plateau; }
};

/// Takes the numbers of a made curve as they are, be they of a material or not.
inline calibrate::TargetOptions any_numbers() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  calibrate::TargetOptions options;
  options.plausible.min_modulus = options.plausible.min_yield_strain = 0.0;
  options.plausible.min_soft_yield_strain = 0.0;
  options.plausible.max_modulus = options.plausible.strong_stress = kInfinity;
  options.plausible.max_ductile_modulus = kInfinity;
  return options;
}

/// A smooth curve with hardening, as of an aluminium alloy: 70 GPa, 300 MPa, to 10 %.
inline calibrate::Curve smooth_curve(std::size_t samples = 500, double end = 0.1) {
  calibrate::Curve out;
  for (std::size_t i = 0; i < samples; ++i) {
    const double strain = end * static_cast<double>(i) / static_cast<double>(samples - 1);
    const double elastic = 70e9 * strain;
    const double plastic = 300e6 + 5e8 * strain;
    out.strain.push_back(strain);
    out.stress.push_back(elastic / std::pow(1.0 + std::pow(elastic / plastic, 12.0), 1.0 / 12.0));
  }
  return out;
}

/// A smooth curve that falls on from its largest stress along given fractions of it.
inline calibrate::Curve ending_with(std::initializer_list<double> fractions, double step = 1e-7) {
  calibrate::Curve curve = smooth_curve();
  const double rm = curve.stress.back();
  for (const double fraction : fractions) {
    curve.strain.push_back(curve.strain.back() + step);
    curve.stress.push_back(fraction * rm);
  }
  return curve;
}

/// A target's correction of a kind. @throws std::runtime_error if it has none
inline const calibrate::Correction& find_correction(const calibrate::Target& target,
                                                    const std::string& kind) {
  for (const calibrate::Correction& correction : target.corrections) {
    if (correction.kind == kind) return correction;
  }
  throw std::runtime_error("no correction " + kind);
}

/// Whether one of a target's warnings begins with these words.
inline bool warns_that(const calibrate::Target& target, std::string_view beginning) {
  return std::ranges::any_of(
      target.warnings, [&](const std::string& warning) { return warning.starts_with(beginning); });
}

}  // namespace plastica::testing
