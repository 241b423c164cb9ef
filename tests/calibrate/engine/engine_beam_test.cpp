#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/calibrate/engine/engine_scenes.hpp"
#include "tests/support/message.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::testing {
namespace {

using calibrate::EngineBeam;
using calibrate::EngineJoint;
using calibrate::JointHold;
using calibrate::kNever;

constexpr std::array<JointHold, 3> kSprung{JointHold::Sprung, JointHold::Sprung, JointHold::Sprung};
constexpr std::array<JointHold, 3> kFree{};

void expect_near(double value, double expected) {
  EXPECT_NEAR(value, expected, tolerance(1e-14) * std::fabs(expected));
}

TEST(EngineBeam, OfACantileverHasTheStiffnessesOfItsMaterial) {
  const Scene scene = breakable_scene();
  const EngineBeam beam = beam_of(scene);
  const SectionProperties p = properties_of(scene);
  ASSERT_EQ(beam.joints.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    SCOPED_TRACE(i);
    const EngineJoint& joint = beam.joints[i];
    const double l = i == 0 ? 0.125 : 0.25;
    EXPECT_EQ(joint.name, "joint_" + std::to_string(i));
    EXPECT_EQ(joint.half_joint, i == 0);
    EXPECT_EQ(joint.rotation, kSprung);
    expect_near(joint.at, 0.25 * static_cast<double>(i));
    expect_near(joint.length, l);
    expect_near(joint.stiffness[0], 200e9 * p.second_moment_x / l);
    expect_near(joint.stiffness[1], 200e9 * p.second_moment_y / l);
    expect_near(joint.stiffness[2], 200e9 / 2.6 * p.torsion_constant / l);
    expect_near(joint.yield_moment[0], 250e6 * p.section_modulus_x);
    expect_near(joint.yield_moment[1], 250e6 * p.section_modulus_y);
    expect_near(joint.yield_moment[2], 250e6 / std::sqrt(3.0) * p.torsion_modulus);
    EXPECT_EQ(joint.hardened_stiffness, (std::array<double, 3>{}));
  }
}

/// By a moment at its end a cantilever turns M L/EI: the joint beside the end has its half as well.
TEST(EngineBeam, TurnsByAMomentAtItsEndAsTheSceneDoes) {
  Scene scene = breakable_scene();
  const auto turn = [&] {
    double compliance = 0.0;
    for (const EngineJoint& joint : beam_of(scene).joints) compliance += 1.0 / joint.stiffness[0];
    return compliance * 200e9 * properties_of(scene).second_moment_x / scene.beam.length;
  };
  EXPECT_NEAR(turn(), 0.875, tolerance(1e-12));
  scene.loads.push_back({.at = Place::end(), .moment = {1.0, 0.0, 0.0}});
  EXPECT_NEAR(turn(), 1.0, tolerance(1e-12));
}

TEST(EngineBeam, BreaksAtTheAngleThatAHingeLengthTakes) {
  Scene scene = breakable_scene();
  const SectionProperties p = properties_of(scene);
  const EngineBeam beam = beam_of(scene);
  // The depth in the plane of bending.
  EXPECT_EQ(beam.hinge_lengths, (std::array<double, 3>{0.03, 0.02, 0.03}));
  const auto& angle = beam.joints[1].break_angle;
  expect_near(angle[0], 0.02 * 0.03 / 0.015);
  expect_near(angle[1], 0.02 * 0.02 / 0.01);
  expect_near(angle[2], 0.02 * std::sqrt(3.0) * 0.03 * p.torsion_modulus / p.torsion_constant);

  scene.hinge_length = 0.0;
  const EngineBeam own = beam_of(scene);
  expect_near(own.joints[0].break_angle[0], 0.02 * 0.125 / 0.015);
  expect_near(own.joints[1].break_angle[0], 0.02 * 0.25 / 0.015);

  scene.break_limit_y = 0.05;
  expect_near(beam_of(scene).joints[1].break_angle[1], 0.05 * 0.25 / 0.01);
}

TEST(EngineBeam, BreaksAtTheAngleAtWhichTheSolverBreaksIt) {
  Scene scene = breakable_scene();
  const EngineJoint clamp = beam_of(scene).joints[0];
  scene.supports.push_back({.at = Place::end(),
                            .kind = SupportKind::Roller,
                            .hold = HeldFreedoms{false, true},
                            .translation = {0.0, -0.2, 0.0},
                            .history = History::turning_points({1.0})});
  const Response response = simulate(scene, {.steps = 40});
  ASSERT_EQ(response.chain.events.size(), 1U);
  const auto& joint = response.chain.events[0].joints.at(0);
  EXPECT_EQ(joint.joint, 0);
  EXPECT_NEAR(joint.moment[0], clamp.yield_moment[0], 1e-9 * clamp.yield_moment[0]);
  // The solver meets a break within kBreakTolerance.
  EXPECT_NEAR(std::fabs(joint.angle[0]), clamp.break_angle[0], 1e-4 * clamp.break_angle[0]);
}

TEST(EngineBeam, ByTheReportsFormulasIsHalfAsStiffAndBreaksByTheSine) {
  Scene scene = breakable_scene();
  scene.formulas = Formulas::Report;
  const EngineBeam beam = beam_of(scene);
  const SectionProperties p = properties_of(scene);
  ASSERT_EQ(beam.joints.size(), 4U);
  EXPECT_EQ(beam.joints[0].rotation,
            (std::array<JointHold, 3>{JointHold::Rigid, JointHold::Rigid, JointHold::Rigid}));
  EXPECT_FALSE(beam.joints[0].half_joint);
  const EngineJoint& joint = beam.joints[1];
  expect_near(joint.stiffness[0], 200e9 * p.second_moment_x / 0.5);
  expect_near(joint.yield_moment[0], 250e6 * p.second_moment_x / 0.02);
  EXPECT_NEAR(joint.break_angle[0], 2.0 * std::asin(0.02 * 0.25 / 0.03), tolerance(1e-14));
  // (h/l) sin(theta/2) never gets there.
  scene.break_limit_x = 0.121;
  EXPECT_EQ(beam_of(scene).joints[1].break_angle[0], kNever);
}

TEST(EngineBeam, HasNoLimitsWhereTheSceneHasNone) {
  const EngineJoint joint = beam_of(cantilever_scene(4)).joints[1];
  EXPECT_EQ(joint.yield_moment, (std::array<double, 3>{kNever, kNever, kNever}));
  EXPECT_EQ(joint.break_angle, (std::array<double, 3>{kNever, kNever, kNever}));
}

TEST(EngineBeam, OfLinearHardeningHasTheTangentModulus) {
  Scene scene = breakable_scene();
  scene.material.hardening = {.law = HardeningLaw::Linear, .tangent_modulus = 2e9};
  const EngineJoint joint = beam_of(scene).joints[1];
  EXPECT_NEAR(joint.hardened_stiffness[0], 0.01 * joint.stiffness[0],
              tolerance(1e-14) * joint.stiffness[0]);
  // Where hardening spreads the turn, it counts over the joint's own length.
  expect_near(joint.break_angle[0], 0.02 * 0.25 / 0.015);
}

TEST(EngineBeam, CapsTheWholeSectionWhereTheSceneDoes) {
  Scene scene = breakable_scene();
  scene.yield_cap = YieldCap::FullyPlastic;
  expect_near(beam_of(scene).joints[1].yield_moment[0],
              250e6 * properties_of(scene).plastic_section_modulus_x);
}

TEST(EngineBeam, JoinsTwoSectionsInARow) {
  const EngineBeam beam = beam_of(rich_scene());
  ASSERT_EQ(beam.regions.size(), 2U);
  // Joint 2 lies between both: half of either length in a row.
  const double thin = beam.joints[1].stiffness[0];
  const double thick = beam.joints[3].stiffness[0];
  const double both = beam.joints[2].stiffness[0];
  EXPECT_NEAR(both, 2.0 / (1.0 / thin + 1.0 / thick), 1e-12 * both);
  expect_near(beam.joints[2].yield_moment[0], beam.joints[1].yield_moment[0]);
  expect_near(beam.segments[3].mass, 7850.0 * 0.025 * 0.03 * 0.25);
}

TEST(EngineBeam, HasAJointForEachRigidSupport) {
  const EngineBeam beam = beam_of(rich_scene());
  ASSERT_EQ(beam.joints.size(), 6U);
  const EngineJoint& roller = beam.joints[4];
  EXPECT_EQ(roller.name, "support_2");
  EXPECT_TRUE(roller.off_start);
  EXPECT_FALSE(roller.half_joint);
  EXPECT_FALSE(roller.parent);
  EXPECT_EQ(roller.child, 1U);
  EXPECT_EQ(roller.holds, (std::array<bool, 3>{true, true, false}));
  EXPECT_EQ(roller.rotation, kFree);
  EXPECT_NEAR(roller.point[2], 0.3, 1e-15);
  const EngineJoint& clamp = beam.joints[5];
  EXPECT_EQ(clamp.name, "support_3");
  EXPECT_TRUE(clamp.half_joint);
  EXPECT_EQ(clamp.child, 3U);
  EXPECT_EQ(clamp.holds, (std::array<bool, 3>{true, true, false}));
  EXPECT_EQ(clamp.rotation, kSprung);
  expect_near(clamp.stiffness[0], 2.0 * beam.joints[3].stiffness[0]);
}

TEST(EngineBeam, IsHeldOnBothSidesByAClampInside) {
  Scene scene = breakable_scene();
  scene.supports[0].at = {0.5, {}};
  const EngineBeam beam = beam_of(scene);
  ASSERT_EQ(beam.joints.size(), 5U);  // three between segments, two half joints
  EXPECT_EQ(beam.joints[1].rotation, kFree);
  EXPECT_EQ(beam.joints[3].name, "support_1");
  EXPECT_EQ(beam.joints[3].child, 1U);
  EXPECT_EQ(beam.joints[4].name, "support_1_beyond");
  EXPECT_EQ(beam.joints[4].child, 2U);
  EXPECT_EQ(beam.joints[4].holds, (std::array<bool, 3>{}));
  for (const std::size_t half : {3U, 4U}) {
    EXPECT_TRUE(beam.joints[half].half_joint);
    expect_near(beam.joints[half].stiffness[0], 2.0 * beam.joints[0].stiffness[0]);
  }
}

TEST(EngineBeam, ThatIsPinnedTurnsFreelyAndIsHeldAgainstTwist) {
  Scene scene = breakable_scene();
  scene.supports[0].kind = SupportKind::Pin;
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  const EngineJoint pin = beam_of(scene).joints[0];
  EXPECT_EQ(pin.rotation,
            (std::array<JointHold, 3>{JointHold::Free, JointHold::Free, JointHold::Sprung}));
  EXPECT_EQ(pin.stiffness[0], 0.0);
  EXPECT_EQ(pin.yield_moment[0], kNever);
}

TEST(EngineBeam, InFlightHasNoJointToTheGround) {
  Scene scene = breakable_scene();
  scene.supports.clear();
  const EngineBeam beam = beam_of(scene, {.analysis = Analysis::Dynamics, .duration = 1.0});
  ASSERT_EQ(beam.joints.size(), 3U);
  EXPECT_EQ(beam.joints[0].parent, 0U);
}

TEST(EngineBeam, IsTheSameForEveryLevel) {
  Scene scene = breakable_scene();
  const EngineBeam spatial = beam_of(scene, {.level = Level::Spatial});
  for (const Level level : {Level::Planar, Level::Twist}) {
    const EngineBeam beam = beam_of(scene, {.level = level});
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(beam.joints[i].stiffness, spatial.joints[i].stiffness);
      EXPECT_EQ(beam.joints[i].break_angle, spatial.joints[i].break_angle);
      EXPECT_EQ(beam.segments[i].inertia, spatial.segments[i].inertia);
    }
  }
}

TEST(EngineBeam, HasItsSectionsInertiaWhateverTheSceneLeavesOut) {
  const Scene scene = breakable_scene();
  const EngineBeam beam = beam_of(scene, {.rotary_inertia = RotaryInertia::Off});
  const SectionProperties p = properties_of(scene);
  const double mass = 7850.0 * p.area * 0.25;
  expect_near(beam.segments[1].mass, mass);
  expect_near(beam.segments[1].inertia[0],
              mass * 0.25 * 0.25 / 12.0 + 7850.0 * 0.25 * p.second_moment_x);
  expect_near(beam.segments[1].inertia[2], 7850.0 * 0.25 * (p.second_moment_x + p.second_moment_y));
}

TEST(EngineBeam, OfAnArcTurnsFromSegmentToSegment) {
  Scene scene = breakable_scene();
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = 1.0;
  const EngineBeam beam = beam_of(scene);
  const auto& z = beam.segments[3].axes[2];
  EXPECT_NEAR(std::atan2(z[1], z[2]), 0.875, 1e-14);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(beam.joints[3].point[k], beam.segments[3].start[k], 1e-15);
  }
}

TEST(EngineBeam, NotesWhatItLeavesOut) {
  Scene scene = rich_scene();
  scene.yield_model = YieldModel::Fibre;
  scene.supports.push_back({.at = {0.75, {}}, .kind = SupportKind::Pillar, .gap = 0.01});
  scene.supports[2].translation = {0.0, 0.01, 0.0};
  std::string notes;
  for (const std::string& note : beam_of(scene).notes) notes += note + '\n';
  for (const char* what :
       {"fibre sections", "linear hardening", "support[4] at 0.75 m only pushes: left out",
        "support[3] at 1 m moves: here it stands still"}) {
    EXPECT_NE(notes.find(what), std::string::npos) << what << " in\n" << notes;
  }
}

// One hold along x + y is none along x and y: it would be a pin.
TEST(EngineBeam, HoldsAlongANormalThatIsAnAxis) {
  for (const Place& at : {Place::start(), Place::end()}) {
    Scene scene = breakable_scene();
    scene.supports = {{.at = {0.5, {}}, .kind = SupportKind::Clamp},
                      {.at = at, .kind = SupportKind::InclinedRoller, .normal = {0.0, -1.0, 0.0}}};
    const auto holds_of = [&] {
      const EngineBeam beam = beam_of(scene);
      const auto found = std::ranges::find(beam.joints, "support_2", &EngineJoint::name);
      return found == beam.joints.end() ? std::array<bool, 3>{} : found->holds;
    };
    const auto is_left_out = [&] {
      const std::vector<std::string> notes = beam_of(scene).notes;
      return std::ranges::any_of(notes, [](const std::string& note) {
        return note.find("holds along its normal alone") != std::string::npos;
      });
    };
    EXPECT_EQ(holds_of(), (std::array<bool, 3>{false, true, false}));
    EXPECT_FALSE(is_left_out());
    scene.supports[1].normal = {0.6, 0.8, 0.0};
    EXPECT_EQ(holds_of(), (std::array<bool, 3>{}));
    EXPECT_TRUE(is_left_out());
  }
}

TEST(EngineBeam, OfACouponIsRefused) {
  Scene scene = breakable_scene();
  scene.drive.strain = {0.0, 0.01};
  EXPECT_EQ(message_of([&] { beam_of(scene); }),
            "drive.strain: a coupon has no joints: an export needs a beam");
}

TEST(EngineBeam, ThatIsBentAndHeldInPartIsRefused) {
  Scene scene = breakable_scene();
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = 1.0;
  scene.supports.push_back({.at = Place::end(),
                            .kind = SupportKind::Clamp,
                            .hold = HeldFreedoms{true, true, false, true, true, true}});
  EXPECT_EQ(message_of([&] { beam_of(scene); }),
            "support at 1 m: must hold all translations or none where it holds rotation and the "
            "beam's axis does not run along z: an engine's joint has one frame");
}

}  // namespace
}  // namespace plastica::testing
