#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "plastica/run/batch.hpp"
#include "tests/support/motion_scene.hpp"
#include "tests/support/response_bits.hpp"
#include "tests/support/tolerance.hpp"

// Point masses in motion, against rigid bodies, Parkes' cantilever and other schemes.

namespace plastica {
namespace {

using testing::add_probe;
using testing::cantilever_scene;
using testing::chain_scene;
using testing::completed;
using testing::last_energy;
using testing::last_of;
using testing::motion_options;
using testing::tolerance;

constexpr std::array kGeneralSchemes{Scheme::LinearlyImplicitEuler,
                                     Scheme::LinearlyImplicitMidpoint, Scheme::GeneralizedAlpha,
                                     Scheme::EnergyMomentum};

double line_mass(const Scene& scene) {
  return scene.material.density * testing::properties_of(scene).area;
}

/// Bodies at the start, at a joint, within a segment, and at the end.
void add_masses(Scene& scene) {
  scene.masses = {{Place::start(), 0.4, {0.01, 0.02, 0.005}},
                  {{0.5, {}}, 1.0, {0.03, 0.01, 0.02}},
                  {{0.7, {}}, 0.3, {}},
                  {Place::end(), 0.6, {0.02, 0.015, 0.01}}};
}

// A stiff bar that flies and turns about an axis through its middle: m v and I w, from the first.
TEST(FlyingMasses, HaveTheMomentumAndEnergyOfARigidBody) {
  Scene scene = chain_scene(10);
  scene.beam.segment_fractions.assign(10, 0.1);
  add_masses(scene);
  scene.masses[2].at = {0.73, {}};
  InitialMotion motion;
  motion.about = {0.5, {}};
  motion.velocity = {0.0, 2.0, 0.0};
  motion.spin = {3.0, 0.0, 0.0};
  scene.initial_motions = {motion};
  add_probe(scene, ProbeQuantity::Momentum, {}, Component::Y);
  add_probe(scene, ProbeQuantity::AngularMomentum, {}, Component::X);
  double mass = line_mass(scene);
  double first = 0.0;  // sum of m (z - L/2)
  const SectionProperties p = testing::properties_of(scene);
  double inertia = line_mass(scene) / 12.0 + scene.material.density * p.second_moment_x;
  for (const PointMass& body : scene.masses) {
    const double arm = body.at.fraction - 0.5;
    mass += body.mass;
    first += body.mass * arm;
    inertia += body.mass * arm * arm + body.inertia[0];
  }
  // A spin about x moves what lies ahead along z by -y.
  const double momentum = mass * 2.0 - 3.0 * first;
  const double energy = 0.5 * (mass * 4.0 + 2.0 * 2.0 * -3.0 * first + inertia * 9.0);
  const double turning = 3.0 * inertia - 2.0 * first - 0.5 * momentum;
  for (const Level level : {Level::Planar, Level::Spatial}) {
    for (const Scheme scheme : kGeneralSchemes) {
      SolverOptions options = motion_options(scheme, 1e-4, 50);
      options.level = level;
      const Response response = simulate(scene, options);
      EXPECT_NEAR(response.probes[0][0] / momentum, 1.0, tolerance(1e-12));
      EXPECT_NEAR(response.probes[1][0] / turning, 1.0, tolerance(1e-12));
      EXPECT_NEAR(response.chain.energy[0].kinetic / energy, 1.0, tolerance(1e-12));
      EXPECT_LT(testing::drift_of(response, 0), 1e-8);
    }
  }
}

/// An arc, so that the masses' inertias have products in the axes of their segments.
Scene flying_arc(bool in_space) {
  Scene scene = testing::flying_scene(8, in_space);
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = 1.0;
  scene.beam.arc_towards = {0.0, 1.0, 0.0};
  add_masses(scene);
  for (const Component component : {Component::X, Component::Y, Component::Z}) {
    add_probe(scene, ProbeQuantity::Momentum, {}, component);
    add_probe(scene, ProbeQuantity::AngularMomentum, {}, component);
  }
  return scene;
}

TEST(FlyingMasses, KeepMomentumAndEnergy) {
  for (const bool in_space : {false, true}) {
    SolverOptions options = motion_options(Scheme::EnergyMomentum, 5e-4, 200);
    options.level = in_space ? Level::Spatial : Level::Planar;
    const Response response = completed(flying_arc(in_space), options);
    for (std::size_t p = 0; p < 6; ++p) {
      double size = 0.0;
      for (std::size_t q = p % 2; q < 6; q += 2) {
        size = std::max(size, std::fabs(response.probes[q][0]));
      }
      for (std::size_t i = 0; i < response.samples; ++i) {
        ASSERT_NEAR(response.probes[p][i], response.probes[p][0], 1e-9 * size) << p << ' ' << i;
      }
    }
    EXPECT_LT(response.momentum_error, 1e-9);
    EXPECT_LT(testing::largest_residual(response), 1e-7);
  }
}

// A cut at the joint that carries the body: each fragment takes half, and nothing is lost.
TEST(FlyingMasses, KeepMomentumOverACutAtTheirPlace) {
  Scene scene = flying_arc(true);
  scene.cuts.push_back({{0.5, {}}, 0.02});
  const Response response = simulate(scene, motion_options(Scheme::EnergyMomentum, 2e-4, 200));
  ASSERT_EQ(response.status, Status::Broken);
  ASSERT_EQ(response.chain.events.size(), 1U);
  EXPECT_EQ(response.chain.events[0].fragments.size(), 2U);
  for (const std::size_t p : {0U, 2U, 4U}) {
    EXPECT_NEAR(last_of(response, p), response.probes[p][0],
                1e-8 * std::fabs(response.probes[2][0]));
  }
  EXPECT_LT(response.momentum_error, 1e-8);
  EXPECT_LT(testing::largest_residual(response), 1e-6);
}

/// A soft cantilever that falls with bodies on it.
Scene falling(bool in_space) {
  Scene scene = cantilever_scene(8);
  scene.material.youngs_modulus = 2e9;
  scene.material.density = 1200.0;
  scene.section.height = 0.03;
  scene.gravity = {in_space ? 4.0 : 0.0, -9.81, 0.0};
  scene.gravity_history = History::constant();
  scene.masses = {{{0.5, {}}, 0.3, {0.003, 0.002, 0.001}},
                  {Place::end(), 0.2, {0.001, 0.002, 0.003}}};
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
  if (in_space) add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::X);
  return scene;
}

/// Largest distance of two responses, over the largest size.
double relative_distance(const Response& a, const Response& b, std::size_t probe) {
  double largest = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < a.samples; ++i) {
    largest = std::max(largest, std::fabs(a.probes[probe][i] - b.probes[probe][i]));
    size = std::max(size, std::fabs(a.probes[probe][i]));
  }
  return largest / size;
}

class Space : public ::testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Levels, Space, ::testing::Bool(),
                         [](const auto& each) { return each.param ? "spatial" : "planar"; });

TEST_P(Space, ArticulatedSchemesCarryThemAsTheOthersDo) {
  const Scene scene = falling(GetParam());
  const auto run = [&](Scheme scheme, double step) {
    SolverOptions options = motion_options(scheme, step, 20);
    options.duration = 0.04;
    return completed(scene, options);
  };
  const Response exact = run(Scheme::EnergyMomentum, 1e-5);
  const Response coarse = run(Scheme::ArticulatedMidpoint, 8e-5);
  const Response fine = run(Scheme::ArticulatedMidpoint, 4e-5);
  for (std::size_t p = 0; p < scene.probes.size(); ++p) {
    EXPECT_LT(relative_distance(exact, fine, p), 1e-3) << p;
    EXPECT_LT(relative_distance(exact, fine, p), 0.35 * relative_distance(exact, coarse, p)) << p;
  }
  EXPECT_LT(fine.energy_balance_error, 1e-3);
  EXPECT_NEAR(last_energy(fine).external / last_energy(exact).external, 1.0, 1e-3);
  const Response euler = run(Scheme::ArticulatedEuler, 1e-5);
  EXPECT_LT(relative_distance(exact, euler, 0), 1e-2);
}

TEST_P(Space, AllSchemesAgree) {
  const Scene scene = falling(GetParam());
  const auto run = [&](Scheme scheme) {
    SolverOptions options = motion_options(scheme, 2e-4, 20);
    options.duration = 0.1;
    return completed(scene, options);
  };
  const Response exact = run(Scheme::EnergyMomentum);
  for (const Scheme scheme : kGeneralSchemes) {
    const Response found = run(scheme);
    const double within = scheme == Scheme::LinearlyImplicitEuler ? 3e-2 : 2e-3;
    EXPECT_LT(relative_distance(exact, found, 0), within) << static_cast<int>(scheme);
  }
}

TEST(FallingMasses, MoveInSpaceAsInThePlane) {
  const Scene scene = falling(false);
  for (const Scheme scheme : {Scheme::EnergyMomentum, Scheme::GeneralizedAlpha,
                              Scheme::LinearlyImplicitMidpoint, Scheme::ArticulatedMidpoint}) {
    SolverOptions options = motion_options(scheme, 5e-5, 20);
    options.duration = 0.04;
    options.level = Level::Planar;
    const Response planar = completed(scene, options);
    options.level = Level::Spatial;
    const Response spatial = completed(scene, options);
    const bool articulated = is_articulated(scheme);
    for (std::size_t p = 0; p < 2; ++p) {
      EXPECT_LT(relative_distance(planar, spatial, p), articulated ? 2e-5 : 1e-7)
          << static_cast<int>(scheme);
    }
  }
}

TEST(FallingMasses, AreTheMirrorImageFromTheOtherEnd) {
  Scene scene = falling(false);
  scene.masses[0].at = {0.25, {}};
  Scene image = scene;
  image.supports[0].at = Place::end();
  for (PointMass& mass : image.masses) mass.at.fraction = 1.0 - mass.at.fraction;
  for (Probe& probe : image.probes) probe.at = Place::start();
  SolverOptions options = motion_options(Scheme::EnergyMomentum, 2e-4, 20);
  options.duration = 0.1;
  const Response here = completed(scene, options);
  const Response there = completed(image, options);
  EXPECT_LT(relative_distance(here, there, 0), 1e-7);
}

TEST(FallingMasses, InABatchHaveTheBitsThatTheyHaveAlone) {
  std::vector<Scene> scenes;
  for (int i = 0; i < 5; ++i) {
    scenes.push_back(falling(false));
    scenes.back().masses[1].mass *= 1.0 + 0.3 * i;
    scenes.back().masses[0].inertia[0] *= 1.0 + 0.5 * i;
  }
  for (const Analysis analysis : {Analysis::Dynamics, Analysis::Statics}) {
    SolverOptions options = motion_options(Scheme::ArticulatedMidpoint, 5e-5, 10);
    if (analysis == Analysis::Statics) {
      options = {.steps = 4};
      for (Scene& scene : scenes) scene.gravity_history = History::ramp();
    }
    std::vector<BatchCase> cases;
    for (const Scene& scene : scenes) {
      cases.push_back({std::to_string(cases.size()), scene, options});
    }
    const std::vector<BatchRow> rows = run_batch(cases, {.threads = 1});
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      EXPECT_EQ(testing::bits_of(rows[i].response), testing::bits_of(simulate(scenes[i], options)))
          << i;
    }
  }
}

// Parkes (1955): a rigid, perfectly plastic cantilever of mass m per length is struck at its tip,
// which carries M, with v0. A hinge starts at the tip. At a distance x from it nothing is sheared
// there, so (M + m x/2) v = M v0; the moment is M_p, so m v x^2/6 = M_p t about the tip. When it
// has come to the clamp the rest turns as one body about it. All hinges together turn by
// M v0^2/(2 M_p).
struct Parkes {
  double deflection = 0.0;  ///< of the tip, small
  double rotation = 0.0;    ///< of the tip
};

Parkes parkes(double line, double length, double mass, double speed, double moment) {
  const double g = 0.5 * line / mass;
  const double scale = line * speed * speed / (6.0 * moment);
  Parkes found;
  constexpr int kSteps = 20000;
  for (int k = 0; k < kSteps; ++k) {
    const double x = length * (k + 0.5) / kSteps;
    const double rate = (2.0 + g * x) / std::pow(1.0 + g * x, 3);
    found.deflection += scale * rate * x * length / kSteps;
    found.rotation += scale * rate * length / kSteps;
  }
  const double spin = speed / (1.0 + g * length) / length;
  const double inertia = mass * length * length + line * std::pow(length, 3) / 3.0;
  const double turned = 0.5 * inertia * spin * spin / moment;
  found.deflection += length * turned;
  found.rotation += turned;
  return found;
}

class ParkesCantilever : public ::testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(MassRatios, ParkesCantilever, ::testing::Values(2.0, 10.0),
                         [](const auto& each) { return each.param < 5.0 ? "twice" : "tenfold"; });

/// What the joints of an elastic, perfectly plastic chain have turned by in the end, over Parkes'.
/// @param mass_ratio  of the tip over the beam
/// @param stiffness   the blow over what the beam can store elastically
Parkes chain_over_parkes(double mass_ratio, int segments, double stiffness) {
  constexpr double kRotation = 0.1;
  Scene scene = cantilever_scene(segments);
  scene.yield_model = YieldModel::PerAxis;
  const double moment = testing::yield_moment_of(scene);
  const double second = testing::properties_of(scene).second_moment_x;
  scene.material.youngs_modulus = 0.5 * stiffness * moment / (second * kRotation);
  const double line = line_mass(scene);
  const double mass = mass_ratio * line;
  scene.masses.push_back({Place::end(), mass, {}});
  const double blow = std::sqrt(2.0 * moment * kRotation / mass);
  InitialMotion struck;
  struck.from = {1.0 - 0.6 / segments, {}};
  struck.velocity = {0.0, -blow, 0.0};
  scene.initial_motions = {struck};
  // The beam stops after M v0 L/M_p.
  SolverOptions options = motion_options(Scheme::GeneralizedAlpha, 8e-4 / segments, 20);
  options.level = Level::Planar;
  options.duration = 1.5 * mass * blow / moment;
  const Response response = completed(scene, options);
  // The blow meets a segment and not a point: by its energy.
  const double speed = std::sqrt(2.0 * response.chain.energy[0].kinetic / mass);
  const Parkes exact = parkes(line, 1.0, mass, speed, moment);
  EXPECT_NEAR(exact.rotation / (0.5 * mass * speed * speed / moment), 1.0, 1e-6);
  Parkes found;
  const ChainHistory& chain = response.chain;
  const std::size_t frame = chain.plastic_angle.size() / 3 - chain.joints;
  for (std::size_t joint = 0; joint < chain.joints; ++joint) {
    const double turned = chain.plastic_angle[3 * (frame + joint)];
    found.rotation += turned / exact.rotation;
    found.deflection += turned * (1.0 - static_cast<double>(joint) / segments) / exact.deflection;
  }
  return {std::fabs(found.deflection), std::fabs(found.rotation)};
}

// Elastic waves keep the travelling hinge from being sharp: the deflection comes near the rigid
// beam's slowly as the beam is made stiffer and finer; the rotation is the blow's energy over M_p.
TEST_P(ParkesCantilever, EndsAsTheRigidPlasticTheorySays) {
  const bool heavy = GetParam() > 5.0;
  const Parkes coarse = chain_over_parkes(GetParam(), 20, 200.0);
  const Parkes middle = chain_over_parkes(GetParam(), 40, 800.0);
  const Parkes fine = chain_over_parkes(GetParam(), 80, 3200.0);
  RecordProperty("deflections", std::to_string(coarse.deflection) + ' ' +
                                    std::to_string(middle.deflection) + ' ' +
                                    std::to_string(fine.deflection));
  EXPECT_NEAR(coarse.rotation, 1.0, 0.01);
  EXPECT_NEAR(fine.rotation, 1.0, 0.001);
  EXPECT_NEAR(fine.deflection, 1.0, heavy ? 0.01 : 0.025);
  EXPECT_LT(middle.deflection - 1.0, 0.75 * (coarse.deflection - 1.0));
  EXPECT_LT(fine.deflection - 1.0, 0.75 * (middle.deflection - 1.0));
}

}  // namespace
}  // namespace plastica
