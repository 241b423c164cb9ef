#include <gtest/gtest.h>

#include <numbers>

#include "plastica/io/scene_file.hpp"
#include "tests/support/message.hpp"

namespace plastica::io {
namespace {

using Vector = std::array<double, 3>;

/// A scene in time that ends after two seconds, with more text at its end.
plastica::Setup read_motion(const std::string& text) {
  const std::string solver = "[solver]\nanalysis = 'dynamics'\nduration = '2 s'\n";
  return parse_scene_file(solver + text, "s.toml").setup;
}

const std::string kVelocity = "[[initial_motion]]\nvelocity = ['0 m/s', '36 km/h', '0 m/s']\n";
const std::string kHeldStart = "[[support]]\nat = 'start'\nkind = 'clamp'\n";
const std::string kGravity = "[gravity]\ny = '-9.81 m/s^2'\nhistory = 'constant'\n";

TEST(SceneInTime, ReadsHowItIsSolved) {
  const SolverOptions solver =
      read_motion(
          "scheme = 'energy_momentum'\ntime_step = '0.5 ms'\nstep_error = 1e-4\n"
          "rho_infinity = 0.5\nrotary_inertia = 'off'\ndamping = 'relaxation'\n"
          "damping_time = '2 ms'\nframes = 12\n" +
          kVelocity)
          .solver;
  EXPECT_EQ(solver.analysis, Analysis::Dynamics);
  EXPECT_EQ(solver.duration, 2.0);
  EXPECT_EQ(solver.scheme, Scheme::EnergyMomentum);
  EXPECT_EQ(solver.time_step, 5e-4);
  EXPECT_EQ(solver.step_error, 1e-4);
  EXPECT_EQ(solver.rho_infinity, 0.5);
  EXPECT_EQ(solver.rotary_inertia, RotaryInertia::Off);
  EXPECT_EQ(solver.damping, Damping::Relaxation);
  EXPECT_EQ(solver.damping_time, 2e-3);
  EXPECT_EQ(solver.frames, 12);
}

TEST(SceneInTime, NeedsNoSupports) {
  const plastica::Setup setup = read_motion(kVelocity);
  EXPECT_TRUE(setup.scene.supports.empty());
  EXPECT_FALSE(setup.scene.is_coupon());
  EXPECT_NO_THROW(read_motion(kGravity));
}

TEST(SceneInTime, ReadsInitialMotions) {
  const auto motions =
      read_motion(kVelocity +
                  "[[initial_motion]]\nfrom = { segment = 2 }\nto = '75 %'\nabout = 'start'\n"
                  "velocity = ['1 m/s', '2 m/s', '3 mm/s']\n"
                  "spin = ['180 deg/s', '0 rad/s', '5 rad/s']\n"
                  "[[initial_motion]]\nspin = ['1 rad/s', '0 rad/s', '0 rad/s']\n")
          .scene.initial_motions;
  ASSERT_EQ(motions.size(), 3U);
  EXPECT_EQ(motions[0].from.fraction, 0.0);
  EXPECT_EQ(motions[0].to.fraction, 1.0);
  EXPECT_DOUBLE_EQ(motions[0].velocity[1], 10.0);
  EXPECT_EQ(motions[0].spin, Vector{});
  EXPECT_EQ(motions[1].from.segment, 2);
  EXPECT_EQ(motions[1].to.fraction, 0.75);
  EXPECT_EQ(motions[1].about.fraction, 0.0);
  EXPECT_EQ(motions[1].velocity, (Vector{1.0, 2.0, 0.003}));
  EXPECT_DOUBLE_EQ(motions[1].spin[0], std::numbers::pi);
  EXPECT_EQ(motions[1].spin[2], 5.0);
  EXPECT_EQ(motions[2].velocity, Vector{});
  EXPECT_EQ(motions[2].about.fraction, 0.5);
}

TEST(SceneInTime, ReadsCutsAndWhatABreakDoes) {
  const Scene scene = read_motion("[rules]\non_break = 'cut_worst'\n" + kHeldStart + kGravity +
                                  "[[cut]]\nat = 0.5\ntime = '250 ms'\n"
                                  "[[cut]]\nat = { segment = 3 }\ntime = '0 s'\n")
                          .scene;
  EXPECT_EQ(scene.on_break, BreakPolicy::CutWorst);
  ASSERT_EQ(scene.cuts.size(), 2U);
  EXPECT_EQ(scene.cuts[0].at.fraction, 0.5);
  EXPECT_EQ(scene.cuts[0].time, 0.25);
  EXPECT_EQ(scene.cuts[1].at.segment, 3);
  EXPECT_EQ(scene.cuts[1].time, 0.0);
}

TEST(SceneInTime, ReadsTheRestitutionOfAPillar) {
  const auto restitution = [](const std::string& value) {
    return read_motion(kGravity +
                       "[[support]]\nat = 'end'\nkind = 'pillar'\nrestitution = " + value)
        .scene.supports.at(0)
        .restitution;
  };
  EXPECT_EQ(restitution("0.25"), 0.25);
  EXPECT_EQ(restitution("'40 %'"), 0.4);
}

TEST(SceneInTime, ReadsProbesOfMotionsAndAllEnergies) {
  const auto probe = [](const std::string& text) {
    return read_motion(kVelocity + "[[probe]]\n" + text + "\n").scene.probes.at(0);
  };
  EXPECT_EQ(probe("kind = 'velocity'").quantity, ProbeQuantity::Velocity);
  EXPECT_EQ(probe("kind = 'velocity'").component, Component::Y);
  EXPECT_EQ(probe("kind = 'velocity'\nat = { segment = 2 }").at.segment, 2);
  EXPECT_EQ(probe("kind = 'spin'").component, Component::X);
  EXPECT_EQ(probe("kind = 'momentum'").component, Component::Y);
  EXPECT_EQ(probe("kind = 'angular_momentum'").component, Component::X);
  EXPECT_EQ(probe("kind = 'momentum'\ncomponent = 'size'").component, Component::Size);
  for (std::size_t i = 0; i < kEnergyKinds.size(); ++i) {
    const std::string word(kEnergyKinds[i]);
    EXPECT_EQ(probe("kind = 'energy'\nenergy = '" + word + "'").energy, static_cast<EnergyKind>(i))
        << word;
  }
}

TEST(SceneInTime, NamesTheLineOfWhatItRefuses) {
  const auto error = [](const std::string& text) {
    return testing::message_of([&] { read_motion(text); });
  };
  EXPECT_EQ(error("[[initial_motion]]\nfrom = 'start'\n"),
            "s.toml:4: initial_motion[1]: needs velocity or spin");
  EXPECT_EQ(error(kVelocity + "about = 'end'\n"),
            "s.toml:6: initial_motion[1].about = end: has no spin to go through it");
  EXPECT_EQ(error(kVelocity + "from = 0.5\nto = 0.25\n"),
            "s.toml:7: initial_motion[1].to = 0.25: must lie beyond from = 0.5");
  EXPECT_EQ(error(kVelocity + "[[cut]]\nat = 0.5\n"), "s.toml:6: cut[1].time: is missing");
  EXPECT_EQ(
      error(kVelocity + "[[cut]]\nat = 'end'\ntime = '1 s'\n"),
      "s.toml:7: cut[1].at = end: is nearest to the beam's end, where no joint is: no support "
      "holds its rotation");
}

}  // namespace
}  // namespace plastica::io
