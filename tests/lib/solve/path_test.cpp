#include "plastica/solve/path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "plastica/run/simulate.hpp"
#include "tests/support/chain.hpp"

namespace plastica {
namespace {

using testing::cantilever;

/// Fully plastic moment of the test's section, 20 mm x 20 mm, 250 MPa [N m].
constexpr double kPlasticMoment = 250e6 * 0.02 * 0.02 * 0.02 / 4.0;

/// Stiff, so that a hinge forms before the beam has moved; each joint yields at M_p at once.
Scene hinge_scene(double factor) {
  Scene scene = cantilever(20, {0.0, -factor * kPlasticMoment, 0.0});
  scene.material.youngs_modulus = 200e12;
  scene.yield_model = YieldModel::PerAxis;
  scene.yield_cap = YieldCap::FullyPlastic;
  scene.probes = {{"tip", ProbeQuantity::Displacement},
                  {"factor", ProbeQuantity::LoadFactor},
                  {"residual", ProbeQuantity::Energy, {}, Component::X, EnergyKind::Residual},
                  {"external", ProbeQuantity::Energy, {}, Component::X, EnergyKind::External}};
  return scene;
}

double last(const Response& response, std::size_t probe) {
  return response.probes[probe][response.samples - 1];
}

TEST(Path, FindsALimitLoadFromBothSides) {
  const Response response = simulate(hinge_scene(2.0));
  EXPECT_EQ(response.status, Status::LimitLoad);
  ASSERT_TRUE(response.limit);
  EXPECT_LE(response.limit->below, response.limit->above);
  EXPECT_NEAR(response.limit->below, 0.5, 1e-4 * 0.5);
  EXPECT_NEAR(response.limit->above, 0.5, 3e-4 * 0.5);
}

TEST(Path, FollowsTheHingeByDisplacement) {
  SolverOptions options;
  options.control = PathControl::Displacement;
  options.control_motion = {0.0, -0.2, 0.0};
  const Response response = simulate(hinge_scene(2.0), options);
  EXPECT_EQ(response.status, Status::Completed);
  EXPECT_NEAR(last(response, 0), -0.2, SolverOptions{}.tolerance);
  // The hinge at the clamp turns by asin 0.2 and carries M_p on a shorter lever.
  EXPECT_NEAR(last(response, 1), 0.5 / std::sqrt(1.0 - 0.04), 1e-5);
}

TEST(Path, ComesBackOnTheElasticLineAfterUnloading) {
  Scene scene = cantilever(20, {0.0, -1.2 * kPlasticMoment / 1.5, 0.0});
  scene.yield_model = YieldModel::PerAxis;
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 40e9;
  scene.loads[0].history = History::turning_points({1.0, 0.0, 1.0});
  SolverOptions options;
  options.steps = 30;
  const Response response = simulate(scene, options);
  ASSERT_EQ(response.status, Status::Completed);
  const auto& tip = response.probes[0];
  EXPECT_LT(tip[20], -1e-3);            // bent for good
  EXPECT_NEAR(tip[30], tip[10], 1e-9);  // reloaded to where it was
  EXPECT_NEAR(tip[15], tip[25], 1e-9);  // on one line, down and up
}

/// A shallow arch, pinned at both ends, pushed at the crown: the load rises, falls and rises again.
TEST(Path, PassesTheLimitPointsOfASnappingArch) {
  Scene scene = cantilever(24, {});
  scene.yield_model = YieldModel::Elastic;
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = 0.6;
  Support pin;
  pin.kind = SupportKind::Pin;
  scene.supports = {pin, pin};
  scene.supports[1].at = Place::end();
  scene.loads[0].at = {0.5, {}};
  // At the crown the arch's normal lies across the chord, 0.3 rad from y.
  scene.loads[0].force = {0.0, 40e3 * std::cos(0.3), -40e3 * std::sin(0.3)};
  scene.probes.push_back({"factor", ProbeQuantity::LoadFactor});
  scene.probes[0].at = {0.5, {}};
  SolverOptions options;
  options.translation = JointTranslation::Elastic;
  options.control = PathControl::ArcLength;
  options.steps = 60;
  const Response response = simulate(scene, options);
  // It comes to the load asked for on its way back, where no arch would stay.
  EXPECT_EQ(response.status, Status::Unstable) << name_of(response.status);
  const auto& factor = response.probes[1];
  const auto end = factor.begin() + static_cast<std::ptrdiff_t>(response.samples);
  // Up to the top, down by a third at least, and up again beyond the first top.
  const auto top =
      std::find_if(factor.begin(), end - 1, [](const double& f) { return *(&f + 1) < f; });
  const auto valley = std::min_element(top, end);
  EXPECT_NEAR(*top, 0.998, 0.01);  // displacement control sees 0.998 there
  EXPECT_LT(*valley, 0.67 * *top);
  EXPECT_GT(*(end - 1), *top);
}

TEST(Path, StopsAtOnceWhereTheBeamIsFreeToMove) {
  Scene scene = cantilever(8, {0.0, -1.0, 0.0});
  scene.supports[0].kind = SupportKind::Pin;
  scene.supports.push_back({{1e-7, {}}, SupportKind::Roller});
  const Response response = simulate(scene);
  EXPECT_EQ(response.status, Status::Mechanism);
  EXPECT_EQ(response.samples, 0U);
}

TEST(Path, TakesNoStiffBeamForOneThatIsFreeToMove) {
  for (const EndRule rule : {EndRule::HalfJoint, EndRule::Equal}) {
    Scene scene = cantilever(8, {0.0, -1e6, 0.0});
    scene.section.width = scene.section.height = 5.0;  // EI/L^3 = 1e13 N/m
    scene.end_rule = rule;
    EXPECT_EQ(simulate(scene).status, Status::Completed);
  }
}

TEST(Path, RefusesToHoldTheRigidAxisAtBothEnds) {
  Scene scene = cantilever(8, {0.0, -1.0, 0.0});
  scene.supports.push_back({});
  scene.supports[1].at = Place::end();
  EXPECT_EQ(simulate(scene).status, Status::HeldTwice);
  SolverOptions options;
  options.translation = JointTranslation::Elastic;
  EXPECT_EQ(simulate(scene, options).status, Status::Completed);
}

/// What holds a point along y and along z holds it along a slanted axis that cannot stretch, too,
/// though neither does so alone.
TEST(Path, RefusesToHoldARigidAxisTwiceHoweverItLies) {
  const std::vector<std::vector<std::array<double, 3>>> beams{
      {{0.0, 0.0, 0.0}, {0.0, 0.6, 0.8}},
      {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.5}, {0.0, 0.3, 0.9}},
      {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.5}, {0.0, 0.5, 0.5}}};
  for (const auto& points : beams) {
    for (const Level level : {Level::Planar, Level::Spatial}) {
      for (const Analysis analysis : {Analysis::Statics, Analysis::Dynamics}) {
        Scene scene = cantilever(16, {0.0, -1.0, 0.5});
        scene.beam.shape = BeamShape::Polyline;
        scene.beam.points = points;
        scene.beam.length = 1.0;
        scene.loads[0].at = {0.25, {}};
        for (const double at : {0.75, 1.0}) {
          Support clamp;
          clamp.at = {at, {}};
          scene.supports.push_back(clamp);
        }
        SolverOptions options{.level = level, .steps = 1};
        options.analysis = analysis;
        EXPECT_EQ(simulate(scene, options).status, Status::HeldTwice) << points.size();
        if (analysis == Analysis::Dynamics) continue;
        options.translation = JointTranslation::Elastic;
        EXPECT_EQ(simulate(scene, options).status, Status::Completed) << points.size();
      }
    }
  }
}

/// Shallow arches and short stretches hold by little, but they hold.
TEST(Path, HoldsArchesOnWhateverStandsUnderThem) {
  const auto sum_of_reactions = [](Scene scene, int segments) {
    scene.beam.segments = segments;
    const Response response = simulate(scene, {.level = Level::Planar, .steps = 1});
    EXPECT_EQ(response.status, Status::Completed) << segments;
    const ChainHistory& chain = response.chain;
    const std::size_t last = (chain.frame_sample.size() - 1) * chain.supports;
    double sum = 0.0;
    for (std::size_t s = 0; s < chain.supports; ++s) sum += chain.reaction[6 * (last + s) + 1];
    return sum;
  };
  const auto arc = [](double degrees) {
    Scene scene = cantilever(8, {0.0, -100.0, 0.0});
    scene.beam.shape = BeamShape::Arc;
    scene.beam.arc_angle = degrees * std::acos(-1.0) / 180.0;
    return scene;
  };
  for (const double degrees : {180.0, 30.0}) {
    Scene scene = arc(degrees);
    constexpr int kSpans = 60;
    scene.supports.clear();
    for (int i = 0; i <= kSpans; ++i) {
      scene.supports.push_back({.at = {i / double{kSpans}, {}}, .kind = SupportKind::Pin});
    }
    scene.loads[0].at = Place::start();
    scene.loads[0].to = Place::end();
    EXPECT_NEAR(sum_of_reactions(scene, 6 * kSpans), 100.0, 1e-4) << degrees;
  }
  for (const int segments : {120, 480}) {
    Scene scene = arc(0.326);
    scene.supports.push_back({.at = {0.25, {}}, .kind = SupportKind::Clamp});
    EXPECT_NEAR(sum_of_reactions(scene, segments), 100.0, 1e-2) << segments;
  }
  Scene guided = cantilever(8, {0.0, -100.0, 0.0});
  guided.loads[0].at = {0.3, {}};
  for (const double at : {0.5, 0.5005}) {
    Support guide{.at = {at, {}}, .kind = SupportKind::Guide};
    guide.hold = HeldFreedoms{true, true, false, true, true, true};
    guided.supports.push_back(guide);
  }
  EXPECT_NEAR(sum_of_reactions(guided, 50), 100.0, 1e-4);
}

/// Between rollers a column bears more than it would without, from the first load on, too.
TEST(Path, HoldsAColumnUnderAThrustFromTheStart) {
  constexpr int kSpans = 5;
  for (const double thrust : {25.0, 40.0, 100.0}) {  // E I/L^2; it buckles at some 25 pi^2
    Scene scene = cantilever(80, {});
    scene.yield_model = YieldModel::Elastic;
    const SectionProperties p = section_properties(scene.section, scene.material.poisson_ratio);
    const double unit = scene.material.youngs_modulus * p.second_moment_x;
    scene.loads[0].force = {0.0, 0.0, -thrust * unit};
    scene.loads[0].history = History{{0.0}, {1.0}};
    scene.supports.clear();
    for (int i = 0; i <= kSpans; ++i) {
      scene.supports.push_back({.at = {i / double{kSpans}, {}},
                                .kind = i == 0 ? SupportKind::Pin : SupportKind::Roller});
    }
    SolverOptions options{.level = Level::Planar, .steps = 1};
    options.duration = 1.0;
    EXPECT_EQ(simulate(scene, options).status, Status::Completed) << thrust;
  }
}

TEST(Path, ClaimsNoLimitForAnElasticFollowerLoad) {
  // Seen from its tip a beam under a follower force has one shape for each force: there is no
  // limit.
  Scene scene = cantilever(4, {});
  scene.material.youngs_modulus = 200e9;
  scene.yield_model = YieldModel::Elastic;
  scene.loads[0].force = {2e8, 8e8 / 3.0, 0.0};
  scene.loads[0].follows = true;
  const Response response = simulate(scene, {.level = Level::Spatial});
  EXPECT_EQ(response.status, Status::NotConverged);
}

TEST(Path, StopsWhereItIsToldTo) {
  for (const PathControl control : {PathControl::Load, PathControl::ArcLength}) {
    SolverOptions options;
    options.control = control;
    const Model model = prepare(cantilever(8, {0.0, -1.0, 0.0}), options);
    Workspace workspace = make_workspace(model);
    Response response = make_response(model);
    workspace.on_progress = [](double time) { return time < 0.42; };
    run(model, {}, workspace, response);
    EXPECT_EQ(response.status, Status::Interrupted);
    EXPECT_GT(response.samples, 1U);
    EXPECT_LT(response.chain.time[response.samples - 1], 0.42);
    workspace.on_progress = nullptr;
    run(model, {}, workspace, response);
    EXPECT_EQ(response.status, Status::Completed);
  }
}

TEST(Path, BalancesTheEnergiesOfALoadingToTheSquareOfItsSteps) {
  const auto residual_fraction = [](int steps) {
    Scene scene = hinge_scene(0.9);
    scene.material.youngs_modulus = 200e9;
    scene.material.hardening.law = HardeningLaw::Linear;
    scene.material.hardening.tangent_modulus = 20e9;
    SolverOptions options;
    options.steps = steps;
    const Response response = simulate(scene, options);
    EXPECT_EQ(response.status, Status::Completed);
    return std::fabs(last(response, 2) / last(response, 3));
  };
  const double coarse = residual_fraction(20);
  const double fine = residual_fraction(80);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(fine, coarse / 8.0);
}

}  // namespace
}  // namespace plastica
