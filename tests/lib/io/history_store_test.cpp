#include <gtest/gtest.h>

#include "plastica/io/scene_reader.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"

namespace plastica::io {
namespace {

using plastica::testing::message_of;

/// The histories of two loads, the first from 0 to 1 in a second.
class HistoryStore : public ::testing::Test {
 protected:
  std::vector<Load> read(const std::vector<std::uint8_t>& continues,
                         const std::vector<double>& second_time = {0.0, 2.0},
                         const std::vector<std::vector<double>>& slopes = {}) const {
    Hdf5File file = Hdf5File::create(path_, Overwrite::Allowed);
    Hdf5Group& root = file.root();
    Ragged<double> time;
    Ragged<double> factor;
    time.push_back(std::vector<double>{0.0, 1.0});
    time.push_back(second_time);
    factor.push_back(std::vector<double>{0.0, 1.0});
    factor.push_back(std::vector<double>(second_time.size(), 1.0));
    root.write_ragged("loads/history/time", time, {"s"});
    root.write_ragged("loads/history/factor", factor, {"1"});
    if (!slopes.empty()) {
      Ragged<double> slope;
      for (const auto& row : slopes) slope.push_back(row);
      root.write_ragged("loads/history/slope", slope, {"1/s"});
    }
    if (!continues.empty()) root.write("loads/history/continues", continues);
    file.commit();
    const Hdf5File written = Hdf5File::open(path_);
    SceneReader reader(written.root());
    std::vector<Load> loads(2);
    reader.histories("loads/history", loads);
    return loads;
  }

  ScratchFolder folder_;
  std::string path_ = folder_.file("out.h5");
};

TEST_F(HistoryStore, SaysWhetherAHistoryGoesOn) {
  const std::vector<Load> loads = read({0, 1});
  EXPECT_EQ(loads[0].history.at(3.0), 1.0);
  EXPECT_FALSE(loads[0].history.continues);
  EXPECT_TRUE(loads[1].history.continues);
}

TEST_F(HistoryStore, ReadsFilesThatDoNotSayAsTheyRan) {
  const std::vector<Load> loads = read({});
  EXPECT_EQ(loads[0].history, History::ramp());
  EXPECT_FALSE(loads[1].history.continues);
}

TEST_F(HistoryStore, RefusesWhatHasNoLineToGoOnAlong) {
  EXPECT_EQ(message_of([&] {
              read({0, 1}, {0.0});
            }),
            path_ +
                ": /loads/history/continues = 1: needs two times at least, which make the "
                "line");
  EXPECT_EQ(message_of([&] {
              read({0, 2});
            }),
            path_ + ": /loads/history/continues = 2: must be 0 or 1");
}

TEST_F(HistoryStore, ReadsTheSlopesOfSmoothHistories) {
  const std::vector<Load> loads = read({0, 0}, {0.0, 2.0}, {{}, {0.5, -0.25}});
  EXPECT_TRUE(loads[0].history.slope.empty());
  EXPECT_EQ(loads[1].history.slope, (std::vector<double>{0.5, -0.25}));
}

TEST_F(HistoryStore, RefusesSlopesThatDoNotFit) {
  EXPECT_EQ(message_of([&] {
              read({0, 0}, {0.0, 2.0}, {{}, {0.5}});
            }),
            path_ + ": /loads/history/slope: must have a slope for each time, or none");
  EXPECT_EQ(message_of([&] {
              read({0, 0}, {0.0, 2.0}, {{}});
            }),
            path_ + ": /loads/history/slope: does not have a history for each row");
  EXPECT_EQ(message_of([&] {
              read({0, 1}, {0.0, 2.0}, {{}, {0.5, 0.5}});
            }),
            path_ + ": /loads/history/continues = 1: must be 0 of a history with slopes");
}

}  // namespace
}  // namespace plastica::io
