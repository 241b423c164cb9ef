#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/report/scene_figure.hpp"
#include "plastica/report/scene_plot.hpp"
#include "tests/support/has.hpp"
#include "tests/support/message.hpp"
#include "tests/support/motion_record.hpp"

namespace plastica::report {
namespace {

using plastica::testing::has;

using plastica::testing::cantilever_text;
using plastica::testing::message_of;
using plastica::testing::motion_record;
using plastica::testing::record_of;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

std::string script_of(const io::SceneRecord& record, ScenePlotRequest request) {
  if (request.output.empty()) request.output = "x.svg";
  const std::vector<io::SceneRecord> records{record};
  return scene_plot_script(records, request);
}

TEST(MotionPlot, IsAFilmUnlessAskedOtherwise) {
  const io::SceneRecord record = motion_record();
  EXPECT_EQ(script_of(record, {}), script_of(record, {"film"}));
  std::string kinds;
  for (const ScenePlotKind& kind : scene_plot_kinds_of(record))
    kinds += std::string(kind.name) + ' ';
  EXPECT_EQ(kinds, "film shape moment joint load history energy spectrum ");
  kinds.clear();
  for (const ScenePlotKind& kind : scene_plot_kinds_of(record_of(cantilever_text()))) {
    kinds += std::string(kind.name) + ' ';
  }
  EXPECT_EQ(kinds, "shape film moment joint load history energy ") << "statics have no spectrum";
}

TEST(Film, ShowsEightFramesWithTheirTimesAndFragments) {
  const std::string script = script_of(motion_record(), {"film"});
  for (const char* part :
       {"set label 1 '0 ms'", "set label 4 '90 ms, 2 fragments'",
        "set label 8 '200 ms, 3 fragments'", "'pillar'", "'clamp'", "'cut'", "'force'",
        "'undeformed axis'", "'plastic strain [%]'", "set cbrange [0:4.8]", "set arrow 901"}) {
    EXPECT_TRUE(has(script, part)) << part;
  }
  EXPECT_FALSE(has(script, "set label 9 "));
}

TEST(Film, ShowsTheFramesAndTimesThatAreAskedFor) {
  ScenePlotRequest request{"film"};
  request.film_frames = 3;
  request.film_from = 0.1;
  request.film_to = 0.12;
  const std::string script = script_of(motion_record(), request);
  EXPECT_TRUE(has(script, "set label 1 '100 ms, 2 fragments'")) << script;
  EXPECT_TRUE(has(script, "set label 3 '120 ms, 2 fragments'"));
  EXPECT_FALSE(has(script, "set label 4 "));
  request.film_to = 0.05;
  EXPECT_EQ(message_of([&] { script_of(motion_record(), request); }),
            "--to = 0.05 s: must not be before --from 0.1 s");
}

TEST(Film, HasFewerFramesWhereFewerWereKept) {
  const std::string script = script_of(motion_record({.samples = 41, .frames = 5}), {"film"});
  EXPECT_TRUE(has(script, "set label 5 "));
  EXPECT_FALSE(has(script, "set label 6 "));
}

TEST(Film, OfNothingThatYieldsHasNoColours) {
  io::SceneRecord record = motion_record({.breaks = false});
  for (double& strain : record.response.chain.plastic_strain) strain = 0.0;
  const std::string script = script_of(record, {"film"});
  EXPECT_FALSE(has(script, "plastic strain"));
  EXPECT_FALSE(has(script, "'cut'"));
}

TEST(ShapeOfAMotion, IsOfTheFrameNextToTheTime) {
  const io::SceneRecord record = motion_record();
  EXPECT_TRUE(has(script_of(record, {"shape"}), "at 200 ms; largest displacement"));
  ScenePlotRequest early{"shape"};
  early.time = 0.051;
  const std::string script = script_of(record, early);
  EXPECT_TRUE(has(script, "at 50 ms; largest displacement")) << script;
  EXPECT_FALSE(has(script, "'cut'")) << "it is whole then";
  early.time = 0.1;
  EXPECT_TRUE(has(script_of(record, early), "at 100 ms; 2 fragments; "));
  EXPECT_TRUE(has(script_of(record, early), "'cut'"));
}

TEST(ShapeOfAMotion, LeavesASupportWhereItIsWhenItsJointLetsGo) {
  // A guide goes with the beam, here 3 m along z, until the joint that it holds is cut.
  io::SceneRecord record = motion_record({.segments = 4, .samples = 11, .frames = 3});
  record.setup.scene.supports[0].kind = SupportKind::Guide;
  record.setup.scene.supports[0].hold.reset();
  auto& chain = record.response.chain;
  for (std::size_t i = 0; i < 5; ++i) chain.position[3 * (2 * 5 + i) + 2] += 3.0;
  const std::string held = script_of(record, {"shape"});
  EXPECT_TRUE(has(held, "<< END_OF_DATA\n3 0 \nEND_OF_DATA")) << held;
  chain.events[0].joints[0].joint = 0;
  const std::string loose = script_of(record, {"shape"});
  EXPECT_TRUE(has(loose, "<< END_OF_DATA\n0 0 \nEND_OF_DATA")) << loose;
  EXPECT_FALSE(has(loose, "<< END_OF_DATA\n3 0 \nEND_OF_DATA"));
}

TEST(EnergyOfAMotion, IsStackedUpToWhatCameIn) {
  const std::string script = script_of(motion_record(), {"energy"});
  EXPECT_EQ(count_of(script, "using 1:2:3 with filledcurves"), 6U);
  for (const char* name :
       {"'kinetic'", "'elastic'", "'plastic'", "'damping'", "'numerical dissipation'", "'fracture'",
        "'external'", "'residual'", "'break or cut'"}) {
    EXPECT_TRUE(has(script, name)) << name;
  }
  EXPECT_FALSE(has(script, "'impact'")) << "there was none";
  EXPECT_EQ(count_of(script, "nohead front"), 2U);
  // The last row of the top area ends at what came in, less the residual.
  EXPECT_TRUE(has(script, " 19.994 \nEND_OF_DATA")) << script;
}

TEST(EnergyOfAMotion, DrawsWhatASchemeMakesAsALine) {
  io::SceneRecord record = motion_record();
  for (Energies& energy : record.response.chain.energy) energy.numerical_dissipation *= -1.0;
  EXPECT_EQ(count_of(script_of(record, {"energy"}), "using 1:2:3 with filledcurves"), 5U);
  const std::string statics = script_of(record_of(cantilever_text()), {"energy"});
  EXPECT_EQ(count_of(statics, "filledcurves"), 0U);
}

TEST(SpectrumOfAMotion, IsLogarithmicAndNamesItsPeaks) {
  const std::string script = script_of(motion_record(), {"spectrum"});
  for (const char* part : {"set logscale y", "'frequency [Hz]'", "'amplitude of tip [mm]'",
                           "'30.00 Hz'", "'150.0 Hz'"}) {
    EXPECT_TRUE(has(script, part)) << part;
  }
  ScenePlotRequest speed{"spectrum"};
  speed.probe = "speed";
  EXPECT_TRUE(has(script_of(motion_record(), speed), "'amplitude of speed [m/s]'"));
}

TEST(HistoryOfAMotion, ShowsAProbeOverTimeWithTheEvents) {
  ScenePlotRequest request{"history"};
  const std::string script = script_of(motion_record(), request);
  EXPECT_TRUE(has(script, "'tip [mm]'") && has(script, "'time [s]'")) << script;
  EXPECT_EQ(count_of(script, "nohead front"), 2U);
  request.probe = "kinetic";
  EXPECT_TRUE(has(script_of(motion_record(), request), "'kinetic [J]'"));
  request.probe = "top";
  EXPECT_EQ(message_of([&] { script_of(motion_record(), request); }),
            "--probe = top: must be a probe of the file: tip, speed, kinetic");
}

TEST(MotionPlot, OfATerminalIsMadeOfLetters) {
  for (const char* what : {"film", "shape", "history", "energy", "spectrum"}) {
    ScenePlotRequest request{what};
    request.output = "-";
    const std::string script = script_of(motion_record(), request);
    EXPECT_TRUE(has(script, "pointtype '#'")) << what;
    EXPECT_FALSE(has(script, "polygons") || has(script, "filledcurves")) << what;
  }
}

TEST(MotionPlot, RefusesOptionsOfOtherPictures) {
  const auto refusal = [](const ScenePlotRequest& request) {
    return message_of([&] { script_of(motion_record(), request); });
  };
  ScenePlotRequest request{"energy"};
  request.time = 0.1;
  EXPECT_EQ(refusal(request), "--time = 0.1 s: goes with --what shape, moment only");
  request = {"shape"};
  request.film_frames = 4;
  EXPECT_EQ(refusal(request), "--frames = 4: goes with --what film only");
  request = {"shape"};
  request.film_from = 0.1;
  EXPECT_EQ(refusal(request), "--from = 0.1 s: goes with --what film only");
  request = {"film"};
  request.probe = "tip";
  EXPECT_EQ(refusal(request), "--probe = tip: goes with --what load, history, spectrum only");
}

TEST(LongCurves, KeepTheirExtremesWhereTheyAreThinned) {
  std::vector<std::vector<double>> points;
  for (int i = 0; i < 100000; ++i)
    points.push_back({1.0 * i, i == 54321 ? 9.0 : (i % 2 ? 1.0 : -1.0)});
  const auto kept = thinned(points);
  EXPECT_LT(kept.size(), 4000U);
  EXPECT_EQ(kept.front(), points.front());
  EXPECT_EQ(kept.back(), points.back());
  EXPECT_NE(std::find(kept.begin(), kept.end(), points[54321]), kept.end());
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  points.resize(1000);
  EXPECT_EQ(thinned(points), points);
}

/// On a plateau the ordinate says nothing of where a cycle turns.
TEST(LongCurves, KeepWhereTheyTurnBack) {
  std::vector<std::vector<double>> points;
  for (int cycle = 0; cycle < 2000; ++cycle) {
    for (const double side : {1.0, -1.0}) {
      for (int k = 1; k <= 4; ++k) points.push_back({0.25 * k * side, k < 2 ? 0.0 : side});
    }
  }
  const auto kept = thinned(points);
  EXPECT_LT(kept.size(), points.size() / 2);
  // Each stretch holds a cycle and more, and turns at both sides.
  EXPECT_GT(std::ranges::count_if(kept, [](const auto& point) { return point[0] == 1.0; }), 1000);
  EXPECT_GT(std::ranges::count_if(kept, [](const auto& point) { return point[0] == -1.0; }), 1000);
}

/// Where each point stands by itself, one of those that lie on each other is enough.
TEST(LongCurves, KeepDotsWhereverThereAreAny) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<std::vector<double>> points;
  for (int i = 0; i < 60000; ++i) points.push_back({1.0 * i, normal(random)});
  points[777][1] = 9.0;
  const auto kept = thinned_dots(points);
  EXPECT_LT(kept.size(), 20000U);
  EXPECT_NE(std::find(kept.begin(), kept.end(), points[777]), kept.end());
  // Of those within two deviations a quarter is within half of one where all cells are taken, and
  // 40 % of all are.
  const auto within = [&](double size) {
    return static_cast<double>(std::ranges::count_if(
        kept, [size](const auto& point) { return std::abs(point[1]) < size; }));
  };
  EXPECT_GT(within(0.5) / within(2.0), 0.2);
  const auto page = [&](Stroke stroke) {
    Figure figure;
    figure.panels = {{"", "x", "y", {{points, "all", kBlue, stroke}}}};
    return std::ranges::count(figure_page(figure).text(), '\n');
  };
  EXPECT_GT(page(Stroke::Points), static_cast<std::ptrdiff_t>(kept.size()));
  EXPECT_LT(page(Stroke::Line), 4000);
  points.resize(6000);
  EXPECT_EQ(thinned_dots(points), points);
}

}  // namespace
}  // namespace plastica::report
