#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "calibrate/report/plot.hpp"
#include "tests/calibrate/report/records.hpp"
#include "tests/calibrate/report/scene_records.hpp"
#include "tests/support/has.hpp"
#include "tests/support/message.hpp"

/// Pictures of files that compare laws.
namespace plastica::calibrate {
namespace {

using plastica::testing::has;

using plastica::testing::message_of;
using testing::fitted_record;
using testing::scene_record;

std::vector<FitRecord> two_laws() {
  std::vector<FitRecord> records{fitted_record("a"), fitted_record("a")};
  records[0].result.law = Law::Ideal;
  records[0].result.misfit_rms = 9e6;
  records[0].result.misfit_fraction = 0.032;
  records[1].result.law = Law::Linear;
  records[1].result.misfit_rms = 1e6;
  records[1].result.misfit_fraction = 0.0036;
  for (FitRecord& record : records) record.result.effective_samples = 200.0;
  for (double& stress : records[0].result.fitted.stress) stress -= 7e6;
  return records;
}

std::vector<SceneFitRecord> two_scene_laws() {
  std::vector<SceneFitRecord> records{scene_record("bar"), scene_record("bar")};
  records[0].result.law = Law::Ideal;
  for (TargetFit& of_target : records[0].result.targets) {
    of_target.cost *= 100.0;
    of_target.misfit_fraction *= 10.0;
  }
  records[1].result.law = Law::Voce;
  return records;
}

TEST(LawsPlot, ShowsWhatEachLawMakesOfACurveAndHowFarOffItIs) {
  const std::string script = plot_script(two_laws(), {.what = "laws"});
  for (const char* wanted : {"title 'ideal, 3.2 %'", "title 'linear, 0.36 %'", "title 'measured'",
                             "measured - fitted"}) {
    EXPECT_TRUE(has(script, wanted)) << wanted;
  }
}

TEST(LawsPlot, ShowsEachTargetOfAFitThroughScenes) {
  const std::string script = plot_script(two_scene_laws(), {.what = "laws"});
  for (const char* wanted :
       {"'bent'", "'twisted'", "title 'ideal, 8.3 %'", "title 'voce, 0.83 %'"}) {
    EXPECT_TRUE(has(script, wanted)) << wanted;
  }
}

TEST(LawsPlot, DrawsOtherPicturesOfTheAdvisedLawOrOfTheOneThatIsNamed) {
  const std::vector<FitRecord> records = two_laws();
  // The same curves; the name says the law.
  std::vector<FitRecord> linear{records[1]}, ideal{records[0]};
  linear[0].target.name = "a:linear";
  ideal[0].target.name = "a:ideal";
  EXPECT_EQ(plot_script(records, {}), plot_script(linear, {}));
  EXPECT_EQ(plot_script(records, {.law = "ideal"}), plot_script(ideal, {}));
  EXPECT_EQ(plot_script(records, {.specimen = "a:ideal"}), plot_script(ideal, {}));
  const std::vector<SceneFitRecord> scenes = two_scene_laws();
  std::vector<SceneFitRecord> voce{scenes[1]};
  voce[0].name = "bar:voce";
  EXPECT_EQ(plot_script(scenes, {.law = "voce"}), plot_script(voce, {}));
  EXPECT_EQ(plot_script(scenes, {.specimen = "bar:voce"}), plot_script(voce, {}));
}

TEST(LawsPlot, RefusesWhatAFileHasNot) {
  const std::vector<FitRecord> one{fitted_record("a")};
  EXPECT_EQ(message_of([&] { plot_script(one, {.what = "laws"}); }),
            "--what = laws: there are none to compare: calibrate with --laws");
  EXPECT_EQ(message_of([&] { plot_script(two_laws(), {.law = "voce"}); }),
            "--law = voce: is no law of this file; it has ideal, linear");
  EXPECT_EQ(message_of([&] { plot_script(two_laws(), {.what = "laws", .law = "ideal"}); }),
            "--law = ideal: does not go with the picture 'laws', which has all");
  EXPECT_EQ(message_of([&] { plot_script(two_laws(), {.what = "laws", .specimen = "b"}); }),
            "--case = b: is not in this file; it has a");
}

}  // namespace
}  // namespace plastica::calibrate
