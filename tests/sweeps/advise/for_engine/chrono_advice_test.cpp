#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sweeps/advise/for_engine/engine_advice_json.hpp"
#include "sweeps/advise/for_engine/engine_advice_text.hpp"
#include "sweeps/advise/for_engine/engine_chain.hpp"
#include "sweeps/advise/for_engine/engine_loads.hpp"
#include "tests/sweeps/advise/for_engine/engine_advice_scenes.hpp"
#include "tests/sweeps/advise/for_engine/engine_truth.hpp"

/// Chrono is not installed: its advice is held against our own finest runs by a run of its
/// published rule, not of Chrono. What is told is the error of the advice, not of the rule.
namespace plastica::testing {
namespace {

/// The run of an advised beam by the rule.
Histories run_by_rule_of_chrono(const plastica::Setup& setup, const sweeps::EngineAdvice& advice) {
  const auto chain = sweeps::engine_chain(*advice.engine, advice.beam, {true, true, true});
  const sweeps::EngineLoads loads(setup.scene, advice.beam);
  Histories histories(setup.scene.probes.size());
  const auto record = [&] {
    for (std::size_t k = 0; k < histories.size(); ++k) {
      histories[k].push_back(loads.observe(*chain, setup.scene.probes[k]));
    }
  };
  record();
  std::vector<sweeps::SegmentWrench> wrenches;
  for (int step = 1; step <= setup.solver.steps * advice.setting.steps; ++step) {
    const double time = advice.time_step * (step - 1);
    const Vec<double, 3> turned = loads.ground_rotation(time);
    for (std::size_t k = 0; k < 3; ++k) chain->set_rest(k, turned[k]);
    loads.gather(*chain, time, wrenches);
    EXPECT_TRUE(chain->step(loads.gravity(time), wrenches));
    if (step % advice.setting.steps == 0) record();
  }
  return histories;
}

void expect_within_by_rule(const std::string& text, const std::vector<double>& errors) {
  expect_within("chrono", text, errors, run_by_rule_of_chrono);
}

TEST(ChronoAdvice, HoldsByItsRuleForAStripThatIsLetGo) {
  expect_within_by_rule(released_strip(), {0.05, 0.02});
}

TEST(ChronoAdvice, HoldsByItsRuleForTheRobotsArmWhoseClampTurns) {
  expect_within_by_rule(robot_arm(), {0.05, 0.02, 0.01});
}

TEST(ChronoAdvice, HoldsByItsRuleInSpace) { expect_within_by_rule(biaxial_bar(), {0.05, 0.02}); }

// Implicit dampers: as much of them as for MuJoCo.
TEST(ChronoAdvice, HoldsByItsRuleForADampedBarWithAMassAtItsEnd) {
  expect_within_by_rule(damped_arm(), {0.05, 0.02});
}

TEST(ChronoAdvice, SaysThatChronoWasNotRun) {
  sweeps::AdviceOptions options;
  options.within = 0.05;
  const plastica::Setup setup = io::parse_scene_file(damped_arm(), "scene.toml").setup;
  const sweeps::EngineAdvice advice =
      sweeps::advise_for_engine(*sweeps::advised_engine("chrono"), setup, options);
  const std::string text = sweeps::engine_advice_text(advice, options, "arm.toml");
  for (const char* words :
       {"arm.toml for chrono, within 5 %:\n", "which was not verified in Chrono itself\n",
        " by Chrono's rule\n", "N m s/rad, half of the scene's: Chrono's rule counts it twice\n",
        "AccumulateForce"}) {
    EXPECT_NE(text.find(words), std::string::npos) << words << '\n' << text;
  }
  EXPECT_EQ(text.find("armature"), std::string::npos) << text;
  const std::string json = sweeps::engine_advice_json(advice, options, "");
  for (const char* words : {"\"engine\": \"chrono\"", "\"rule_held_against\": null",
                            "which was not verified in Chrono itself"}) {
    EXPECT_NE(json.find(words), std::string::npos) << words << '\n' << json;
  }
}

}  // namespace
}  // namespace plastica::testing
