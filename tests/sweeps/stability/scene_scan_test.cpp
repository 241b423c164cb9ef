#include "sweeps/stability/scene_scan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plastica/io/scene_file.hpp"
#include "plastica/run/simulate.hpp"
#include "sweeps/plan/derived_fields.hpp"
#include "sweeps/stability/scene_scan_text.hpp"
#include "sweeps/stability/summary.hpp"
#include "tests/support/has.hpp"
#include "tests/support/message.hpp"
#include "tests/sweeps/places_alike.hpp"
#include "tests/sweeps/sprung_beam.hpp"

namespace plastica::sweeps::stability {
namespace {

Setup shipped_scene(const std::string& name) {
  return io::read_scene_file(std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/" + name + ".toml")
      .setup;
}

SceneScan scan_of(const Setup& setup, const std::vector<std::string>& names,
                  const SceneScanOptions& options = {}) {
  return scan_scene("scene", setup, scanned_fields(setup, names), options);
}

TEST(SceneScan, FindsHowFewSegmentsAreAccurate) {
  // Of half joints the tip is off the elastica by 48.7 %/N^2, so N and 4 N differ by 45.7 %/N^2:
  // within 1 % from 6.76 segments on.
  const SceneScan scan = scan_of(shipped_scene("cantilever"), {"beam.segments"}, {.within = 0.01});
  ASSERT_EQ(scan.own.validity, Validity::Valid);
  EXPECT_NEAR(scan.deviation.value_or(0.0), 0.457 / (32.0 * 32.0), 1e-4);
  const ScanLimit& below = scan.fields.at(0).below;
  EXPECT_EQ(below.end, ScanEnd::Verdict);
  EXPECT_GE(below.value, 6.0);
  EXPECT_LE(below.value, 8.0);
  EXPECT_LT(below.next, 7.0);
  EXPECT_GE(below.next, 4.0);
  EXPECT_EQ(below.verdict.validity, Validity::Inaccurate);
  EXPECT_NE(below.verdict.reason.find("is off a finer run by 1."), std::string::npos)
      << below.verdict.reason;
  // 64 times the work are 2 048 segments; from 1 012 the next factor is beyond.
  EXPECT_EQ(scan.fields[0].above.end, ScanEnd::Work);
  EXPECT_GE(scan.fields[0].above.value, 1000.0);
}

TEST(SceneScan, IsNotFooledByErrorsOfTwoOrdersThatCancel) {
  // Six segments and four times as many differ by 0.4 %, and are 1.8 % and 1.3 % off.
  const plastica::Setup setup = sprung_beam(6);
  const SceneScan scan = scan_of(setup, {"beam.segments"}, {.within = 0.01});
  EXPECT_EQ(scan.own.validity, Validity::Inaccurate);
  EXPECT_TRUE(plastica::testing::has(scan.own.reason, "is off the limit of finer runs by"))
      << scan.own.reason;
  const Response response = simulate(setup.scene, setup.solver);
  const double error = std::fabs(response.probes[0].back() / force_of_spring(setup) - 1.0);
  EXPECT_NEAR(error, 0.018, 0.001);
  EXPECT_GE(scan.deviation.value_or(0.0), error);
}

// Young's modulus in MPa that was taken for Pa.
TEST(SceneScan, WarnsOfTheSceneAsItIs) {
  plastica::Setup setup = shipped_scene("cantilever");
  const SceneScanOptions options{.within = 0.01, .reach = 2.0, .max_work = 4.0};
  EXPECT_TRUE(scan_of(setup, {"beam.segments"}, options).warnings.empty());
  setup.scene.material.youngs_modulus *= 1e-3;
  for (Load& load : setup.scene.loads) {
    for (double& force : load.force) force *= 1e-3;
  }
  const SceneScan scan = scan_of(setup, {"beam.segments"}, options);
  ASSERT_FALSE(scan.warnings.empty());
  EXPECT_NE(scene_scan_text(scan, options).find("\n  warning     "), std::string::npos);
}

TEST(SceneScan, IsNotTakenInByPlacesThatStandAlikeInTwoDivisions) {
  const SceneScan coarse = scan_of(places_alike(4), {"beam.segments"});
  EXPECT_EQ(coarse.own.validity, Validity::Inaccurate);
  const SceneScan scan = scan_of(places_alike(128), {"beam.segments"}, {.max_work = 4.0});
  ASSERT_EQ(scan.own.validity, Validity::Valid) << scan.own.reason;
  const auto tip = [](double segments) {
    const plastica::Setup at = places_alike(static_cast<int>(segments));
    return simulate(at.scene, at.solver).probes[0].back();
  };
  const double truth = tip(2000.0);
  for (const StabilityRow& row : scan.rows) {
    if (row.at.empty() || row.verdict.validity != Validity::Valid) continue;
    // Within 5 % of a run that is itself off by less than a tenth of that.
    EXPECT_NEAR(tip(row.at[0].value), truth, 0.055 * std::abs(truth)) << row.id;
  }
}

TEST(SceneScan, IsNotTakenInByProbesOfTheSameNearestJoint) {
  plastica::Setup setup = places_alike(9);
  setup.scene.supports.pop_back();
  setup.scene.loads[0].at = Place::end();
  Probe& probe = setup.scene.probes[0];
  probe.quantity = ProbeQuantity::Moment;
  probe.component = Component::X;
  // The joint at 8/9 is the nearest one of 9 segments and of 36.
  probe.at = {0.9, {}};
  const SceneScan scan = scan_of(setup, {"beam.segments"});
  EXPECT_EQ(scan.own.validity, Validity::Inaccurate);
  EXPECT_NEAR(scan.deviation.value_or(0.0), 0.1 / 0.9, 0.01);
}

/// Steps of 4 ms and of 2 ms see nothing of a force that swings in one: they differ by 0.5 %, and
/// are 22 % off.
TEST(SceneScan, IsNotTakenInByStepsOfTheLoadsPeriod) {
  const plastica::Setup setup =
      io::parse_scene_file(
          "material = 'S355'\n[beam]\nlength = '2 m'\nsegments = 16\n"
          "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
          "[rules]\nyield_model = 'elastic'\n"
          "[solver]\nanalysis = 'dynamics'\nduration = '200 ms'\nsteps = 50\n"
          "time_step = '4 ms'\nframes = 1\n[gravity]\ny = '-9.81 m/s^2'\n"
          "[[support]]\nat = 'start'\nkind = 'clamp'\n"
          "[[load]]\nat = 'end'\nforce = ['0 N', '-200 N', '0 N']\n"
          "history = { period = '1 ms', cycles = 200 }\n"
          "[[probe]]\nname = 'tip'\nkind = 'displacement'\nat = 'end'\ncomponent = 'y'\n",
          "shaken.toml")
          .setup;
  const SceneScan scan = scan_of(setup, {"beam.length"});
  EXPECT_EQ(scan.own.validity, Validity::Inaccurate);
  EXPECT_GT(scan.deviation.value_or(0.0), 0.15);
}

TEST(SceneScan, FollowsASceneWhoseResultIsTheSameUpToItsReach) {
  // An elastic beam's shape under its own end's motion depends on no modulus.
  plastica::Setup setup = shipped_scene("cantilever");
  setup.scene.yield_model = YieldModel::Elastic;
  const SceneScan scan =
      scan_of(setup, {"material.density", "material.yield_stress"}, {.reach = 100.0});
  for (const ScannedField& field : scan.fields) {
    EXPECT_FALSE(field.matters()) << field.field->path;
    EXPECT_EQ(field.above.end, ScanEnd::Reach);
    EXPECT_NEAR(field.above.value / field.value, 100.0, 1e-9);
    EXPECT_NEAR(field.below.value / field.value, 0.01, 1e-9);
  }
  EXPECT_TRUE(plastica::testing::has(scene_scan_text(scan, {}),
                                     "change no probe: material.density, "
                                     "material.yield_stress"));
}

TEST(SceneScan, EndsWhereAFieldsRangeDoes) {
  const plastica::Setup setup = shipped_scene("cantilever");
  const SceneScan scan = scan_of(setup, {"material.poisson_ratio"});
  EXPECT_EQ(scan.fields.at(0).above.end, ScanEnd::Range);
  EXPECT_EQ(scan.fields[0].above.value, setup.scene.material.poisson_ratio);
  EXPECT_EQ(scan.fields[0].below.end, ScanEnd::Reach);
}

TEST(SceneScan, EndsWhereATimeStepIsCutToTheSamples) {
  // The arm has a sample every 4 ms: a longer step is the same run.
  const SceneScan scan =
      scan_of(shipped_scene("robot_arm"), {"solver.time_step"}, {.within = 0.9, .reach = 100.0});
  ASSERT_EQ(scan.own.validity, Validity::Valid);
  const ScanLimit& above = scan.fields.at(0).above;
  EXPECT_EQ(above.end, ScanEnd::Samples);
  EXPECT_NEAR(above.value, 4e-3, 1e-12);
  for (const StabilityRow& row : scan.rows) {
    for (const ScannedValue& value : row.at) EXPECT_LE(value.value, 4e-3 * (1.0 + 1e-9));
  }
}

TEST(SceneScan, SaysWhereARunFails) {
  // Under a hundred times its load the yielding cantilever has long met its limit load, which is an
  // answer; a tolerance of rounding is met by none.
  const SceneScan scan = scan_of(shipped_scene("cantilever"), {"solver.tolerance"}, {.reach = 1e9});
  const ScanLimit& below = scan.fields.at(0).below;
  EXPECT_EQ(below.end, ScanEnd::Verdict);
  EXPECT_EQ(below.verdict.validity, Validity::Failed);
  EXPECT_LT(below.value, 1e-11);
}

TEST(SceneScan, RunsNothingElseUnlessTheSceneItselfIsValid) {
  plastica::Setup setup = shipped_scene("robot_arm");
  set_field(setup, find_field("beam.segments"), 4.0);
  const SceneScan scan = scan_of(setup, {"beam.segments"});
  EXPECT_EQ(scan.own.validity, Validity::Inaccurate);
  EXPECT_TRUE(scan.fields.empty());
  EXPECT_EQ(scan.rows.size(), 1U);
  EXPECT_TRUE(plastica::testing::has(scene_scan_text(scan, {}), "plastica advise"))
      << scene_scan_text(scan, {});
}

TEST(SceneScan, HasTheSameRowsForEveryNumberOfThreads) {
  const plastica::Setup setup = shipped_scene("cantilever");
  const auto rows = [&](int threads) {
    std::vector<std::string> all;
    const SceneScan scan =
        scan_of(setup, {"beam.length", "scale.loads"}, {.reach = 10.0, .threads = threads});
    for (StabilityRow row : scan.rows) {
      row.seconds = 0.0;
      all.push_back(rows_csv(std::vector{row}));
    }
    return all;
  };
  const auto one = rows(1);
  EXPECT_GT(one.size(), 8U);
  EXPECT_EQ(rows(2), one);
}

TEST(SceneScan, ScansAPair) {
  const plastica::Setup setup = shipped_scene("cantilever");
  const Field& segments = find_field("beam.segments");
  const Field& loads = find_axis_field("scale.loads");
  const SceneScanOptions options{.within = 0.01, .reach = 10.0};
  const SceneScan scan = scan_of(setup, {"beam.segments", "scale.loads"}, options);
  const PairScan pair = scan_pair("scene", setup, scan.fields.at(0), scan.fields.at(1), options);
  EXPECT_TRUE(pair.complete);
  const std::vector<StabilityRow>& rows = pair.rows;
  ASSERT_GT(rows.size(), 80U);
  // Few segments are off under the scene's own load, as in the scan of segments alone.
  const auto class_at = [&](double n) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const StabilityRow& r) {
      return r.at[0].value == n && r.at[1].value == 1.0;
    });
    return row == rows.end() ? Validity::Failed : row->verdict.validity;
  };
  EXPECT_EQ(class_at(rows.front().at[0].value), Validity::Inaccurate);
  EXPECT_EQ(class_at(32.0), Validity::Valid);
  EXPECT_TRUE(
      plastica::testing::has(pair_map(rows, setup, segments, loads).text(), "set logscale y"));
}

TEST(SceneScan, TakesAllNumbersOfTheSceneUnlessSomeAreNamed) {
  const auto all = scanned_fields(shipped_scene("cantilever"), {});
  const auto is_there = [&](const char* path) {
    return std::any_of(all.begin(), all.end(), [&](const Field* f) { return f->path == path; });
  };
  for (const char* path : {"beam.segments", "beam.length", "material.youngs_modulus",
                           "section.width", "solver.tolerance", "scale.loads"}) {
    EXPECT_TRUE(is_there(path)) << path;
  }
  // Words, what is not set, dimensions of other shapes, what adds results.
  for (const char* path : {"rules.end_rule", "material.break_strain", "section.radius",
                           "solver.buckling", "gravity.y"}) {
    EXPECT_FALSE(is_there(path)) << path;
  }
}

TEST(SceneScan, RefusesWhatCannotBeFollowed) {
  const plastica::Setup setup = shipped_scene("cantilever");
  const auto message = [&](const std::vector<std::string>& names) {
    return plastica::testing::message_of([&] { scanned_fields(setup, names); });
  };
  EXPECT_EQ(message({"rules.end_rule"}),
            "--vary = rules.end_rule: is a word, which has no factors");
  EXPECT_EQ(message({"gravity.y"}),
            "--vary = gravity.y: is not set, or 0, in the scene: there is nothing to multiply");
  EXPECT_EQ(message({"beam.length", "beam.length"}), "--vary = beam.length: is named twice");
  EXPECT_NE(message({"beam.lenght"}), "no error");
  plastica::Setup coupon = setup;
  coupon.scene.drive.strain = {0.0, 0.01};
  EXPECT_NE(plastica::testing::message_of([&] { scan_of(coupon, {"material.yield_stress"}); }),
            "no error");
}

TEST(SceneScan, Stops) {
  const std::atomic<bool> stop{true};
  const SceneScan scan = scan_of(shipped_scene("cantilever"), {"beam.length"}, {.stop = &stop});
  EXPECT_FALSE(scan.complete);
}

}  // namespace
}  // namespace plastica::sweeps::stability
