#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/run/batch.hpp"
#include "tests/support/motion_scene.hpp"

/// Spatial scenes of articulated schemes, against the schemes that solve the whole step.
namespace plastica {
namespace {

using testing::add_probe;
using testing::completed;

/// A soft bar of 20 mm x 30 mm that falls aslant and is twisted at its tip.
Scene twisted_scene(int segments) {
  Scene scene = testing::cantilever_scene(segments);
  scene.material.youngs_modulus = 2e9;
  scene.material.density = 1200.0;
  scene.section.height = 0.03;
  scene.gravity = {4.0, -9.81, 0.0};
  scene.gravity_history = History::constant();
  Load load;
  load.at = Place::end();
  load.force = {1.0, -2.0, 0.5};
  load.moment = {0.3, 0.2, 1.5};
  load.history = History::constant();
  scene.loads.push_back(load);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::X);
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::Z);
  return scene;
}

SolverOptions options_of(Scheme scheme, double step, double duration) {
  SolverOptions options = testing::motion_options(scheme, step, 20);
  options.duration = duration;
  return options;
}

double distance(const Response& a, const Response& b, std::size_t probe) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.samples; ++i) {
    largest = std::max(largest, std::fabs(a.probes[probe][i] - b.probes[probe][i]));
  }
  return largest;
}

double largest_of(const Response& a, std::size_t probe) {
  double largest = 0.0;
  for (const double x : a.probes[probe]) largest = std::max(largest, std::fabs(x));
  return largest;
}

void expect_order(const Scene& scene, Scheme scheme, double step, double order) {
  constexpr double kDuration = 0.01;
  const Response exact = completed(scene, options_of(Scheme::EnergyMomentum, step / 16, kDuration));
  const Response coarse = completed(scene, options_of(scheme, step, kDuration));
  const Response fine = completed(scene, options_of(scheme, step / 4, kDuration));
  for (std::size_t probe = 0; probe < 3; ++probe) {
    const double found = std::log2(distance(coarse, exact, probe) / distance(fine, exact, probe));
    EXPECT_NEAR(found / 2.0, order, 0.2) << probe;
  }
}

TEST(ArticulatedInSpace, ConvergesWithItsOrder) {
  const Scene scene = twisted_scene(5);
  expect_order(scene, Scheme::ArticulatedMidpoint, 4e-5, 2.0);
  expect_order(scene, Scheme::ArticulatedEuler, 1e-5, 1.0);
  Scene clamped = scene;
  clamped.end_rule = EndRule::Equal;
  expect_order(clamped, Scheme::ArticulatedMidpoint, 4e-5, 2.0);
  Scene pin = scene;
  pin.supports[0].kind = SupportKind::Pin;
  expect_order(pin, Scheme::ArticulatedMidpoint, 4e-5, 2.0);
}

TEST(ArticulatedInSpace, BalancesEnergyAndKnowsWhatSupportsCarry) {
  Scene scene = twisted_scene(6);
  add_probe(scene, ProbeQuantity::Reaction, Place::start(), Component::Y);
  add_probe(scene, ProbeQuantity::ReactionMoment, Place::start(), Component::X);
  add_probe(scene, ProbeQuantity::ReactionMoment, Place::start(), Component::Z);
  add_probe(scene, ProbeQuantity::Moment, {0.5, {}}, Component::Y);
  add_probe(scene, ProbeQuantity::Velocity, Place::end(), Component::X);
  add_probe(scene, ProbeQuantity::AngularMomentum, Place::start(), Component::Z);
  for (const EndRule rule : {EndRule::HalfJoint, EndRule::Equal}) {
    scene.end_rule = rule;
    const Response exact = completed(scene, options_of(Scheme::EnergyMomentum, 1e-5, 0.02));
    const Response response = completed(scene, options_of(Scheme::ArticulatedMidpoint, 1e-5, 0.02));
    EXPECT_LT(response.energy_balance_error, 1e-4);
    const Energies& a = response.chain.energy.back();
    const Energies& b = exact.chain.energy.back();
    EXPECT_NEAR(a.external / b.external, 1.0, 1e-3);
    EXPECT_NEAR(a.kinetic / b.kinetic, 1.0, 1e-2);
    for (std::size_t probe = 3; probe < scene.probes.size(); ++probe) {
      double largest = 0.0;
      for (std::size_t i = 1; i < exact.samples; ++i) {
        largest = std::max(largest, std::fabs(response.probes[probe][i] - exact.probes[probe][i]));
      }
      EXPECT_LT(largest, 0.03 * largest_of(exact, probe)) << probe;
    }
  }
}

TEST(ArticulatedInSpace, YieldsAxisByAxis) {
  Scene scene = testing::struck_scene(6, 15.0, YieldModel::PerAxis);
  scene.initial_motions[0].velocity[0] = 10.0;
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::PlasticAngle, Place::start(), Component::X);
  const Response exact = completed(scene, options_of(Scheme::EnergyMomentum, 2e-6, 3e-3));
  const Response fine = completed(scene, options_of(Scheme::ArticulatedMidpoint, 2e-6, 3e-3));
  EXPECT_GT(largest_of(exact, 1), 0.005);
  EXPECT_LT(distance(fine, exact, 0), 3e-3 * largest_of(exact, 0));
  EXPECT_LT(distance(fine, exact, 1), 1e-2 * largest_of(exact, 1));
  EXPECT_NEAR(fine.chain.energy.back().plastic / exact.chain.energy.back().plastic, 1.0, 1e-2);
}

TEST(ArticulatedInSpace, HasTheBitsOfALoneBeamInEveryLane) {
  std::vector<BatchCase> cases;
  for (int i = 0; i < 21; ++i) {
    Scene scene = i % 3 == 0 ? testing::struck_scene(4, 10.0 + i, YieldModel::PerAxis)
                             : twisted_scene(4 + i % 2);
    scene.gravity[0] = 1.0 + 0.1 * i;
    SolverOptions options = options_of(Scheme::ArticulatedMidpoint, 5e-5, 2e-3);
    options.level = Level::Spatial;
    if (i % 5 == 4) options.precision = Precision::Float;
    cases.push_back({std::to_string(i), scene, options});
  }
  const std::vector<BatchRow> together = run_batch(cases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const BatchRow alone = run_case(cases[i]);
    EXPECT_EQ(together[i].reason, "");
    EXPECT_EQ(together[i].response.status, Status::Completed);
    EXPECT_EQ(together[i].response.probes, alone.response.probes) << i;
    EXPECT_EQ(together[i].response.chain.position, alone.response.chain.position) << i;
    EXPECT_EQ(together[i].response.chain.reaction, alone.response.chain.reaction) << i;
  }
}

TEST(ArticulatedInSpace, FollowsThePlaneWhereAllLiesInIt) {
  Scene scene = twisted_scene(6);
  scene.gravity[0] = 0.0;
  scene.loads[0].force[0] = 0.0;
  scene.loads[0].moment = {0.3, 0.0, 0.0};
  SolverOptions options = options_of(Scheme::ArticulatedMidpoint, 1e-4, 0.02);
  const Response plane = completed(scene, options);
  options.level = Level::Spatial;
  const Response space = completed(scene, options);
  EXPECT_LT(distance(plane, space, 0), 2e-3 * largest_of(plane, 0));
  EXPECT_LT(largest_of(space, 1), 1e-12);
}

TEST(ArticulatedInSpace, RefusesWhatItsKernelsDoNotHold) {
  const auto refusal_of = [](const Scene& scene) -> std::string {
    try {
      prepare(scene, options_of(Scheme::ArticulatedMidpoint, 1e-3, 0.1));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  Scene scene = twisted_scene(4);
  EXPECT_EQ(refusal_of(scene), "");
  scene.yield_model = YieldModel::Interaction;
  EXPECT_NE(refusal_of(scene).find("rules.yield_model = interaction"), std::string::npos);
  scene = twisted_scene(4);
  scene.supports[0].kind = SupportKind::Pin;
  scene.end_rule = EndRule::Equal;
  EXPECT_NE(refusal_of(scene).find("rules.end_rule"), std::string::npos);
}

}  // namespace
}  // namespace plastica
