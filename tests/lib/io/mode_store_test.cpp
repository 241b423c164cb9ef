#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "plastica/io/scene_store.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/scene_record.hpp"

namespace plastica::io {
namespace {

using plastica::testing::cantilever_text;
using plastica::testing::record_of;

TEST(ModeStore, ReadsTheBifurcationsOfAPathBack) {
  // Twice the load under which the column buckles, pi^2/4 E I/L^2 = 6.9 kN.
  const SceneRecord record = record_of(cantilever_text("0 N", R"([[load]]
at = "end"
force = ["0 N", "0 N", "-14 kN"]
)"));
  EXPECT_EQ(record.response.status, Status::Unstable);
  ASSERT_TRUE(record.response.critical);
  EXPECT_EQ(record.response.critical->mode.size(), record.response.critical->factor.size() * 5 * 3);
  const ScratchFolder folder;
  const std::string path = folder.file("out.h5");
  write_scene_store(path, record);
  const SceneRecord read = read_scene_store(path);
  EXPECT_EQ(read.response.status, Status::Unstable);
  ASSERT_TRUE(read.response.critical);
  EXPECT_EQ(read.response.critical->factor, record.response.critical->factor);
  EXPECT_EQ(read.response.critical->below, record.response.critical->below);
  EXPECT_EQ(read.response.critical->above, record.response.critical->above);
  EXPECT_EQ(read.response.critical->unstable_modes, record.response.critical->unstable_modes);
  EXPECT_EQ(read.response.critical->out_of_plane, record.response.critical->out_of_plane);
  EXPECT_EQ(read.response.critical->mode, record.response.critical->mode);
}

TEST(ModeStore, ReadsBucklingAndVibrationBack) {
  SceneRecord record = record_of(cantilever_text("0 N", R"([[load]]
at = "end"
force = ["0 N", "0 N", "-1 kN"]
)"));
  EXPECT_FALSE(record.response.buckling || record.response.vibration);
  const std::vector<double> modes(2 * 5 * 3, 0.25);
  record.response.buckling = BucklingModes{1.0, {6.9, 60.0}, {0.0, 0.25}, {0, 1}, modes};
  record.response.vibration = VibrationModes{{1.5, 9.5}, modes};
  record.response.limit = LimitLoad{0.5, 0.6, std::vector<double>(15, 0.5)};
  const ScratchFolder folder;
  const std::string path = folder.file("out.h5");
  write_scene_store(path, record);
  const SceneRecord read = read_scene_store(path);
  ASSERT_TRUE(read.response.buckling && read.response.vibration && read.response.limit);
  EXPECT_EQ(read.response.buckling->about, 1.0);
  EXPECT_EQ(read.response.buckling->factor, record.response.buckling->factor);
  EXPECT_EQ(read.response.buckling->rotation, record.response.buckling->rotation);
  EXPECT_EQ(read.response.buckling->out_of_plane, record.response.buckling->out_of_plane);
  EXPECT_EQ(read.response.buckling->mode, modes);
  EXPECT_EQ(read.response.vibration->frequency, record.response.vibration->frequency);
  EXPECT_EQ(read.response.vibration->mode, modes);
  EXPECT_EQ(read.response.limit->mode, record.response.limit->mode);
}

}  // namespace
}  // namespace plastica::io
