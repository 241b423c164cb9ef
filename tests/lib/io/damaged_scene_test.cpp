#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "plastica/io/scene_store.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"
#include "tests/support/motion_record.hpp"
#include "tests/support/scene_record.hpp"

namespace plastica::io {
namespace {

using plastica::testing::cantilever_text;
using plastica::testing::coupon_text;
using plastica::testing::message_of;
using plastica::testing::motion_record;
using plastica::testing::record_of;
using plastica::testing::swinging_text;

/// What is said of a record that is written as it should not be.
class DamagedScene : public ::testing::Test {
 protected:
  template <class Spoil>
  std::string refusal(SceneRecord record, const Spoil& spoil) const {
    spoil(record);
    write_scene_store(path_, record);
    const std::string message = message_of([&] { read_scene_store(path_); });
    return message.substr(std::min(message.size(), path_.size() + 2));
  }

  ScratchFolder folder_;
  std::string path_ = folder_.file("out.h5");
};

TEST_F(DamagedScene, OfACouponWithFewerStrainsThanSamplesIsRefused) {
  EXPECT_EQ(refusal(record_of(coupon_text()),
                    [](SceneRecord& record) { record.setup.scene.drive.strain.resize(1); }),
            "/drive/strain: must have a strain for each sample");
  EXPECT_EQ(refusal(record_of(coupon_text()),
                    [](SceneRecord& record) { record.setup.scene.drive.strain.clear(); }),
            "/drive/strain: must be there for a coupon, and not for a beam");
  EXPECT_EQ(refusal(record_of(coupon_text()),
                    [](SceneRecord& record) { record.response.event->sample = 1U << 20U; }),
            "/coupon_break/sample: must be a sample of the drive");
}

TEST_F(DamagedScene, WhoseBeamIsNoneIsRefused) {
  const SceneRecord beam = record_of(cantilever_text());
  EXPECT_EQ(refusal(beam, [](SceneRecord& record) { record.outline.ends[1] = 0.0; }),
            "/beam/ends: must rise from each to the next");
  EXPECT_EQ(refusal(beam, [](SceneRecord& record) { record.outline.ends[4] = 0.9; }),
            "/beam/ends: must begin with 0, end with 1");
  EXPECT_EQ(refusal(beam, [](SceneRecord& record) { record.outline.width[0] = 0.0; }),
            "/beam/width = 0: must be above 0");
  EXPECT_EQ(refusal(beam, [](SceneRecord& record) { record.outline.node[3] = NAN; }),
            "/beam/node = nan: must be finite");
  EXPECT_EQ(refusal(beam, [](SceneRecord& record) { record.setup.scene.beam.segments = 5; }),
            "/beam/width: must have a row for each of beam.segments");
  EXPECT_EQ(refusal(beam, [](SceneRecord& record) { record.level = Level::Coupon; }),
            "/scene/level: must be coupon for a coupon alone");
}

TEST_F(DamagedScene, WhoseNumbersAreOutOfTheirRangeIsRefused) {
  const SceneRecord beam = record_of(cantilever_text());
  EXPECT_EQ(refusal(beam, [](SceneRecord& record) { record.response.chain.moment[4] = INFINITY; }),
            "/joints/moment = inf: must be finite");
  EXPECT_EQ(refusal(beam, [](SceneRecord& record) { record.response.chain.iterations[2] = -1; }),
            "/path/iterations = -1: must be from 0 to 2147483647");
  EXPECT_EQ(refusal(beam, [](SceneRecord& record) { record.outline.round[2] = 2; }),
            "/beam/round = 2: must be 0 or 1");
  EXPECT_EQ(refusal(beam,
                    [](SceneRecord& record) {
                      record.setup.scene.probes[0].at = {1.5, {}};
                    }),
            "/probes/at = 1.5: must be from 0 to 1");
  const SceneRecord motion = motion_record({.segments = 4, .samples = 11, .frames = 3});
  for (const double time : {9.0, -1.0}) {
    EXPECT_EQ(refusal(motion, [&](SceneRecord& record) { record.response.chain.time[0] = time; }),
              "/path/time: must rise from 0 on in a motion");
  }
}

TEST_F(DamagedScene, WhoseVelocitiesAreOfOtherFramesOrSegmentsIsRefused) {
  const SceneRecord motion = record_of(swinging_text());
  EXPECT_EQ(refusal(motion, [](SceneRecord& record) { record.response.chain.velocity[7] = NAN; }),
            "/segments/velocity = nan: must be finite");
  EXPECT_EQ(refusal(motion, [](SceneRecord& record) { record.response.chain.spin[7] = INFINITY; }),
            "/segments/spin = inf: must be finite");
  EXPECT_EQ(refusal(motion, [](SceneRecord& record) { record.response.chain.spin.clear(); }),
            "/segments/spin: must be there beside segments/velocity");
  EXPECT_EQ(refusal(motion, [](SceneRecord& record) { record.response.chain.velocity.clear(); }),
            "/segments/velocity: must be there beside segments/spin");
  // Written behind a record that has none.
  const auto refusal_of = [&](const char* path, std::vector<std::size_t> shape,
                              const std::string& text) {
    SceneRecord without = record_of(text);
    without.response.chain.velocity.clear();
    without.response.chain.spin.clear();
    write_scene_store(path_, without, Overwrite::Allowed, [&](Hdf5Group& root) {
      const std::vector<double> zeros(shape[0] * shape[1] * shape[2]);
      const std::vector<std::size_t> right{6, 4, 3};
      for (const char* other : {"segments/velocity", "segments/spin"}) {
        const bool spoiled = std::string(path) == other;
        const std::vector<double> fitting(6U * 4U * 3U);
        root.write_array<double>(other, spoiled ? zeros : fitting, spoiled ? shape : right);
      }
    });
    const std::string message = message_of([&] { read_scene_store(path_); });
    return message.substr(std::min(message.size(), path_.size() + 2));
  };
  for (const char* path : {"segments/velocity", "segments/spin"}) {
    for (const std::vector<std::size_t>& shape : std::vector<std::vector<std::size_t>>{
             {5, 4, 3}, {6, 5, 3}, {6, 4, 2}, {4, 6, 3}, {0, 4, 3}}) {
      EXPECT_EQ(refusal_of(path, shape, swinging_text()),
                "/" + std::string(path) + ": must have the extents 6 x 4 x 3");
    }
  }
  EXPECT_EQ(refusal_of("segments/none", {0, 0, 0}, cantilever_text()),
            "/segments/velocity: must not be there: the beam is at rest");
}

}  // namespace
}  // namespace plastica::io
