#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/motion_scene.hpp"

namespace plastica {
namespace {

using testing::add_probe;
using testing::last_energy;
using testing::last_of;
using testing::motion_options;

/// A cantilever of 10 m of weight and end force: f_1 is 13.6 Hz of the bar of 1 m, 20 mm x 20 mm.
Scene pushed_scene(YieldModel model, double force) {
  Scene scene = testing::cantilever_scene(10);
  scene.yield_model = model;
  Load push;
  push.force = {0.0, -force, 0.0};
  scene.loads.push_back(push);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  return scene;
}

class DampedRest : public ::testing::TestWithParam<Scheme> {};

INSTANTIATE_TEST_SUITE_P(Schemes, DampedRest,
                         ::testing::Values(Scheme::LinearlyImplicitEuler,
                                           Scheme::LinearlyImplicitMidpoint,
                                           Scheme::GeneralizedAlpha, Scheme::EnergyMomentum),
                         [](const auto& each) {
                           return "Scheme" + std::to_string(static_cast<int>(each.param));
                         });

TEST_P(DampedRest, IsTheStaticEquilibrium) {
  Scene scene = pushed_scene(YieldModel::Elastic, 100.0);
  const double still = last_of(testing::completed(scene), 0);
  scene.loads[0].history = History::constant();
  SolverOptions options = motion_options(GetParam(), 2e-3, 1000);
  options.damping = Damping::Stiffness;
  options.damping_time = 0.02;  // a good half of the critical one at f_1
  EXPECT_NEAR(last_of(testing::completed(scene, options), 0), still, 1e-6 * std::fabs(still));
}

TEST_P(DampedRest, IsTheStaticEquilibriumOfAYieldedBeam) {
  // First yield at 333 N; hardening keeps what was loaded along the same way. A model without the
  // axial force, which enters yielding at rest alone.
  Scene scene = pushed_scene(YieldModel::PerAxis, 400.0);
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 20e9;
  const double still = last_of(testing::completed(scene), 0);
  // Ramped over 50 periods of 13.6 Hz.
  scene.loads[0].history = {{0.0, 4.0}, {0.0, 1.0}};
  SolverOptions options = motion_options(GetParam(), 2e-3, 2500);
  options.damping = Damping::Stiffness;
  options.damping_time = 0.005;
  EXPECT_NEAR(last_of(testing::completed(scene, options), 0), still, 1e-3 * std::fabs(still));
}

TEST(EnergyBalance, CountsTheWorkOfAnEndThatIsTurned) {
  Scene scene = testing::cantilever_scene(6);
  Support end{.at = Place::end(), .kind = SupportKind::Guide};
  end.hold = HeldFreedoms{false, false, false, true, false, false};
  end.rotation = {-0.3, 0.0, 0.0};
  end.history = {{0.0, 0.1}, {0.0, 1.0}};
  scene.supports.push_back(end);
  SolverOptions options = motion_options(Scheme::GeneralizedAlpha, 1e-4, 10);
  options.duration = 0.1;
  options.damping = Damping::Stiffness;
  options.damping_time = 5e-3;
  const Response response = testing::completed(scene, options);
  EXPECT_GT(last_energy(response).external, 1.0);
  // The moment of the steps' ends alone would be off by a fraction of 1e-3, one over their number.
  EXPECT_LT(testing::largest_residual(response), 1e-7);
  // Damping begins at once, faster than the step: the scheme makes some energy there.
  EXPECT_LT(response.energy_balance_error, 1e-4);
}

TEST(AdaptiveSteps, MeetTheErrorTheyAreGiven) {
  Scene scene = pushed_scene(YieldModel::Elastic, 100.0);
  scene.loads[0].history = {{0.0, 0.1}, {0.0, 1.0}};
  SolverOptions exact = motion_options(Scheme::EnergyMomentum, 1e-5, 10);
  exact.duration = 0.1;
  const double tip = last_of(testing::completed(scene, exact), 0);
  double before = 1.0;
  int steps_before = 0;
  for (const double error : {1e-5, 1e-6, 1e-7}) {
    SolverOptions options = exact;
    options.time_step = 0.01;
    options.step_error = error;
    const Response response = testing::completed(scene, options);
    const double off = std::fabs(last_of(response, 0) - tip);
    EXPECT_LT(off, 0.5 * before);
    EXPECT_GT(response.counters.steps, steps_before);
    before = off;
    steps_before = response.counters.steps;
  }
  EXPECT_LT(before, 1e-4 * std::fabs(tip));
}

TEST(Damping, TakesEnergyOutOfAVibrationByItsRatio) {
  // A free vibration of f_1 loses exp(-2 pi zeta) of its amplitude a period, zeta = pi f_1 tau.
  Scene scene = testing::cantilever_scene(20);
  InitialMotion blow;
  blow.from = {0.9, {}};
  blow.velocity = {0.0, 0.1, 0.0};
  scene.initial_motions = {blow};
  for (const Damping damping : {Damping::Stiffness, Damping::Relaxation}) {
    SolverOptions options = motion_options(Scheme::EnergyMomentum, 2e-4, 100);
    options.duration = 1.0;
    options.damping = damping;
    options.damping_time = 1e-3;
    const Response response = testing::completed(scene, options);
    const auto total = [&](std::size_t sample) {
      return response.chain.energy[sample].kinetic + response.chain.energy[sample].elastic;
    };
    // The higher modes are gone after 0.2 s; f_1 of the chain of 20 is 16.16 Hz.
    const double f = 0.16154 * 0.02 * std::sqrt(200e9 / 7850.0);
    const double rate = std::log(total(20) / total(100)) / 0.8;
    const double expected = 4.0 * M_PI * M_PI * f * f * options.damping_time;
    EXPECT_NEAR(rate, expected, 0.01 * expected);
  }
}

}  // namespace
}  // namespace plastica
