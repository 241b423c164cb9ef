#include "plastica/run/companions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/support/chain_scene.hpp"
#include "tests/support/response_bits.hpp"

/// Beams that take the steps of another: their equilibria are those of their own runs, their
/// differences the derivatives of closed forms, and who cannot be taken along runs alone.
namespace plastica {
namespace {

using testing::add_probe;
using testing::bits_of;
using testing::yield_moment_of;

constexpr double kStep = 1e-5;

BatchCase case_of(const Scene& scene, int steps = 12) {
  BatchCase one{"", scene, {}};
  one.options.steps = steps;
  return one;
}

Load load_at(double fraction, std::array<double, 3> force) {
  Load load;
  load.at = {fraction, {}};
  load.force = force;
  return load;
}

void probe_all(Scene& scene) {
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::Displacement, {0.6, {}}, Component::Y);
  add_probe(scene, ProbeQuantity::Moment, {0.3, {}}, Component::X);
}

void harden(Scene& scene) {
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 20e9;
  scene.material.hardening.kinematic_fraction = 0.3;
}

/// A cantilever that is bent to and fro, beyond first yield.
Scene bent(YieldModel model) {
  Scene scene = testing::cantilever_scene(8);
  scene.yield_model = model;
  harden(scene);
  scene.loads = {load_at(1.0, {0.0, -1.3 * yield_moment_of(scene), 0.0})};
  scene.loads[0].history = History::turning_points({1.0, -1.0, 0.2});
  probe_all(scene);
  return scene;
}

/// Bent both ways and twisted by a follower, with its weight.
Scene askew(YieldModel model) {
  Scene scene = bent(model);
  scene.material.density = 7850.0;
  scene.gravity = {0.0, -9.81, 0.0};
  scene.loads[0].force = {120.0, -180.0, 30.0};
  scene.loads[0].moment = {0.0, 0.0, 40.0};
  scene.loads[0].follows = true;
  return scene;
}

/// Pushed half way, between a clamp and a pillar that it meets on the way, beside a spring.
Scene propped() {
  Scene scene = bent(YieldModel::PerAxis);
  Support pillar{.at = Place::end(), .kind = SupportKind::Pillar};
  pillar.gap = 0.004;
  scene.supports.push_back(pillar);
  scene.supports.push_back(
      {.at = {0.6, {}}, .kind = SupportKind::Elastic, .stiffness = {0.0, 2e4, 0.0}});
  scene.loads[0].at = {0.5, {}};
  return scene;
}

/// A shaft that is twisted beyond first yield and back.
Scene twisted() {
  Scene scene = testing::cantilever_scene(6);
  scene.yield_model = YieldModel::PerAxis;
  harden(scene);
  scene.section = {};
  scene.section.shape = SectionShape::Circle;
  scene.section.radius = 0.01;
  Load load;
  load.at = Place::end();
  load.moment = {0.0, 0.0, 300.0};
  load.history = History::turning_points({1.0, -0.5});
  scene.loads = {load};
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::Z);
  add_probe(scene, ProbeQuantity::Moment, {0.5, {}}, Component::Z);
  return scene;
}

/// Changes of one number each, among them those of the layout.
std::vector<std::function<void(Scene&)>> changes() {
  return {[](Scene& s) { s.material.youngs_modulus *= 1.0 + kStep; },
          [](Scene& s) { s.material.yield_stress *= 1.0 + kStep; },
          [](Scene& s) { s.beam.length *= 1.0 + kStep; },
          [](Scene& s) { s.loads[0].moment[2] += 1e-3; },
          [](Scene& s) { s.loads[0].force[1] *= 1.0 - kStep; }};
}

std::vector<BatchCase> beside(const Scene& scene, const SolverOptions& options = {}) {
  std::vector<BatchCase> cases{case_of(scene)};
  for (const auto& change : changes()) {
    cases.push_back(case_of(scene));
    change(cases.back().scene);
  }
  for (BatchCase& one : cases) {
    one.options = options;
    one.options.steps = 12;
  }
  return cases;
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double v : values) most = std::max(most, std::fabs(v));
  return most;
}

/// Each is in its own equilibrium.
void expect_own_equilibria(const std::vector<BatchCase>& cases, double tolerance = 1e-8) {
  const std::vector<BatchRow> rows = run_with_companions(cases);
  ASSERT_EQ(rows.size(), cases.size());
  int together = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Response alone = simulate(cases[i].scene, cases[i].options);
    const Response& found = rows[i].response;
    ASSERT_EQ(rows[i].reason, "");
    ASSERT_EQ(found.status, Status::Completed) << i;
    ASSERT_EQ(found.samples, alone.samples);
    if (i == 0) {
      EXPECT_TRUE(bits_of(found) == bits_of(alone));
      continue;
    }
    if (!(bits_of(found) == bits_of(alone))) ++together;
    EXPECT_EQ(found.chain.time, alone.chain.time);
    for (std::size_t p = 0; p < alone.probes.size(); ++p) {
      const double enough = tolerance * largest(alone.probes[p]);
      for (std::size_t k = 0; k < alone.samples; ++k) {
        EXPECT_NEAR(found.probes[p][k], alone.probes[p][k], enough)
            << "case " << i << " probe " << p << " sample " << k;
      }
    }
    EXPECT_NEAR(found.permanent_strain, alone.permanent_strain, 1e-6 * alone.permanent_strain);
  }
  EXPECT_GE(together, 3);  // who ran alone has the bits of that
}

TEST(Companions, AreInTheirOwnEquilibria) {
  expect_own_equilibria(beside(bent(YieldModel::Elastic)));
  expect_own_equilibria(beside(bent(YieldModel::PerAxis)));
  expect_own_equilibria(beside(twisted()));
}

TEST(Companions, AreInTheirOwnEquilibriaInSpace) {
  expect_own_equilibria(beside(askew(YieldModel::Elastic)));
  expect_own_equilibria(beside(askew(YieldModel::PerAxis)));
  expect_own_equilibria(beside(askew(YieldModel::Interaction)));
}

TEST(Companions, AreInTheirOwnEquilibriaByFibres) {
  expect_own_equilibria(beside(bent(YieldModel::Fibre)));
}

TEST(Companions, AreInTheirOwnEquilibriaWhereJointsStretch) {
  SolverOptions options;
  options.translation = JointTranslation::Elastic;
  expect_own_equilibria(beside(bent(YieldModel::PerAxis), options));
}

TEST(Companions, AreInTheirOwnEquilibriaOnPillars) { expect_own_equilibria(beside(propped())); }

/// E I w'' = M of joints: the tip of a chain of n rigid segments goes by F L^3/(3 E I)
/// (1 + 1/(2 n^2)), whose logarithm falls by that of E and rises by three times that of L.
TEST(Companions, DifferByTheDerivativesOfAnElasticBeam) {
  Scene scene = testing::cantilever_scene(10);
  scene.loads = {load_at(1.0, {0.0, -1e-3, 0.0})};
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  std::vector<BatchCase> cases(3, case_of(scene, 2));
  cases[1].scene.material.youngs_modulus *= 1.0 + kStep;
  cases[2].scene.beam.length *= 1.0 + kStep;
  const auto rows = run_with_companions(cases);
  const auto slope = [&](std::size_t i) {
    const double at = testing::last_of(rows[0].response, 0);
    return (testing::last_of(rows[i].response, 0) / at - 1.0) / kStep;
  };
  EXPECT_NEAR(slope(1), -1.0, 2.0 * kStep);
  EXPECT_NEAR(slope(2), 3.0, 4.0 * kStep);
}

/// Under prescribed motions all stresses scale with E, the yield stress and the hardening: the
/// reaction R is homogeneous in them, so that by Euler's theorem sum p dR/dp = R, however the
/// joints yield.
TEST(Companions, DifferByTheDerivativesOfABeamThatYields) {
  Scene scene = bent(YieldModel::PerAxis);
  scene.loads.clear();
  Support hand{.at = Place::end(), .kind = SupportKind::Roller};
  hand.translation = {0.0, -0.08, 0.0};
  hand.history = History::turning_points({1.0, -0.3});
  scene.supports.push_back(hand);
  add_probe(scene, ProbeQuantity::Reaction, Place::end(), Component::Y);
  std::vector<BatchCase> cases(4, case_of(scene, 30));
  cases[1].scene.material.youngs_modulus *= 1.0 + kStep;
  cases[2].scene.material.yield_stress *= 1.0 + kStep;
  cases[3].scene.material.hardening.tangent_modulus *= 1.0 + kStep;
  const auto rows = run_with_companions(cases);
  const Response& lead = rows[0].response;
  ASSERT_GT(lead.permanent_strain, 1e-3);
  const std::size_t reaction = lead.probes.size() - 1;
  const double most = largest(lead.probes[reaction]);
  bool matters[4] = {};
  for (std::size_t k = 0; k < lead.samples; ++k) {
    double sum = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const double by = (rows[i].response.probes[reaction][k] - lead.probes[reaction][k]) / kStep;
      matters[i] = matters[i] || std::fabs(by) > 0.02 * most;
      sum += by;
    }
    EXPECT_NEAR(sum, lead.probes[reaction][k], 1e-4 * most) << "sample " << k;
  }
  for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_TRUE(matters[i]) << i;
}

void expect_bits_of_alone(const std::vector<BatchCase>& cases) {
  const auto rows = run_with_companions(cases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Response alone = simulate(cases[i].scene, cases[i].options);
    EXPECT_EQ(rows[i].response.status, alone.status) << i;
    EXPECT_TRUE(bits_of(rows[i].response) == bits_of(alone)) << i;
  }
}

/// Whose numbers lie far away might end on another branch.
TEST(Companions, RunAloneWhereTheyLieFarAway) {
  std::vector<BatchCase> cases(5, case_of(bent(YieldModel::PerAxis)));
  cases[1].scene.material.youngs_modulus *= 0.5;
  cases[2].scene.material.yield_stress *= 1.2;
  cases[3].scene.loads[0].force[1] *= -0.5;
  cases[4].scene.material.hardening = {};  // to its limit load
  cases[4].scene.loads[0].force[1] *= 1.5;
  EXPECT_EQ(simulate(cases[4].scene, cases[4].options).status, Status::LimitLoad);
  expect_bits_of_alone(cases);
}

TEST(Companions, AreNotRunWhereTheLeadIsLost) {
  Scene scene = bent(YieldModel::PerAxis);
  scene.material.hardening = {};
  scene.loads[0].force[1] *= 2.0;  // beyond the limit load
  const std::vector<BatchCase> cases = beside(scene);
  const auto rows = run_with_companions(cases);
  const Response alone = simulate(cases[0].scene, cases[0].options);
  EXPECT_EQ(alone.status, Status::LimitLoad);
  EXPECT_TRUE(bits_of(rows[0].response) == bits_of(alone));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].response.status, Status::NotRun);
    EXPECT_EQ(rows[i].response.samples, 0U);
  }
}

TEST(Companions, RunAloneWhereTheyMayBreak) {
  Scene scene = bent(YieldModel::PerAxis);
  scene.material.break_strain = 0.01;
  EXPECT_EQ(why_no_companion(prepare(scene)), "it may break");
  expect_bits_of_alone(beside(scene));
}

TEST(Companions, RunAloneInMotionAndAlongArcs) {
  Scene scene = testing::cantilever_scene(4);
  scene.loads = {load_at(1.0, {0.0, -10.0, 0.0})};
  scene.material.density = 7850.0;
  probe_all(scene);
  SolverOptions options;
  options.control = PathControl::ArcLength;
  expect_bits_of_alone(beside(scene, options));
  options = {};
  options.analysis = Analysis::Dynamics;
  options.time_step = 1e-3;
  options.duration = 0.012;
  expect_bits_of_alone(beside(scene, options));
}

/// Of other supports or steps.
TEST(Companions, RunAloneBesideBeamsOfAnotherKind) {
  std::vector<BatchCase> cases(4, case_of(bent(YieldModel::PerAxis)));
  cases[1].options.steps = 9;
  cases[2].scene.beam.segments = 9;
  cases[3].scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  expect_bits_of_alone(cases);
}

/// The first equilibrium of a beam that its weight bends far is found by parts of the load, which
/// companions do not see.
TEST(Companions, RunAloneWhereTheFirstEquilibriumIsFar) {
  Scene scene = testing::cantilever_scene(4);
  scene.material.youngs_modulus = 20e6;
  scene.material.density = 1200.0;
  scene.gravity = {0.0, -9.81, 0.0};
  scene.gravity_history = History::constant();
  scene.loads = {load_at(1.0, {0.0, 0.01, 0.0})};
  probe_all(scene);
  expect_bits_of_alone(beside(scene));
}

TEST(Companions, OfCouponsAreRunAlone) {
  Scene scene;
  scene.material.youngs_modulus = 200e9;
  scene.material.yield_stress = 250e6;
  scene.drive.strain = {0.0, 1e-3, 5e-3};
  scene.probes = {{"stress", ProbeQuantity::Stress}};
  const std::vector<std::string> paths{"material.yield_stress"};
  const Model model = prepare(scene, {}, paths);
  const std::vector<double> values{250e6, 251e6};
  const auto responses = run_with_companions(model, values, 2);
  EXPECT_EQ(responses[0].probes[0].back(), 250e6);
  EXPECT_EQ(responses[1].probes[0].back(), 251e6);
  const std::vector<BatchCase> cases(2, case_of(scene));
  EXPECT_EQ(run_with_companions(cases)[1].response.probes[0].back(), 250e6);
}

TEST(Companions, AreNotRunWithoutALead) {
  std::vector<BatchCase> cases(3, case_of(bent(YieldModel::PerAxis)));
  cases[0].scene.section.height = -1.0;
  const auto rows = run_with_companions(cases);
  EXPECT_EQ(rows[0].response.status, Status::Rejected);
  EXPECT_EQ(rows[1].response.status, Status::NotRun);
  const std::vector<std::string> paths{"material.yield_stress"};
  const Model model = prepare(cases[1].scene, cases[1].options, paths);
  const auto responses = run_with_companions(model, std::vector<double>{-1.0, 250e6}, 2);
  EXPECT_EQ(responses[0].status, Status::InvalidParameter);
  EXPECT_EQ(responses[1].status, Status::NotRun);
}

TEST(Companions, ThatAreNoInputAreRows) {
  std::vector<BatchCase> cases(3, case_of(bent(YieldModel::PerAxis)));
  cases[1].scene.section.height = -1.0;
  const auto rows = run_with_companions(cases);
  EXPECT_EQ(rows[0].response.status, Status::Completed);
  EXPECT_EQ(rows[1].response.status, Status::Rejected);
  EXPECT_NE(rows[1].reason, "");
  EXPECT_EQ(rows[2].response.status, Status::Completed);
}

TEST(Companions, OfAModelAreRowsOfTheirValues) {
  const Scene scene = bent(YieldModel::PerAxis);
  const std::vector<std::string> paths{"material.youngs_modulus", "material.yield_stress"};
  const Model model = prepare(scene, case_of(scene).options, paths);
  const std::vector<double> values{200e9, 250e6, 200.002e9, 250e6, 200e9, -1.0, 200e9, 250e6};
  const auto responses = run_with_companions(model, values, 4);
  EXPECT_EQ(responses[0].status, Status::Completed);
  EXPECT_EQ(responses[1].status, Status::Completed);
  EXPECT_EQ(responses[2].status, Status::InvalidParameter);
  EXPECT_NE(responses[1].probes, responses[0].probes);
  for (std::size_t k = 0; k < responses[0].samples; ++k) {
    EXPECT_NEAR(responses[3].probes[0][k], responses[0].probes[0][k], 1e-9);
  }
}

TEST(Companions, AreNoMoreThanMemoryIsFor) {
  const Scene scene = bent(YieldModel::PerAxis);
  EXPECT_GT(most_companions(prepare(scene)), 100U);
  SolverOptions many_frames;
  many_frames.steps = 200'000;
  EXPECT_EQ(most_companions(prepare(scene, many_frames)), 0U);
  SolverOptions motion;
  motion.analysis = Analysis::Dynamics;
  motion.time_step = 1e-3;
  motion.duration = 0.1;
  Scene heavy = scene;
  heavy.material.density = 7850.0;
  EXPECT_EQ(most_companions(prepare(heavy, motion)), 0U);
}

TEST(Companions, EndWithTheFlag) {
  const std::atomic<bool> raised{true};
  const std::vector<BatchCase> cases(2, case_of(bent(YieldModel::PerAxis)));
  const auto rows = run_with_companions(cases, &raised);
  EXPECT_EQ(rows[0].response.status, Status::Interrupted);
  EXPECT_EQ(rows[1].response.status, Status::NotRun);
}

}  // namespace
}  // namespace plastica
