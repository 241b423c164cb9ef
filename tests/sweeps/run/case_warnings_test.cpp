#include "sweeps/run/case_warnings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "sweeps/run/sweep_run.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/sweeps/sweep_text.hpp"

namespace plastica::sweeps {
namespace {

using Texts = std::vector<std::string>;

/// A sweep of a clamped bar, 20 mm high and 10 mm wide unless it says otherwise.
Sweep sweep_of(const std::string& more, const std::string& rest,
               const std::string& section = "width = '10 mm', height = '20 mm'") {
  const io::ScratchFolder folder;
  folder.write("scene.toml",
               "beam = { length = '1 m', segments = 16, section = { shape = 'rectangle', " +
                   section +
                   " } }\n"
                   "material.name = 'S355'\nrules.yield_model = 'elastic'\n"
                   "[[support]]\nat = 'start'\nkind = 'clamp'\n"
                   "[[probe]]\nname = 'tip'\nkind = 'displacement'\n" +
                   more);
  return parse_sweep("scene = 'scene.toml'\n" + rest, folder.file("sweep.toml"));
}

Texts warnings_after(SweepRun& run, const Sweep& sweep) {
  const auto results = run.run();
  return case_warnings(sweep, run.cases(), results);
}

template <typename... Arguments>
Texts warnings_of(const Arguments&... arguments) {
  const Sweep sweep = sweep_of(arguments...);
  SweepRun run(sweep, {});
  return warnings_after(run, sweep);
}

const std::string kLoad = "[[load]]\nat = 'end'\nforce = ['0 N', '-10 N', '0 N']\n";
const std::string kTip = "[error]\nprobe = 'tip'\n";

bool has(const Texts& texts, const std::string& words) {
  return std::ranges::any_of(
      texts, [&](const std::string& text) { return text.find(words) != text.npos; });
}

TEST(CaseWarnings, AreNoneOfAPlainSweep) {
  EXPECT_EQ(warnings_of(kLoad, segments_axis("[4, 8]") + kTip), Texts{});
}

// Between three samples the load is at its peak.
TEST(CaseWarnings, AreThoseOfTheScenes) {
  const std::string peak = kLoad + "history = { turning_points = [1, 0] }\n";
  const std::string samples = "[[axis]]\nfield = 'solver.steps'\nvalues = [3, 5, 4]\n";
  const Texts warnings = warnings_of(peak, samples + kTip);
  ASSERT_EQ(warnings.size(), 1U);  // alike but for numbers
  EXPECT_TRUE(warnings[0].starts_with(
      "of 2 of 3 cases, at solver.steps 5: histories turn between two samples"))
      << warnings[0];
  EXPECT_TRUE(has(warnings_of(peak, "[set]\nsolver.steps = 3\n" + segments_axis("[4, 8]") + kTip),
                  "histories turn between two samples"));
}

// The clamp's joint yields at 16/3 times its cap over the length, 1.26 kN; at 6 times, 1.42 kN, the
// beam is a mechanism.
const std::string kPropped =
    "[[support]]\nat = 'end'\nkind = 'roller'\n"
    "[[load]]\nat = 0.5\nforce = ['0 N', '-1 kN', '0 N']\n";

std::string loads_axis(const std::string& values) {
  return "[set]\nrules.yield_model = 'interaction'\n[[axis]]\nfield = 'scale.loads'\nvalues = [" +
         values + "]\n" + kTip;
}

TEST(CaseWarnings, AreWhatOnlyARunShows) {
  const Texts warnings = warnings_of(kPropped, loads_axis("1.1, 1.35, 1"));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(warnings[0].starts_with("of 1 of 3 cases, at scale.loads 1.35: joints have yielded"))
      << warnings[0];
}

/// So many loads, from 1 kN to 1.4 kN; the upper third yields.
std::string many_loads(int count, int every) {
  std::string values;
  for (int i = 0; i < count; i += every) {
    values += (values.empty() ? "" : ", ") + std::to_string(1.0 + 0.4 * i / (count - 1));
  }
  return loads_axis(values);
}

EarlierResults earlier_of(const SweepRun& run, const std::vector<CaseResult>& results) {
  EarlierResults earlier;
  for (std::size_t i = 0; i < results.size(); ++i) earlier.emplace(run.ids()[i], results[i]);
  return earlier;
}

// Others are looked at where there are others.
TEST(CaseWarnings, OfResumedCasesAreThoseOfAFreshRun) {
  const Sweep first = sweep_of(kPropped, many_loads(41, 1));
  SweepRun run(first, {});
  const auto results = run.run();
  const EarlierResults earlier = earlier_of(run, results);
  const Sweep second = sweep_of(kPropped, many_loads(41, 2));
  SweepRun fresh(second, {});
  SweepRun resumed(second, {.earlier = earlier});
  EXPECT_GT(resumed.resumed(), 5U);
  const Texts warnings = warnings_after(fresh, second);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("cases that were looked at (of 21)"), std::string::npos)
      << warnings[0];
  EXPECT_EQ(warnings_after(resumed, second), warnings);
}

// A wider sweep watches fewer of the cases that it takes over.
TEST(CaseWarnings, OfResumedCasesThatAreNotWatchedNowAreNone) {
  const Sweep narrow = sweep_of(kPropped, many_loads(41, 2));
  SweepRun first(narrow, {});
  const auto narrow_results = first.run();
  const Sweep wide = sweep_of(kPropped, many_loads(41, 1));
  const auto fresh = SweepRun(wide, {}).run();
  const auto resumed = SweepRun(wide, {.earlier = earlier_of(first, narrow_results)}).run();
  ASSERT_EQ(resumed.size(), fresh.size());
  for (std::size_t i = 0; i < fresh.size(); ++i) EXPECT_EQ(resumed[i].warnings, fresh[i].warnings);
}

// Modes have none of a run; a load beyond 1.42 kN has no equilibrium.
TEST(CaseWarnings, KeepNoCaseFromBeingResumed) {
  for (const std::string rest :
       {"[error]\nquantity = 'natural_frequency'\n", "[error]\nquantity = 'loaded_frequency'\n",
        "[error]\nquantity = 'buckling_factor'\n", kTip.c_str()}) {
    const Sweep sweep =
        sweep_of(kPropped,
                 "[set]\nrules.yield_model = 'interaction'\n[[axis]]\nfield = 'scale.loads'\n"
                 "values = [0.1, 1.35, 1.6]\n" +
                     rest);
    SweepRun run(sweep, {});
    const auto results = run.run();
    EXPECT_EQ(SweepRun(sweep, {.earlier = earlier_of(run, results)}).resumed(), 3U) << rest;
  }
}

// The bar swings half as fast about its weak axis.
TEST(CaseWarnings, NameTheLowerFrequencyOutOfThePlane) {
  const std::string frequency = segments_axis("[64]") + "[error]\nquantity = 'natural_frequency'\n";
  const Texts warnings = warnings_of(kLoad, frequency);
  EXPECT_TRUE(has(warnings, "in space the unloaded beam has 8.35 Hz in place of 16.7 Hz"));
  EXPECT_FALSE(has(warnings_of(kLoad, frequency, "width = '20 mm', height = '10 mm'"), "in space"));
  EXPECT_FALSE(
      has(warnings_of(kLoad, "[set]\nsolver.level = 'spatial'\n" + frequency), "in space"));
  const std::string torque = "[[load]]\nat = 'end'\nmoment = ['0 N m', '0 N m', '1 N m']\n";
  EXPECT_TRUE(has(warnings_of(torque, frequency), "that of twisting alone"));
}

TEST(CaseWarnings, SayWhereARecordIsTooShortForAFrequency) {
  const auto lasting = [](const std::string& duration) {
    return warnings_of(
        "[solver]\nanalysis = 'dynamics'\ntime_step = '0.5 ms'\nsteps = 100\n"
        "duration = '" +
            duration + "'\n" + kLoad + "history = 'constant'\n",
        segments_axis("[16]") + kTip + "take = 'frequency'\n");
  };
  EXPECT_TRUE(has(lasting("0.1 s"), "the motion lasts 1.67 periods"));
  EXPECT_EQ(lasting("0.2 s"), Texts{});
}

}  // namespace
}  // namespace plastica::sweeps
