#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "plastica/report/format.hpp"
#include "plastica/report/scene_csv.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_json.hpp"
#include "plastica/report/scene_text.hpp"
#include "tests/support/has.hpp"
#include "tests/support/scene_record.hpp"

namespace plastica::report {
namespace {

using plastica::testing::has;

using plastica::testing::cantilever_text;
using plastica::testing::coupon_text;
using plastica::testing::record_of;

/// A record whose path ended in a limit load.
io::SceneRecord limited() {
  io::SceneRecord record = record_of(cantilever_text());
  record.response.status = Status::LimitLoad;
  record.response.limit = LimitLoad{1.49979, 1.50031};
  return record;
}

io::SceneRecord broken() {
  io::SceneRecord record = record_of(cantilever_text());
  record.response.status = Status::Broken;
  record.response.chain.events = {ChainBreak{2.0, 0.75, {}, {}}};
  record.response.chain.events.front().joints = {
      {0, BreakCause::BendingX, false, 0.1001, 0.1, {473.33, 0.0, 1e-14}, {0.2, 0.0, 0.0}, 12.5}};
  return record;
}

TEST(SceneReport, BeginsWithHowItEndedAndTheLevelWithItsReason) {
  const std::string text = scene_report(record_of(cantilever_text()));
  EXPECT_TRUE(text.starts_with("beam: completed\n  level           planar: ")) << text;
  EXPECT_TRUE(has(text, "  beam            1 m in 4 segments, 20 x 20 mm\n")) << text;
}

TEST(SceneReport, SaysWhatRanDefaultsIncluded) {
  io::SceneRecord record = record_of(cantilever_text());
  Scene& scene = record.setup.scene;
  scene.material = Material{};
  scene.section = Section{};
  scene.supports[0] = {Place::start(), SupportKind::Clamp};
  scene.supports.resize(1);
  Support pillar{.at = {0.5, {}}, .kind = SupportKind::Pillar};
  pillar.gap = 0.002;
  pillar.restitution = 0.5;
  scene.supports.push_back(pillar);
  Load tip;
  tip.force = {0.0, -500.0, 0.0};
  tip.moment = {0.0, 0.0, 20.0};
  tip.history = {{0.0, 1.0}, {0.0, 2.0}};
  Load spread;
  spread.at = Place::start();
  spread.to = Place::end();
  spread.force = {0.0, -10.0, 0.0};
  scene.loads = {tip, spread};
  scene.gravity = {0.0, -9.81, 0.0};
  scene.gravity_history = History::constant();
  record.response.chain.time.back() = 1.0;
  const std::string text = scene_report(record);
  for (const char* line :
       {"\n  material        S355, E 210.0 GPa, yield stress 355.0 MPa\n",
        "\n  section         rectangle, 100 x 100 mm\n",
        "\n  supports        clamp at start; pillar at 0.5 (pushes along y, gap 2.000 mm, "
        "restitution "
        "0.5)\n",
        "\n  loads           F_y -500 N, M_z 20 N m at end, up to 2 times that; F_y -10 N/m from "
        "start "
        "to end;\n                  g_y -9.81 m/s^2\n"}) {
    EXPECT_TRUE(has(text, line)) << line << text;
  }
  Support slope{.at = Place::end(), .kind = SupportKind::InclinedRoller};
  slope.normal = {0.0, 0.8, -0.6};
  scene.supports = {slope};
  EXPECT_TRUE(has(scene_report(record), "inclined_roller at end (holds along (0, 0.8, -0.6))"));
  scene.yield_model = YieldModel::Elastic;
  EXPECT_TRUE(has(scene_report(record), "\n  yield           elastic: joints never yield\n"));
  scene.yield_model = YieldModel::Interaction;
  EXPECT_TRUE(has(scene_report(record),
                  "\n  yield           interaction, cap first_yield, hardening ideal\n"));
  const auto json = nlohmann::json::parse(scene_json(record));
  EXPECT_EQ(json.at("material").at("youngs_modulus"), 210e9);
  EXPECT_EQ(json.at("material").at("yield_stress"), 355e6);
  EXPECT_EQ(json.at("section").at("shape"), "rectangle");
  EXPECT_EQ(json.at("section").at("width"), 0.1);
}

TEST(SceneReport, CallsAStressOfTheElasticModulusSoWhereTheBeamYields) {
  io::SceneRecord record = record_of(cantilever_text());
  EXPECT_TRUE(has(scene_report(record), "bending stress"));
  EXPECT_FALSE(has(scene_report(record), "as if elastic"));
  record.response.chain.plastic_strain.back() = 1e-3;
  EXPECT_TRUE(has(scene_report(record), "as if elastic")) << scene_report(record);
}

TEST(SceneReport, NamesALimitLoadByItsBracket) {
  EXPECT_EQ(outcome_line(limited()), "limit load: factor 1.4998; at 1.5003 the beam has given way");
  io::SceneRecord close = limited();
  close.response.limit->below = 1.4998213;
  close.response.limit->above = 1.4998219;
  EXPECT_EQ(outcome_line(close), "limit load: factor 1.499821; at 1.499822 the beam has given way");
}

TEST(SceneReport, NamesEachBrokenJointWithCauseStrainAndLimit) {
  const io::SceneRecord record = broken();
  EXPECT_EQ(outcome_line(record), "broken: 1 joint over its limit at factor 0.75, time 2 s");
  const std::string text = scene_report(record);
  EXPECT_TRUE(has(text, "  2.0000      0     start  bending x   10.01  10.00  473.33    0    0"))
      << text;
  EXPECT_TRUE(has(text, "  12.500   no\n")) << text;
}

TEST(SceneReport, SaysWhatToChangeWhereTheRunIsNotUsable) {
  io::SceneRecord record = record_of(cantilever_text());
  record.response.status = Status::NotConverged;
  const std::string text = scene_report(record);
  EXPECT_TRUE(text.starts_with("beam: not-converged\n  advice          take more steps")) << text;
}

TEST(SceneReport, OfNoValidSampleIsStillAReport) {
  const io::SceneFile file = io::parse_scene_file(cantilever_text(), "beam.toml");
  const Model model = prepare(file.setup.scene, file.setup.solver);
  Response response = make_response(model);
  response.status = Status::Mechanism;
  const io::SceneRecord record = io::make_scene_record(file, model, response);
  EXPECT_TRUE(scene_report(record).starts_with("beam: mechanism\n"));
  EXPECT_TRUE(nlohmann::json::parse(scene_json(record)).at("energies").is_null());
  std::ostringstream joints;
  write_joints_csv(joints, record);
  EXPECT_TRUE(joints.str().ends_with("bending stress [Pa]\n"));
}

TEST(SceneReport, ShowsProbesReactionsPeaksAndEnergiesThatBalance) {
  const io::SceneRecord record = record_of(cantilever_text());
  const std::string text = scene_report(record);
  EXPECT_TRUE(has(text, "displacement y at end\n")) << text;
  EXPECT_TRUE(has(text, "moment x at start\n")) << text;
  EXPECT_TRUE(has(text, "  clamp            start    0  100.00    0  ")) << text;
  const ScenePeaks peaks = peaks_of(record);
  ASSERT_TRUE(peaks.moment && peaks.stress);
  EXPECT_EQ(peaks.moment->joint, 0U);
  EXPECT_EQ(peaks.moment->axis, 0U);
  // 100 N on a metre, shortened a little as the tip comes down by 12 mm.
  EXPECT_NEAR(std::fabs(peaks.moment->value), 100.0, 0.02);
  EXPECT_NEAR(std::fabs(peaks.stress->value), 100.0 * 6.0 / 8e-6, 0.02 * 6.0 / 8e-6);
  EXPECT_FALSE(peaks.plastic_strain);
  // The tip's: F L^3/(3 E I), and what four segments add to it, 1/(4 N^2).
  ASSERT_TRUE(peaks.displacement);
  EXPECT_EQ(peaks.displacement->joint, 4U);
  EXPECT_EQ(peaks.displacement->axis, 1U);
  EXPECT_TRUE(has(text, "\n  displacement  ")) << text;
  EXPECT_LT(residual_fraction(record).value(), 1e-3);
}

/// P L/(E A) = 11.9 um of a bar that nothing bends.
TEST(SceneReport, ShowsTheDisplacementOfABarInTension) {
  const io::SceneRecord record = record_of(
      "[beam]\nlength = '1 m'\nsegments = 4\nmaterial = 'S355'\n"
      "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
      "[solver]\ntranslation = 'elastic'\n[[support]]\nat = 'start'\nkind = 'clamp'\n"
      "[[load]]\nat = 'end'\nforce = ['0 N', '0 N', '1 kN']\n");
  const ScenePeaks peaks = peaks_of(record);
  ASSERT_TRUE(peaks.displacement);
  EXPECT_EQ(peaks.displacement->axis, 2U);
  EXPECT_NEAR(peaks.displacement->value, 1e3 / (210e9 * 4e-4), 1e-9);
  EXPECT_TRUE(has(scene_report(record), "most along z\n")) << scene_report(record);
}

TEST(SceneReport, SaysWhatHelpsAPathWhoseEnergyIsNotBalanced) {
  io::SceneRecord record = broken();
  EXPECT_FALSE(has(scene_report(record), "energy balance"));
  record.response.energy_balance_error = 0.05;
  EXPECT_TRUE(
      has(scene_report(record), "\n  the energy balance is off by 5 %: raise solver.steps\n"));
}

TEST(SceneReport, OfACouponHasNoBeamAndTellsTheBreak) {
  const std::string text = scene_report(record_of(coupon_text()));
  EXPECT_TRUE(
      text.starts_with("beam: broken at sample 3, strain 0.0216905, permanent strain 0.02\n"
                       "  level           coupon: "))
      << text;
  for (const char* part : {"\nReactions", "\nJoints", "  beam  ", "\nEffort"}) {
    EXPECT_FALSE(has(text, part)) << text;
  }
}

TEST(SceneReport, IsNowhereWiderThanAHundredColumns) {
  for (const io::SceneRecord& record : {broken(), limited(), record_of(coupon_text())}) {
    std::istringstream lines(scene_report(record));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(width_of(line), 100U) << line;
  }
}

TEST(SceneReport, SaysWhereAPathBifurcates) {
  // A column under 14 kN, twice pi^2/4 E I/L^2 = 6909 N; a square one, so in two ways at once.
  const io::SceneRecord record = record_of(cantilever_text("0 N", R"([[load]]
at = "end"
force = ["0 N", "0 N", "-14 kN"]
)"));
  const std::string text = scene_report(record);
  EXPECT_TRUE(text.starts_with("beam: unstable: it bifurcates at factor 0.4")) << text;
  const auto json = nlohmann::json::parse(scene_json(record));
  EXPECT_EQ(json.at("status"), "unstable");
  const auto& point = json.at("critical_points").at(0);
  EXPECT_NEAR(point.at("factor"), 6909.0 / 14000.0, 0.02 * 0.5);  // of four segments
  EXPECT_EQ(point.at("unstable_modes"), 2);
  EXPECT_EQ(point.at("mode").size(), 15U);
}

TEST(SceneJson, GivesWhatTheReportSaysInSi) {
  const auto json = nlohmann::json::parse(scene_json(broken()));
  EXPECT_EQ(json.at("status"), "broken");
  EXPECT_EQ(json.at("level"), "planar");
  EXPECT_TRUE(json.at("limit_load").is_null());
  EXPECT_EQ(json.at("events").at(0).at("joints").at(0).at("cause"), "bending_x");
  EXPECT_EQ(json.at("probes").at("tip").at("unit"), "m");
  EXPECT_LT(json.at("probes").at("tip").at("last"), -0.011);
  EXPECT_NEAR(json.at("reactions").at(0).at("force").at(1), 100.0, 1e-6);
  const auto limit = nlohmann::json::parse(scene_json(limited())).at("limit_load");
  EXPECT_EQ(limit.at("below"), 1.49979);
  EXPECT_EQ(limit.at("above"), 1.50031);
}

TEST(SceneJson, SaysWhatHoldsAndWhatLoadsTheBeam) {
  const io::SceneRecord record = record_of(cantilever_text("-0.1 kN", R"([[region]]
from = 0.5
to = "end"
section = { shape = "circle", radius = "8 mm" }
[[support]]
at = 0.5
kind = "elastic"
stiffness = ["0 N/m", "2 N/mm", "0 N/m"]
rotational_stiffness = ["3 N m/rad", "0 N m/rad", "0 N m/rad"]
[[support]]
at = "end"
kind = "pillar"
gap = "200 mm"
translation = ["0 mm", "-5 mm", "0 mm"]
history = { turning_points = [1, 0.5] }
[[load]]
at = "start"
to = 0.5
force = ["0 N/m", "-2 N/mm", "0 N/m"]
follows = true
history = "constant"
[gravity]
acceleration = ["0 m/s^2", "-9.81 m/s^2", "0 m/s^2"]
)"));
  const auto json = nlohmann::json::parse(scene_json(record));
  EXPECT_EQ(json.at("regions"), nlohmann::json::parse(R"([
    {"from": 0.5, "to": 1, "section": {"shape": "circle", "radius": 0.008},
     "material": {"name": "S355", "youngs_modulus": 210e9, "yield_stress": 355e6,
                  "density": 7850}}])"));
  EXPECT_EQ(json.at("supports"), nlohmann::json::parse(R"([
    {"kind": "clamp", "at": 0, "holds": ["x", "y", "z", "rx", "ry", "rz"], "motion": null},
    {"kind": "elastic", "at": 0.5, "holds": [], "stiffness": [0, 2000, 0],
     "rotational_stiffness": [3, 0, 0], "motion": null},
    {"kind": "pillar", "at": 1, "holds": [], "normal": [0, 1, 0], "gap": 0.2, "restitution": 0,
     "motion": {"translation": [0, -0.005, 0], "rotation": [0, 0, 0],
                "history": {"time": [0, 1, 2], "factor": [0, 1, 0.5], "continues": false}}}])"));
  EXPECT_EQ(json.at("loads"), nlohmann::json::parse(R"([
    {"at": 1, "to": null, "force": [0, -100, 0], "force_unit": "N", "moment": [0, 0, 0],
     "moment_unit": "N m", "follows": false,
     "history": {"time": [0, 1], "factor": [0, 1], "continues": true}},
    {"at": 0, "to": 0.5, "force": [0, -2000, 0], "force_unit": "N/m", "moment": [0, 0, 0],
     "moment_unit": "N m/m", "follows": true,
     "history": {"time": [0], "factor": [1], "continues": false}}])"));
  EXPECT_EQ(json.at("gravity").at("acceleration"), nlohmann::json({0, -9.81, 0}));
  EXPECT_EQ(json.at("gravity").at("history").at("continues"), true);
  const auto coupon = nlohmann::json::parse(scene_json(record_of(coupon_text())));
  EXPECT_TRUE(coupon.at("supports").empty() && coupon.at("loads").empty());
  EXPECT_TRUE(coupon.at("gravity").is_null());
}

TEST(ProbeTable, HasARowPerSampleAndUnitsInTheHeader) {
  const io::SceneRecord record = record_of(cantilever_text());
  std::ostringstream out;
  write_probes_csv(out, record);
  const std::string text = out.str();
  EXPECT_TRUE(text.starts_with("sample,time [s],factor [1],tip [m],root [N m]\n0,0,0,")) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 7);
}

TEST(JointTable, HasARowPerJointOfTheLastSample) {
  const io::SceneRecord record = record_of(cantilever_text());
  std::ostringstream out;
  write_joints_csv(out, record);
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 6);
  EXPECT_TRUE(has(text, "\n4,1,")) << text;
  std::ostringstream none;
  EXPECT_THROW(write_joints_csv(none, record_of(coupon_text())), InputError);
}

}  // namespace
}  // namespace plastica::report
