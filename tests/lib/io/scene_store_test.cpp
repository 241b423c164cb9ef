#include "plastica/io/scene_store.hpp"

#include <gtest/gtest.h>

#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"
#include "tests/support/scene_record.hpp"

namespace plastica::io {
namespace {

using plastica::testing::cantilever_text;
using plastica::testing::coupon_text;
using plastica::testing::message_of;
using plastica::testing::record_of;

class SceneStore : public ::testing::Test {
 protected:
  SceneRecord stored(const SceneRecord& record) const {
    write_scene_store(path_, record);
    return read_scene_store(path_);
  }

  ScratchFolder folder_;
  std::string path_ = folder_.file("out.h5");
};

void expect_same_chain(const ChainHistory& a, const ChainHistory& b) {
  EXPECT_EQ(a.joints, b.joints);
  EXPECT_EQ(a.supports, b.supports);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.factor, b.factor);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.moment, b.moment);
  EXPECT_EQ(a.force, b.force);
  EXPECT_EQ(a.angle, b.angle);
  EXPECT_EQ(a.plastic_angle, b.plastic_angle);
  EXPECT_EQ(a.rotation, b.rotation);
  EXPECT_EQ(a.plastic_strain, b.plastic_strain);
  EXPECT_EQ(a.stress, b.stress);
  EXPECT_EQ(a.reaction, b.reaction);
  ASSERT_EQ(a.energy.size(), b.energy.size());
  for (std::size_t i = 0; i < a.energy.size(); ++i) {
    EXPECT_EQ(a.energy[i].elastic, b.energy[i].elastic);
    EXPECT_EQ(a.energy[i].plastic, b.energy[i].plastic);
    EXPECT_EQ(a.energy[i].external, b.energy[i].external);
    EXPECT_EQ(a.energy[i].residual, b.energy[i].residual);
  }
}

TEST_F(SceneStore, ReadsAChainBackBitByBit) {
  SceneRecord record = record_of(cantilever_text());
  record.response.seconds = 0.25;
  const SceneRecord read = stored(record);
  EXPECT_EQ(read.level, Level::Planar);
  EXPECT_EQ(read.level_reason, record.level_reason);
  EXPECT_EQ(read.warnings, record.warnings);
  EXPECT_EQ(read.setup.scene.name, "beam");
  for (const Field& field : fields()) {
    EXPECT_EQ(field.get(read.setup), field.get(record.setup)) << field.path;
  }
  EXPECT_EQ(read.inputs.at(0).name, "beam.toml");
  EXPECT_EQ(read.inputs.at(0).text, cantilever_text());
  EXPECT_EQ(read.response.status, Status::Completed);
  EXPECT_EQ(read.response.samples, 6U);
  EXPECT_EQ(read.response.probes, record.response.probes);
  EXPECT_EQ(read.response.permanent_strain, record.response.permanent_strain);
  EXPECT_EQ(read.response.counters.iterations, record.response.counters.iterations);
  EXPECT_EQ(read.response.seconds, 0.25);
  EXPECT_FALSE(read.response.limit || read.response.event || !read.response.chain.events.empty());
  expect_same_chain(read.response.chain, record.response.chain);
}

TEST_F(SceneStore, ReadsTheBeamAndWhatActsOnItBack) {
  const SceneRecord record = record_of(cantilever_text("-100 N", R"([[load]]
at = 0.25
to = "end"
moment = ["1 N m/m", "0 N m/m", "0 N m/m"]
follows = true
history = { time = ["0 s", "2 s", "3 s"], factor = [0, 1, 0.5] }
[[support]]
at = "end"
kind = "pillar"
normal = "y"
gap = "1 m"
)"));
  const SceneRecord read = stored(record);
  EXPECT_EQ(read.outline.ends, record.outline.ends);
  EXPECT_EQ(read.outline.node, record.outline.node);
  EXPECT_EQ(read.outline.axes, record.outline.axes);
  EXPECT_EQ(read.outline.modulus, record.outline.modulus);
  EXPECT_EQ(read.outline.strain_per_angle, record.outline.strain_per_angle);
  EXPECT_EQ(read.outline.round, record.outline.round);
  const Scene& scene = read.setup.scene;
  ASSERT_EQ(scene.loads.size(), 2U);
  EXPECT_EQ(scene.loads[0].at.fraction, 1.0);  // given as the end of segment 4
  EXPECT_FALSE(scene.loads[0].at.segment || scene.loads[0].to);
  EXPECT_EQ(scene.loads[1].at.fraction, 0.25);
  EXPECT_EQ(scene.loads[1].to->fraction, 1.0);
  EXPECT_EQ(scene.loads[1].moment, (std::array<double, 3>{1.0, 0.0, 0.0}));
  EXPECT_TRUE(scene.loads[1].follows && !scene.loads[0].follows);
  EXPECT_EQ(scene.loads[1].history.time, (std::vector<double>{0.0, 2.0, 3.0}));
  EXPECT_EQ(scene.loads[1].history.factor, (std::vector<double>{0.0, 1.0, 0.5}));
  ASSERT_EQ(scene.supports.size(), 2U);
  EXPECT_EQ(scene.supports[0].kind, SupportKind::Clamp);
  EXPECT_EQ(scene.supports[0].held(), (HeldFreedoms{true, true, true, true, true, true}));
  EXPECT_EQ(scene.supports[1].kind, SupportKind::Pillar);
  EXPECT_EQ(scene.supports[1].gap, 1.0);
  ASSERT_EQ(scene.probes.size(), 2U);
  EXPECT_EQ(scene.probes[1].name, "root");
  EXPECT_EQ(scene.probes[1].quantity, ProbeQuantity::Moment);
  EXPECT_EQ(scene.probes[1].component, Component::X);
  EXPECT_EQ(scene.probes[1].at.fraction, 0.0);
}

TEST_F(SceneStore, KeepsOfAnUnfinishedPathWhatIsValid) {
  const io::SceneFile file = io::parse_scene_file(cantilever_text(), "beam.toml");
  const Model model = prepare(file.setup.scene, file.setup.solver);
  Response response = simulate(file.setup.scene, file.setup.solver);
  const Response whole = response;
  response.status = Status::LimitLoad;
  response.limit = LimitLoad{0.5, 0.51};
  response.samples = 2;
  const SceneRecord read = stored(io::make_scene_record(file, model, response));
  EXPECT_EQ(read.response.status, Status::LimitLoad);
  EXPECT_EQ(read.response.limit->below, 0.5);
  EXPECT_EQ(read.response.limit->above, 0.51);
  ASSERT_EQ(read.response.chain.time.size(), 2U);
  ASSERT_EQ(read.response.probes.at(0).size(), 2U);
  EXPECT_EQ(read.response.probes[0][1], whole.probes[0][1]);
  ASSERT_EQ(read.response.chain.moment.size(), 2U * 5U * 3U);
  EXPECT_EQ(read.response.chain.moment[15], whole.chain.moment[15]);
}

TEST_F(SceneStore, KeepsEveryJointOfABreak) {
  SceneRecord record = record_of(cantilever_text());
  ChainBreak event{2.5, 0.75, {}, {{0, 2}, {3, 9}}};
  event.joints.push_back(
      {3, BreakCause::Torsion, true, 0.11, 0.1, {1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}, 7.0});
  event.joints.push_back({4, BreakCause::Biaxial, false, 0.2, 0.1, {}, {}, 8.0});
  record.response.status = Status::Broken;
  record.response.chain.events = {event};
  const auto events = stored(record).response.chain.events;
  ASSERT_EQ(events.size(), 1U);
  const ChainBreak* read = &events.front();
  EXPECT_EQ(read->pieces, event.pieces);
  EXPECT_TRUE(read->joints[0].cut);
  EXPECT_FALSE(read->joints[1].cut);
  EXPECT_EQ(read->time, 2.5);
  EXPECT_EQ(read->factor, 0.75);
  ASSERT_EQ(read->joints.size(), 2U);
  EXPECT_EQ(read->joints[0].joint, 3);
  EXPECT_EQ(read->joints[0].cause, BreakCause::Torsion);
  EXPECT_EQ(read->joints[0].moment, event.joints[0].moment);
  EXPECT_EQ(read->joints[0].angle, event.joints[0].angle);
  EXPECT_EQ(read->joints[1].cause, BreakCause::Biaxial);
  EXPECT_EQ(read->joints[1].dissipation, 8.0);
}

TEST_F(SceneStore, ReadsACouponBackWithItsBreak) {
  const SceneRecord record = record_of(coupon_text());
  ASSERT_TRUE(record.response.event);
  const SceneRecord read = stored(record);
  EXPECT_EQ(read.level, Level::Coupon);
  EXPECT_EQ(read.setup.scene.drive.strain, record.setup.scene.drive.strain);
  EXPECT_EQ(read.response.probes, record.response.probes);
  ASSERT_TRUE(read.response.event);
  EXPECT_EQ(read.response.event->sample, record.response.event->sample);
  EXPECT_EQ(read.response.event->strain, record.response.event->strain);
  EXPECT_EQ(read.response.event->dissipation, record.response.event->dissipation);
  EXPECT_EQ(read.outline.segments(), 0U);
}

TEST_F(SceneStore, OfAnotherSchemaOrVersionIsRefused) {
  const auto write = [&](std::string_view schema, int version) {
    Hdf5File file = Hdf5File::create(path_);
    write_schema(file.root(), schema, version);
    file.commit();
  };
  const auto reading = [&] { return message_of([&] { read_scene_store(path_); }); };
  write("plastica/fits", 1);
  EXPECT_EQ(reading(), path_ + ": schema = plastica/fits: must be plastica/scene");
  write(kSceneSchema, kSceneVersion + 1);
  EXPECT_EQ(reading(), path_ + ": version = 2: must be 1, which this Plastica reads");
  write(kSceneSchema, kSceneVersion);
  EXPECT_EQ(reading(), path_ + ": /options: is not a group of this file");
}

TEST_F(SceneStore, WhoseArraysDoNotFitEachOtherIsRefused) {
  SceneRecord record = record_of(cantilever_text());
  record.outline.width.push_back(1.0);
  EXPECT_THROW(write_scene_store(path_, record), std::logic_error);
  EXPECT_FALSE(std::filesystem::exists(path_));
  record.outline.width.pop_back();
  record.response.samples = 5;  // of 6: the probes have too many values
  EXPECT_THROW(write_scene_store(path_, record), std::logic_error);
}

}  // namespace
}  // namespace plastica::io
