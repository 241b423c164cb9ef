#include "tests/cli/bad_input.hpp"

namespace plastica::testing {
namespace {

constexpr const char* kMotionScene =
    "[beam]\n"                                                                // 1
    "length = '4 m'\n"                                                        // 2
    "segments = 8\n"                                                          // 3
    "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"  // 4
    "[solver]\n"                                                              // 5
    "analysis = 'dynamics'\n"                                                 // 6
    "duration = '2 s'\n"                                                      // 7
    "damping = 'stiffness'\n"                                                 // 8
    "damping_time = '1 ms'\n"                                                 // 9
    "[[initial_motion]]\n"                                                    // 10
    "from = 'start'\n"                                                        // 11
    "to = { segment = 4 }\n"                                                  // 12
    "velocity = ['0 m/s', '10 m/s', '0 m/s']\n"                               // 13
    "spin = ['1 rad/s', '0 rad/s', '0 rad/s']\n"                              // 14
    "about = 0.5\n"                                                           // 15
    "[[cut]]\n"                                                               // 16
    "at = 0.5\n"                                                              // 17
    "time = '1 s'\n"                                                          // 18
    "[[support]]\n"                                                           // 19
    "at = 'end'\n"                                                            // 20
    "kind = 'pillar'\n"                                                       // 21
    "restitution = 0.5\n"                                                     // 22
    "[[probe]]\n"                                                             // 23
    "kind = 'momentum'\n"                                                     // 24
    "[[probe]]\n"                                                             // 25
    "kind = 'energy'\n"                                                       // 26
    "energy = 'kinetic'\n";                                                   // 27

/// The scene with one piece changed, and the line that `simulate` answers with behind the file.
BadInput motion_change(std::string name, const std::string& from, const std::string& to,
                       const std::string& line) {
  return bad_scene(std::move(name), changed(kMotionScene, from, to), line);
}

/// A cantilever at rest with some of a motion from line 5 on.
BadInput at_rest(std::string name, const std::string& lines, std::string line) {
  const std::string text = kMotionScene;
  return {std::move(name),
          {{"scene.toml", text.substr(0, text.find("[solver]")) + lines +
                              "[[support]]\nat = 'start'\nkind = 'clamp'\n"
                              "[[load]]\nat = 'end'\nforce = ['0 N', '1 N', '0 N']\n"}},
          {"simulate", "scene.toml", "-o", "out.csv"},
          "scene.toml:" + std::move(line) + ": needs solver.analysis = \"dynamics\""};
}

class BadMotionScene : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadMotionScene, IsRefusedInOneLine) { expect_refusal(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Solver, BadMotionScene,
    ::testing::Values(
        motion_change("UnknownAnalysis", "'dynamics'", "'kinematics'",
                      "6: solver.analysis = kinematics: must be one of statics, dynamics"),
        motion_change(
            "UnknownScheme", "duration", "scheme = 'verlet'\nduration",
            "7: solver.scheme = verlet: must be one of linearly_implicit_euler, "
            "linearly_implicit_midpoint, generalized_alpha, energy_momentum, articulated_euler, "
            "articulated_midpoint"),
        motion_change("StepOfZero", "duration", "time_step = '0 s'\nduration",
                      "7: solver.time_step = 0 s: must be above 0 s"),
        motion_change("StepWithoutUnit", "duration", "time_step = 0.001\nduration",
                      "7: solver.time_step = 0.001: a time needs a unit (examples: s, min, h)"),
        motion_change("NegativeStepError", "duration", "step_error = -1\nduration",
                      "7: solver.step_error = -1: must be at least 0"),
        motion_change("RadiusAboveOne", "duration", "rho_infinity = 1.5\nduration",
                      "7: solver.rho_infinity = 1.5: must be from 0 to 1"),
        motion_change("UnknownRotaryInertia", "duration", "rotary_inertia = 'yes'\nduration",
                      "7: solver.rotary_inertia = yes: must be one of off, on"),
        motion_change("NegativeFrames", "duration", "frames = -1\nduration",
                      "7: solver.frames = -1: must be from 0 to 1e+07"),
        motion_change("HalfAFrame", "duration", "frames = 0.5\nduration",
                      "7: solver.frames = 0.5: must be an integer"),
        motion_change("UnknownDamping", "'stiffness'", "'viscous'",
                      "8: solver.damping = viscous: must be one of none, stiffness, relaxation"),
        motion_change("DampingWithoutTime", "damping_time = '1 ms'\n", "",
                      "5: solver.damping_time = 0: must be above 0 s with solver.damping"),
        motion_change(
            "DampingTimeWithoutDamping", "damping = 'stiffness'\n", "",
            "8: solver.damping_time = 0.001: is of no use with solver.damping = \"none\""),
        motion_change(
            "ArcLength", "duration", "control = 'arc_length'\nduration",
            "7: solver.control = arc_length: must be auto or load in dynamics, where time goes "
            "on by itself"),
        motion_change("WatchedPoint", "duration", "control_at = 'end'\nduration",
                      "7: solver.control_at = end: is of no use in dynamics"),
        motion_change(
            "NoEnd", "duration = '2 s'\n", "",
            "5: solver.duration = 0: must be above 0 where no history says when the motion "
            "ends")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    InitialMotion, BadMotionScene,
    ::testing::Values(
        motion_change("OfNothing",
                      "velocity = ['0 m/s', '10 m/s', '0 m/s']\n"
                      "spin = ['1 rad/s', '0 rad/s', '0 rad/s']\n",
                      "", "10: initial_motion[1]: needs velocity or spin"),
        motion_change("AboutAPointWithoutSpin", "spin = ['1 rad/s', '0 rad/s', '0 rad/s']\n", "",
                      "14: initial_motion[1].about = 0.5: has no spin to go through it"),
        motion_change("ThatRunsBack", "'start'", "0.75",
                      "12: initial_motion[1].to = { segment = 4 }: must lie beyond from = 0.75"),
        motion_change(
            "OfNoSegment", "to = { segment = 4 }", "to = 0.05",
            "12: initial_motion[1].to = 0.05: leaves no segment's middle between from = start "
            "and itself, so nothing would move"),
        motion_change(
            "OffTheBeam", "to = { segment = 4 }", "to = { segment = 9 }",
            "12: initial_motion[1].to = { segment = 9 }: must be a segment from 1 to 8, or 0 for "
            "the start"),
        motion_change("ToAWholeNumber", "to = { segment = 4 }", "to = 4",
                      "12: initial_motion[1].to = 4: is neither a segment nor a fraction: write "
                      "{ segment = 4 } for the outer end of that segment, …"),
        motion_change(
            "AboutAPointOffTheBeam", "about = 0.5", "about = 1.5",
            "15: initial_motion[1].about = 1.5: must be a fraction of the length, 0 to 1"),
        motion_change("InOneNumber", "['0 m/s', '10 m/s', '0 m/s']", "'10 m/s'",
                      "13: initial_motion[1].velocity = '10 m/s': must be a list in brackets"),
        motion_change("InMetres", "'10 m/s'", "'10 m'",
                      "13: initial_motion[1].velocity[2] = 10 m: \"m\" is not a unit of velocity "
                      "(examples: m/s, km/h)"),
        motion_change(
            "SpinWithoutUnit", "'1 rad/s'", "1",
            "14: initial_motion[1].spin[1] = 1: an angular velocity needs a unit (examples: "
            "rad/s, deg/s)"),
        motion_change(
            "InTurns", "'1 rad/s'", "'1 1/min/s'",
            "14: initial_motion[1].spin[1] = 1 1/min/s: \"1/min/s\" is not a unit of angular "
            "velocity (examples: rad/s, deg/s)"),
        motion_change(
            "OfUnknownKey", "about", "around",
            "15: initial_motion[1].around = 0.5: is not a key of initial_motion[1]; did you "
            "mean about?"),
        motion_change(
            "OfATwist", "duration", "level = 'twist'\nduration",
            "7: solver.level = twist: initial_motion[1].velocity has a component along y, and "
            "twist is about the beam's axis z alone")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Cut, BadMotionScene,
    ::testing::Values(
        motion_change("Nowhere", "at = 0.5\n", "", "16: cut[1].at: is missing"),
        motion_change("AtNoTime", "time = '1 s'\n", "", "16: cut[1].time: is missing"),
        motion_change("BeforeTheStart", "'1 s'", "'-1 s'",
                      "18: cut[1].time = -1: must be finite and not negative"),
        motion_change("InMetres", "'1 s'", "'1 m'",
                      "18: cut[1].time = 1 m: \"m\" is not a unit of time (examples: s, min, h)"),
        motion_change("OffTheBeam", "at = 0.5\n", "at = -0.5\n",
                      "17: cut[1].at = -0.5: must be a fraction of the length, 0 to 1"),
        motion_change(
            "OfAFreeEnd", "at = 0.5\n", "at = 'start'\n",
            "17: cut[1].at = start: is nearest to the beam's start, where no joint is: no "
            "support holds its rotation"),
        motion_change(
            "OfTheSameJoint", "[[support]]",
            "[[cut]]\nat = { segment = 4 }\ntime = '2 s'\n[[support]]",
            "20: cut[2].at = { segment = 4 }: cut[1] cuts the nearest joint, that at segment "
            "end 4, too")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Support, BadMotionScene,
    ::testing::Values(
        motion_change("ThatGivesBackMore", "= 0.5\n[[probe]]", "= 1.5\n[[probe]]",
                      "22: support[1].restitution = 1.5: must be from 0 to 1"),
        motion_change("ThatGivesBackWithoutPushing", "'pillar'", "'roller'",
                      "22: support[1].restitution = 0.5: belongs to kind = \"pillar\""),
        motion_change(
            "ThatJumps", "'pillar'\nrestitution = 0.5\n",
            "'roller'\ntranslation = ['0 m', '1 m', '0 m']\nhistory = 'constant'\n",
            "23: support[1].history = 1: is the factor at time 0 and must be 0 in dynamics: "
            "what a support holds cannot jump")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Probe, BadMotionScene,
    ::testing::Values(
        motion_change("OfTheWholeBeamAtAPlace", "'momentum'", "'momentum'\nat = 'end'",
                      "25: probe[1].at = end: is of no use: momentum is the whole beam's"),
        motion_change("OfUnknownEnergy", "'kinetic'", "'thermal'",
                      "27: probe[2].energy = 'thermal': must be one of \"elastic\", "
                      "\"plastic\", \"external\", \"residual\", \"kinetic\", …")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    AtRest, BadMotionScene,
    ::testing::Values(
        at_rest("WithAnInitialMotion",
                "[[initial_motion]]\nvelocity = ['0 m/s', '1 m/s', '0 m/s']\n",
                "5: initial_motion[1]"),
        at_rest("WithACut", "[[cut]]\nat = 0.5\ntime = '1 s'\n", "5: cut[1]"),
        at_rest("WithRestitution", "[[support]]\nat = 'end'\nkind = 'pillar'\nrestitution = 0.5\n",
                "8: support[1].restitution = 0.5"),
        at_rest("WithDamping", "[solver]\ndamping = 'relaxation'\ndamping_time = '1 s'\n",
                "6: solver.damping = relaxation"),
        at_rest("WithAVelocity", "[[probe]]\nkind = 'velocity'\nat = 'end'\n",
                "6: probe[1].kind = velocity"),
        at_rest("WithAMomentum", "[[probe]]\nkind = 'momentum'\n", "6: probe[1].kind = momentum"),
        at_rest("WithAKineticEnergy", "[[probe]]\nkind = 'energy'\nenergy = 'kinetic'\n",
                "7: probe[1].energy = kinetic")),
    name_of_case);

TEST(BadMotionScenes, AreCouponsInTime) {
  expect_refusal(
      {"",
       {{"scene.toml", "[drive]\nstrain = [0, '1 %']\n[solver]\nanalysis = 'dynamics'\n"}},
       {"simulate", "scene.toml"},
       "scene.toml:4: solver.analysis = dynamics: must be statics in a scene with a "
       "drive, which is at rest at each strain"});
  expect_refusal({"",
                  {{"scene.toml", "[drive]\nstrain = [0, '1 %']\n[[cut]]\nat = 3\n"}},
                  {"simulate", "scene.toml"},
                  "scene.toml:3: cut: does not go with [drive]: a scene is a chain with supports "
                  "and loads, or a coupon with a drive"});
}

TEST(BadMotionScenes, HaveNothingThatMoves) {
  expect_refusal({"",
                  {{"scene.toml",
                    "[solver]\nanalysis = 'dynamics'\nduration = '1 s'\n"
                    "[[support]]\nat = 'start'\nkind = 'clamp'\n"}},
                  {"simulate", "scene.toml"},
                  "scene.toml: load: is missing, and nothing else moves the beam: give a [[load]], "
                  "an [[initial_motion]], gravity, or a support's translation or rotation"});
}

}  // namespace
}  // namespace plastica::testing
