#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "plastica/io/journal.hpp"
#include "plastica/io/team_journals.hpp"
#include "sweeps/run/result_bytes.hpp"
#include "sweeps/run/sweep_run.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/thread_team.hpp"
#include "tests/sweeps/sweep_text.hpp"

/// A sweep that several processes do together, here by threads in place of processes.
namespace plastica::sweeps {
namespace {

class TeamSweep : public ::testing::Test {
 protected:
  struct Ran {
    std::vector<CaseResult> results;
    std::size_t resumed = 0;
    bool complete = false;
  };

  enum class Finish { No, Yes };

  /// @param size  0: in one process without a team
  Ran run(std::size_t size, bool resume, std::size_t stop_after = 0, bool rerun_failed = false,
          Finish finish = Finish::Yes) {
    Ran ran;
    const auto work = [&](Team* team) {
      std::atomic<bool> stop = false;
      SweepRun run(sweep_, {.journal = {.path = journal_, .resume = resume, .team = team},
                            .rerun_failed = rerun_failed,
                            .threads = 1,
                            .stop = &stop});
      run.on_progress([&](const SweepProgress& p) {
        if (stop_after > 0 && p.done >= p.resumed + stop_after) stop = true;
      });
      std::vector<CaseResult> results = run.run();
      if (!run.leads()) return;
      ran = {std::move(results), run.resumed(), run.complete()};
      if (ran.complete && finish == Finish::Yes) run.finish();
    };
    if (size == 0) {
      work(nullptr);
    } else {
      rethrow(run_team(size, [&](Team& team) { work(&team); }));
    }
    return ran;
  }

  void expect_reference(const Ran& ran) const {
    EXPECT_TRUE(ran.complete);
    ASSERT_EQ(ran.results.size(), reference_.size());
    for (std::size_t i = 0; i < reference_.size(); ++i) {
      CaseResult result = ran.results[i];
      CaseResult expected = reference_[i];
      result.seconds = expected.seconds = 0.0;
      EXPECT_EQ(bytes_of(result), bytes_of(expected)) << "case " << i;
    }
    EXPECT_FALSE(std::filesystem::exists(journal_));
    EXPECT_TRUE(io::team_journals_beside(journal_).empty());
  }

  io::ScratchFolder folder_;
  std::string journal_ = io::journal_path(folder_.file("out.h5"));
  Sweep sweep_ = cantilever_sweep(segments_axis("[2, 3, 4, 5, 6, 7, 8, 9, 10]") + kTipError);
  std::vector<CaseResult> reference_ = SweepRun(sweep_, {}).run();
};

TEST_F(TeamSweep, GivesTheSameBitsAsOneProcess) {
  for (const std::size_t size : {1U, 2U, 3U, 12U}) expect_reference(run(size, false));
}

TEST_F(TeamSweep, GoesOnAfterAStopWithAnyNumberOfProcesses) {
  EXPECT_FALSE(run(2, true, 1).complete);
  EXPECT_FALSE(run(0, true, 1).complete);
  expect_reference(run(4, true));
}

// A case that has failed before and is to run again, but does not because of a stop, is not done.
TEST_F(TeamSweep, DoesNotCountWhatItShouldRunAgainAsDone) {
  run(2, false, 0, false, Finish::No);
  { const SweepRun fold(sweep_, {.journal = {.path = journal_, .resume = true}}); }
  const io::JournalContent content = io::read_any_journal(journal_);
  const io::JournalRecord& failed = content.records.back();
  CaseResult result = result_from_bytes(failed.payload);
  result.status = Status::NotConverged;
  {
    io::Journal journal = io::Journal::resume(journal_, content.run_digest, content);
    journal.append(failed.id, bytes_of(result));
  }
  rethrow(run_team(2, [&](Team& team) {
    std::atomic<bool> stop = true;
    SweepRun again(sweep_, {.journal = {.path = journal_, .resume = true, .team = &team},
                            .rerun_failed = true,
                            .threads = 1,
                            .stop = &stop});
    EXPECT_LT(again.resumed(), sweep_.axes.front().values.size());
    (void)again.run();
    EXPECT_FALSE(again.complete());
  }));
  expect_reference(run(2, true, 0, true));
}

}  // namespace
}  // namespace plastica::sweeps
