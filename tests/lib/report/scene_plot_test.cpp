#include "plastica/report/scene_plot.hpp"

#include <gtest/gtest.h>

#include "plastica/base/check.hpp"
#include "plastica/report/scene_curves.hpp"
#include "tests/support/has.hpp"
#include "tests/support/message.hpp"
#include "tests/support/scene_record.hpp"

namespace plastica::report {
namespace {

using plastica::testing::has;

using plastica::testing::cantilever_text;
using plastica::testing::coupon_text;
using plastica::testing::message_of;
using plastica::testing::record_of;

std::string script_of(const std::vector<io::SceneRecord>& records, ScenePlotRequest request = {}) {
  if (request.output.empty()) request.output = "x.svg";
  return scene_plot_script(records, request);
}

TEST(ScenePlot, ShowsTheShapeUnlessAskedOtherwise) {
  const io::SceneRecord record = record_of(cantilever_text());
  const std::string script = script_of({record});
  EXPECT_EQ(script, script_of({record}, {"shape", {}, {}, {}}));
  for (const char* part : {"'undeformed axis'", "'on the way'", "with polygons", "'clamp'",
                           "'force'", "'z [m]'", "'y [m]'", "largest displacement 12.28 mm"}) {
    EXPECT_TRUE(has(script, part)) << part;
  }
  EXPECT_FALSE(has(script, "plastic strain")) << "nothing has yielded";
}

TEST(ScenePlot, ColoursTheShapeByPlasticStrain) {
  io::SceneRecord record = record_of(cantilever_text());
  auto& strain = record.response.chain.plastic_strain;
  strain[strain.size() - 5] = 0.05;  // joint 0 at the last sample
  const std::string script = script_of({record});
  EXPECT_TRUE(has(script, "set cbrange [0:5]")) << script;
  EXPECT_TRUE(has(script, "'plastic strain [%]'"));
}

TEST(ScenePlot, LaysMomentsOfSeveralFilesOverEachOther) {
  std::string fine = cantilever_text();
  fine.replace(fine.find("segments = 4"), 12, "segments = 8");
  fine.replace(fine.find("at = { segment = 4 }"), 20, "at = \"end\"");
  const std::vector<io::SceneRecord> records{record_of(cantilever_text()), record_of(fine)};
  const std::string script = script_of(records, {"moment", {}, {}, {}});
  EXPECT_TRUE(has(script, "'4 segments'") && has(script, "'8 segments'")) << script;
  EXPECT_TRUE(has(script, "'M_x [N m]'"));
  EXPECT_FALSE(has(script, "'T [N m]'")) << "a panel of zeros";
}

TEST(ScenePlot, SaysWhatEachCurveIsWhereProbesOfOneNameDiffer) {
  io::SceneRecord other = record_of(cantilever_text());
  other.setup.scene.name = "other";
  const std::vector<io::SceneRecord> alike{record_of(cantilever_text()), other};
  const std::string& name = alike[0].setup.scene.probes[0].name;
  EXPECT_TRUE(has(script_of(alike, {"load", {}, name, {}}), name + ": displacement"));
  std::vector<io::SceneRecord> unlike = alike;
  unlike[1].setup.scene.probes[0].at = {0.5, {}};
  const std::string script = script_of(unlike, {"load", {}, name, {}});
  EXPECT_TRUE(has(script, "'displacement [mm]'")) << script;
  EXPECT_TRUE(has(script, "at 0.5'")) << script;
  unlike[1].setup.scene.probes[0].quantity = ProbeQuantity::Rotation;
  EXPECT_TRUE(has(message_of([&] {
                    script_of(unlike, {"load", {}, name, {}});
                  }),
                  "which have no axis in common"));
}

TEST(ScenePlot, ShowsTheJointOfTheLargestStrainOrTheOneAskedFor) {
  const io::SceneRecord record = record_of(cantilever_text());
  EXPECT_TRUE(has(script_of({record}, {"joint", {}, {}, {}}), "joint 0 at start of the length"));
  EXPECT_TRUE(has(script_of({record}, {"joint", 2, {}, {}}), "joint 2 at 0.5 of the length"));
}

TEST(ScenePlot, RefusesATimeThatIsNotThere) {
  const io::SceneRecord record = record_of(cantilever_text());
  const double last = record.response.chain.time.back();
  for (const double time : {-5.0, last + 50.0}) {
    ScenePlotRequest request{"shape", {}, {}, {}};
    request.time = time;
    const std::string message = message_of([&] { script_of({record}, request); });
    EXPECT_TRUE(has(message, "--time = ") && has(message, "must be within the times that are kept"))
        << message;
  }
  ScenePlotRequest request{"shape", {}, {}, {}};
  request.time = last;
  EXPECT_NO_THROW(script_of({record}, request));
}

TEST(ScenePlot, ShowsTheJointThatBrokeUpToItsBreak) {
  io::SceneRecord record = record_of(cantilever_text());
  ChainHistory& chain = record.response.chain;
  BrokenJoint broken;
  broken.joint = 2;
  BrokenJoint cut = broken;
  cut.joint = 1;
  cut.cause = BreakCause::Cut;
  chain.events.push_back({chain.time[1], 0.1, {cut}, {}});
  chain.events.push_back({0.5 * (chain.time[2] + chain.time[3]), 0.5, {broken}, {}});
  const Figure figure = joint_figure(std::vector{record}, {});
  EXPECT_EQ(figure.panels[0].title,
            "joint 2 at 0.5 of the length, broken: bending about x, extreme fibre");
  EXPECT_EQ(figure.panels[0].curves[0].points.size(), 3U);
  // About the axis of the cause, not that of the largest strain.
  chain.events[1].joints[0].cause = BreakCause::Torsion;
  EXPECT_EQ(joint_figure(std::vector{record}, {}).panels[0].title,
            "joint 2 at 0.5 of the length, broken: torsion");
  const Figure both = joint_figure(std::vector{record, record_of(cantilever_text())}, {});
  EXPECT_EQ(both.panels[0].title, "");
  EXPECT_EQ(both.panels[0].curves[1].name, "4 segments, joint 0");
  const Figure other = joint_figure(std::vector{record}, 3);
  EXPECT_GT(other.panels[0].curves[0].points.size(), 3U);
}

TEST(ScenePlot, OfACouponIsItsStressOverItsStrain) {
  const io::SceneRecord record = record_of(coupon_text());
  const auto kinds = scene_plot_kinds_of(record);
  ASSERT_EQ(kinds.size(), 1U);
  EXPECT_EQ(kinds[0].name, "joint");
  const std::string script = script_of({record});
  EXPECT_TRUE(has(script, "1 355 \n")) << script;  // 1 %, the yield stress
}

TEST(ScenePlot, ShowsTheLoadOverTheProbeThatIsAskedFor) {
  const io::SceneRecord record = record_of(cantilever_text());
  EXPECT_TRUE(has(script_of({record}, {"load", {}, {}, {}}), "'tip: displacement y at end [mm]'"));
  EXPECT_TRUE(
      has(script_of({record}, {"load", {}, "root", {}}), "'root: moment x at start [N m]'"));
}

TEST(ScenePlot, ShowsTheEnergiesThatAreNotZero) {
  const std::string script = script_of({record_of(cantilever_text())}, {"energy", {}, {}, {}});
  for (const char* name : {"'external'", "'elastic'", "'residual'"}) {
    EXPECT_TRUE(has(script, name)) << name;
  }
  EXPECT_FALSE(has(script, "'plastic'") || has(script, "'kinetic'")) << "nothing has yielded";
}

TEST(ScenePlot, OfATerminalIsMadeOfLetters) {
  const io::SceneRecord record = record_of(cantilever_text());
  for (const char* what : {"shape", "film", "moment", "joint", "load", "history", "energy"}) {
    const std::string script = script_of({record}, {what, {}, {}, "-"});
    EXPECT_TRUE(has(script, "pointtype '#'")) << what;
    EXPECT_FALSE(has(script, "polygons")) << what;
  }
}

TEST(ScenePlot, LetsNoTextOfAUserLeaveItsQuotes) {
  io::SceneRecord record = record_of(cantilever_text());
  record.setup.scene.name = "'; system 'x";
  for (const char* what : {"shape", "film", "moment", "joint", "load", "history", "energy"}) {
    EXPECT_TRUE(has(script_of({record}, {what, {}, {}, {}}), "'''; system ''x'")) << what;
  }
}

TEST(ScenePlot, SaysWhatThereIsToDraw) {
  const std::vector<io::SceneRecord> one{record_of(cantilever_text())};
  const std::vector<io::SceneRecord> two{one[0], one[0]};
  const std::vector<io::SceneRecord> coupon{record_of(coupon_text())};
  const auto refusal = [](const std::vector<io::SceneRecord>& records, ScenePlotRequest request) {
    return message_of([&] { script_of(records, request); });
  };
  EXPECT_EQ(
      refusal(one, {"pie", {}, {}, {}}),
      "--what = pie: must be one of shape, film, moment, joint, load, history, energy for this "
      "file");
  EXPECT_EQ(refusal(coupon, {"shape", {}, {}, {}}),
            "--what = shape: must be one of joint for this file");
  EXPECT_EQ(refusal(two, {"shape", {}, {}, {}}), "--what = shape: is drawn of one file at a time");
  EXPECT_EQ(refusal(one, {"joint", 5, {}, {}}), "--joint = 5: must be from 0 to 4");
  EXPECT_EQ(refusal(one, {"joint", -1, {}, {}}), "--joint = -1: must be from 0 to 4");
  EXPECT_EQ(refusal(coupon, {"joint", 0, {}, {}}),
            "--joint = 0: is not of a coupon, which has none");
  EXPECT_EQ(refusal(one, {"shape", 1, {}, {}}), "--joint = 1: goes with --what joint only");
  EXPECT_EQ(refusal(one, {"shape", {}, "tip", {}}),
            "--probe = tip: goes with --what load, history, spectrum only");
  EXPECT_EQ(refusal(one, {"load", {}, "top", {}}),
            "--probe = top: must be a probe of the file: tip, root");
}

}  // namespace
}  // namespace plastica::report
