#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "plastica/theory/lumped_chain.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

// Beams that are not even: regions, segments of different lengths, corners.

namespace plastica {
namespace {

using testing::add_probe;
using testing::bending_stiffness_of;
using testing::cantilever_scene;
using testing::completed;
using testing::last_of;
using testing::tolerance;

constexpr double kForce = 1e-2;  ///< [N]; finite rotations cost 1e-11 of the deflection

/// Tip deflection along an axis under a force there, over the closed form, minus 1.
double error_of(Scene scene, Component along, double exact) {
  Load load{.force = {}};
  load.force[static_cast<std::size_t>(along)] = kForce;
  scene.loads.push_back(load);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), along);
  return last_of(completed(scene, {.steps = 1}), 0) / exact - 1.0;
}

/// Errors fall with the square of the segments, and are small.
void expect_order_two(const std::function<double(int)>& error, double largest) {
  const double coarse = error(16);
  const double fine = error(32);
  const double finest = error(64);
  EXPECT_NEAR(coarse, 0.0, tolerance(largest));
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, tolerance(0.05));
  EXPECT_NEAR(std::log2(fine / finest), 2.0, tolerance(0.05));
}

/// int M^2/(EI) of a tip force on a cantilever whose outer half has another stiffness.
double stepped_tip(double inner, double outer) {
  return kForce / 3.0 * ((1.0 - 0.125) / inner + 0.125 / outer);
}

TEST(ChainBeams, BendInPartsOfDifferentSections) {
  expect_order_two(
      [](int segments) {
        Scene scene = cantilever_scene(segments);
        const double ei = bending_stiffness_of(scene);
        Section thin = scene.section;
        thin.height = 0.5 * scene.section.height;
        scene.regions.push_back({{0.5, {}}, Place::end(), thin, scene.material});
        return error_of(scene, Component::Y, stepped_tip(ei, ei / 8.0));
      },
      0.01);
}

TEST(ChainBeams, BendInPartsOfDifferentMaterials) {
  expect_order_two(
      [](int segments) {
        Scene scene = cantilever_scene(segments);
        const double ei = bending_stiffness_of(scene);
        Material soft = scene.material;
        soft.youngs_modulus *= 0.35;
        scene.regions.push_back({{0.5, {}}, Place::end(), scene.section, soft});
        return error_of(scene, Component::Y, stepped_tip(ei, 0.35 * ei));
      },
      0.01);
}

TEST(ChainBeams, YieldFirstWhereAPartIsWeak) {
  // The outer half yields at a fifth of the stress: at its inner end M = P/2, before the clamp.
  Scene scene = cantilever_scene(20);
  scene.material.youngs_modulus *= 1e3;
  scene.yield_model = YieldModel::PerAxis;
  const double moment = testing::yield_moment_of(scene);
  Material weak = scene.material;
  weak.yield_stress *= 0.2;
  scene.regions.push_back({{0.5, {}}, Place::end(), scene.section, weak});
  scene.loads.push_back({.force = {0.0, -moment, 0.0}});
  const Response response = simulate(scene);
  ASSERT_EQ(response.status, Status::LimitLoad);
  EXPECT_NEAR(response.limit->below, 0.4, tolerance(2e-4));
}

TEST(ChainBeams, SayALimitAsTheFactorOfWhatGrowsBesideADeadLoad) {
  // A tip force that is there from the first, a moment that grows to twice what then yields.
  Scene scene = cantilever_scene(20);
  scene.material.youngs_modulus *= 1e3;
  scene.yield_model = YieldModel::PerAxis;
  const double moment = testing::yield_moment_of(scene);
  scene.loads.push_back({.force = {0.0, -0.25 * moment, 0.0}, .history = History::constant()});
  scene.loads.push_back({.moment = {1.5 * moment, 0.0, 0.0}});
  const Response response = simulate(scene);
  ASSERT_EQ(response.status, Status::LimitLoad);
  EXPECT_NEAR(response.limit->below, 0.5, tolerance(2e-4));
  EXPECT_NEAR(response.chain.factor[response.samples - 1],
              response.chain.time[response.samples - 1], 1e-12);
}

/// Segments whose lengths grow evenly to three times the first.
std::vector<double> growing(int segments) {
  std::vector<double> fractions;
  for (int i = 0; i < segments; ++i) fractions.push_back(1.0 + 2.0 * i / (segments - 1));
  double sum = 0.0;
  for (const double fraction : fractions) sum += fraction;
  for (double& fraction : fractions) fraction /= sum;
  return fractions;
}

TEST(ChainBeams, KeepTheOrderWithSegmentsOfDifferentLengths) {
  expect_order_two(
      [](int segments) {
        Scene scene = cantilever_scene(segments);
        scene.beam.segment_fractions = growing(segments);
        return error_of(scene, Component::Y, kForce / 3.0 / bending_stiffness_of(scene));
      },
      0.01);
}

TEST(ChainBeams, TakeTributaryLengthsThatAreGiven) {
  // One joint in the middle of a clamped beam: it turns by M l/EI.
  Scene scene = cantilever_scene(2);
  scene.end_rule = EndRule::Equal;
  scene.loads.push_back({.moment = {1.0, 0.0, 0.0}});
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
  const double ei = bending_stiffness_of(scene);
  EXPECT_NEAR(last_of(completed(scene, {.steps = 1}), 0) * ei, 0.5, tolerance(1e-10));
  scene.beam.joint_lengths = {0.3};
  EXPECT_NEAR(last_of(completed(scene, {.steps = 1}), 0) * ei, 0.3, tolerance(1e-10));
}

TEST(ChainBeams, TurnEvenlyAtJointsAndInTheMiddleOfSegments) {
  // Bent by a moment at its end the slope grows evenly, up to the end, whose half segment the last
  // joint has, too.
  const auto slope = [](int segments, const Place& place) {
    Scene scene = cantilever_scene(segments);
    scene.loads = {{.moment = {1e-3, 0.0, 0.0}}};
    add_probe(scene, ProbeQuantity::Rotation, place, Component::X);
    return last_of(completed(scene, {.steps = 1}), 0) * bending_stiffness_of(scene) / 1e-3;
  };
  EXPECT_NEAR(slope(32, Place::end()), 1.0, tolerance(1e-10));
  EXPECT_NEAR(slope(32, {0.5, {}}), 0.5, tolerance(1e-10));
  EXPECT_NEAR(slope(31, {0.5, {}}), 0.5, tolerance(1e-10));
}

// To state what they are anyway changes nothing: the end's half segment is beside them.
TEST(ChainBeams, TurnAtTheirEndWithTributaryLengthsAsWell) {
  Scene scene = cantilever_scene(10);
  scene.loads = {{.moment = {1e-3, 0.0, 0.0}}};
  scene.beam.joint_lengths.assign(9, 0.1);
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
  const double rotation = last_of(completed(scene, {.steps = 1}), 0);
  EXPECT_NEAR(rotation * bending_stiffness_of(scene) / 1e-3, 1.0, tolerance(1e-10));
}

TEST(ChainBeams, GiveTheEndRuleByTributaryLengths) {
  constexpr int kSegments = 8;
  Scene scene = cantilever_scene(kSegments);
  const double exact = kForce / 3.0 / bending_stiffness_of(scene);
  scene.end_rule = EndRule::ThreeHalves;
  const double by_rule = error_of(scene, Component::Y, exact);
  scene.end_rule = EndRule::Equal;
  scene.beam.joint_lengths.assign(kSegments - 1, 1.0 / kSegments);
  scene.beam.joint_lengths.front() = scene.beam.joint_lengths.back() = 1.5 / kSegments;
  EXPECT_NEAR(error_of(scene, Component::Y, exact), by_rule, tolerance(1e-12));
  EXPECT_NEAR(by_rule + 1.0,
              theory::tip_force_ratio(theory::ChainConvention::ThreeHalvesEnds, kSegments),
              tolerance(1e-8));
}

/// Two legs at a right angle: `a` along z, then `b` along y.
Scene elbow(int segments, double a) {
  Scene scene = cantilever_scene(segments);
  scene.section.width = 0.01;
  const double b = 1.0 - a;
  scene.beam.shape = BeamShape::Polyline;
  scene.beam.points = {{0.0, 0.0, 0.0}, {0.0, 0.0, a}, {0.0, b, a}};
  return scene;
}

TEST(ChainBeams, BendAroundACornerInTheirPlane) {
  // Force along z at the tip: leg a bends under the moment P b alone, leg b under P s.
  expect_order_two(
      [](int segments) {
        const Scene scene = elbow(segments, 0.5);
        const double ei = bending_stiffness_of(scene);
        return error_of(scene, Component::Z, kForce / ei * (0.125 / 3.0 + 0.25 * 0.5));
      },
      0.01);
}

TEST(ChainBeams, BendAndTwistAroundACorner) {
  // Force along x: both legs bend about their other axis, leg a is twisted by P b as well.
  expect_order_two(
      [](int segments) {
        const Scene scene = elbow(segments, 0.5);
        const SectionProperties p = testing::properties_of(scene);
        const double ei = scene.material.youngs_modulus * p.second_moment_y;
        const double gj = resolved_shear_modulus(scene.material) * p.torsion_constant;
        return error_of(scene, Component::X, kForce * (2.0 * 0.125 / 3.0 / ei + 0.25 * 0.5 / gj));
      },
      0.01);
}

/// Tip deflection along an axis of legs between points under a force there, by the method of the
/// unit load: int (m_u m_w/EI_u + m_v m_w/EI_v + T^2/GJ) ds along each leg, of a section that is
/// alike about all axes.
double unit_load_tip(const std::vector<std::array<double, 3>>& points, std::size_t along,
                     double bending, double torsion) {
  const auto tip = points.back();
  double sum = 0.0;
  for (std::size_t leg = 0; leg + 1 < points.size(); ++leg) {
    std::array<double, 3> tangent{};
    double length = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      tangent[k] = points[leg + 1][k] - points[leg][k];
      length += tangent[k] * tangent[k];
    }
    length = std::sqrt(length);
    for (double& t : tangent) t /= length;
    // The moment is linear along a leg: Simpson's rule is exact.
    for (const auto& [at, weight] : {std::pair{0.0, 1.0}, {0.5, 4.0}, {1.0, 1.0}}) {
      std::array<double, 3> arm{};
      for (std::size_t k = 0; k < 3; ++k)
        arm[k] = tip[k] - points[leg][k] - at * length * tangent[k];
      std::array<double, 3> moment{};
      moment[(along + 1) % 3] = arm[(along + 2) % 3];
      moment[(along + 2) % 3] = -arm[(along + 1) % 3];
      double square = 0.0;
      double twist = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        square += moment[k] * moment[k];
        twist += moment[k] * tangent[k];
      }
      sum += weight * length / 6.0 * ((square - twist * twist) / bending + twist * twist / torsion);
    }
  }
  return kForce * sum;
}

/// At a corner a joint stands for a part of each leg, which bends and twists about its own axes.
TEST(ChainBeams, BendAndTwistOverLegsThatLieInNoPlane) {
  // Both corners are turned about axes of the section, the first about x, the second about y.
  const double rise = std::sqrt(3.0) / 8.0;
  const std::vector<std::array<double, 3>> right{
      {0.0, 0.0, 0.0}, {0.0, 0.0, 0.25}, {0.0, 0.5, 0.25}, {0.25, 0.5, 0.25}};
  const std::vector<std::array<double, 3>> oblique{
      {0.0, 0.0, 0.0}, {0.0, 0.0, 0.25}, {0.0, rise, 0.375}, {2.0 * rise, 2.0 * rise, 0.5}};
  // In a plane, and bent out of it along x.
  const std::vector<std::array<double, 3>> flat{
      {0.0, 0.0, 0.0}, {0.0, 0.0, 0.5}, {0.0, 2.0 * rise, 0.75}};
  for (const auto& points : {right, oblique, flat}) {
    for (std::size_t along = 0; along < 3; ++along) {
      SCOPED_TRACE(::testing::Message() << "along "
                                        << "xyz"[along]);
      expect_order_two(
          [&](int segments) {
            Scene scene = cantilever_scene(segments);
            scene.section.height = scene.section.width;
            scene.beam.shape = BeamShape::Polyline;
            scene.beam.points = points;
            const SectionProperties p = testing::properties_of(scene);
            const double ei = scene.material.youngs_modulus * p.second_moment_y;
            const double gj = resolved_shear_modulus(scene.material) * p.torsion_constant;
            return error_of(scene, static_cast<Component>(along),
                            unit_load_tip(points, along, ei, gj));
          },
          0.01);
    }
  }
}

/// Twist of the tip about an axis under a moment about it at the corner of an elbow, over that of
/// leg a alone: a section that is no square, so that both bending stiffnesses and torsion count.
double corner_moment_error(int segments, std::size_t about, bool guided) {
  Scene scene = elbow(segments, 0.5);
  const SectionProperties p = testing::properties_of(scene);
  const double e = scene.material.youngs_modulus;
  const double gj = resolved_shear_modulus(scene.material) * p.torsion_constant;
  // Leg a lies along z, leg b along y.
  const std::array<double, 3> of_a{e * p.second_moment_x, e * p.second_moment_y, gj};
  const std::array<double, 3> of_b{e * p.second_moment_x, gj, e * p.second_moment_y};
  Load load;
  load.at = guided ? Place::end() : Place{0.5, {}};
  load.moment[about] = 1e-3;
  scene.loads.push_back(load);
  if (guided) scene.supports.push_back({.at = {0.5, {}}, .kind = SupportKind::Guide});
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), static_cast<Component>(about));
  const double exact = load.moment[about] * 0.5 / (guided ? of_b : of_a)[about];
  return last_of(completed(scene, {.level = Level::Spatial, .steps = 1}), 0) / exact - 1.0;
}

TEST(ChainBeams, TurnByAMomentAtACornerWhateverTheSegments) {
  for (std::size_t about = 0; about < 3; ++about) {
    for (const int segments : {4, 16}) {
      EXPECT_NEAR(corner_moment_error(segments, about, false), 0.0, tolerance(1e-6))
          << "xyz"[about] << ", " << segments;
    }
  }
}

TEST(ChainBeams, AreHeldAtACornerAboutTheAxesOfTheLegs) {
  for (std::size_t about = 0; about < 3; ++about) {
    EXPECT_NEAR(corner_moment_error(16, about, true), 0.0, tolerance(1e-6)) << "xyz"[about];
  }
}

/// A pin at a corner holds the beam's twist there, about the axis half-way between its legs, and
/// both legs turn by one angle psi about the one across it: of leg a, whose ends stay where they
/// are, (4 E I + G J)/(2 L) psi = P L/sqrt 2.
TEST(ChainBeams, TurnAsOneAtACornerThatAPinHolds) {
  const auto error = [](int segments, double* turns_apart) {
    Scene scene = elbow(segments, 0.5);
    const SectionProperties p = testing::properties_of(scene);
    const double ei = scene.material.youngs_modulus * p.second_moment_y;
    const double gj = resolved_shear_modulus(scene.material) * p.torsion_constant;
    scene.supports.push_back({.at = {0.5, {}}, .kind = SupportKind::Pin});
    scene.loads.push_back({.force = {kForce, 0.0, 0.0}});
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::X);
    for (const double at : {0.5 - 1e-6, 0.5 + 1e-6}) {
      add_probe(scene, ProbeQuantity::Rotation, {at, {}}, Component::Y);
    }
    SolverOptions options{.level = Level::Spatial, .steps = 1};
    options.translation = JointTranslation::Elastic;  // leg a is held at both of its ends
    const Response response = completed(scene, options);
    *turns_apart = last_of(response, 2) / last_of(response, 1) - 1.0;
    const double exact = kForce * 0.125 * (1.0 / (3.0 * ei) + 1.0 / (4.0 * ei + gj));
    return last_of(response, 0) / exact - 1.0;
  };
  double apart = 0.0;
  EXPECT_NEAR(error(16, &apart), 0.0, tolerance(0.01));
  EXPECT_NEAR(error(256, &apart), 0.0, tolerance(1e-3));  // shear, which is not in the closed form
  EXPECT_NEAR(apart, 0.0, tolerance(0.02));
}

TEST(ChainBeams, AreHeldAtACornerByStiffSpringsAsByAGuide) {
  const auto tip = [](SupportKind kind) {
    Scene scene = elbow(16, 0.5);
    Support support{.at = {0.5, {}}, .kind = kind};
    if (kind == SupportKind::Elastic) support.rotational_stiffness = {1e12, 1e12, 1e12};
    scene.supports.push_back(support);
    scene.loads.push_back({.force = {kForce, 0.0, 0.0}});
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::X);
    return last_of(completed(scene, {.level = Level::Spatial, .steps = 1}), 0);
  };
  EXPECT_NEAR(tip(SupportKind::Elastic) / tip(SupportKind::Guide), 1.0, tolerance(1e-6));
}

/// In a plane turns are counted along the beam: its axes alone do not tell 200 degrees from -160.
TEST(ChainBeams, TurnFromNothingWhereTheyWindByMoreThanHalfATurn) {
  Scene scene = cantilever_scene(20);
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = 200.0 * std::acos(-1.0) / 180.0;
  Load load;
  load.moment = {1e-3, 0.0, 0.0};
  scene.loads.push_back(load);
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
  const double exact = 1e-3 * scene.beam.length / bending_stiffness_of(scene);
  for (const Level level : {Level::Planar, Level::Spatial}) {
    const Response response = completed(scene, {.level = level, .steps = 1});
    EXPECT_NEAR(response.probes[0][0], 0.0, 1e-15);
    EXPECT_NEAR(last_of(response, 0) / exact, 1.0, tolerance(1e-6));
  }
}

}  // namespace
}  // namespace plastica
