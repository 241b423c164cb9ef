#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "plastica/run/axial_warning.hpp"
#include "tests/support/axial_limit.hpp"
#include "tests/support/chain_scene.hpp"

// The N-M limit of joints that do not stretch, through whole runs: a cantilever that is pulled and
// then bent until it carries no more.

namespace plastica {
namespace {

using testing::cantilever_scene;
using testing::plastic_moment_left;
using testing::properties_of;

const Section kSquare{.width = 0.02, .height = 0.02};
const Section kCircle{.shape = SectionShape::Circle, .radius = 0.01};
const Section kTube{.shape = SectionShape::RoundTube, .radius = 0.01, .inner_radius = 0.0095};
const Section kThickTube{.shape = SectionShape::RoundTube, .radius = 0.01, .inner_radius = 0.006};
const Section kBox{.shape = SectionShape::RectangularTube,
                   .width = 0.02,
                   .height = 0.03,
                   .inner_width = 0.018,
                   .inner_height = 0.027};

/// N over N_p, from none to nearly all.
constexpr double kPulls[] = {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 0.95};

/// Its axial force is there from a tenth of the time on; the transverse force grows to 1.3 times
/// what the section carries without the other. So stiff that N times the deflection is below 3e-4
/// of the moment.
Scene pulled(const Section& section, double n, YieldModel model, YieldCap cap) {
  Scene scene = cantilever_scene(8);
  scene.section = section;
  scene.material.youngs_modulus = 1e16;
  scene.yield_model = model;
  scene.yield_cap = cap;
  const SectionProperties p = properties_of(scene);
  const double stress = scene.material.yield_stress;
  const bool first_yield = model != YieldModel::Fibre && cap == YieldCap::FirstYield;
  const double modulus = first_yield ? p.section_modulus_x : p.plastic_section_modulus_x;
  scene.loads.push_back({.at = Place::end(),
                         .force = {0.0, 1.3 * stress * modulus, 0.0},
                         .history = {{0.0, 0.1, 1.0}, {0.0, 0.01, 1.0}}});
  scene.loads.push_back({.at = Place::end(),
                         .force = {0.0, 0.0, n * stress * p.area},
                         .history = {{0.0, 0.1, 1.0}, {0.0, 1.0, 1.0}}});
  return scene;
}

/// The moment at the clamp at the limit load, over that without axial force.
double limit_of(const Scene& scene, Level level, JointTranslation translation) {
  const Response response =
      simulate(scene, {.level = level, .translation = translation, .steps = 40});
  EXPECT_EQ(response.status, Status::LimitLoad) << name_of(response.status);
  if (!response.limit) return 0.0;
  return 1.3 * response.limit->below;
}

void expect_limit(const Section& section, YieldModel model, double allowed, Level level,
                  JointTranslation translation = JointTranslation::Rigid) {
  for (const double n : kPulls) {
    const double exact = plastic_moment_left(section, n);
    const Scene scene = pulled(section, n, model, YieldCap::FullyPlastic);
    EXPECT_NEAR(limit_of(scene, level, translation) / exact, 1.0, allowed) << n;
    // Compression takes as much, but for what the deflection adds.
    Scene pushed = scene;
    pushed.loads[1].force[2] *= -1.0;
    EXPECT_NEAR(limit_of(pushed, level, translation) / exact, 1.0, allowed) << -n;
  }
}

TEST(AxialLimit, OfARectangleIsOneLessTheSquare) {
  for (const double n : kPulls) EXPECT_NEAR(plastic_moment_left(kSquare, n), 1.0 - n * n, 1e-4);
  // What the deflection adds, and the bracket of the limit load: over what is left at n = 0.95.
  expect_limit(kSquare, YieldModel::Interaction, 4e-3, Level::Planar);
  expect_limit(kSquare, YieldModel::Interaction, 4e-3, Level::Spatial);
}

TEST(AxialLimit, OfRoundSectionsIsTheirsWithinAPercent) {
  for (const Section& section : {kCircle, kTube, kThickTube}) {
    expect_limit(section, YieldModel::Interaction, 0.01, Level::Planar);
  }
  expect_limit(kCircle, YieldModel::Interaction, 0.01, Level::Spatial);
}

TEST(AxialLimit, OfABoxInAPlaneIsItsOwnWithinAPercent) {
  expect_limit(kBox, YieldModel::Interaction, 0.01, Level::Planar);
}

/// Fibres come to their limit slowly, and at a slope that counts as none: so the end is moved, to
/// 60 times its deflection at first yield, and the moment at the clamp read.
TEST(AxialLimit, OfFibresIsTheSectionsWithinAPercent) {
  for (const Section& section : {kSquare, kCircle, kTube, kBox}) {
    for (const double n : kPulls) {
      Scene scene = pulled(section, n, YieldModel::Fibre, YieldCap::FirstYield);
      scene.material.youngs_modulus = 1e18;
      const SectionProperties p = properties_of(scene);
      const double stress = scene.material.yield_stress;
      Support hand{.at = Place::end(), .kind = SupportKind::Clamp};
      hand.hold = HeldFreedoms{false, true, false, false, false, false};
      hand.translation = {0.0, 60.0 * stress / (3e18 * p.outer_distance_x), 0.0};
      hand.history = scene.loads[0].history;
      scene.supports.push_back(hand);
      scene.loads.erase(scene.loads.begin());
      testing::add_probe(scene, ProbeQuantity::Moment, Place::start(), Component::X);
      // The flanges of the box are a twentieth of its depth: forty fibres have two in each.
      const int fibres = section.shape == SectionShape::RectangularTube ? 80 : 40;
      const Response response =
          testing::completed(scene, {.level = Level::Planar, .fibres = fibres, .steps = 40});
      const double moment =
          std::fabs(testing::last_of(response, 0)) / (stress * p.plastic_section_modulus_x);
      EXPECT_NEAR(moment / plastic_moment_left(section, n), 1.0, 0.01) << n;
    }
  }
}

/// Elastic stresses of N and M add: |n| + |m| = 1, of every shape.
TEST(AxialLimit, OfFirstYieldIsTheSumOfBoth) {
  for (const Section& section : {kSquare, kCircle, kTube, kBox}) {
    for (const double n : kPulls) {
      const Scene scene = pulled(section, n, YieldModel::Interaction, YieldCap::FirstYield);
      EXPECT_NEAR(limit_of(scene, Level::Planar, JointTranslation::Rigid) / (1.0 - n), 1.0, 6e-3)
          << n;
    }
  }
}

/// The conservative surface is first yield, too.
TEST(AxialLimit, IsThatOfTheConservativeSurface) {
  const Scene scene = pulled(kSquare, 0.6, YieldModel::Conservative, YieldCap::FirstYield);
  EXPECT_NEAR(limit_of(scene, Level::Planar, JointTranslation::Rigid), 0.4, 1e-3);
  EXPECT_NEAR(limit_of(scene, Level::Spatial, JointTranslation::Rigid), 0.4, 1e-3);
}

/// Float has the same laws.
TEST(AxialLimit, IsThatOfFloatAlike) {
  const Scene scene = pulled(kSquare, 0.5, YieldModel::Interaction, YieldCap::FullyPlastic);
  const Response response =
      simulate(scene, {.level = Level::Planar, .precision = Precision::Float, .steps = 40});
  ASSERT_TRUE(response.limit) << name_of(response.status);
  EXPECT_NEAR(1.3 * response.limit->below, 0.75, 5e-3);
}

/// A bar that is pulled, alone: it has a limit load at N_p.
TEST(AxialLimit, OfABarIsItsPlasticForce) {
  for (const YieldModel model :
       {YieldModel::Interaction, YieldModel::Conservative, YieldModel::Fibre}) {
    for (const double pull : {1.05, 10.0, -1.05}) {
      for (const Level level : {Level::Planar, Level::Spatial}) {
        Scene scene = cantilever_scene(8);
        scene.yield_model = model;
        scene.loads.push_back(
            {.at = Place::end(),
             .force = {0.0, 0.0, pull * scene.material.yield_stress * properties_of(scene).area}});
        // Compression alone would buckle it: shorter.
        scene.beam.length = 0.05;
        const Response response = simulate(scene, {.level = level, .steps = 20});
        EXPECT_EQ(response.status, Status::LimitLoad) << name_of(response.status) << pull;
        ASSERT_TRUE(response.limit);
        EXPECT_NEAR(response.limit->below * std::fabs(pull), 1.0, 1e-4);
        EXPECT_GE(response.limit->above * std::fabs(pull), 1.0 - 1e-5);
      }
    }
  }
}

TEST(AxialLimit, IsNotMetBelowIt) {
  Scene scene = cantilever_scene(8);
  scene.yield_model = YieldModel::Interaction;
  scene.loads.push_back(
      {.at = Place::end(),
       .force = {0.0, 0.0, 0.999 * scene.material.yield_stress * properties_of(scene).area}});
  const Response response = testing::completed(scene);
  EXPECT_FALSE(response.axial);
}

/// What per_axis leaves out is measured, and said.
TEST(AxialWarning, SaysHowMuchPerAxisCarriesTooMuch) {
  Scene scene = pulled(kSquare, 0.35, YieldModel::PerAxis, YieldCap::FullyPlastic);
  const Response response = simulate(scene, {.level = Level::Planar, .steps = 40});
  ASSERT_TRUE(response.axial);
  EXPECT_NEAR(response.axial->ratio, 0.35, 1e-3);
  EXPECT_EQ(response.axial->fraction, 0.0);
  EXPECT_NEAR(response.axial->left, 1.0 - 0.35 * 0.35, 1e-3);
  const std::string said = axial_warnings(scene, {}, response).at(0);
  EXPECT_NE(said.find("0.35 N_p"), std::string::npos) << said;
  EXPECT_NE(said.find("14 % more"), std::string::npos) << said;
  scene.loads[1].force[2] *= 2.0;
  scene.yield_cap = YieldCap::FirstYield;
  const Response first = simulate(scene, {.level = Level::Spatial, .steps = 40});
  ASSERT_TRUE(first.axial);
  EXPECT_NEAR(first.axial->left, 0.3, 1e-3);
  scene.yield_model = YieldModel::Interaction;
  const Response seen = simulate(scene, {.level = Level::Planar, .steps = 40});
  EXPECT_TRUE(axial_warnings(scene, {}, seen).empty());
}

/// Hardening carries more than N_p; the bar lengthens, and the run says that it does not show it.
TEST(AxialWarning, SaysThatABarLengthens) {
  Scene scene = cantilever_scene(4);
  scene.yield_model = YieldModel::Interaction;
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 2e9;
  const double yield = scene.material.yield_stress * properties_of(scene).area;
  scene.loads.push_back({.at = Place::end(), .force = {0.0, 0.0, 1.05 * yield}});
  scene.loads.push_back({.at = Place::end(), .force = {0.0, 1.0, 0.0}});
  const Response response = testing::completed(scene);
  ASSERT_TRUE(response.axial);
  EXPECT_NEAR(response.axial->ratio, 1.05, 1e-6);
  EXPECT_NE(axial_warnings(scene, {}, response).at(0).find("elastic"), std::string::npos);
}

/// In a motion, too, joints that stretch yield by the axial force, and hardening may carry more.
TEST(AxialWarning, IsNoneOfAMotionWhoseJointsStretch) {
  Scene scene = cantilever_scene(4);
  scene.yield_model = YieldModel::Interaction;
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 20e9;
  scene.loads.push_back({.at = Place::end(), .moment = {1.0, 0.0, 0.0}});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Clamp});
  scene.supports[1].hold = HeldFreedoms{false, false, true, false, false, false};
  scene.supports[1].translation = {0.0, 0.0, 0.005};
  scene.supports[1].history = {{0.0, 0.05}, {0.0, 1.0}};
  SolverOptions options{.level = Level::Planar, .analysis = Analysis::Dynamics, .duration = 0.05};
  options.translation = JointTranslation::Elastic;
  const Response response = testing::completed(scene, options);
  EXPECT_GT(response.chain.energy.back().plastic, 0.0);
  EXPECT_TRUE(axial_warnings(scene, options, response).empty());
}

/// The joint to the ground does not stretch: in a motion its moment knows nothing of N.
TEST(AxialWarning, SaysThatAMotionLeavesTheAxialForceOutOfTheJointAtAClamp) {
  Scene scene = cantilever_scene(4);
  scene.yield_model = YieldModel::Interaction;
  scene.yield_cap = YieldCap::FullyPlastic;
  const double yield = scene.material.yield_stress * properties_of(scene).area;
  const History pulled_first{{0.0, 0.5, 1.0}, {0.0, 1.0, 1.0}};
  scene.loads.push_back({.at = Place::end(), .force = {0.0, 0.0, 0.7 * yield}});
  scene.loads[0].history = pulled_first;
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  scene.supports[1].hold = HeldFreedoms{false, true, false, true, false, false};
  scene.supports[1].translation = {0.0, -0.1, 0.0};
  scene.supports[1].history = {{0.0, 0.5, 1.0}, {0.0, 0.0, 1.0}};
  SolverOptions options{.level = Level::Planar, .analysis = Analysis::Dynamics, .duration = 1.0};
  options.translation = JointTranslation::Elastic;
  const Response response = testing::completed(scene, options);
  ASSERT_TRUE(response.axial);
  EXPECT_EQ(response.axial->fraction, 0.0);
  EXPECT_NEAR(response.axial->ratio, 0.7, 0.05);
  const std::string warning = axial_warnings(scene, options, response).at(0);
  EXPECT_NE(warning.find("do not stretch"), std::string::npos) << warning;
}

/// A bar that is held along its axis at both ends, bent by 0.45 of its depth at the middle.
Scene held_bar(SupportKind ends) {
  Scene scene;
  scene.beam = {.length = 2.0, .segments = 16};
  scene.section = {.width = 0.02, .height = 0.1};
  scene.material.youngs_modulus = 200e9;
  scene.material.yield_stress = 100e6;
  scene.yield_model = YieldModel::Interaction;
  scene.yield_cap = YieldCap::FullyPlastic;
  scene.supports = {{.at = Place::start(), .kind = ends}, {.at = Place::end(), .kind = ends}};
  scene.probes = {{"N", ProbeQuantity::Force, {0.25, {}}, Component::Z}};
  return scene;
}

/// Its axial force [N]. Its plastic hinges lengthen by n h/2 times what they turn (normality to
/// m + n^2 = 1), of which the stretch 2 d^2/L of a bar with straight halves is less:
///   N_p L/EA dn = 4 d/L dd - n h/2 dturn,  turn = hinges (2/L) (d - e m),
/// from where d exceeds what is elastic of it, e at the plastic moment.
/// @param hinges  how often both halves' turn, 2 d/L, is in the turn of all
/// @param elastic  e [m]
double force_of_held_bar(double deflection, double hinges, double elastic) {
  const double length = 2.0, depth = 0.1, yield_strain = 100e6 / 200e9;
  double n = 0.0;
  constexpr int kSteps = 100'000;
  const double step = deflection / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const double d = (i + 0.5) * step;
    const bool yields = d > elastic * (1.0 - n * n);
    const double lengthens = yields ? n * 0.5 * depth * hinges * 2.0 / length : 0.0;
    n += step * (4.0 * d / length - lengthens) /
         (yield_strain * length + lengthens * elastic * 2.0 * n);
  }
  return n * 100e6 * 0.02 * 0.1;
}

TEST(AxialWarning, SaysWhichHingesDoNotLengthen) {
  SolverOptions options;
  options.level = Level::Planar;
  options.translation = JointTranslation::Elastic;
  options.steps = 45;
  SolverOptions plain = options;
  options.control = PathControl::Displacement;
  options.control_at = {0.5, {}};
  options.control_motion = {0.0, -0.045, 0.0};
  Scene clamped = held_bar(SupportKind::Clamp);
  clamped.loads = {{.at = {0.5, {}}, .force = {0.0, -1e3, 0.0}}};
  const Response stiff = testing::completed(clamped, options);
  const auto warnings = axial_warnings(clamped, options, stiff);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(warnings[0].starts_with("the joint at a clamped end yielded under an axial force"))
      << warnings[0];
  // M_p L^2/(24 EI) between clamps, M_p L^2/(12 EI) on pins is elastic: 2.5 and 5 mm.
  // What it says to do: the hinges at the ends lengthen, too, as the one in the middle.
  clamped.end_rule = EndRule::Half;
  const Response right = testing::completed(clamped, options);
  EXPECT_TRUE(axial_warnings(clamped, options, right).empty());
  EXPECT_NEAR(right.probes[0].back() / force_of_held_bar(0.045, 4.0, 2.5e-3), 1.0, 0.015);
  EXPECT_GT(stiff.probes[0].back(), 1.5 * right.probes[0].back());

  // At a support that pushes the middle half of the elongation is lacking.
  Scene pushed = held_bar(SupportKind::Pin);
  pushed.supports.push_back({.at = {0.5, {}}, .kind = SupportKind::Roller});
  pushed.supports[2].hold = HeldFreedoms{false, true, false, false, false, false};
  pushed.supports[2].translation = {0.0, -0.045, 0.0};
  const Response half = testing::completed(pushed, plain);
  const auto of_support = axial_warnings(pushed, plain, half);
  ASSERT_EQ(of_support.size(), 1U);
  EXPECT_TRUE(of_support[0].starts_with("the joint at a rigid support within the beam yielded"))
      << of_support[0];
  Scene loaded = held_bar(SupportKind::Pin);
  loaded.loads = clamped.loads;
  const Response whole = testing::completed(loaded, options);
  EXPECT_TRUE(axial_warnings(loaded, options, whole).empty());
  EXPECT_NEAR(whole.probes[0].back() / force_of_held_bar(0.045, 2.0, 5e-3), 1.0, 0.015);
}

/// A bar beyond N_p that nothing bends: no joint yields, and per_axis would say nothing.
TEST(AxialWarning, SaysThatPerAxisCarriesMoreThanAllOfTheSection) {
  for (const double n : {0.9, 2.0, -2.0}) {
    Scene scene = cantilever_scene(8);
    scene.yield_model = YieldModel::PerAxis;
    const double yield = scene.material.yield_stress * properties_of(scene).area;
    scene.loads.push_back({.at = Place::end(), .force = {0.0, 0.0, n * yield}});
    const Response response = simulate(scene, {.level = Level::Planar});
    EXPECT_EQ(response.axial.has_value(), std::fabs(n) > 1.0) << n;
    if (!response.axial) continue;
    EXPECT_NEAR(response.axial->ratio, std::fabs(n), 1e-9);
    EXPECT_NE(axial_warnings(scene, {}, response).at(0).find("beyond which nothing is carried"),
              std::string::npos);
  }
}

/// Engesser: the column buckles at the tangent modulus' load, 0.67 of this one. One yield surface
/// does not see that, fibres do.
TEST(AxialWarning, SaysThatOneSurfaceIsStiffUnderThrust) {
  Scene scene = cantilever_scene(16);
  scene.section = {.width = 0.02, .height = 0.03};
  scene.beam.length = 1.0;
  scene.material.youngs_modulus = 210e9;
  scene.material.yield_stress = 33.5e6;
  scene.material.hardening = {
      .law = HardeningLaw::Linear, .tangent_modulus = 126e9, .kinematic_fraction = 1.0};
  scene.supports = {{.at = Place::start(),
                     .kind = SupportKind::Pin,
                     .hold = HeldFreedoms{true, true, true, false, false, true}},
                    {.at = Place::end(),
                     .kind = SupportKind::Roller,
                     .hold = HeldFreedoms{true, true, false, false, false, false}}};
  scene.loads = {{.at = Place::end(), .force = {0.0, 50.0, -37e3}}};
  const SolverOptions options{.level = Level::Planar, .translation = JointTranslation::Elastic};
  scene.yield_model = YieldModel::Interaction;
  const Response surface = simulate(scene, options);
  ASSERT_TRUE(surface.axial);
  EXPECT_NEAR(surface.axial->thrust, 37e3 / (33.5e6 * 6e-4), 0.02);
  EXPECT_NE(axial_warnings(scene, options, surface).at(0).find("fibre"), std::string::npos);
  scene.yield_model = YieldModel::Fibre;
  const Response fibres = simulate(scene, options);
  EXPECT_EQ(fibres.status, Status::Unstable);
  EXPECT_TRUE(axial_warnings(scene, options, fibres).empty());
}

}  // namespace
}  // namespace plastica
