#include "plastica/report/scene_frames.hpp"

#include <gtest/gtest.h>

#include "tests/support/motion_record.hpp"

namespace plastica::report {
namespace {

using plastica::testing::motion_record;

TEST(Frames, AreFoundByTheirTime) {
  const io::SceneRecord record = motion_record({.samples = 41, .frames = 5});  // 0, 50 … 200 ms
  EXPECT_EQ(frames_of(record), 5U);
  EXPECT_FALSE(keeps_all_frames(record));
  EXPECT_DOUBLE_EQ(time_of_frame(record, 1), 0.05);
  EXPECT_EQ(frame_at(record), 4U);
  EXPECT_EQ(frame_at(record, 0.0), 0U);
  EXPECT_EQ(frame_at(record, 0.07), 1U);
  EXPECT_EQ(frame_at(record, 0.08), 2U);
  EXPECT_EQ(frame_at(record, 7.0), 4U);
}

TEST(Frames, OfAFilmAreEvenInTimeAndEachThereOnce) {
  const io::SceneRecord record = motion_record({.samples = 41, .frames = 11});  // 0, 20 … 200 ms
  EXPECT_EQ(even_frames(record, 6, 0.0, 0.2), (std::vector<std::size_t>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(even_frames(record, 3, 0.1, 0.14), (std::vector<std::size_t>{5, 6, 7}));
  EXPECT_EQ(even_frames(record, 9, 0.1, 0.14), (std::vector<std::size_t>{5, 6, 7}));
  EXPECT_EQ(even_frames(record, 1, 0.0, 0.2), (std::vector<std::size_t>{10}));
}

TEST(Fragments, AreWhatTheCutsUpToATimeLeave) {
  const io::SceneRecord record = motion_record({.segments = 8});  // breaks at 80, cut at 140 ms
  EXPECT_EQ(fragments_at(record, 0.079), (std::vector<Fragment>{{0, 7}}));
  EXPECT_EQ(fragments_at(record, 0.081), (std::vector<Fragment>{{0, 3}, {4, 7}}));
  EXPECT_EQ(fragments_at(record, 0.2), record.response.chain.events.back().fragments);
}

TEST(Fragments, AreNotMadeByJointsThatHoldOrLetGoOfTheGround) {
  io::SceneRecord record = motion_record({.segments = 8});
  auto& events = record.response.chain.events;
  events.pop_back();
  events[0].joints[0].cut = false;
  EXPECT_EQ(fragments_at(record, 0.2).size(), 1U);
  for (const int joint : {0, 8}) {
    events[0].joints[0] = {joint, BreakCause::BendingX, true, 0.1, 0.1, {}, {}, 0.0};
    EXPECT_EQ(fragments_at(record, 0.2).size(), 1U) << joint;
    EXPECT_TRUE(cut_joints(record, 0.2)[static_cast<std::size_t>(joint)]);
  }
}

TEST(TimeText, HasTheUnitOfTheLargest) {
  EXPECT_EQ(time_text(0.0125, 2.0), "0.0125 s");
  EXPECT_EQ(time_text(0.0125, 0.2), "12.5 ms");
  EXPECT_EQ(time_text(1.25e-5, 1e-4), "12.5 µs");
  EXPECT_EQ(time_text(0.0, 0.0), "0 s");
}

}  // namespace
}  // namespace plastica::report
