#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "plastica/io/scene_file.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/message.hpp"

namespace plastica::io {
namespace {

const std::string kHeld = "[[support]]\nat = 'start'\nkind = 'clamp'\n";
const std::string kPushed = "[[load]]\nat = 'end'\nforce = ['0 N', '-100 N', '0 N']\n";

plastica::Setup setup_of(const std::string& text) { return parse_scene_file(text, "s.toml").setup; }

/// A cantilever that is taken along by its end, to a closed form: P = 3 EI w/L^3, less what a chain
/// of N segments is stiffer by, 1/(2 N^2).
TEST(DisplacementControl, TakesAPointAlong) {
  const plastica::Setup setup = setup_of(
      "beam.segments = 40\nsolver.control = 'displacement'\n"
      "solver.control_motion = ['0 m', '-0.1 mm', '0 m']\n" +
      kHeld + kPushed + "[[probe]]\nkind = 'displacement'\n");
  const plastica::Response response = simulate(setup.scene, setup.solver);
  ASSERT_EQ(response.status, Status::Completed);
  EXPECT_NEAR(response.probes[0].at(response.samples - 1), -1e-4, 1e-12);
  const double force = 100.0 * response.chain.factor.at(response.samples - 1);
  const double exact = 3.0 * testing::bending_stiffness_of(setup.scene) * 1e-4 /
                       std::pow(setup.scene.beam.length, 3);
  EXPECT_NEAR(force / exact, 1.0, 1e-3);
}

TEST(DisplacementControl, NeedsToKnowHowFar) {
  const auto error = [](const std::string& text, const std::string& load = kPushed) {
    return testing::message_of([&] { setup_of(text + kHeld + load); });
  };
  EXPECT_EQ(error("solver.control = 'displacement'\n"),
            "s.toml:1: solver.control_motion: is needed: how far displacement control takes the "
            "point that it watches");
  EXPECT_EQ(error("solver.control = 'displacement'\n"
                  "solver.control_motion = ['0 m', '0 m', '0 m']\n"),
            "s.toml:2: solver.control_motion: is needed: how far displacement control takes the "
            "point that it watches");
  EXPECT_EQ(error("solver.control_motion = ['0 m', '1 mm', '0 m']\n"),
            "s.toml:1: solver.control_motion = ['0 m', '1 mm', '0 m']: goes with control = "
            "\"displacement\" alone");
  EXPECT_EQ(error("solver.control = 'displacement'\n"
                  "solver.control_motion = ['0 m', '1 mm', '0 m']\n",
                  "[[load]]\nat = 'end'\nmoment = ['0 N m', '0 N m', '1 N m']\n"),
            "s.toml:1: solver.control = displacement: takes a point along: a beam that is twisted "
            "alone follows \"arc_length\"");
}

}  // namespace
}  // namespace plastica::io
