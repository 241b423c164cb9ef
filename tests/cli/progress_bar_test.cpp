#include "cli/progress_bar.hpp"

#include <gtest/gtest.h>

#include "cli/frame_progress.hpp"
#include "cli/motion_progress.hpp"

namespace plastica::cli {
namespace {

TEST(ProgressBar, CountsNoTimeForWhatAnEarlierRunHasDone) {
  EXPECT_EQ(ProgressBar::line("sweeping", 150, 0, 100, 200, 10.0),
            "sweeping [##################......] 150/200, 0 failed, 5/s, 0:00:10 left");
}

TEST(ProgressBar, TellsDoneFailedRateAndRemainingTime) {
  EXPECT_EQ(ProgressBar::line("fitting", 50, 2, 0, 200, 10.0),
            "fitting [######..................] 50/200, 2 failed, 5/s, 0:00:30 left");
  EXPECT_EQ(ProgressBar::line("fitting", 1, 0, 0, 10000, 1.5),
            "fitting [........................] 1/10000, 0 failed, 0.667/s, 4:09:59 left");
}

TEST(ProgressBar, TellsNoTimeBeforeThereIsARate) {
  EXPECT_EQ(ProgressBar::line("fitting", 0, 0, 0, 8, 0.0),
            "fitting [........................] 0/8, 0 failed, 0/s");
  EXPECT_EQ(ProgressBar::line("fitting", 0, 0, 0, 8, 2.0),
            "fitting [........................] 0/8, 0 failed, 0/s");
}

TEST(ProgressBar, IsFullAtTheEnd) {
  EXPECT_EQ(ProgressBar::line("fitting", 8, 8, 0, 8, 2.0),
            "fitting [########################] 8/8, 8 failed, 4/s");
  EXPECT_EQ(ProgressBar::line("fitting", 0, 0, 0, 0, 0.0),
            "fitting [########################] 0/0, 0 failed, 0/s");
}

TEST(FrameProgress, TellsDoneRemainingTimeAndRate) {
  EXPECT_EQ(FrameProgress::line(50, 200, 10.0),
            "frames [######..................] 50/200, 0:00:30 left, 5/s");
  EXPECT_EQ(FrameProgress::line(0, 200, 2.0), "frames [........................] 0/200");
  EXPECT_EQ(FrameProgress::line(200, 200, 10.0), "frames [########################] 200/200, 20/s");
}

TEST(MotionProgress, TellsPartRateAndRemainingTime) {
  EXPECT_EQ(MotionProgress::line(0.125, 0.5, 10.0),
            "simulating [######..................] 25.0 %, 0.125 of 0.5 s, 0.0125 s/s, "
            "0:00:30 left");
  EXPECT_EQ(MotionProgress::line(1e-3, 10.0, 1.5),
            "simulating [........................] 0.0 %, 0.001 of 10 s, 0.000667 s/s, "
            "4:09:59 left");
}

TEST(MotionProgress, TellsNoTimeBeforeThereIsARate) {
  EXPECT_EQ(MotionProgress::line(0.0, 0.5, 2.0),
            "simulating [........................] 0.0 %, 0 of 0.5 s");
}

TEST(MotionProgress, IsFullAtTheEnd) {
  EXPECT_EQ(MotionProgress::line(0.5, 0.5, 2.0),
            "simulating [########################] 100.0 %, 0.5 of 0.5 s, 0.25 s/s");
}

}  // namespace
}  // namespace plastica::cli
