#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/motion_scene.hpp"

namespace plastica {
namespace {

using testing::add_probe;
using testing::drift_of;
using testing::flying_scene;
using testing::motion_options;

void add_momenta(Scene& scene) {
  for (const Component axis : {Component::Y, Component::Z}) {
    add_probe(scene, ProbeQuantity::Momentum, {}, axis);
  }
  add_probe(scene, ProbeQuantity::AngularMomentum, {}, Component::X);
}

/// Sums of |p| and |r x p| over the segments at time 0.
std::array<double, 2> sizes_at_start(const Scene& scene) {
  const int n = scene.beam.segments;
  const double mass = scene.material.density * scene.section.width * scene.section.height / n;
  double momentum = 0.0;
  double turning = 0.0;
  for (int i = 0; i < n; ++i) {
    const double z = (i + 0.5) / n;
    std::array<double, 3> v{};
    for (const InitialMotion& part : scene.initial_motions) {
      if (z < part.from.fraction) continue;
      const double arm = z - part.about.fraction;
      v = {v[0] + part.velocity[0] + part.spin[1] * arm,
           v[1] + part.velocity[1] - part.spin[0] * arm, v[2] + part.velocity[2]};
    }
    momentum += mass * std::hypot(v[0], v[1], v[2]);
    turning += mass * z * std::hypot(v[0], v[1]);
  }
  return {momentum, turning};
}

double change_of(const Response& response, std::size_t probe) {
  double change = 0.0;
  for (const double value : response.probes[probe]) {
    change = std::max(change, std::fabs(value - response.probes[probe][0]));
  }
  return change;
}

double energy_drift(const Response& response) {
  const auto& energy = response.chain.energy;
  double most = 0.0;
  for (std::size_t i = 0; i < response.samples; ++i) {
    most = std::max(most, std::fabs(energy[i].kinetic + energy[i].elastic - energy[0].kinetic));
  }
  return most / energy[0].kinetic;
}

class FreeFlight : public ::testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Levels, FreeFlight, ::testing::Bool(),
                         [](const auto& each) { return each.param ? "spatial" : "planar"; });

TEST_P(FreeFlight, KeepsMomentumAndEnergyOverTenThousandSteps) {
  Scene scene = flying_scene(8, GetParam());
  add_momenta(scene);
  SolverOptions options = motion_options(Scheme::EnergyMomentum, 1e-3, 100);
  options.duration = 10.0;
  const Response response = simulate(scene, options);
  ASSERT_EQ(response.status, Status::Completed);
  EXPECT_EQ(response.counters.steps, 10000);
  const auto [momentum, turning] = sizes_at_start(scene);
  EXPECT_LT(change_of(response, 0), 1e-10 * momentum);
  EXPECT_LT(change_of(response, 1), 1e-10 * momentum);
  EXPECT_LT(change_of(response, 2), 1e-10 * turning);
  EXPECT_LT(energy_drift(response), 1e-6);
}

TEST_P(FreeFlight, DriftsByTheOrderOfTheOtherSchemes) {
  Scene scene = flying_scene(4, GetParam());
  scene.material.youngs_modulus = 2e7;  // bends slowly enough for the steps to follow
  add_momenta(scene);
  const auto drift = [&](Scheme scheme, double step) {
    SolverOptions options = motion_options(scheme, step, 20);
    options.duration = 0.1;
    options.rho_infinity = 1.0;
    return drift_of(simulate(scene, options), 2);
  };
  const auto order = [&](Scheme scheme) {
    return std::log2(drift(scheme, 2e-4) / drift(scheme, 1e-4));
  };
  EXPECT_GT(order(Scheme::LinearlyImplicitEuler), 0.9);
  EXPECT_GT(order(Scheme::GeneralizedAlpha), 1.9);
  EXPECT_LT(drift(Scheme::LinearlyImplicitMidpoint, 2e-4), 1e-10);
}

}  // namespace
}  // namespace plastica
