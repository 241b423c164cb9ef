#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/chain_scene.hpp"
#include "tests/support/message.hpp"
#include "tests/support/motion_scene.hpp"

// Chains in float beside the same in double.

namespace plastica {
namespace {

using testing::add_probe;
using testing::cantilever_scene;
using testing::flying_scene;
using testing::last_energy;
using testing::motion_options;
using testing::struck_scene;
using testing::yield_moment_of;

SolverOptions in(Precision precision, SolverOptions options = {}) {
  options.precision = precision;
  return options;
}

/// The largest difference of a probe from double, over the largest size.
double difference(const Response& response, const Response& exact, std::size_t probe) {
  EXPECT_EQ(response.status, exact.status);
  EXPECT_EQ(response.samples, exact.samples);
  double off = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < std::min(response.samples, exact.samples); ++i) {
    off = std::max(off, std::fabs(response.probes[probe][i] - exact.probes[probe][i]));
    size = std::max(size, std::fabs(exact.probes[probe][i]));
  }
  return off / size;
}

/// All probes agree within `most`, and are not the same numbers.
void expect_float(const Scene& scene, double most, const SolverOptions& options = {}) {
  const Response exact = simulate(scene, in(Precision::Double, options));
  const Response response = simulate(scene, in(Precision::Float, options));
  for (std::size_t p = 0; p < scene.probes.size(); ++p) {
    const double off = difference(response, exact, p);
    EXPECT_LT(off, most) << scene.probes[p].name;
    EXPECT_GT(off, 1e-10) << scene.probes[p].name;
  }
}

/// Bent by a force at its end, to a tip deflection of 0.55 of the length if elastic.
Scene bent_scene(int segments) {
  Scene scene = cantilever_scene(segments);
  scene.loads.push_back({.force = {0.0, -6e3, 0.0}});
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::Moment, Place::start(), Component::X);
  return scene;
}

/// Loaded to `factor` of first yield at the clamp, and let go.
Scene yielding_scene(YieldModel model, double factor) {
  Scene scene = cantilever_scene(20);
  scene.yield_model = model;
  const double force = factor * yield_moment_of(scene);
  scene.loads.push_back(
      {.force = {0.0, -force, 0.0}, .history = History::turning_points({1.0, 0.0})});
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  return scene;
}

TEST(Precision, BendsAnElasticBeamInFloatAsInDouble) {
  // Sums over the chain round more the longer it is: 1e-6 with 5 segments, 2.5e-6 with 400.
  for (const int segments : {5, 20, 100, 400}) expect_float(bent_scene(segments), 1e-5);
}

TEST(Precision, FindsTheMomentsOfARollerInFloat) {
  Scene scene = bent_scene(16);
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  scene.loads[0].at = {0.5, {}};
  scene.probes[0].at = {0.5, {}};
  expect_float(scene, 4e-5);
}

TEST(Precision, YieldsInFloatAsInDouble) {
  // Newton's method may leave 2e-5 of the moment (SolverOptions::tolerance).
  expect_float(yielding_scene(YieldModel::Fibre, 1.3), 1e-4);
  Scene scene = yielding_scene(YieldModel::PerAxis, 0.9);
  scene.supports.push_back({.at = {0.5, {}}, .kind = SupportKind::Pillar, .gap = 0.002});
  expect_float(scene, 1e-4);
}

TEST(Precision, YieldsInSpaceInFloatAsInDouble) {
  for (const YieldModel model : {YieldModel::PerAxis, YieldModel::Interaction,
                                 YieldModel::Conservative, YieldModel::Fibre}) {
    Scene scene = cantilever_scene(10);
    scene.yield_model = model;
    // Three quarters of what the edge bears, and turned by more than bears the rest: on one surface
    // by little more, since what flows then soon gives way to the force.
    const bool alone = model == YieldModel::PerAxis || model == YieldModel::Fibre;
    const double moment = 0.6 * yield_moment_of(scene);
    scene.supports.push_back({.at = Place::end(),
                              .kind = SupportKind::Guide,
                              .hold = HeldFreedoms{false, false, false, false, false, true},
                              .rotation = {0.0, 0.0, alone ? 0.2 : 0.12}});
    scene.loads.push_back({.force = {0.25 * moment, -moment, 0.0}});
    add_probe(scene, ProbeQuantity::Moment, Place::start(), Component::Z);
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
    SCOPED_TRACE(static_cast<int>(model));
    expect_float(scene, 1e-4);
  }
}

TEST(Precision, TwistsInFloatAsInDouble) {
  Scene scene = cantilever_scene(30);
  scene.yield_model = YieldModel::PerAxis;
  // Twisted far beyond yield and back: the half joint at the end is turned by the sum of all
  // angles, whose rounding Newton's method cannot undo.
  scene.supports.push_back({.at = Place::end(),
                            .kind = SupportKind::Guide,
                            .hold = HeldFreedoms{false, false, false, false, false, true},
                            .rotation = {0.0, 0.0, 0.8},
                            .history = History::turning_points({1.0, 0.8})});
  add_probe(scene, ProbeQuantity::Moment, Place::start(), Component::Z);
  add_probe(scene, ProbeQuantity::Rotation, {0.5, {}}, Component::Z);
  expect_float(scene, 5e-4);
}

TEST(Precision, KeepsTheEnergyOfAFlightToTheRoundingOfPositions) {
  for (const bool in_space : {false, true}) {
    const SolverOptions options = motion_options(Scheme::EnergyMomentum, 1e-3, 100);
    const Scene scene = flying_scene(8, in_space);
    const auto drift = [&](Precision precision) {
      const Response response = simulate(scene, in(precision, options));
      EXPECT_EQ(response.status, Status::Completed);
      const Energies& end = last_energy(response);
      const Energies& begin = response.chain.energy.front();
      const double before = begin.kinetic + begin.elastic;
      return std::fabs(end.kinetic + end.elastic - before) / before;
    };
    EXPECT_LT(drift(Precision::Double), 1e-10);
    EXPECT_LT(drift(Precision::Float), 2e-4);
    EXPECT_GT(drift(Precision::Float), 1e-9);
  }
}

TEST(Precision, MovesInFloatAsInDoubleWithEveryScheme) {
  // One solve is enough in float where double solves again for what has begun to yield: it is less
  // than the rounding of positions makes of the moments.
  const std::vector<std::pair<Scheme, double>> schemes{{Scheme::LinearlyImplicitEuler, 1e-3},
                                                       {Scheme::LinearlyImplicitMidpoint, 5e-3},
                                                       {Scheme::GeneralizedAlpha, 2e-4},
                                                       {Scheme::EnergyMomentum, 2e-4}};
  for (const auto& [scheme, most] : schemes) {
    Scene scene = struck_scene(10, 12.0, YieldModel::PerAxis);
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
    SCOPED_TRACE(static_cast<int>(scheme));
    expect_float(scene, most, motion_options(scheme, 5e-4, 60));
  }
}

TEST(Precision, RefusesWhatHasNoKernelsInFloat) {
  const auto refusal = [](const Scene& scene, SolverOptions options = {}) {
    options.precision = Precision::Float;
    return testing::message_of([&] { prepare(scene, options); });
  };
  Scene coupon;
  coupon.drive.strain = {0.001};
  EXPECT_EQ(refusal(coupon),
            "solver.precision = float: is of chains: a coupon is computed in double");
  Scene scene = bent_scene(4);
  EXPECT_EQ(refusal(scene, {.translation = JointTranslation::Elastic}),
            "solver.precision = float: is of joints that are rigid in translation "
            "(solver.translation)");
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 1e9;
  EXPECT_EQ(refusal(scene),
            "solver.precision = float: is of ideal plasticity (material.hardening.law)");
}

}  // namespace
}  // namespace plastica
