#include "sweeps/advise/advice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "plastica/io/scene_file.hpp"
#include "sweeps/advise/advice_text.hpp"
#include "sweeps/advise/watched_probes.hpp"
#include "tests/support/message.hpp"

namespace plastica::sweeps {
namespace {

using testing::message_of;

Setup shipped(const std::string& name) {
  return io::read_scene_file(std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/" + name + ".toml")
      .setup;
}

AdviceOptions asked(double within) {
  AdviceOptions options;
  options.within = within;
  return options;
}

/// A steel cantilever, 1 m long, with a tip force that hardly bends it.
Setup cantilever() {
  return io::parse_scene_file(R"(
material = "S355"
[beam]
length = "1 m"
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
segments = 16
[rules]
yield_model = "elastic"
[solver]
steps = 1
[[support]]
at = "start"
kind = "clamp"
[[load]]
at = "end"
force = ["0 N", "-1 N", "0 N"]
[[probe]]
name = "tip"
kind = "displacement"
at = "end"
component = "y"
)",
                              "cantilever.toml")
      .setup;
}

double tip_of(const Setup& setup, const Advice& advice) {
  const plastica::Setup at = setup_at(setup, advice.axes, advice.setting);
  return simulate(at.scene, at.solver).probes[0].back();
}

TEST(Advice, IsWithinWhatWasAskedOfTheClosedForm) {
  const plastica::Setup setup = cantilever();
  const double exact =
      -1.0 / (3.0 * setup.scene.material.youngs_modulus * std::pow(0.02, 4.0) / 12.0);
  for (const double within : {0.05, 0.01, 0.002, 1e-4}) {
    const Advice advice = advise(setup, asked(within));
    ASSERT_EQ(advice.end, AdviceEnd::Found) << within;
    const double error = std::abs(tip_of(setup, advice) / exact - 1.0);
    EXPECT_LE(error, advice.promised) << within;
    EXPECT_LE(advice.promised, within);
    // The cheapest by the law 1/(4 N^2) of this beam takes sqrt(1/(4 within)) segments.
    EXPECT_LE(advice.setting[0], std::max(4.0, 2.5 * std::sqrt(0.25 / within))) << within;
  }
}

TEST(Advice, LooksAtBucklingLoadsOfAColumnThatDoesNotMove) {
  // Euler's factors 2 and 8 in the plane of least stiffness, see the scene.
  const plastica::Setup setup = shipped("column");
  const Advice advice = advise(setup, asked(0.01));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  EXPECT_GT(advice.setting[0], 4.0);
  const plastica::Setup at = setup_at(setup, advice.axes, advice.setting);
  const Response response = simulate(at.scene, at.solver);
  ASSERT_TRUE(response.buckling.has_value());
  EXPECT_NEAR(response.buckling->factor[0], 2.0, 0.01 * 2.0);
}

TEST(Advice, OfTheRobotsArmHoldsAgainstARunThatIsFinestInBoth) {
  const plastica::Setup setup = shipped("robot_arm");
  const Advice advice = advise(setup, asked(0.03));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  Setting finest = advice.setting;
  for (std::size_t k = 0; k < 2; ++k) finest[k] = advice.axes[k].scaled(finest[k], 0.25);
  const auto watched = watched_probes(setup, {}).watched;
  const auto run = [&](const Setting& setting) {
    const plastica::Setup at = setup_at(setup, advice.axes, setting);
    return outcome_of(run_case({"arm", at.scene, at.solver}), watched);
  };
  EXPECT_LE(deviation(run(advice.setting), run(finest), watched).largest, advice.promised);
}

TEST(Advice, SaysWhereItFindsNothing) {
  // The force of an impact has no limit that refinement comes to.
  AdviceOptions options = asked(0.001);
  options.max_work = 2e5;
  const Advice advice = advise(shipped("crash_bumper"), options);
  EXPECT_EQ(advice.end, AdviceEnd::TooMuchWork);
  EXPECT_NE(advice_text(advice, options, "crash_bumper.toml").find("nothing within 0.1 %"),
            std::string::npos);
}

TEST(Advice, PromisesNothingAtTheFinestThereIs) {
  // 20 000 segments are 1/(4 N^2) = 6e-10 off, and none are finer.
  EXPECT_EQ(advise(cantilever(), asked(1e-11)).end, AdviceEnd::AtFinest);
}

TEST(Advice, RefusesWhatItCannotLookAt) {
  plastica::Setup setup = cantilever();
  EXPECT_EQ(message_of([&] { advise(setup, {.within = 0.01, .probes = {"top"}}); }),
            "--of = top: is no probe of the scene");
  setup.scene.probes[0].component = Component::X;
  EXPECT_EQ(message_of([&] { advise(setup, asked(0.01)); }),
            "probe: stays within rounding, whatever is probed: advice needs a probe of something "
            "that moves");
  setup.scene.probes[0].quantity = ProbeQuantity::LoadFactor;
  EXPECT_EQ(message_of([&] { advise(setup, asked(0.01)); }),
            "probe: is missing: advice needs one to look at");
}

}  // namespace
}  // namespace plastica::sweeps
