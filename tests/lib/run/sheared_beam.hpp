#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

/// Beams that stretch and shear, for their tests.
namespace plastica::testing {

inline constexpr double kPullForce = 1e-2;  ///< [N]

inline SolverOptions elastic(int steps = 1) {
  SolverOptions options;
  options.translation = JointTranslation::Elastic;
  options.steps = steps;
  return options;
}

inline double value_of(const Scene& scene) { return last_of(completed(scene, elastic()), 0); }

inline double shear_stiffness_of(const Scene& scene) {
  const SectionProperties p = properties_of(scene);
  return resolved_shear_modulus(scene.material) * p.shear_coefficient_y * p.area;
}

/// Errors fall with the square of the segments, and are at most `most` over their square.
inline void expect_second_order(const std::function<double(int)>& error, double most,
                                std::array<int, 3> segments = {16, 64, 256}) {
  const double coarse = error(segments[0]);
  const double fine = error(segments[1]);
  const double finest = error(segments[2]);
  EXPECT_LT(std::fabs(coarse) * segments[0] * segments[0], most);
  EXPECT_NEAR(std::log(coarse / fine) / std::log(segments[1] / segments[0]), 2.0, tolerance(0.06));
  EXPECT_NEAR(std::log(fine / finest) / std::log(segments[2] / segments[1]), 2.0, tolerance(0.06));
}

}  // namespace plastica::testing
