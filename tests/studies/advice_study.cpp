// Whether `plastica advise` keeps its word: the advised settings of the corpus against runs that
// are four times finer in every axis, against closed forms, and their cost against the cheapest
// setting of a grid. PLASTICA_STUDY=full runs all, =truths all without the grid, =sample a few;
// =names lists the scenes, of which PLASTICA_STUDY_SCENE=NAME takes one.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sweeps/advise/advice.hpp"
#include "sweeps/advise/watched_probes.hpp"
#include "tests/studies/advice_corpus.hpp"

namespace plastica::studies {
namespace {

using namespace plastica::sweeps;

/// A tolerance that was asked for, and what came of it.
struct Trial {
  std::string scene;
  std::string group;
  double within = 0.0;
  Advice advice;
  double off_finer = 0.0;            ///< from a run four times finer in every axis [1]
  std::optional<double> off_form{};  ///< from the closed form, less what that leaves out [1]
  double grid_ratio = 0.0;           ///< work over that of the cheapest in the grid; 0: none
  std::string quantity{};            ///< whose error is the largest
  double off_own = 0.0;              ///< the file's own, from the same run [1]
  double own_cost = 0.0;             ///< of the file's own, over that of what is advised
};

std::string study() {
  const char* asked = std::getenv("PLASTICA_STUDY");
  return asked == nullptr ? "sample" : asked;
}

std::vector<Outcome> run_all(const std::vector<Setup>& setups,
                             const std::vector<WatchedProbe>& watched) {
  std::vector<BatchCase> cases;
  for (const Setup& setup : setups) {
    cases.push_back({std::to_string(cases.size()), setup.scene, setup.solver});
  }
  std::vector<Outcome> outcomes;
  for (const BatchRow& row : run_batch(cases)) outcomes.push_back(outcome_of(row, watched));
  return outcomes;
}

/// How far a run is off a closed form, over the largest size that a probe has in it, or over the
/// number; less what the form leaves out.
double off_closed_form(const ClosedForm& form, const Outcome& outcome,
                       const std::vector<WatchedProbe>& watched) {
  double value = std::numeric_limits<double>::quiet_NaN();
  double size = std::abs(form.value);
  for (const OneNumber& number : outcome.numbers) {
    if (number.name == form.of) value = number.value;
  }
  for (std::size_t k = 0; k < watched.size(); ++k) {
    if (watched[k].name != form.of || outcome.history[k].empty()) continue;
    value = outcome.history[k].back();
    for (const double each : outcome.history[k]) size = std::max(size, std::abs(each));
  }
  const double off = std::abs(std::abs(value) - std::abs(form.value)) / size;
  return std::isnan(off) ? std::numeric_limits<double>::infinity() : std::max(0.0, off - form.off);
}

/// All settings between the coarsest and twice as fine as one in each axis, by factors of `ratio`,
/// that do not take more work.
std::vector<Setting> grid_to(const Setup& setup, const Advice& finest, double ratio) {
  std::vector<Setting> grid{{}};
  for (std::size_t k = 0; k < finest.axes.size(); ++k) {
    const FinenessAxis& axis = finest.axes[k];
    const double last = axis.size(axis.scaled(finest.setting[k], 0.5));
    std::vector<Setting> longer;
    for (double value = axis.coarsest; axis.size(value) >= 0.999 * last;) {
      for (Setting setting : grid) {
        setting.push_back(value);
        longer.push_back(std::move(setting));
      }
      const double next = axis.scaled(value, 1.0 / ratio);
      if (next == value) break;
      value = next;
    }
    grid = std::move(longer);
  }
  // What is advised is within the tolerance: the cheapest is not dearer.
  constexpr double kDearer = 1.3;
  std::erase_if(grid, [&](const Setting& setting) {
    double work = 1.0;
    for (std::size_t k = 0; k < setting.size(); ++k) {
      work *= finest.axes[k].size(finest.setting[k]) / finest.axes[k].size(setting[k]);
    }
    return work > kDearer;
  });
  for (Setting& setting : grid) setting = taken_setting(setup, finest.axes, setting);
  std::ranges::sort(grid);
  grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
  return grid;
}

/// Work of the cheapest setting of a grid, with the advised words, that is within each tolerance of
/// the finest and richest; infinite where none is.
std::map<double, double> cheapest_in_grid(const Setup& setup, const Advice& finest,
                                          const std::vector<WatchedProbe>& watched,
                                          const std::vector<double>& tolerances) {
  const double ratio = finest.axes.size() <= 2 ? std::numbers::sqrt2 : 2.0;
  const Setup worded = setup_with(setup, finest.word_axes, finest.words);
  std::vector<Setup> setups;
  for (const Setting& setting : grid_to(worded, finest, ratio)) {
    setups.push_back(setup_at(worded, finest.axes, setting));
  }
  setups.push_back(finer_setup(setup, finest, 0.25));
  const std::vector<Outcome> outcomes = run_all(setups, watched);
  std::map<double, double> least;
  for (const double within : tolerances) least[within] = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < outcomes.size(); ++i) {
    const double off = deviation(outcomes[i], outcomes.back(), watched).largest;
    const double cost = kernel_cost(setups[i]) * static_cast<double>(outcomes[i].work);
    for (auto& [within, work] : least) {
      if (off <= within) work = std::min(work, cost);
    }
  }
  return least;
}

Trial try_one(const CorpusScene& scene, double within, const std::vector<WatchedProbe>& watched) {
  AdviceOptions options;
  options.within = within;
  Trial trial{.scene = scene.name,
              .group = scene.group,
              .within = within,
              .advice = advise(scene.setup, options)};
  if (trial.advice.end != AdviceEnd::Found) return trial;
  const std::vector<Outcome> outcomes =
      run_all({advised_setup(scene.setup, trial.advice),
               finer_setup(scene.setup, trial.advice, 0.25), scene.setup},
              watched);
  trial.off_own = deviation(outcomes[2], outcomes[1], watched).largest;
  trial.own_cost =
      static_cast<double>(outcomes[2].work) * kernel_cost(scene.setup) / trial.advice.cost;
  const Deviation off = deviation(outcomes[0], outcomes[1], watched);
  trial.off_finer = off.largest;
  trial.quantity = off.quantity + off.reason;
  if (scene.truth) trial.off_form = off_closed_form(*scene.truth, outcomes[0], watched);
  return trial;
}

/// What the advice cost, over a run of what is advised.
double overhead(const Trial& trial) {
  double cost = 0.0;
  for (const TriedSetting& one : trial.advice.tried) cost += one.cost;
  return cost / trial.advice.cost;
}

/// The name of a field without its table.
std::string_view key_of(const Field& field) {
  return std::string_view(field.path).substr(field.path.find('.') + 1);
}

/// The numbers, and the words that are others than the file's.
std::string advised_text(const Advice& advice) {
  std::string text;
  for (std::size_t k = 0; k < advice.axes.size(); ++k) {
    const Field& field = *advice.axes[k].field;
    const std::string_view unit = si_unit(field.dimension);
    text += fmt::format("{}{} {:.4g}{}", k == 0 ? "" : ", ", key_of(field), advice.setting[k],
                        unit == "1" ? "" : fmt::format(" {}", unit));
  }
  if (!advice.fractions.empty()) text += ", graded";
  for (std::size_t w = 0; w < advice.words.size(); ++w) {
    const WordAxis& axis = advice.word_axes[w];
    if (advice.words[w] == axis.own) continue;
    text += fmt::format(", {} {}", key_of(axis.field()), axis.choices[advice.words[w]].text());
  }
  return text;
}

double error_of(const Trial& trial) {
  return std::max(trial.off_finer, trial.off_form.value_or(0.0));
}

void print_line(const Trial& trial) {
  const Advice& advice = trial.advice;
  const std::string begin = fmt::format("{:<28} {:4.1f} %", trial.scene, 100.0 * trial.within);
  if (advice.end != AdviceEnd::Found) {
    fmt::print("{}  nothing in {} runs: {} {}\n", begin, advice.runs, advised_text(advice),
               advice.reason);
  } else {
    fmt::print(
        "{}  promised {:7.4f} true {:7.4f} form {:7.4f} {} {} runs {} work x {:.3g}, grid x {:.3g} "
        "({})\n",
        begin, 100.0 * advice.promised, 100.0 * trial.off_finer,
        100.0 * trial.off_form.value_or(0.0), error_of(trial) <= trial.within ? "    " : "MISS",
        advised_text(advice), advice.runs, overhead(trial), trial.grid_ratio, trial.quantity);
  }
  std::fflush(stdout);
}

double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return 0.0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1))];
}

/// A row of docs/accuracy.md for each scene that is shipped.
void print_shipped(const std::vector<Trial>& trials) {
  for (const Trial& t : trials) {
    if (t.group != "shipped") continue;
    const auto percent = [](double fraction) { return fmt::format("{:.2g} %", 100.0 * fraction); };
    if (t.advice.end != AdviceEnd::Found) {
      fmt::print("| {} | {} | none | | | | |\n", t.scene, percent(t.within));
      continue;
    }
    fmt::print("| {} | {} | {} | {} | {} | {} | {:.2g} |\n", t.scene, percent(t.within),
               advised_text(t.advice), percent(t.advice.promised), percent(error_of(t)),
               percent(t.off_own), 1.0 / t.own_cost);
  }
}

/// A row of the table for each group, and one for all.
void print_table(const std::vector<Trial>& trials) {
  std::vector<std::string> groups;
  for (const Trial& t : trials) {
    if (std::ranges::find(groups, t.group) == groups.end()) groups.push_back(t.group);
  }
  groups.emplace_back("all");
  fmt::print(
      "| scenes | asked | advised | within what was asked | worst true over promised | "
      "times the grid's cheapest: median, 90 % | work of the advice: median, 90 % |\n"
      "|---|---|---|---|---|---|---|\n");
  for (const std::string& group : groups) {
    int asked = 0;
    int found = 0;
    int kept = 0;
    double worst = 0.0;
    std::vector<double> ratios;
    std::vector<double> overheads;
    for (const Trial& t : trials) {
      if (group != "all" && t.group != group) continue;
      ++asked;
      if (t.advice.end != AdviceEnd::Found) continue;
      ++found;
      kept += error_of(t) <= t.within ? 1 : 0;
      worst = std::max(worst, error_of(t) / t.advice.promised);
      overheads.push_back(overhead(t));
      if (t.grid_ratio > 0.0) ratios.push_back(t.grid_ratio);
    }
    fmt::print("| {} | {} | {} | {} | {:.2f} | {:.2f}, {:.2f} | {:.1f}, {:.1f} |\n", group, asked,
               found, kept, worst, quantile(ratios, 0.5), quantile(ratios, 0.9),
               quantile(overheads, 0.5), quantile(overheads, 0.9));
  }
}

/// Scenes for which nothing can be advised: the force of an impact has no limit, a path fails, and
/// what breaks or wears out in fibres gathers in ever shorter joints; `flying` begins with a jump
/// of its velocity within the beam, which 0.2 % do not allow for.
bool has_no_advice(const std::string& scene) {
  static const std::vector<std::string> kNone{
      "broken_by_a_body",     "crash_bumper",        "flying",
      "report_fig06_twisted", "report_fig11_broken", "report_proposal6_wear"};
  return std::ranges::find(kNone, scene) != kNone.end();
}

/// Scenes that take minutes: their breaks move along the beam, or their forces have no limit, so
/// that thousands of segments are tried. The sample leaves them out.
bool takes_long(const CorpusScene& scene) {
  return has_no_advice(scene.name) || scene.name == "breaking_cantilever" ||
         scene.name == "report_fig06_bent" || scene.group.ends_with("breaking");
}

TEST(Advice, KeepsItsWord) {
  if (study() == "names") {
    for (const CorpusScene& scene : advice_corpus()) fmt::print("{}\n", scene.name);
    return;
  }
  const bool full = study() != "sample";
  const std::vector<double> tolerances = full ? std::vector{0.05, 0.01, 0.002} : std::vector{0.05};
  const char* only = std::getenv("PLASTICA_STUDY_SCENE");
  std::vector<Trial> trials;
  std::size_t number = 0;
  for (const CorpusScene& scene : advice_corpus()) {
    if (!full && (takes_long(scene) || number++ % 3 != 0)) continue;
    if (only != nullptr && scene.name != only) continue;
    const std::vector<WatchedProbe> watched = watched_probes(scene.setup, {}).watched;
    std::vector<Trial> of_scene;
    for (const double within : tolerances) of_scene.push_back(try_one(scene, within, watched));
    if (study() == "full" && of_scene.back().advice.end == AdviceEnd::Found) {
      const std::map<double, double> least =
          cheapest_in_grid(scene.setup, of_scene.back().advice, watched, tolerances);
      for (Trial& trial : of_scene) {
        if (trial.advice.end != AdviceEnd::Found) continue;
        trial.grid_ratio = trial.advice.cost / least.at(trial.within);
      }
    }
    for (const Trial& trial : of_scene) {
      print_line(trial);
      EXPECT_TRUE(trial.advice.end == AdviceEnd::Found || has_no_advice(scene.name)) << scene.name;
      trials.push_back(trial);
    }
  }
  print_shipped(trials);
  print_table(trials);
  int found = 0;
  int kept = 0;
  for (const Trial& trial : trials) {
    if (trial.advice.end != AdviceEnd::Found) continue;
    ++found;
    kept += error_of(trial) <= trial.within ? 1 : 0;
    EXPECT_LE(error_of(trial), 2.0 * trial.advice.promised) << trial.scene;
  }
  EXPECT_GE(kept, 0.98 * found);
}

}  // namespace
}  // namespace plastica::studies
