#include "calibrate/store/journaled_batch.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/fit/fitted_curve.hpp"
#include "calibrate/target/curve_spool.hpp"
#include "tests/calibrate/store/same_bits.hpp"
#include "tests/calibrate/store/synthetic_fits.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

namespace fs = std::filesystem;

/// A batch in a folder of its own, and what it gives if nothing interrupts it.
class JournaledBatchTest : public ::testing::Test {
 protected:
  /// Leaves a journal with all fits in it, as a run that was killed before it wrote its output.
  void leave_journal() {
    JournaledBatch batch(targets_, options_, {.journal = {journal_}, .threads = 1});
    batch.run();
  }
  /// Leaves a journal of a run that was stopped after some fits.
  void stop_after(std::size_t fits) {
    std::atomic<bool> stop = false;
    const auto progress = [&](const BatchProgress& p) { stop = p.done >= fits; };
    JournaledBatch batch(
        targets_, options_,
        {.journal = {journal_}, .threads = 1, .stop = &stop, .progress = progress});
    batch.run();
    EXPECT_FALSE(batch.complete());
  }

  io::ScratchFolder folder_;
  std::string journal_ = io::journal_path(folder_.file("out.h5"));
  std::vector<Target> targets_ = ideal_targets(9);
  FitOptions options_ = ideal_options();
  std::vector<FitResult> reference_ = fit(targets_, options_);
};

TEST_F(JournaledBatchTest, GivesTheSameBitsAsAPlainBatchForEveryNumberOfThreads) {
  for (const int threads : {1, 2, 3, 8}) {
    JournaledBatch batch(targets_, options_, {.journal = {journal_}, .threads = threads});
    EXPECT_TRUE(same_bits(batch.run(), reference_)) << threads;
    EXPECT_TRUE(batch.complete());
    batch.finish();
    EXPECT_FALSE(fs::exists(journal_));
  }
}

/// Whatever of the curves lies in memory, on the disk, or on both.
TEST_F(JournaledBatchTest, GivesTheSameBitsWhereCurvesArePutAside) {
  const std::string run = JournaledBatch(targets_, options_, {.journal = {journal_}}).run_id();
  for (const std::size_t in_memory : {0U, 4000U, 1U << 20U}) {
    for (const int threads : {1, 4}) {
      const auto spool = std::make_shared<CurveSpool>(folder_.file(""), in_memory);
      std::vector<Target> light = targets_;
      for (Target& target : light) put_aside(target, spool);
      EXPECT_EQ(light[0].corrected.size(), 0U);
      const auto result_of = [&](bool resume) {
        JournaledBatch batch(
            light, options_,
            {.journal = {journal_, resume}, .threads = threads, .counts_curves = true});
        EXPECT_EQ(batch.run_id(), run);
        EXPECT_EQ(batch.resumed(), resume ? light.size() : 0U);
        std::vector<FitResult> results = batch.run();
        EXPECT_TRUE(batch.complete());
        for (std::size_t i = 0; i < results.size(); ++i) {
          EXPECT_EQ(results[i].fitted.size(), 0U);
          EXPECT_EQ(results[i].fitted.samples(), reference_[i].fitted.size());
          results[i].fitted = remade_curve(light[i], options_, results[i]);
        }
        if (resume) batch.finish();
        return results;
      };
      EXPECT_TRUE(same_bits(result_of(false), reference_)) << in_memory << ' ' << threads;
      EXPECT_TRUE(same_bits(result_of(true), reference_)) << in_memory << ' ' << threads;
    }
  }
}

TEST_F(JournaledBatchTest, StartsAfreshWhereThereIsNothingToResume) {
  JournaledBatch batch(targets_, options_, {.journal = {journal_, true}});
  EXPECT_EQ(batch.resumed(), 0U);
  EXPECT_EQ(batch.resumptions(), 0);
  EXPECT_TRUE(same_bits(batch.run(), reference_));
}

// The means of a report are by group: a file whose groups have changed is not this run's.
TEST_F(JournaledBatchTest, IsAnotherRunWithOtherGroups) {
  const auto id_of = [&](const char* group) {
    std::vector<Target> targets = targets_;
    if (group != nullptr) targets[0].group = {{"lot", group}};
    return JournaledBatch(targets, options_, {.journal = {journal_}}).run_id();
  };
  EXPECT_EQ(id_of("A"), id_of("A"));
  EXPECT_NE(id_of("A"), id_of("B"));
  EXPECT_NE(id_of("A"), id_of(nullptr));
}

// Exports take what the fit's file says of the material, be it the default.
TEST_F(JournaledBatchTest, IsAnotherRunWhereTheFileSaysAnotherKey) {
  const auto id_of = [&](std::vector<std::string> stated) {
    FitOptions options = options_;
    options.stated = std::move(stated);
    return JournaledBatch(targets_, options, {.journal = {journal_}}).run_id();
  };
  EXPECT_EQ(id_of({"material.density"}), id_of({"material.density"}));
  EXPECT_NE(id_of({"material.density"}), id_of({}));
}

TEST_F(JournaledBatchTest, ResumesWithTheSameBitsWhereverTheJournalWasCut) {
  leave_journal();
  const std::string whole = io::content_of(journal_);
  std::size_t torn = 0;
  for (std::size_t cut = 0; cut <= 20; ++cut) {
    const std::size_t size = whole.size() * cut / 20;
    folder_.write("out.h5.journal", whole.substr(0, size));
    const int threads = static_cast<int>(cut % 3) + 1;
    JournaledBatch batch(targets_, options_, {.journal = {journal_, true}, .threads = threads});
    EXPECT_TRUE(same_bits(batch.run(), reference_)) << "cut at " << size;
    EXPECT_EQ(batch.stale(), 0U);
    if (batch.dropped_bytes() > 0) ++torn;
    if (cut == 20) {
      EXPECT_EQ(batch.resumed(), targets_.size());
      EXPECT_EQ(batch.dropped_bytes(), 0U);
    }
    batch.finish();
  }
  EXPECT_GT(torn, 15U);
}

// Whether a result has its evaluations depends on the size of a run: a journal of a smaller one has
// them, one of a larger one has not.
TEST_F(JournaledBatchTest, HasEvaluationsOrTheirNumberWhateverTheJournalHas) {
  FitOptions brief = options_;
  brief.keep_trace = false;
  const std::vector<FitResult> without = fit(targets_, brief);
  for (std::size_t i = 0; i < without.size(); ++i) {
    EXPECT_EQ(without[i].evaluations(), reference_[i].evaluations());
    EXPECT_TRUE(without[i].trace.costs.empty());
    EXPECT_TRUE(without[i].trace.values.empty());
    EXPECT_EQ(without[i].trace.active, reference_[i].trace.active);
    EXPECT_EQ(without[i].cost, reference_[i].cost);
  }
  leave_journal();
  {
    JournaledBatch grown(targets_, brief, {.journal = {journal_, true}});
    EXPECT_EQ(grown.resumed(), targets_.size());
    EXPECT_TRUE(same_bits(grown.run(), without));
    grown.finish();
  }
  {
    JournaledBatch large(targets_, brief, {.journal = {journal_}, .threads = 1});
    large.run();
  }
  const auto searched = static_cast<std::size_t>(std::ranges::count_if(
      reference_, [](const FitResult& result) { return result.evaluations() > 0; }));
  ASSERT_GT(searched, 5U);  // the others were rejected
  JournaledBatch shrunk(targets_, options_, {.journal = {journal_, true}});
  EXPECT_EQ(shrunk.resumed(), targets_.size() - searched);
  EXPECT_EQ(shrunk.stale(), searched);
  EXPECT_TRUE(same_bits(shrunk.run(), reference_));
}

TEST_F(JournaledBatchTest, ResumesAfterAStopWithTheSameBits) {
  stop_after(4);
  JournaledBatch batch(targets_, options_, {.journal = {journal_, true}});
  EXPECT_EQ(batch.resumed(), 4U);
  EXPECT_EQ(batch.resumptions(), 1);
  EXPECT_TRUE(same_bits(batch.run(), reference_));
}

TEST_F(JournaledBatchTest, CountsEachResumption) {
  stop_after(2);
  std::atomic<bool> stop = true;
  for (int resumption = 1; resumption <= 3; ++resumption) {
    JournaledBatch batch(targets_, options_, {.journal = {journal_, true}, .stop = &stop});
    EXPECT_EQ(batch.resumptions(), resumption);
    EXPECT_EQ(batch.resumed(), 2U);
    batch.run();
  }
}

TEST_F(JournaledBatchTest, SaysOfFitsThatAStopPreventedThatTheyWereNotRun) {
  std::atomic<bool> stop = true;
  JournaledBatch batch(targets_, options_, {.journal = {journal_}, .stop = &stop});
  const auto results = batch.run();
  ASSERT_EQ(results.size(), targets_.size());
  for (const FitResult& result : results) EXPECT_EQ(result.reason, "not run");
  EXPECT_THROW(batch.finish(), std::logic_error);
}

TEST_F(JournaledBatchTest, TakesFromTheJournalInWhateverOrderTheTargetsCome) {
  stop_after(5);
  std::reverse(targets_.begin(), targets_.end());
  std::reverse(reference_.begin(), reference_.end());
  JournaledBatch batch(targets_, options_, {.journal = {journal_, true}});
  EXPECT_EQ(batch.resumed(), 5U);
  EXPECT_TRUE(same_bits(batch.run(), reference_));
}

TEST_F(JournaledBatchTest, FitsAgainWhatHasChanged) {
  leave_journal();
  targets_[4].corrected.stress[9] *= 1.001;
  const auto expected = fit(targets_, options_);
  JournaledBatch batch(targets_, options_, {.journal = {journal_, true}});
  EXPECT_EQ(batch.resumed(), targets_.size() - 1);
  EXPECT_EQ(batch.stale(), 1U);
  EXPECT_TRUE(same_bits(batch.run(), expected));
  EXPECT_FALSE(same_bits(expected[4], reference_[4]));
}

TEST_F(JournaledBatchTest, FitsEverythingAgainWithOtherOptions) {
  leave_journal();
  options_.seed = 99;
  JournaledBatch batch(targets_, options_, {.journal = {journal_, true}});
  EXPECT_EQ(batch.resumed(), 0U);
  EXPECT_EQ(batch.stale(), targets_.size());
  EXPECT_TRUE(same_bits(batch.run(), fit(targets_, options_)));
}

TEST_F(JournaledBatchTest, RefusesToWriteOverTheJournalOfAnInterruptedRun) {
  stop_after(4);
  const std::string before = io::content_of(journal_);
  const auto begin = [&] { JournaledBatch(targets_, options_, {.journal = {journal_}}); };
  EXPECT_EQ(plastica::testing::message_of(begin),
            journal_ +
                ": is the journal of an interrupted run, with 4 finished fits: use --resume to go "
                "on or --force to start afresh");
  EXPECT_EQ(io::content_of(journal_), before);
}

TEST_F(JournaledBatchTest, StartsAfreshOverAJournalIfForced) {
  stop_after(4);
  JournaledBatch batch(targets_, options_, {.journal = {journal_, false, true}});
  EXPECT_EQ(batch.resumed(), 0U);
  EXPECT_TRUE(same_bits(batch.run(), reference_));
}

TEST_F(JournaledBatchTest, ResumesEvenIfForcedToWriteOverTheOutput) {
  stop_after(4);
  const JournaledBatch batch(targets_, options_, {.journal = {journal_, true, true}});
  EXPECT_EQ(batch.resumed(), 4U);
}

TEST_F(JournaledBatchTest, RefusesAJournalOfAnotherKindUnlessForced) {
  { const auto other = io::Journal::create(journal_, 12345); }
  const auto resume = [&] { JournaledBatch(targets_, options_, {.journal = {journal_, true}}); };
  EXPECT_NE(plastica::testing::message_of(resume).find("of another version"), std::string::npos);
  JournaledBatch batch(targets_, options_, {.journal = {journal_, true, true}});
  EXPECT_TRUE(same_bits(batch.run(), reference_));
}

TEST_F(JournaledBatchTest, NeverTouchesAFileThatIsNoJournal) {
  folder_.write("out.h5.journal", "my diary");
  const auto begin = [&] {
    JournaledBatch(targets_, options_, {.journal = {journal_, true, true}});
  };
  EXPECT_NE(plastica::testing::message_of(begin).find("is in the place of the journal"),
            std::string::npos);
  EXPECT_EQ(io::content_of(journal_), "my diary");
}

TEST_F(JournaledBatchTest, LeavesNoJournalOfARunThatFinishedNoFit) {
  options_.confidence = 2.0;
  {
    JournaledBatch batch(targets_, options_, {.journal = {journal_}, .threads = 1});
    EXPECT_THROW(batch.run(), InputError);
  }
  EXPECT_FALSE(fs::exists(journal_));
}

TEST_F(JournaledBatchTest, RefusesTwoTargetsOfOneName) {
  targets_[1].name = targets_[0].name;
  const auto begin = [&] { JournaledBatch(targets_, options_, {.journal = {journal_}}); };
  EXPECT_EQ(plastica::testing::message_of(begin),
            "bar-1.csv: name = bar-0: two targets of a batch have it");
}

TEST_F(JournaledBatchTest, ReportsItsProgressFitByFit) {
  stop_after(3);
  std::vector<std::size_t> done;
  BatchProgress last;
  const auto progress = [&](const BatchProgress& p) {
    done.push_back(p.done);
    last = p;
  };
  JournaledBatch batch(targets_, options_, {.journal = {journal_, true}, .progress = progress});
  batch.run();
  EXPECT_EQ(done, (std::vector<std::size_t>{3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(last.resumed, 3U);
  EXPECT_EQ(last.rejected, 1U);
  EXPECT_EQ(last.failed, 0U);
  EXPECT_EQ(last.total, 9U);
}

}  // namespace
}  // namespace plastica::calibrate
