#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/store/journaled_batch.hpp"
#include "plastica/io/team_journals.hpp"
#include "tests/calibrate/store/same_bits.hpp"
#include "tests/calibrate/store/synthetic_fits.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"
#include "tests/support/thread_team.hpp"

/// A batch that several processes do together, here by threads in place of processes.
namespace plastica::calibrate {
namespace {

namespace fs = std::filesystem;

class TeamBatch : public ::testing::Test {
 protected:
  /// What one process did, or its team.
  struct Ran {
    std::vector<FitResult> results;
    std::size_t resumed = 0;
    bool complete = false;
  };

  /// Runs the batch in a team. @param size  0: in one process without a team
  /// @param stop_after  fits of all but the last process: 0: none is stopped
  Ran run(std::size_t size, bool resume, std::size_t stop_after = 0, bool finish = true) {
    Ran ran;
    const auto work = [&](Team* team) {
      std::atomic<bool> stop = false;
      const auto progress = [&](const BatchProgress& p) {
        if (stop_after > 0 && p.done >= p.resumed + stop_after) stop = true;
      };
      JournaledBatch batch(targets_, options_,
                           {.journal = {.path = journal_, .resume = resume, .team = team},
                            .threads = 2,
                            .stop = &stop,
                            .progress = progress});
      std::vector<FitResult> results = batch.run();
      if (!batch.leads()) return;
      ran = {std::move(results), batch.resumed(), batch.complete()};
      if (ran.complete && finish) batch.finish();
    };
    if (size == 0) {
      work(nullptr);
    } else {
      rethrow(run_team(size, [&](Team& team) { work(&team); }));
    }
    return ran;
  }

  bool nothing_is_left() const {
    return !fs::exists(journal_) && io::team_journals_beside(journal_).empty();
  }

  io::ScratchFolder folder_;
  std::string journal_ = io::journal_path(folder_.file("out.h5"));
  std::vector<Target> targets_ = ideal_targets(13);
  FitOptions options_ = ideal_options();
  std::vector<FitResult> reference_ = fit(targets_, options_);
};

TEST_F(TeamBatch, GivesTheSameBitsAsOneProcess) {
  for (const std::size_t size : {1U, 2U, 3U, 8U, 20U}) {  // more than there are fits, too
    const Ran ran = run(size, false);
    EXPECT_TRUE(ran.complete) << size;
    EXPECT_TRUE(same_bits(ran.results, reference_)) << size;
    EXPECT_TRUE(nothing_is_left()) << size;
  }
}

// With another number of processes each time, or one without a team.
TEST_F(TeamBatch, GoesOnAfterAStopWithAnyNumberOfProcesses) {
  std::size_t done = 0;
  for (const std::size_t size : {3U, 2U, 0U}) {  // of 13 at most 2 each of a process
    const Ran ran = run(size, true, 1);
    EXPECT_FALSE(ran.complete) << size;
    EXPECT_GE(ran.resumed, done) << size;
    done = ran.resumed;
  }
  for (const std::size_t size : {2U, 0U}) {
    const Ran ran = run(size, true, 0, size == 0);  // kept, and found complete by the next
    EXPECT_TRUE(same_bits(ran.results, reference_)) << size;
    if (size == 0) {
      EXPECT_EQ(ran.resumed, targets_.size());
    }
  }
  EXPECT_TRUE(nothing_is_left());
}

// As after a kill: what each process has kept, and torn ends.
TEST_F(TeamBatch, TakesWhatEachProcessHasKept) {
  run(3, false, 0, false);
  const auto others = io::team_journals_beside(journal_);
  ASSERT_EQ(others.size(), 2U);
  fs::resize_file(others[1], fs::file_size(others[1]) - 1);
  const Ran ran = run(2, true);
  EXPECT_TRUE(same_bits(ran.results, reference_));
  EXPECT_TRUE(nothing_is_left());

  run(3, false, 0, false);
  fs::remove(journal_);  // that of the leader
  const Ran again = run(0, true);
  EXPECT_TRUE(same_bits(again.results, reference_));
  EXPECT_TRUE(nothing_is_left());
}

TEST_F(TeamBatch, RefusesToWriteOverTheJournalsOfAnother) {
  run(3, false, 0, false);
  const std::string refused =
      "is the journal of an interrupted run, with 13 finished fits: use --resume to go on or "
      "--force to start afresh";
  EXPECT_EQ(testing::message_of([&] { run(2, false); }), journal_ + ": " + refused);
  EXPECT_EQ(testing::message_of([&] { run(0, false); }), journal_ + ": " + refused);
  fs::remove(journal_);
  EXPECT_NE(testing::message_of([&] { run(0, false); }).find("--resume"), std::string::npos);
  EXPECT_EQ(io::team_journals_beside(journal_).size(), 2U);
}

TEST_F(TeamBatch, RefusesProcessesThatReadOtherCurves) {
  std::vector<Target> others = targets_;
  others[4].corrected.stress[9] *= 1.001;
  const auto work = [&](Team& team) {
    JournaledBatch batch(team.rank() == 1 ? others : targets_, options_,
                         {.journal = {.path = journal_, .team = &team}});
    batch.run();
  };
  EXPECT_EQ(testing::message_of([&] { rethrow(run_team(3, work)); }),
            "processes = 3: do not have the same inputs, options or version");
  EXPECT_TRUE(nothing_is_left());
}

TEST_F(TeamBatch, TellsItsLeaderHowFarAllAre) {
  std::mutex mutex;
  std::size_t most = 0;
  bool heard_of_others = false;
  rethrow(run_team(3, [&](Team& team) {
    const auto progress = [&, leads = team.leads(),
                           own = std::this_thread::get_id()](const BatchProgress& p) {
      const std::lock_guard lock(mutex);
      EXPECT_LE(p.done, p.total);
      if (!leads) return;
      most = std::max(most, p.done);
      heard_of_others = heard_of_others || std::this_thread::get_id() != own;
    };
    JournaledBatch batch(
        targets_, options_,
        {.journal = {.path = journal_, .team = &team}, .threads = 1, .progress = progress});
    batch.run();
  }));
  EXPECT_EQ(most, targets_.size());
  EXPECT_TRUE(heard_of_others);  // before the results of all are there
}

}  // namespace
}  // namespace plastica::calibrate
