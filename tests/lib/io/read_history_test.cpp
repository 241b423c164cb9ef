#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "plastica/io/scene_file.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/lib/io/scratch_folder.hpp"

// Histories from the words of a scene file to their factors over time, and through a result file.

namespace plastica::io {
namespace {

using std::numbers::pi;

std::string scene_with(const std::string& history) {
  return "[[support]]\nat = 'start'\nkind = 'clamp'\n"
         "[[load]]\nat = 'end'\nforce = ['0 N', '1 N', '0 N']\nhistory = " +
         history + "\n";
}

History history_of(const std::string& words) {
  return parse_scene_file(scene_with(words), "s.toml").setup.scene.loads[0].history;
}

TEST(ReadHistory, OfASineIsOneOfItsPeriodAndCycles) {
  const History sine = history_of("{ period = '80 ms', cycles = 2.25 }");
  EXPECT_NEAR(sine.end(), 0.18, 1e-15);
  for (double time = 0.0; time < 0.18; time += 0.0037) {
    EXPECT_NEAR(sine.at(time), std::sin(2.0 * pi * time / 0.08), 2e-8) << time;
  }
  EXPECT_NEAR(sine.at(1.0), 1.0, 1e-12);  // where it ends
}

TEST(ReadHistory, OfASineHasItsPhaseAndOffset) {
  const History sine =
      history_of("{ period = '2 s', cycles = 3, phase = '90 deg', offset = '-50 %' }");
  for (const double time : {0.0, 0.3, 1.0, 2.5, 5.9}) {
    EXPECT_NEAR(sine.at(time), std::cos(pi * time) - 0.5, 2e-8) << time;
  }
}

TEST(ReadHistory, OfASmoothStepGoesFromZeroToOneBetweenItsTimes) {
  const History step = history_of("{ smooth_step = ['500 ms', '2.5 s'] }");
  for (const double time : {0.0, 0.5, 1.0, 1.5, 2.3, 2.5, 9.0}) {
    const double s = std::min(1.0, std::max(0.0, (time - 0.5) / 2.0));
    EXPECT_NEAR(step.at(time), s * s * (3.0 - 2.0 * s), 1e-15) << time;
  }
  EXPECT_EQ(step.end(), 2.5);
}

/// Columns by name and by number, units of the header and of the scene; straight between the rows.
TEST(ReadHistory, OfColumnsHasTheRowsOfTheFile) {
  const ScratchFolder folder;
  folder.write("a.csv", "n,time [ms],a [%],b\n1,0,0,0\n2,10,50,3\n3,40,-100,-6\n");
  const auto read = [&](const std::string& keys) {
    const std::string path =
        folder.write("s.toml", scene_with("{ table = 'a.csv', " + keys + " }"));
    return read_scene_file(path).setup.scene.loads[0].history;
  };
  const std::vector<double> factor{0.0, 0.25, 0.5, 0.0, -1.0, -1.0};
  const History named = read("time = 'time', factor = 'a'");
  const History numbered = read("time = 2, factor = 4");
  const History given =
      read("time = 2, time_unit = 's', factor = 'a', factor_unit = '1', override_unit = true");
  for (std::size_t k = 0; k < factor.size(); ++k) {
    const double time = std::vector<double>{0.0, 5e-3, 0.01, 0.02, 0.04, 7.0}[k];
    EXPECT_NEAR(named.at(time), factor[k], 1e-15) << time;
    EXPECT_NEAR(numbered.at(time), 6.0 * factor[k], 1e-14) << time;
    EXPECT_NEAR(given.at(1e3 * time), 100.0 * factor[k], 1e-12) << time;
  }
}

/// The spline swings below 0 where straight lines stand still.
TEST(ReadHistory, OfRowsGoesStraightOrSmoothlyBetweenThem) {
  const std::string rows = "time = ['0 s', '1 s', '2 s', '3 s', '4 s'], factor = [0, 0, 1, 1, 1]";
  const History straight = history_of("{ " + rows + ", interpolation = 'linear' }");
  EXPECT_EQ(straight, history_of("{ " + rows + " }"));
  EXPECT_EQ(straight.at(1.5), 0.5);
  const History smooth = history_of("{ " + rows + ", interpolation = 'cubic' }");
  EXPECT_EQ(smooth, History::spline({0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, 0.0, 1.0, 1.0, 1.0}));
  EXPECT_LT(smooth.at(0.5), -0.01);
  const ScratchFolder folder;
  folder.write("a.csv", "time [s],a\n0,0\n1,0\n2,1\n3,1\n4,1\n");
  const std::string path = folder.write(
      "s.toml", scene_with("{ table = 'a.csv', time = 1, factor = 2, interpolation = 'cubic' }"));
  EXPECT_EQ(read_scene_file(path).setup.scene.loads[0].history, smooth);
}

const std::vector<std::string> kWords{
    "{ period = '0.7 s', cycles = 1.3, phase = '0.3 rad' }",
    "{ smooth_step = ['0.1 s', '0.4 s'] }",
    "{ time = ['0 s', '0.1 s', '0.3 s'], factor = [0, 0.3, 0.1], interpolation = 'cubic' }",
    "{ time = ['0 s', '0.1 s'], factor = [0, 0.3] }",
    "{ cycles = 2 }",
    "'ramp'"};

/// Loads, supports and gravity each keep theirs, to the last bit.
TEST(ReadHistory, ComesBackFromAResultFileAsItWas) {
  std::string text =
      "[[support]]\nat = 'start'\nkind = 'clamp'\n"
      "[gravity]\ny = '-9.81 m/s^2'\nhistory = " +
      kWords[0] + "\n";
  double place = 0.0;
  for (const std::string& words : kWords) {
    text += "[[load]]\nat = 'end'\nforce = ['0 N', '1 N', '0 N']\nhistory = " + words +
            "\n[[support]]\nat = " + std::to_string(place += 0.125) +
            "\nkind = 'elastic'\n"
            "stiffness = ['0 N/m', '1 N/m', '0 N/m']\n"
            "translation = ['0 m', '1 mm', '0 m']\nhistory = " +
            words + "\n";
  }
  const ScratchFolder folder;
  const SceneFile file = parse_scene_file(text, "s.toml");
  const Model model = prepare(file.setup.scene, file.setup.solver);
  write_scene_store(folder.file("out.h5"), make_scene_record(file, model, make_response(model)));
  const Scene read = read_scene_store(folder.file("out.h5")).setup.scene;
  const Scene& scene = file.setup.scene;
  EXPECT_EQ(read.gravity_history, scene.gravity_history);
  EXPECT_FALSE(read.gravity_history.slope.empty());
  ASSERT_EQ(read.loads.size(), kWords.size());
  for (std::size_t i = 0; i < kWords.size(); ++i) {
    EXPECT_EQ(read.loads[i].history, scene.loads[i].history) << kWords[i];
    EXPECT_EQ(read.supports[i + 1].history, scene.supports[i + 1].history) << kWords[i];
    EXPECT_EQ(read.loads[i].history.at(0.23), scene.loads[i].history.at(0.23)) << kWords[i];
  }
}

/// What a result keeps of its inputs is text that reads as the scene that ran.
TEST(ReadHistory, IsTheSameFromTheTextThatAResultKeeps) {
  const ScratchFolder folder;
  for (const std::string& words : kWords) {
    const SceneFile file = parse_scene_file(scene_with(words), "s.toml");
    const Model model = prepare(file.setup.scene, file.setup.solver);
    write_scene_store(folder.file("out.h5"), make_scene_record(file, model, make_response(model)));
    const auto inputs = read_scene_store(folder.file("out.h5")).inputs;
    ASSERT_EQ(inputs.size(), 1U);
    EXPECT_EQ(parse_scene_file(inputs[0].text, "s.toml").setup.scene.loads[0].history,
              file.setup.scene.loads[0].history);
  }
}

}  // namespace
}  // namespace plastica::io
