#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/motion_scene.hpp"
#include "tests/support/sanitized.hpp"
#include "tests/support/tolerance.hpp"

/// Motions of supports that move themselves.
namespace plastica {
namespace {

using testing::add_probe;
using testing::completed;
using testing::motion_options;
using testing::tolerance;

constexpr Scheme kSchemes[] = {Scheme::LinearlyImplicitEuler, Scheme::LinearlyImplicitMidpoint,
                               Scheme::GeneralizedAlpha, Scheme::EnergyMomentum};

/// A table of a smooth step over [0, 0.3 s]: straight lines between its rows.
History table_of(double row) {
  const History smooth = History::smooth_step(0.0, 0.3);
  History table{{}, {}};
  for (int i = 0; row * i < 0.3 + 0.5 * row; ++i) {
    table.time.push_back(row * i);
    table.factor.push_back(smooth.at(row * i));
  }
  return table;
}

/// A rod that turns out of its clamp by itself; the clamp moves by next to nothing.
Scene nudged_rod(const History* history) {
  Scene scene = testing::cantilever_scene(1);
  scene.material.density = 7850.0;
  InitialMotion turns;
  turns.spin = {0.1, 0.0, 0.0};
  scene.initial_motions = {turns};
  if (history != nullptr) {
    scene.supports[0].rotation = {1e-9, 0.0, 0.0};
    scene.supports[0].history = *history;
  }
  add_probe(scene, ProbeQuantity::Angle, Place::start(), Component::X);
  return scene;
}

/// The largest difference of two series, `every` so many samples of the second.
double difference(const Response& a, const Response& b, std::size_t every = 1) {
  double off = 0.0;
  for (std::size_t i = 0; i < a.samples; ++i) {
    off = std::max(off, std::fabs(a.probes[0][i] - b.probes[0][i * every]));
  }
  return off;
}

/// What moves by a nanorad damps and swings as what stands still, along curves and tables alike; at
/// the corners of these generalized-alpha begins anew, which is off by no more than its step is.
TEST(MovingSupports, ThatHardlyMoveChangeNothing) {
  for (const Scheme scheme : kSchemes) {
    for (const Damping damping : {Damping::None, Damping::Stiffness}) {
      if (testing::kSanitized && damping == Damping::None) continue;
      SolverOptions options = motion_options(scheme, 1e-3, 300);
      options.damping = damping;
      options.damping_time = damping == Damping::None ? 0.0 : 1e-3;
      SolverOptions halves = motion_options(scheme, 5e-4, 600);
      halves.damping = options.damping;
      halves.damping_time = options.damping_time;
      const Response still = completed(nudged_rod(nullptr), options);
      // Half the step leaves a quarter of an error of second order.
      const double of_step =
          4.0 / 3.0 * difference(still, completed(nudged_rod(nullptr), halves), 2);
      const History histories[] = {History::smooth_step(0.0, 0.3), History::sine(0.087, 3.0),
                                   table_of(1e-3), table_of(5e-3)};
      for (std::size_t k = 0; k < std::size(histories); ++k) {
        // The rod swings by 1.5e-3; a nudge adds no more than its speed, 1e-7 rad/s, over 66 rad/s.
        const double off = difference(still, completed(nudged_rod(&histories[k]), options));
        EXPECT_LT(off, k < 2 ? 2e-8 : std::max(2e-8, of_step))
            << static_cast<int>(scheme) << ' ' << static_cast<int>(damping) << ' ' << k;
      }
    }
  }
}

/// tau omega/2 of one joint of a rigid rod, by the angles at its turns.
TEST(MovingSupports, LeaveTheDampingRatio) {
  const History curve = History::smooth_step(0.0, 0.3);
  SolverOptions options = motion_options(Scheme::GeneralizedAlpha, 1e-4, 3000);
  options.damping = Damping::Stiffness;
  options.damping_time = 1e-3;
  const Scene scene = nudged_rod(&curve);
  const Response response = completed(scene, options);
  const auto& angle = response.probes[0];
  std::vector<double> turns;
  for (std::size_t i = 1; i + 1 < response.samples; ++i) {
    if (angle[i] > angle[i - 1] && angle[i] >= angle[i + 1]) turns.push_back(angle[i]);
  }
  ASSERT_GT(turns.size(), 2u);
  const double decrement =
      std::log(turns.front() / turns.back()) / static_cast<double>(turns.size() - 1);
  const double ratio = decrement / std::hypot(2.0 * std::numbers::pi, decrement);
  const double mass = 7850.0 * 0.02 * 0.02;
  const double inertia = mass * (1.0 / 3.0 + 0.02 * 0.02 / 12.0);
  const double stiffness = testing::bending_stiffness_of(scene) / 0.5;
  const double omega = std::sqrt(stiffness / inertia);
  EXPECT_NEAR(ratio / (0.5 * 1e-3 * omega), 1.0, 0.01);
}

/// A rod that its clamp carries along without turning it: the clamp's force is its mass times the
/// acceleration.
TEST(MovingSupports, CarryWhatTheyMove) {
  const double mass = 7850.0 * 0.02 * 0.02;
  for (std::size_t way = 0; way < 2 * std::size(kSchemes); ++way) {
    const Scheme scheme = kSchemes[way / 2];
    const bool spline = way % 2 == 1;
    Scene scene = testing::cantilever_scene(1);
    scene.material.density = 7850.0;
    scene.supports[0].translation = {0.0, 0.0, 0.05};  // along the rod
    // The rows of a table, too, with the spline through them.
    const History rows = table_of(0.01);
    scene.supports[0].history =
        spline ? History::spline(rows.time, rows.factor) : History::smooth_step(0.0, 0.3);
    add_probe(scene, ProbeQuantity::Reaction, Place::start(), Component::Z);
    const SolverOptions options = motion_options(scheme, 1e-3, 290);
    const Response response = completed(scene, options);
    const double largest = mass * 0.05 * 6.0 / (0.3 * 0.3);
    for (std::size_t i = 20; i < response.samples; ++i) {
      const double s = 1e-3 * static_cast<double>(i) / 0.3;
      const double force = mass * 0.05 * (6.0 - 12.0 * s) / (0.3 * 0.3);
      // Of first order are Euler's scheme and a force over a step.
      EXPECT_NEAR(response.probes[0][i], force, tolerance(0.01 * largest))
          << static_cast<int>(scheme) << " at " << i;
    }
    // Euler's loses as much as it takes up.
    if (scheme == Scheme::LinearlyImplicitEuler) continue;
    const Energies& energy = testing::last_energy(response);
    EXPECT_NEAR(energy.external, energy.kinetic, tolerance(0.01 * energy.kinetic + 1e-6))
        << static_cast<int>(scheme);
  }
}

/// A clamp that turns: the tip's error falls by four where the step is halved.
TEST(MovingSupports, KeepTheOrderOfGeneralizedAlpha) {
  const auto tip = [](double time_step, int steps) {
    Scene scene = testing::cantilever_scene(1);
    scene.material.youngs_modulus = 2e9;
    scene.material.density = 1200.0;
    scene.supports[0].rotation = {0.3, 0.0, 0.0};
    scene.supports[0].history = History::smooth_step(0.0, 0.3);
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
    return testing::last_of(
        completed(scene, motion_options(Scheme::GeneralizedAlpha, time_step, steps)), 0);
  };
  const double coarse = tip(4e-3, 50), middle = tip(2e-3, 100), fine = tip(1e-3, 200);
  EXPECT_NEAR(std::log2(std::fabs((coarse - middle) / (middle - fine))), 2.0, 0.2);
}

/// Steps that follow an error are those of the scheme's order: of midpoint schemes, whose
/// velocities are fitted to a smooth support at each step, as many as of generalized-alpha, whose
/// are not.
TEST(MovingSupports, TakeStepsOfTheSchemesOrder) {
  Scene scene = testing::cantilever_scene(8);
  scene.material.density = 7850.0;
  scene.supports[0].translation = {0.0, 0.01, 0.0};
  scene.supports[0].history = History::sine(0.1, 1.5);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const double exact =
      testing::last_of(completed(scene, motion_options(Scheme::EnergyMomentum, 1e-5, 10000)), 0);
  double steps = 0.0;
  for (const Scheme scheme :
       {Scheme::GeneralizedAlpha, Scheme::LinearlyImplicitMidpoint, Scheme::EnergyMomentum}) {
    SolverOptions options = motion_options(scheme, 1e-2, 10);
    options.step_error = 1e-8;
    const Response response = completed(scene, options);
    EXPECT_NEAR(testing::last_of(response, 0), exact, tolerance(5e-6)) << int(scheme);
    if (steps == 0.0) steps = response.counters.steps;
    EXPECT_NEAR(response.counters.steps / steps, 1.0, 0.1) << int(scheme);
  }
}

/// A lone segment that spins about its center has no linear momentum of which rounding could be
/// all.
TEST(MovingSupports, ALoneSegmentThatSpinsIsBalanced) {
  Scene scene = testing::chain_scene(1);
  scene.material.density = 7850.0;
  InitialMotion turns;
  turns.about = {0.5, {}};
  turns.spin = {3.0, 0.0, 0.0};
  scene.initial_motions = {turns};
  const Response response = completed(scene, motion_options(Scheme::EnergyMomentum, 1e-3, 200));
  EXPECT_LT(response.momentum_error, 1e-3);
}

/// Behind the end of a motion its supports do not stop: nothing is recorded of that.
TEST(MovingSupports, ThatMoveUntilTheEndHaveNoOtherReactionThere) {
  Scene scene = testing::cantilever_scene(10);
  scene.material.density = 7850.0;
  Support& clamp = scene.supports[0];
  clamp.translation = {0.0, 1e-3, 0.0};
  clamp.history = History::spline({0.0, 0.1, 0.2, 0.3}, {0.0, 1.0, 4.0, 9.0});
  add_probe(scene, ProbeQuantity::ReactionMoment, Place::start(), Component::X);
  for (const Scheme scheme : kSchemes) {
    if (testing::kSanitized && scheme != kSchemes[0]) continue;
    SolverOptions options = motion_options(scheme, 1e-4, 3000);
    options.damping = Damping::Stiffness;
    options.damping_time = 1e-3;
    const std::vector<double> moment = completed(scene, options).probes[0];
    const double before = moment.end()[-2];
    EXPECT_NEAR(moment.back(), before, tolerance(0.05 * std::fabs(before)))
        << static_cast<int>(scheme);
  }
}

}  // namespace
}  // namespace plastica
