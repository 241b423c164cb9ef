#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "plastica/base/check.hpp"
#include "tests/support/motion_scene.hpp"

/// Scenes of articulated schemes, against the schemes that solve the whole step.
namespace plastica {
namespace {

using testing::add_probe;
using testing::completed;

/// A soft cantilever that falls by its weight, with a dead force and a torque at its tip.
Scene loaded_scene(int segments) {
  Scene scene = testing::cantilever_scene(segments);
  scene.material.youngs_modulus = 2e9;
  scene.material.density = 1200.0;
  scene.gravity = {0.0, -9.81, 0.0};
  scene.gravity_history = History::constant();
  Load load;
  load.at = Place::end();
  load.force = {0.0, -2.0, 0.5};
  load.moment = {0.3, 0.0, 0.0};
  load.history = History::constant();
  scene.loads.push_back(load);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  return scene;
}

SolverOptions options_of(Scheme scheme, double step, double duration = 0.2) {
  SolverOptions options = testing::motion_options(scheme, step, 20);
  options.duration = duration;
  return options;
}

double distance(const Response& a, const Response& b, std::size_t probe = 0) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.samples; ++i) {
    largest = std::max(largest, std::fabs(a.probes[probe][i] - b.probes[probe][i]));
  }
  return largest;
}

double largest_of(const Response& a, std::size_t probe = 0) {
  double largest = 0.0;
  for (const double x : a.probes[probe]) largest = std::max(largest, std::fabs(x));
  return largest;
}

/// Steps over which the error of a scheme falls, each half of the one before.
double order_of(const Scene& scene, Scheme scheme, double step, double duration = 0.02) {
  const Response exact = completed(scene, options_of(Scheme::EnergyMomentum, step / 16, duration));
  const double coarse = distance(completed(scene, options_of(scheme, step, duration)), exact);
  const double fine = distance(completed(scene, options_of(scheme, step / 4, duration)), exact);
  return std::log2(coarse / fine) / 2.0;
}

TEST(Articulated, ConvergesWithItsOrder) {
  const Scene scene = loaded_scene(8);
  EXPECT_NEAR(order_of(scene, Scheme::ArticulatedMidpoint, 1e-4), 2.0, 0.15);
  EXPECT_NEAR(order_of(scene, Scheme::ArticulatedEuler, 2e-5), 1.0, 0.15);
}

TEST(Articulated, ConvergesFromAClampAPinAndAnArc) {
  Scene clamped = loaded_scene(8);
  clamped.end_rule = EndRule::Equal;
  EXPECT_NEAR(order_of(clamped, Scheme::ArticulatedMidpoint, 1e-4), 2.0, 0.15);

  Scene pendulum = loaded_scene(8);
  pendulum.supports[0].kind = SupportKind::Pin;
  EXPECT_NEAR(order_of(pendulum, Scheme::ArticulatedMidpoint, 1e-4), 2.0, 0.15);

  Scene arc = loaded_scene(8);
  arc.beam.shape = BeamShape::Arc;
  arc.beam.arc_angle = 1.0;
  EXPECT_NEAR(order_of(arc, Scheme::ArticulatedMidpoint, 1e-4), 2.0, 0.15);
}

TEST(Articulated, BeginsWithTheMotionThatJointsAllow) {
  Scene scene = testing::struck_scene(8, 2.0, YieldModel::Elastic);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::Velocity, Place::end(), Component::Y);
  const Response a = completed(scene, options_of(Scheme::ArticulatedMidpoint, 1e-5, 2e-3));
  const Response b = completed(scene, options_of(Scheme::EnergyMomentum, 1e-5, 2e-3));
  EXPECT_DOUBLE_EQ(a.probes[1][0], b.probes[1][0]);
  EXPECT_LT(distance(a, b), 2e-3 * largest_of(b));
}

TEST(Articulated, YieldsAsTheSchemesThatSolveTheWholeStep) {
  Scene scene = testing::struck_scene(8, 20.0, YieldModel::Interaction);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::PlasticAngle, Place::start(), Component::X);
  Scene per_axis = scene;
  per_axis.yield_model = YieldModel::PerAxis;
  const Response exact = completed(scene, options_of(Scheme::EnergyMomentum, 2e-6, 4e-3));
  const Response coarse = completed(scene, options_of(Scheme::ArticulatedMidpoint, 2e-5, 4e-3));
  const Response fine = completed(scene, options_of(Scheme::ArticulatedMidpoint, 5e-6, 4e-3));
  EXPECT_GT(largest_of(exact, 1), 0.01);
  EXPECT_LT(distance(fine, exact), 2e-3 * largest_of(exact));
  EXPECT_LT(distance(fine, exact, 1), 5e-3 * largest_of(exact, 1));
  EXPECT_LT(distance(fine, exact), 0.5 * distance(coarse, exact));
  EXPECT_GT(fine.chain.energy.back().plastic, 0.0);
  EXPECT_NEAR(fine.chain.energy.back().plastic / exact.chain.energy.back().plastic, 1.0, 5e-3);
  EXPECT_LT(fine.energy_balance_error, 5e-3);
  const Response same = completed(per_axis, options_of(Scheme::ArticulatedMidpoint, 2e-5, 4e-3));
  EXPECT_EQ(same.probes, coarse.probes);
}

TEST(Articulated, DampsInProportionToStiffness) {
  const Scene scene = loaded_scene(8);
  SolverOptions fine = options_of(Scheme::EnergyMomentum, 1e-4);
  SolverOptions options = options_of(Scheme::ArticulatedMidpoint, 1e-4);
  fine.damping = options.damping = Damping::Stiffness;
  fine.damping_time = options.damping_time = 2e-3;
  const Response exact = completed(scene, fine);
  const Response response = completed(scene, options);
  EXPECT_LT(distance(response, exact), 1e-3 * largest_of(exact));
  const double damped = exact.chain.energy.back().damping;
  EXPECT_NEAR(response.chain.energy.back().damping / damped, 1.0, 1e-3);
  EXPECT_LT(response.energy_balance_error, 1e-4);
}

TEST(Articulated, FollowsLoadsThatChangeAndCountsTheirWork) {
  Scene scene = loaded_scene(8);
  scene.loads[0].history = {{0.0, 0.05, 0.1, 0.15}, {0.0, 3.0, -1.0, 2.0}};
  EXPECT_NEAR(order_of(scene, Scheme::ArticulatedMidpoint, 1e-4), 2.0, 0.2);
  const Response exact = completed(scene, options_of(Scheme::EnergyMomentum, 1e-4));
  for (const Scheme scheme : {Scheme::ArticulatedMidpoint, Scheme::ArticulatedEuler}) {
    const double step = scheme == Scheme::ArticulatedEuler ? 1e-6 : 1e-4;
    const Response response = completed(scene, options_of(scheme, step));
    EXPECT_LT(response.energy_balance_error, 2e-3);
    const double work = exact.chain.energy.back().external;
    EXPECT_NEAR(response.chain.energy.back().external / work, 1.0,
                scheme == Scheme::ArticulatedEuler ? 0.05 : 1e-3)
        << static_cast<int>(scheme);
  }
}

TEST(Articulated, CountsWhatEulersRuleLoses) {
  const Response response = completed(loaded_scene(8), options_of(Scheme::ArticulatedEuler, 1e-3));
  const Energies& end = response.chain.energy.back();
  EXPECT_GT(end.numerical_dissipation, 0.05 * end.external);
  EXPECT_LT(response.energy_balance_error, 5e-3);
}

TEST(Articulated, KnowsWhatJointsAndSupportsCarry) {
  Scene scene = loaded_scene(8);
  add_probe(scene, ProbeQuantity::Reaction, Place::start(), Component::Y);
  add_probe(scene, ProbeQuantity::ReactionMoment, Place::start(), Component::X);
  add_probe(scene, ProbeQuantity::Moment, {0.5, {}}, Component::X);
  add_probe(scene, ProbeQuantity::Force, {0.5, {}}, Component::Y);
  for (const EndRule rule : {EndRule::HalfJoint, EndRule::Equal}) {
    scene.end_rule = rule;
    const Response exact = completed(scene, options_of(Scheme::EnergyMomentum, 2e-5, 0.05));
    const Response response = completed(scene, options_of(Scheme::ArticulatedMidpoint, 2e-5, 0.05));
    for (std::size_t probe = 1; probe < 5; ++probe) {
      double largest = 0.0;
      for (std::size_t i = 1; i < exact.samples; ++i) {
        largest = std::max(largest, std::fabs(response.probes[probe][i] - exact.probes[probe][i]));
      }
      EXPECT_LT(largest, 0.02 * largest_of(exact, probe)) << probe;
    }
  }
}

TEST(Articulated, ShortensStepsThatTurnTooFar) {
  Scene scene = loaded_scene(6);
  InitialMotion spin;
  spin.spin = {30.0, 0.0, 0.0};
  spin.about = Place::start();
  scene.initial_motions = {spin};
  scene.supports[0].kind = SupportKind::Pin;
  const Response cut = completed(scene, options_of(Scheme::ArticulatedMidpoint, 1e-2));
  EXPECT_GT(cut.counters.cutbacks, 0);
  const Response fine = completed(scene, options_of(Scheme::ArticulatedMidpoint, 1e-3));
  EXPECT_LT(distance(cut, fine), 0.05 * largest_of(fine));

  SolverOptions hopeless = options_of(Scheme::ArticulatedMidpoint, 1e-2);
  hopeless.smallest_step = 1.0;
  const Response failed = simulate(scene, hopeless);
  EXPECT_EQ(failed.status, Status::NotConverged);
  EXPECT_EQ(failed.samples, 1U);
}

TEST(Articulated, StepsWithFloats) {
  const Scene scene = loaded_scene(8);
  SolverOptions options = options_of(Scheme::ArticulatedMidpoint, 1e-3);
  const Response wide = completed(scene, options);
  options.precision = Precision::Float;
  const Response narrow = completed(scene, options);
  EXPECT_GT(distance(narrow, wide), 0.0);
  EXPECT_LT(distance(narrow, wide), 1e-3 * largest_of(wide));
}

std::string refusal_of(const Scene& scene, const SolverOptions& options) {
  try {
    prepare(scene, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Articulated, RefusesWhatItsKernelsDoNotHold) {
  const Scene fine = loaded_scene(4);
  const SolverOptions options = options_of(Scheme::ArticulatedMidpoint, 1e-3);
  EXPECT_EQ(refusal_of(fine, options), "");
  const auto expect = [&](const Scene& scene, const SolverOptions& with, const char* words) {
    const std::string refusal = refusal_of(scene, with);
    EXPECT_NE(refusal.find(words), std::string::npos) << refusal << " for " << words;
  };
  Scene scene = fine;
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  expect(scene, options, "support[2]");
  scene = fine;
  scene.supports.clear();
  expect(scene, options, "an articulated scheme is of a beam that");
  scene = fine;
  scene.loads[0].follows = true;
  expect(scene, options, "load[1].follows");
  scene = fine;
  scene.yield_model = YieldModel::Fibre;
  expect(scene, options, "rules.yield_model = fibre");
  scene = fine;
  scene.yield_model = YieldModel::PerAxis;
  scene.material.break_strain = 0.2;
  expect(scene, options, "know no breaks");
  SolverOptions other = options;
  other.step_error = 1e-5;
  expect(fine, other, "solver.step_error");
  other = options;
  other.damping = Damping::Relaxation;
  other.damping_time = 1e-3;
  expect(fine, other, "solver.damping = relaxation");
}

}  // namespace
}  // namespace plastica
