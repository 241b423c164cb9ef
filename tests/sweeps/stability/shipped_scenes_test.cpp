#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "plastica/io/scene_file.hpp"
#include "plastica/run/simulate.hpp"
#include "sweeps/stability/verdict.hpp"

/// The audits of the shipped scenes: none of them has an undetected error.
namespace plastica::sweeps::stability {
namespace {

const std::filesystem::path kScenes = std::string(PLASTICA_SOURCE_DIR) + "/data/scenes";

plastica::Setup shipped(const std::string& name) {
  return io::read_scene_file((kScenes / (name + ".toml")).string()).setup;
}

class ShippedSceneAudit : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedSceneAudit, FindsNoUndetectedError) {
  const plastica::Setup setup = shipped(GetParam());
  const Response response = simulate(setup.scene, setup.solver);
  const Verdict verdict = judge(setup, response, {.may_reverse = true});
  EXPECT_NE(verdict.validity, Validity::Undetected) << verdict.reason;
}

std::vector<std::string> scenes_of_beams() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kScenes)) {
    if (entry.path().extension() != ".toml") continue;
    const std::string name = entry.path().stem().string();
    if (!shipped(name).scene.is_coupon()) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedSceneAudit, ::testing::ValuesIn(scenes_of_beams()),
                         [](const auto& scene) { return scene.param; });

TEST(Audit, SeesAMomentThatTheWeightOfABodyDoesNotMake) {
  const plastica::Setup setup = shipped("tip_mass");
  const Response response = simulate(setup.scene, setup.solver);
  ASSERT_EQ(judge(setup, response, {}).validity, Validity::Valid);
  plastica::Setup lighter = setup;
  lighter.scene.masses[0].mass *= 0.999;
  EXPECT_EQ(judge(lighter, response, {}).validity, Validity::Undetected);
}

}  // namespace
}  // namespace plastica::sweeps::stability
