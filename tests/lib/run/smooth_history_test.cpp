#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plastica/run/natural_frequencies.hpp"
#include "plastica/run/scene_warnings.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/sanitized.hpp"

// Loads with smooth histories, against the closed form of one mass on one spring.

namespace plastica {
namespace {

using testing::add_probe;

/// A chain of one segment, which swings about its clamp, pushed so little that it stays linear.
Scene swing(const History& history) {
  Scene scene = testing::cantilever_scene(1);
  scene.loads.push_back({.force = {0.0, 1e-3, 0.0}, .history = history});
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  return scene;
}

/// From rest: x/x_static = (sin w t - r sin w0 t)/(1 - r^2), r = w/w0.
TEST(SmoothHistory, OfASineMakesTheForcedVibrationOfTheory) {
  const double at_rest = testing::last_of(
      testing::completed(swing(History::ramp()), {.duration = 1.0, .steps = 1}), 0);
  const double own =
      2.0 * std::numbers::pi * unloaded_frequencies(swing(History::ramp()), {}, 1).front();
  for (const double ratio : {0.3, 0.9, 2.0}) {
    if (testing::kSanitized && ratio < 2.0) continue;
    const double rate = ratio * own;
    const double period = 2.0 * std::numbers::pi / rate;
    SolverOptions options;
    options.analysis = Analysis::Dynamics;
    options.scheme = Scheme::EnergyMomentum;
    options.duration = 4.0 * period;
    options.time_step = std::min(period, 2.0 * std::numbers::pi / own) / 400.0;
    options.steps = 40;
    const Response response = testing::completed(swing(History::sine(period, 4.0)), options);
    double largest = 0.0;
    double off = 0.0;
    for (std::size_t k = 0; k < response.samples; ++k) {
      const double t = response.chain.time[k];
      const double exact =
          at_rest * (std::sin(rate * t) - ratio * std::sin(own * t)) / (1.0 - ratio * ratio);
      largest = std::max(largest, std::fabs(exact));
      off = std::max(off, std::fabs(response.probes[0][k] - exact));
    }
    // Second order: (2 pi/400)^2/12 of the phase, over four periods.
    EXPECT_LT(off, 1e-3 * largest) << ratio;
  }
}

/// A free beam that a pin moves from one place to another: nothing else holds it, so that the pin's
/// force is the rate of its momentum. Where the motion begins and ends its acceleration jumps, by
/// 6/T^2 of the way.
TEST(SmoothHistory, OfAMotionHasTheForceThatItsMomentumTakes) {
  Scene scene = testing::chain_scene(8);
  scene.material.density = 7800.0;
  Support pin{.at = Place::start(), .kind = SupportKind::Pin};
  pin.translation = {0.0, 0.005, 0.0};
  pin.history = History::smooth_step(0.005, 0.025);
  scene.supports = {pin};
  scene.masses.push_back({.at = Place::start(), .mass = 3.0});
  add_probe(scene, ProbeQuantity::Momentum, Place::start(), Component::Y);
  add_probe(scene, ProbeQuantity::Reaction, Place::start(), Component::Y);
  for (const Scheme scheme : {Scheme::GeneralizedAlpha, Scheme::LinearlyImplicitEuler}) {
    SolverOptions options;
    options.analysis = Analysis::Dynamics;
    options.scheme = scheme;
    options.duration = 0.035;
    options.steps = 700;
    options.time_step = 5e-5;
    const Response response = testing::completed(scene, options);
    const auto& momentum = response.probes[0];
    const auto& force = response.probes[1];
    double largest = 0.0;
    for (const double f : force) largest = std::max(largest, std::fabs(f));
    EXPECT_GT(largest, 200.0);
    for (std::size_t k = 1; k + 1 < response.samples; ++k) {
      const double time = response.chain.time[k];
      if (std::fabs(time - 0.005) < 1e-4 || std::fabs(time - 0.025) < 1e-4) continue;
      const double rate = (momentum[k + 1] - momentum[k - 1]) /
                          (response.chain.time[k + 1] - response.chain.time[k - 1]);
      EXPECT_NEAR(force[k], rate, 0.02 * largest) << static_cast<int>(scheme) << " at " << time;
    }
  }
}

TEST(SmoothHistory, ThatStepsAreTooLongForIsWarnedOf) {
  Scene scene = swing(History::sine(1e-3, 10.0));
  SolverOptions options{.analysis = Analysis::Dynamics, .duration = 0.01, .steps = 5};
  const auto warned = [&](double time_step) {
    options.time_step = time_step;
    for (const std::string& warning : scene_warnings(prepare(scene, options))) {
      if (warning.find("in a period of load[1].history") != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(warned(1e-4));
  EXPECT_FALSE(warned(4.9e-5));
}

/// A path of equilibria goes from peak to peak whatever the samples are: a hinge that yields at
/// each of them has turned as with straight segments between the same peaks.
TEST(SmoothHistory, OfASineYieldsAtEachPeakOfAPath) {
  const auto run = [](const History& history, int steps) {
    Scene scene = testing::cantilever_scene(4);
    scene.yield_model = YieldModel::Interaction;
    scene.yield_cap = YieldCap::FullyPlastic;
    scene.material.hardening.law = HardeningLaw::Linear;
    scene.material.hardening.tangent_modulus = 0.05 * scene.material.youngs_modulus;
    const double yield =
        scene.material.yield_stress * testing::properties_of(scene).plastic_section_modulus_x;
    scene.loads.push_back({.force = {0.0, 1.3 * yield, 0.0}, .history = history});
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
    return testing::completed(scene, {.level = Level::Planar, .steps = steps});
  };
  const Response straight = run({{0.0, 0.25, 0.75, 1.25, 1.5}, {0.0, 1.0, -1.0, 1.0, 0.0}}, 12);
  const double left = testing::last_of(straight, 0);
  EXPECT_GT(std::fabs(left), 1e-3);
  for (const int steps : {1, 3, 20}) {
    const Response smooth = run(History::sine(1.0, 1.5), steps);
    EXPECT_NEAR(testing::last_of(smooth, 0), left, 2e-4 * std::fabs(left)) << steps;
  }
}

}  // namespace
}  // namespace plastica
