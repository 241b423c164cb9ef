#include <gtest/gtest.h>

#include <cmath>

#include "calibrate/engine/engine_text.hpp"
#include "calibrate/engine/engine_world.hpp"
#include "tests/calibrate/engine/engine_scenes.hpp"
#include "tests/calibrate/engine/parse_engine_texts.hpp"
#include "tests/support/message.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::testing {
namespace {

using calibrate::engine_text;
using calibrate::EngineBeam;
using calibrate::EngineFormat;
using calibrate::EngineJoint;

void expect_same(double value, double expected, const char* what) {
  if (std::isinf(expected)) {
    EXPECT_EQ(value, expected) << what;
  } else {
    EXPECT_NEAR(value, expected, tolerance(1e-12) * std::fabs(expected)) << what;
  }
}

void expect_same(const std::array<double, 3>& values, const std::array<double, 3>& expected,
                 const char* what) {
  for (std::size_t k = 0; k < 3; ++k) expect_same(values[k], expected[k], what);
}

/// The four numbers that a joint is exported for.
void expect_same_springs(const ParsedJoint& parsed, const EngineJoint& joint) {
  expect_same(parsed.stiffness, joint.stiffness, "stiffness");
  expect_same(parsed.hardened_stiffness, joint.hardened_stiffness, "hardened stiffness");
  expect_same(parsed.yield_moment, joint.yield_moment, "yield moment");
  expect_same(parsed.break_angle, joint.break_angle, "break angle");
}

void expect_same_segments(const ParsedBeam& parsed, const EngineBeam& beam) {
  ASSERT_EQ(parsed.segments.size(), beam.segments.size());
  for (std::size_t i = 0; i < beam.segments.size(); ++i) {
    expect_same(parsed.segments[i].length, beam.segments[i].length, "length");
    expect_same(parsed.segments[i].mass, beam.segments[i].mass, "mass");
    expect_same(parsed.segments[i].inertia, beam.segments[i].inertia, "inertia");
    expect_same(parsed.segments[i].center, beam.segments[i].center(), "center");
  }
}

/// Whose joints all yield and break: formats may leave out what never happens.
const ParsedJoint& joint_of(const ParsedBeam& parsed, const EngineJoint& joint) {
  return parsed.joints.at(joint.name);
}

class EngineFormats : public ::testing::TestWithParam<bool> {
 protected:
  EngineBeam beam() const {
    Scene scene = rich_scene();
    if (!GetParam()) scene.material.hardening = scene.regions[0].material.hardening = {};
    return beam_of(scene);
  }
};

TEST_P(EngineFormats, CsvReadsBack) {
  const EngineBeam beam = this->beam();
  const ParsedBeam parsed = parse_csv(engine_text(beam, EngineFormat::Csv));
  ASSERT_EQ(parsed.joints.size(), beam.joints.size());
  for (const EngineJoint& joint : beam.joints) {
    SCOPED_TRACE(joint.name);
    const ParsedJoint& read = joint_of(parsed, joint);
    expect_same_springs(read, joint);
    expect_same(read.point[2], joint.at, "place");
    expect_same(read.length, joint.length, "length");
    EXPECT_EQ(read.holds, joint.holds);
    EXPECT_EQ(read.half_joint, joint.half_joint);
  }
}

TEST_P(EngineFormats, TablesOfAgxAndChronoReadBack) {
  const EngineBeam beam = this->beam();
  for (const ParsedBeam& parsed : {parse_agx(engine_text(beam, EngineFormat::Agx)),
                                   parse_chrono(engine_text(beam, EngineFormat::Chrono))}) {
    ASSERT_EQ(parsed.joints.size(), beam.joints.size());
    expect_same_segments(parsed, beam);
    for (const EngineJoint& joint : beam.joints) {
      SCOPED_TRACE(joint.name);
      const ParsedJoint& read = joint_of(parsed, joint);
      expect_same_springs(read, joint);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(read.point[k], joint.point[k], 1e-14);
      expect_same(read.length, joint.length, "length");
      EXPECT_EQ(read.holds, joint.holds);
      EXPECT_EQ(read.half_joint, joint.half_joint);
    }
  }
}

TEST_P(EngineFormats, MjcfReadsBack) {
  const EngineBeam beam = this->beam();
  const ParsedBeam parsed = parse_mjcf(engine_text(beam, EngineFormat::Mjcf));
  EXPECT_EQ(parsed.joints.size(), beam.joints.size());
  // Segments, and the bodies of supports: the roller's, then the clamp's.
  ASSERT_EQ(parsed.segments.size(), beam.segments.size() + 2);
  for (const std::size_t i : {0U, 1U}) {
    expect_same(parsed.segments[i].mass, beam.segments[i].mass, "mass");
    expect_same(parsed.segments[i].inertia, beam.segments[i].inertia, "inertia");
    expect_same(parsed.segments[i].center, {0.0, 0.0, 0.125}, "center");
  }
  for (const EngineJoint& joint : beam.joints) {
    SCOPED_TRACE(joint.name);
    if (joint.length == 0.0) continue;  // the roller's body: freedoms without a spring
    expect_same_springs(joint_of(parsed, joint), joint);
    expect_same(joint_of(parsed, joint).length, joint.length, "length");
  }
}

TEST_P(EngineFormats, OpenSeesReadsBack) {
  const EngineBeam beam = this->beam();
  const ParsedBeam parsed = parse_opensees(engine_text(beam, EngineFormat::OpenSees));
  EXPECT_EQ(parsed.joints.size(), beam.joints.size());
  for (const EngineJoint& joint : beam.joints) {
    SCOPED_TRACE(joint.name);
    EXPECT_EQ(joint_of(parsed, joint).half_joint, joint.half_joint);
    if (joint.length > 0.0) expect_same_springs(joint_of(parsed, joint), joint);
  }
}

INSTANTIATE_TEST_SUITE_P(Hardening, EngineFormats, ::testing::Bool(), [](const auto& hardening) {
  return hardening.param ? "linear" : "ideal";
});

TEST(EngineText, HoldsBeamsForBulletAtTheirStartAlone) {
  EXPECT_EQ(message_of([&] { engine_text(beam_of(rich_scene()), EngineFormat::Bullet); }),
            "support_2: is off the beam's start, where the multibody for bullet cannot be held");
  Scene free = rich_scene();
  free.supports.clear();
  EXPECT_EQ(message_of([&] { engine_text(beam_of(free), EngineFormat::Bullet); }),
            "support: is missing: the beam for bullet is a multibody on a fixed base, and nothing "
            "holds this one at its start");
}

TEST(EngineText, SaysTheEquationsInEachFormat) {
  Scene scene = rich_scene();
  scene.name = "a -- b \"<c>\"\nwipe";
  Scene held = scene;
  held.supports.resize(1);
  const EngineBeam beam = beam_of(scene);
  for (const EngineFormat format :
       {EngineFormat::Csv, EngineFormat::Mjcf, EngineFormat::Agx, EngineFormat::Bullet,
        EngineFormat::Chrono, EngineFormat::OpenSees}) {
    const std::string text =
        engine_text(format == EngineFormat::Bullet ? beam_of(held) : beam, format);
    for (const char* line : {"stiffness [N m/rad]: f_x E I_x/l", "between two regions both halves",
                             "c_x sigma_y W_x", "E = 200000000000 Pa", "eps a/(h/2)"}) {
      EXPECT_NE(text.find(line), std::string::npos) << line;
    }
    // A name ends neither a comment nor its line.
    const std::size_t comment = format == EngineFormat::Mjcf ? text.find("<!--") + 4 : 0;
    EXPECT_EQ(text.find("a -- b", comment), std::string::npos);
    EXPECT_EQ(text.find("\nwipe\nmodel") != std::string::npos, format == EngineFormat::OpenSees);
  }
}

/// The world is the user's.
TEST(EngineText, OfAgxLeavesTheGravityOfTheSimulationAlone) {
  const std::string text = engine_text(beam_of(rich_scene()), EngineFormat::Agx);
  EXPECT_EQ(text.find("setUniformGravity"), std::string::npos);
  EXPECT_NE(text.find("\nGRAVITY = (0, -9.81, 0)\n"), std::string::npos);
}

TEST(EngineText, OfMujocoSaysItsStepAndItsDamping) {
  const auto note = [](const Scene& scene, const SolverOptions& options) {
    return calibrate::engine_notes(beam_of(scene, options), EngineFormat::Mjcf).back();
  };
  Scene held = cantilever_scene(2);
  held.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  EXPECT_EQ(note(held, {}),
            "the step is 0.001 s, the scene's; each joint's armature, 0.0005 s times the step and "
            "its stiffness, keeps it stable. The damping of a joint is 0.0001 s times its "
            "stiffness, a tenth of the step, which is numerical");
  const SolverOptions damped{.analysis = Analysis::Dynamics,
                             .duration = 1.0,
                             .time_step = 2e-3,
                             .damping = Damping::Stiffness,
                             .damping_time = 3e-4};
  EXPECT_TRUE(
      note(held, damped).ends_with("The damping of a joint is 0.0003 s times its stiffness"))
      << note(held, damped);
  EXPECT_EQ(calibrate::engine_notes(beam_of(held, damped), EngineFormat::Agx).back(),
            "the damping of the scene's joints, 0.0003 s, is left out");
}

// Its default timestepper counts the damping of a bushing twice.
TEST(EngineText, OfChronoHasHalfOfTheDampingAndSaysThatItWasNotRun) {
  const Scene scene = cantilever_scene(2);
  const SolverOptions damped{.analysis = Analysis::Dynamics,
                             .duration = 1.0,
                             .time_step = 2e-3,
                             .damping = Damping::Stiffness,
                             .damping_time = 3e-4};
  const std::string text = engine_text(beam_of(scene, damped), EngineFormat::Chrono);
  const ParsedBeam parsed = parse_chrono(text);
  for (const EngineJoint& joint : beam_of(scene).joints) {
    const ParsedJoint& read = joint_of(parsed, joint);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(read.damping[k], 1.5e-4 * joint.stiffness[k], 1e-12 * joint.stiffness[k]);
    }
  }
  EXPECT_NE(text.find("\nconstexpr double kTimeStep = 0.002;\n"), std::string::npos);
  EXPECT_NE(text.find("EULER_IMPLICIT_LINEARIZED"), std::string::npos);
  EXPECT_EQ(calibrate::engine_notes(beam_of(scene, damped), EngineFormat::Chrono).back(),
            "the step is 0.002 s, the scene's; advice for chrono, which finds one for an error, is "
            "by Chrono's published rule and was not verified in Chrono itself");
  for (const auto& joint : parse_chrono(engine_text(beam_of(scene), EngineFormat::Chrono)).joints) {
    EXPECT_EQ(joint.second.damping, (std::array<double, 3>{}));
  }
}

TEST(EngineText, HasTheDigitsThatWereMeant) {
  Scene scene = cantilever_scene(20);  // sums and products leave 0.049999999999999996
  const std::string text = engine_text(beam_of(scene), EngineFormat::Mjcf);
  EXPECT_EQ(text.find("9999999"), std::string::npos);
  EXPECT_EQ(text.find("0000000001"), std::string::npos);
  EXPECT_NE(text.find("<numeric name=\"joint_5_tributary_length\" data=\"0.05\"/>"),
            std::string::npos);
}

TEST(EngineText, OfMujocoHasItsNameEscaped) {
  Scene scene = cantilever_scene(2);
  scene.name = "a \"b\" & <c>";
  EXPECT_TRUE(engine_text(beam_of(scene), EngineFormat::Mjcf)
                  .starts_with("<mujoco model=\"a &quot;b&quot; &amp; &lt;c&gt;\">"));
}

TEST(EngineWorld, RefusesWhatCannotBe) {
  calibrate::EngineBeam beam = beam_of(cantilever_scene(2));
  EXPECT_EQ(message_of([&] { calibrate::put_into({.gravity = -1.0}, beam); }),
            "--gravity = -1: must not be negative");
  EXPECT_EQ(message_of([&] { calibrate::put_into({.damping_time = -1.0}, beam); }),
            "--damping = -1: must not be negative");
  beam.gravity = {0.0, -9.0, 1.0};
  EXPECT_EQ(
      message_of([&] { calibrate::put_into({.up = "z"}, beam); }),
      "--up: needs a scene whose gravity is along x, y or z: what is up in this one is no axis");
}

TEST(EngineText, OfAnElasticBeamHasNoYielding) {
  const EngineBeam beam = beam_of(cantilever_scene(2));
  EXPECT_EQ(engine_text(beam, EngineFormat::Mjcf).find("<numeric name=\"joint_0_x"),
            std::string::npos);
  const ParsedBeam parsed = parse_opensees(engine_text(beam, EngineFormat::OpenSees));
  expect_same(parsed.joints.at("joint_1").stiffness, beam.joints[1].stiffness, "stiffness");
  expect_same_springs(parse_csv(engine_text(beam, EngineFormat::Csv)).joints.at("joint_1"),
                      beam.joints[1]);
}

}  // namespace
}  // namespace plastica::testing
