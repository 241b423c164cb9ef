// Whether `plastica advise` keeps its word: the advised setting of many scenes against a run that
// is four times finer in every axis. PLASTICA_STUDY=full runs all, =sample a few.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "plastica/io/scene_file.hpp"
#include "sweeps/advise/advice.hpp"
#include "sweeps/advise/advice_text.hpp"
#include "sweeps/advise/watched_probes.hpp"

namespace plastica::studies {
namespace {

using namespace plastica::sweeps;

struct StudiedScene {
  std::string name;
  Setup setup;
};

/// The shipped scenes of beams.
std::vector<StudiedScene> shipped_scenes() {
  std::vector<StudiedScene> scenes;
  const std::filesystem::path folder = std::string(PLASTICA_SOURCE_DIR) + "/data/scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    Setup setup = io::read_scene_file(entry.path().string()).setup;
    if (!setup.scene.is_coupon()) scenes.push_back({entry.path().stem().string(), setup});
  }
  std::ranges::sort(scenes, {}, &StudiedScene::name);
  return scenes;
}

/// Scenes that take minutes: their breaks move along the beam, or their forces have no limit, so
/// that thousands of segments are tried. Whole studies run them alone.
bool takes_long(const std::string& name) {
  static const std::vector<std::string> kLong{"breaking_cantilever", "crash_bumper",
                                              "report_fig06_bent", "report_fig06_twisted",
                                              "report_proposal6_wear"};
  return std::ranges::find(kLong, name) != kLong.end();
}

/// How far what is advised is off the run that is four times finer in every axis, and richest in
/// every word.
Deviation true_error(const Setup& setup, const Advice& advice,
                     const std::vector<WatchedProbe>& watched) {
  std::vector<BatchCase> cases;
  for (const Setup& at : {advised_setup(setup, advice), finer_setup(setup, advice, 0.25)}) {
    cases.push_back({std::to_string(cases.size()), at.scene, at.solver});
  }
  const std::vector<BatchRow> rows = run_batch(cases);
  return deviation(outcome_of(rows[0], watched), outcome_of(rows[1], watched), watched);
}

/// The numbers, and the words that are others than the file's.
std::string advised_text(const Advice& advice) {
  std::string text = setting_text(advice.axes, advice.setting);
  for (std::size_t w = 0; w < advice.words.size(); ++w) {
    const WordAxis& axis = advice.word_axes[w];
    if (advice.words[w] != axis.own) text += ", " + axis.choices[advice.words[w]].text();
  }
  return text;
}

TEST(Advice, KeepsItsWord) {
  const char* study = std::getenv("PLASTICA_STUDY");
  const bool full = study != nullptr && std::string(study) == "full";
  int found = 0;
  int kept = 0;
  int far = 0;
  for (const StudiedScene& scene : shipped_scenes()) {
    if (!full && takes_long(scene.name)) continue;
    for (const double within : {0.05, 0.01, 0.002}) {
      if (!full && within < 0.05) continue;
      AdviceOptions options;
      options.within = within;
      const Advice advice = advise(scene.setup, options);
      std::string line = fmt::format("{:<26} {:4.1f} %", scene.name, 100.0 * within);
      if (advice.end != AdviceEnd::Found) {
        // What takes long may not converge at all; a bar that is shaken till it breaks does not
        // within 0.2 %.
        EXPECT_TRUE(takes_long(scene.name) || scene.name == "report_fig11_broken") << scene.name;
        fmt::print("{}  nothing in {} runs: {} {}\n", line, advice.runs, advised_text(advice),
                   advice.reason);
        std::fflush(stdout);
        continue;
      }
      const Deviation off =
          true_error(scene.setup, advice, watched_probes(scene.setup, {}).watched);
      ++found;
      kept += off.largest <= within ? 1 : 0;
      far += off.largest > 2.0 * within ? 1 : 0;
      fmt::print(
          "{}  promised {:7.4f} true {:7.4f} {} {} runs {} work x {:.3g}, own {:.4g} % {:.3g} ({}) "
          "{}\n",
          line, 100.0 * advice.promised, 100.0 * off.largest,
          off.largest <= within ? "    " : "MISS", advised_text(advice), advice.runs,
          static_cast<double>(advice.total_work) / static_cast<double>(advice.work),
          100.0 * advice.own.error,
          static_cast<double>(advice.own.work) / static_cast<double>(advice.work), off.quantity,
          off.reason);
      std::fflush(stdout);
    }
  }
  fmt::print("{} of {} kept\n", kept, found);
  EXPECT_GE(kept, 0.98 * found);
  EXPECT_EQ(far, 0);
}

}  // namespace
}  // namespace plastica::studies
