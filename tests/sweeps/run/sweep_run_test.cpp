#include "sweeps/run/sweep_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "sweeps/run/result_bytes.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"
#include "tests/sweeps/sweep_text.hpp"

namespace plastica::sweeps {
namespace {

/// A result without what may differ between two runs.
std::vector<std::byte> bits(CaseResult result) {
  result.seconds = 0.0;
  return bytes_of(result);
}

void expect_same_bits(const std::vector<CaseResult>& a, const std::vector<CaseResult>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(bits(a[i]), bits(b[i])) << "case " << i;
}

std::vector<CaseResult> run_plainly(const Sweep& sweep) { return SweepRun(sweep, {}).run(); }

class SweepRunTest : public ::testing::Test {
 protected:
  /// Runs with one thread until so many cases are done; leaves their journal.
  void stop_after(std::size_t cases) {
    std::atomic<bool> stop = false;
    SweepRunOptions options{.journal = {journal_}, .threads = 1, .stop = &stop};
    SweepRun run(sweep_, std::move(options));
    run.on_progress([&](const SweepProgress& progress) { stop = progress.done >= cases; });
    (void)run.run();
    EXPECT_FALSE(run.complete());
  }

  io::ScratchFolder folder_;
  std::string journal_ = io::journal_path(folder_.file("out.h5"));
  Sweep sweep_ = cantilever_sweep(segments_axis("[2, 3, 4, 5, 6, 7, 8]") + kTipError);
};

TEST_F(SweepRunTest, GivesTheSameBitsForEveryNumberOfThreads) {
  const auto reference = run_plainly(sweep_);
  for (const int threads : {1, 2, 5}) {
    SweepRunOptions options{.threads = threads};
    expect_same_bits(SweepRun(sweep_, std::move(options)).run(), reference);
  }
  EXPECT_EQ(reference[0].segments, 2);
  EXPECT_EQ(reference[0].status, Status::Completed);
  EXPECT_EQ(reference[0].segment_iterations(), 2 * reference[0].iterations);
}

TEST_F(SweepRunTest, GoesOnWithWhatIsMissing) {
  stop_after(3);
  SweepRun run(sweep_, {.journal = {journal_, true}});
  EXPECT_EQ(run.resumed(), 3U);
  std::size_t begun_with = 0;
  run.on_progress([&](const SweepProgress& progress) {
    if (begun_with == 0) begun_with = progress.done;
  });
  expect_same_bits(run.run(), run_plainly(sweep_));
  EXPECT_EQ(begun_with, 3U);
  EXPECT_EQ(run.journal()->resumptions(), 1);
  run.finish();
  EXPECT_FALSE(std::filesystem::exists(journal_));
}

TEST_F(SweepRunTest, TakesOnlyWhatIsStillTheSame) {
  stop_after(3);  // 2, 3 and 4 segments
  const Sweep other = cantilever_sweep(segments_axis("[4, 9, 2]") + kTipError);
  SweepRun run(other, {.journal = {journal_, true}});
  EXPECT_EQ(run.resumed(), 2U);
  expect_same_bits(run.run(), run_plainly(other));
}

TEST_F(SweepRunTest, LeavesTheWorkOfAnotherSweepAlone) {
  stop_after(3);
  const Sweep other = cantilever_sweep(segments_axis("[20]") + kTipError);
  EXPECT_EQ(plastica::testing::message_of([&] {
              SweepRun(other, {.journal = {journal_, true}});
            }),
            journal_ +
                ": has no case of this sweep, nor has its output: name another output, or use "
                "--force to start afresh");
  EXPECT_EQ(SweepRun(sweep_, {.journal = {journal_, true}}).resumed(), 3U);
}

TEST_F(SweepRunTest, TakesResultsOfAnEarlierOutput) {
  SweepRun first(sweep_, {});
  const auto results = first.run();
  EarlierResults earlier;
  for (std::size_t i = 0; i < results.size(); ++i) earlier[first.ids()[i]] = results[i];
  const Sweep wider = cantilever_sweep(segments_axis("[2, 3, 4, 5, 6, 7, 8, 9]") + kTipError);
  SweepRun run(wider, {.journal = {journal_}, .earlier = std::move(earlier)});
  EXPECT_EQ(run.resumed(), 7U);
  expect_same_bits(run.run(), run_plainly(wider));
}

TEST_F(SweepRunTest, RunsCasesOfTheSameContentOnce) {
  // 4 m of 20 mm: both round to 8 segments.
  const Sweep sweep = cantilever_sweep(
      "[[axis]]\nfield = 'beam.segment_depth'\nvalues = [25, 25.1, 50]\n" + kTipError);
  SweepRun run(sweep, {.journal = {journal_}, .threads = 1});
  std::vector<std::size_t> done;
  run.on_progress([&](const SweepProgress& progress) { done.push_back(progress.done); });
  const auto results = run.run();
  EXPECT_EQ(done, (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_TRUE(run.complete());
  EXPECT_EQ(bits(results[0]), bits(results[1]));
  EXPECT_EQ(results[1].segments, 8);
}

TEST_F(SweepRunTest, AdvisesForPathsAndMotionsWhatTheyHave) {
  const Sweep sweep = cantilever_sweep(
      "[set]\nsolver.steps = 1\nsolver.smallest_step = 1\nsolver.max_iterations = 1\n"
      "solver.time_step = '50 ms'\n"
      "[[axis]]\nfield = 'solver.analysis'\nvalues = ['statics', 'dynamics']\n" +
      kTipError);
  const auto results = SweepRun(sweep, {}).run();
  for (const CaseResult& result : results) EXPECT_EQ(result.status, Status::NotConverged);
  EXPECT_EQ(results[0].reason, "take more steps, or control = arc_length");
  EXPECT_TRUE(results[1].reason.starts_with("take smaller steps; ")) << results[1].reason;
}

TEST_F(SweepRunTest, KeepsAFailedCaseAsARowAndRunsItAgainWhenAsked) {
  // A tolerance that two iterations cannot meet.
  const Sweep sweep = cantilever_sweep(
      "[set]\nsolver.steps = 1\nsolver.smallest_step = 1\n"
      "[[axis]]\nfield = 'solver.max_iterations'\nvalues = [1, 25]\n" +
      kTipError);
  SweepRun first(sweep, {});
  const auto results = first.run();
  EXPECT_EQ(results[0].status, Status::NotConverged);
  EXPECT_FALSE(results[0].value.has_value());
  EXPECT_FALSE(results[0].reason.empty());
  EXPECT_EQ(results[1].status, Status::Completed);

  EarlierResults earlier;
  for (std::size_t i = 0; i < results.size(); ++i) earlier[first.ids()[i]] = results[i];
  SweepRun kept(sweep, {.earlier = earlier});
  EXPECT_EQ(kept.resumed(), 2U);
  SweepRun again(sweep, {.earlier = earlier, .rerun_failed = true});
  EXPECT_EQ(again.resumed(), 1U);
  expect_same_bits(again.run(), results);
}

TEST_F(SweepRunTest, MakesARejectedCaseARow) {
  const Sweep sweep = cantilever_sweep(
      "[[axis]]\nfield = 'section.shape'\nvalues = ['rectangle', 'round_tube']\n"
      "[[axis]]\nfield = 'section.inner_radius'\nvalues = ['40 mm', '60 mm']\n"
      "[[axis]]\nfield = 'section.radius'\nvalues = ['50 mm']\n[error]\nprobe = 'tip'\n");
  const auto results = run_plainly(sweep);
  EXPECT_EQ(results[3].status, Status::Rejected);
  EXPECT_NE(results[3].reason.find("section.inner_radius"), std::string::npos);
  EXPECT_EQ(results[2].status, Status::Completed);
}

TEST_F(SweepRunTest, TimesTheLeastOfSeveralRuns) {
  const Sweep sweep =
      cantilever_sweep(segments_axis("[50]") + kTipError + "[cost]\ntimed_runs = 3\n");
  const auto results = run_plainly(sweep);
  EXPECT_GT(results[0].seconds, 0.0);
}

TEST_F(SweepRunTest, MeasuresNaturalFrequencies) {
  const Sweep sweep = cantilever_sweep(segments_axis("[64]") +
                                       "[error]\nquantity = 'natural_frequency'\nmode = 2\n");
  const auto results = run_plainly(sweep);
  EXPECT_EQ(results[0].status, Status::Completed);
  // (4.694/1.875)^2 of the first, 1.044 Hz.
  EXPECT_NEAR(results[0].value.value_or(0.0), 6.545, 0.02);
}

TEST_F(SweepRunTest, MeasuresBucklingFactorsAndFrequenciesAboutTheLoadedState) {
  // A column of which half a segment at its clamp bends at half its length: P = 2 E I N^2
  // (1 - cos(pi/(2N))) (theory/lumped_chain.hpp), and its frequency falls to zero there.
  const auto value = [&](const std::string& quantity, double thrust) {
    Sweep sweep =
        cantilever_sweep(segments_axis("[16]") + "[error]\nquantity = '" + quantity + "'\n");
    sweep.setup.scene.loads = {{.force = {0.0, 0.0, -thrust}}};
    const auto results = run_plainly(sweep);
    EXPECT_EQ(results[0].status, Status::Completed) << results[0].reason;
    // A straight column takes no iteration, and is work all the same.
    EXPECT_GE(results[0].segment_iterations(), 16) << quantity;
    return results[0].value.value_or(0.0);
  };
  const double factor = value("buckling_factor", 1e-3);
  const double still = value("natural_frequency", 1e-3);
  EXPECT_NEAR(value("buckling_factor", 0.5e-3 * factor), 2.0, 1e-6);
  EXPECT_NEAR(value("loaded_frequency", 1e-9 * factor) / still, 1.0, 1e-6);
  // w = cos az - cosh bz and sin az - (a/b) sinh bz with a^2, b^2 = sqrt(p^2/4 + q^2) +- p/2, w'' =
  // w''' + p w' = 0 at the end: q = 0.72086155 times 3.5160153 at p = pi^2/8.
  EXPECT_NEAR(value("loaded_frequency", 0.5e-3 * factor) / still, 0.72086155, 3e-4);
  EXPECT_EQ(value("natural_frequency", 0.5e-3 * factor), still);
}

TEST(TakeOf, GivesOneNumberOfACurve) {
  const std::vector<double> time{0.0, 1.0, 3.0};
  const std::vector<double> values{1.0, -5.0, 3.0};
  const auto take = [&](Take how) { return take_of(how, time, values).value.value_or(0.0); };
  EXPECT_EQ(take(Take::End), 3.0);
  EXPECT_EQ(take(Take::Min), -5.0);
  EXPECT_EQ(take(Take::Max), 3.0);
  EXPECT_EQ(take(Take::Size), 5.0);
  EXPECT_DOUBLE_EQ(take(Take::Mean), (-2.0 - 2.0) / 3.0);
  EXPECT_FALSE(take_of(Take::Frequency, time, values).value.has_value());
  // Of a path beyond its peak.
  EXPECT_EQ(take_of(Take::Mean, std::vector{0.0, 2.0, 1.0}, values).reason,
            "the load falls along the path: there is nothing over it");
}

TEST(TakeOf, FindsTheFrequencyOfASine) {
  std::vector<double> time;
  std::vector<double> values;
  for (int i = 0; i < 512; ++i) {
    time.push_back(0.01 * i);
    values.push_back(std::sin(2.0 * 3.14159265358979 * 7.0 * time.back()));
  }
  EXPECT_NEAR(take_of(Take::Frequency, time, values).value.value_or(0.0), 7.0, 1e-3);
}

TEST(CaseResult, SaysWhichJointBreaks) {
  const Sweep sweep =
      parse_sweep("scene = '../scenes/breaking_cantilever.toml'\n" + segments_axis("[10, 20]") +
                      "[error]\nprobe = 'hinge'\ntake = 'size'\nagainst = 'finest'\n",
                  std::string(PLASTICA_SOURCE_DIR) + "/data/sweeps/test.toml");
  SweepRun run(sweep, {});
  for (const CaseResult& result : run.run()) {
    EXPECT_EQ(result.status, Status::Broken);
    EXPECT_EQ(result.break_joint, 0) << "that of the clamp";
    EXPECT_EQ(result.break_place, 0.0);
  }
  const Sweep whole = cantilever_sweep(segments_axis("[10]") + kTipError);
  const CaseResult intact = SweepRun(whole, {}).run().front();
  EXPECT_EQ(intact.break_joint, -1);
  EXPECT_FALSE(intact.break_place.has_value());
}

TEST(ResultBytes, AreReadBack) {
  CaseResult result;
  result.status = Status::Broken;
  result.reason = "why";
  result.level = Level::Planar;
  result.value = 1.5;
  result.time = {0.0, 1.0};
  result.curve = {2.0, 3.0};
  result.segments = 7;
  result.iterations = 9;
  result.last_value = -1.0;
  result.break_joint = 5;
  result.break_place = 5.0 / 7.0;
  result.seconds = 0.25;
  const CaseResult read = result_from_bytes(bytes_of(result));
  EXPECT_EQ(bytes_of(read), bytes_of(result));
  EXPECT_EQ(read.curve, result.curve);
  EXPECT_EQ(read.last_value, -1.0);
  EXPECT_EQ(read.break_joint, 5);
  EXPECT_EQ(read.break_place, 5.0 / 7.0);
  EXPECT_FALSE(read.standard_error.has_value());
}

}  // namespace
}  // namespace plastica::sweeps
