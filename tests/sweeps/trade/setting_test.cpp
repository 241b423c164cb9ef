#include "sweeps/trade/setting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "plastica/io/scene_file.hpp"
#include "sweeps/run/sweep_run.hpp"
#include "sweeps/trade/recommend_text.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"
#include "tests/sweeps/sweep_text.hpp"

namespace plastica::sweeps {
namespace {

SweepRecord record_of(const std::string& text) {
  const Sweep sweep = cantilever_sweep(text);
  SweepRun run(sweep, {});
  auto results = run.run();
  return make_record(sweep, run.cases(), run.ids(), std::move(results));
}

plastica::Setup setup_with(const SweepRecord& record, std::size_t index) {
  return io::parse_scene_file(scene_with_setting(record, index), "scene").setup;
}

const std::string kSegments = segments_axis("[4, 8, 16]");

TEST(PromisedPoints, HaveGroupsAndLeaveOutWhatFailed) {
  const SweepRecord record =
      record_of("[set]\nsolver.steps = 1\nsolver.smallest_step = 1\n" + kSegments +
                "[[axis]]\nfield = 'solver.max_iterations'\nvalues = [1, 25]\n" + kTipError);
  const auto points = promised_points(record, CostKind::Work);
  ASSERT_EQ(points.size(), 6U);
  EXPECT_TRUE(std::isnan(points[0].error));  // one iteration is not enough
  EXPECT_GT(points[1].error, points[3].error);
  EXPECT_EQ(points[1].cost, static_cast<double>(record.results[1].segment_iterations()));
  EXPECT_EQ(points[1].group, points[5].group);
  EXPECT_NE(points[0].group, points[1].group);
  EXPECT_EQ(points[5].sizes, std::vector{1.0 / 16});
}

TEST(CheckSettings, RefusesOtherProblemsOfTheScene) {
  const SweepRecord record = record_of(
      kSegments + "[[axis]]\nfield = 'beam.length'\nvalues = ['2 m', '4 m']\n" + kTipError);
  EXPECT_EQ(plastica::testing::message_of([&] { check_settings(record); }),
            "beam.length = 2 values: makes other problems of the scene: a recommendation is for "
            "one; fix it by [set] in the sweep");
  EXPECT_NO_THROW(check_settings(record_of(kSegments + kTipError)));
}

TEST(SceneWithSetting, HasTheValuesOfTheCase) {
  const SweepRecord record =
      record_of("[set]\nsolver.tolerance = 1e-8\n" + kSegments +
                "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half_joint', 'equal']\n"
                "[[axis]]\nfield = 'beam.slenderness'\nvalues = [100]\n" +
                kTipError);
  const plastica::Setup setup = setup_with(record, 3);
  EXPECT_EQ(setup.scene.beam.segments, 8);
  EXPECT_EQ(setup.scene.end_rule, EndRule::Equal);
  EXPECT_EQ(setup.solver.tolerance, 1e-8);
  EXPECT_DOUBLE_EQ(setup.scene.beam.length, 2.0);
}

TEST(SceneWithSetting, KeepsTheRestOfTheFile) {
  const SweepRecord record = record_of(segments_axis("[4, 32]") + kTipError);
  EXPECT_EQ(scene_with_setting(record, 1), record.inputs[1].text);
}

TEST(SceneWithSetting, ChangesValuesOfNamedMaterialsAndInlineSections) {
  const SweepRecord record = record_of(
      "[[axis]]\nfield = 'material.yield_stress'\nvalues = ['300 MPa']\n"
      "[[axis]]\nfield = 'section.height'\nvalues = ['25 mm']\n"
      "[[axis]]\nfield = 'rules.hinge_length'\nvalues = ['unset']\n" +
      kTipError);
  const plastica::Setup setup = setup_with(record, 0);
  EXPECT_DOUBLE_EQ(setup.scene.material.yield_stress, 300e6);
  EXPECT_EQ(setup.scene.material.name, "S355");
  EXPECT_DOUBLE_EQ(setup.scene.section.height, 0.025);
}

// A history that is a table beside the scene is that table from the output's folder, too.
TEST(SceneWithSetting, NamesTablesFromTheOutputsFolder) {
  const io::ScratchFolder folder;
  std::filesystem::create_directory(folder.file("sub"));
  folder.write("record.csv", "t [s],a [1]\n0,0\n1,1\n");
  folder.write("sub/record.csv", "t [s],a [1]\n0,0\n1,2\n");
  SweepRecord record = record_of(kSegments + kTipError);
  std::string& scene = record.inputs[1].text;
  const std::string table = "history = { table = 'record.csv', time = 't', factor = 'a' }";
  scene.insert(scene.find("[[load]]") + std::string("[[load]]").size(), "\n" + table);
  scene.erase(scene.find("history = \"ramp\""), std::string("history = \"ramp\"").size());
  const std::string beside = folder.file("");
  const std::string output = folder.file("sub/best.toml");
  const std::string text = scene_with_setting(record, 1, beside, output);
  EXPECT_NE(text.find("table = \"../record.csv\""), std::string::npos) << text;
  const History history = io::parse_scene_file(text, output).setup.scene.loads[0].history;
  EXPECT_EQ(history.at(1.0), 1.0);
  EXPECT_EQ(scene_with_setting(record, 1, beside, folder.file("best.toml")).find("../"),
            std::string::npos);
}

TEST(SceneWithSetting, TakesANamedMaterial) {
  const SweepRecord record =
      record_of("[[axis]]\nfield = 'material.name'\nvalues = ['6061-T6']\n" + kTipError);
  EXPECT_EQ(setup_with(record, 0).scene.material.name, "6061-T6");
}

TEST(SceneWithSetting, RefusesWhatNoFileCanSay) {
  const SweepRecord record =
      record_of("[[axis]]\nfield = 'scale.loads'\nvalues = [2]\n" + kTipError);
  EXPECT_EQ(plastica::testing::message_of([&] { scene_with_setting(record, 0); }),
            "scale.loads = 2: cannot be written into the scene's file: do it by hand");
}

TEST(RecommendationText, NamesTheChoiceAndTheNextCheaper) {
  const SweepRecord record = record_of(kSegments + kTipError);
  const auto points = promised_points(record, CostKind::Work);
  const Wish wish{.within = 0.01};
  const std::string text =
      recommendation_text(record, CostKind::Work, wish, recommend_for_error(points, 0.01));
  EXPECT_NE(text.find("cheapest within 1 %: beam.segments = 8\n"), std::string::npos) << text;
  EXPECT_NE(text.find("next cheaper, not within: beam.segments = 4\n"), std::string::npos) << text;
  const std::string none = recommendation_text(record, CostKind::Work, {.within = 1e-9},
                                               recommend_for_error(points, 1e-9));
  EXPECT_NE(none.find("nothing within 1e-07 %; the nearest is\n  beam.segments = 16"),
            std::string::npos)
      << none;
}

}  // namespace
}  // namespace plastica::sweeps
