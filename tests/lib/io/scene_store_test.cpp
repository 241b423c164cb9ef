#include "plastica/io/scene_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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
  EXPECT_EQ(a.frame_sample, b.frame_sample);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.moment, b.moment);
  EXPECT_EQ(a.force, b.force);
  EXPECT_EQ(a.angle, b.angle);
  EXPECT_EQ(a.plastic_angle, b.plastic_angle);
  EXPECT_EQ(a.rotation, b.rotation);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.spin, b.spin);
  EXPECT_EQ(a.plastic_strain, b.plastic_strain);
  EXPECT_EQ(a.stress, b.stress);
  EXPECT_EQ(a.reaction, b.reaction);
  ASSERT_EQ(a.energy.size(), b.energy.size());
  using E = Energies;
  for (std::size_t i = 0; i < a.energy.size(); ++i) {
    for (const auto entry :
         {&E::elastic, &E::kinetic, &E::plastic, &E::damping, &E::numerical_dissipation, &E::impact,
          &E::fracture, &E::external, &E::residual}) {
      EXPECT_EQ(a.energy[i].*entry, b.energy[i].*entry) << i;
    }
  }
}

void expect_same_joint(const BrokenJoint& a, const BrokenJoint& b) {
  EXPECT_EQ(a.joint, b.joint);
  EXPECT_EQ(a.cause, b.cause);
  EXPECT_EQ(a.cut, b.cut);
  EXPECT_EQ(a.strain, b.strain);
  EXPECT_EQ(a.limit, b.limit);
  EXPECT_EQ(a.moment, b.moment);
  EXPECT_EQ(a.angle, b.angle);
  EXPECT_EQ(a.dissipation, b.dissipation);
}

void expect_same_events(const std::vector<ChainBreak>& a, const std::vector<ChainBreak>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t e = 0; e < a.size(); ++e) {
    EXPECT_EQ(a[e].time, b[e].time);
    EXPECT_EQ(a[e].factor, b[e].factor);
    EXPECT_EQ(a[e].fragments, b[e].fragments);
    ASSERT_EQ(a[e].joints.size(), b[e].joints.size());
    for (std::size_t j = 0; j < a[e].joints.size(); ++j) {
      expect_same_joint(a[e].joints[j], b[e].joints[j]);
    }
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

/// As of a path that arcs lead beyond its peak.
TEST_F(SceneStore, ReadsAPathBackWhoseLoadFalls) {
  SceneRecord record = record_of(cantilever_text());
  record.response.chain.time = {0.0, 0.5, 0.75, 0.25, -0.125, 1.0};
  record.response.chain.factor = record.response.chain.time;
  expect_same_chain(stored(record).response.chain, record.response.chain);
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
  EXPECT_TRUE(scene.loads[0].history.continues && !scene.loads[1].history.continues);
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

TEST_F(SceneStore, KeepsTheFramesOfAMotionApartFromItsSamples) {
  const SceneRecord record = motion_record({.segments = 6, .samples = 41, .frames = 5});
  const SceneRecord read = stored(record);
  EXPECT_EQ(read.response.chain.frame_sample, (std::vector<std::size_t>{0, 10, 20, 30, 40}));
  EXPECT_EQ(read.response.chain.position.size(), 5U * 7U * 3U);
  EXPECT_EQ(read.response.chain.reaction.size(), 5U * 2U * 6U);
  EXPECT_EQ(read.response.probes.at(0).size(), 41U);
  EXPECT_EQ(read.response.probes, record.response.probes);
  EXPECT_EQ(read.response.energy_balance_error, 3e-4);
  EXPECT_EQ(read.response.momentum_error, 2e-5);
  EXPECT_EQ(read.response.longest_step, record.response.longest_step);
  EXPECT_GT(read.response.longest_step, 0.0);
  expect_same_chain(read.response.chain, record.response.chain);
}

TEST_F(SceneStore, KeepsTheVelocitiesOfAMotion) {
  const SceneRecord record = record_of(swinging_text());
  EXPECT_EQ(record.response.chain.velocity.size(), 6U * 4U * 3U);
  EXPECT_EQ(record.response.chain.spin.size(), 6U * 4U * 3U);
  EXPECT_NE(record.response.chain.spin.back(), record.response.chain.spin.front());
  expect_same_chain(stored(record).response.chain, record.response.chain);
  const Hdf5File file = Hdf5File::open(path_);
  EXPECT_EQ(file.root().text_attribute("segments/velocity", "units"), "m/s");
  EXPECT_EQ(file.root().text_attribute("segments/spin", "units"), "rad/s");
  stored(record_of(cantilever_text()));
  EXPECT_FALSE(Hdf5File::open(path_).root().exists("segments/velocity")) << "of a path at rest";
}

/// As files of before are.
TEST_F(SceneStore, ReadsAMotionWithoutVelocities) {
  SceneRecord record = record_of(swinging_text());
  record.response.chain.velocity.clear();
  record.response.chain.spin.clear();
  expect_same_chain(stored(record).response.chain, record.response.chain);
  EXPECT_FALSE(Hdf5File::open(path_).root().exists("segments/velocity"));
}

TEST_F(SceneStore, IsReadBesideGroupsOfOtherFormats) {
  const SceneRecord record = record_of(cantilever_text());
  write_scene_store(path_, record, Overwrite::Allowed, [](Hdf5Group& root) {
    root.write("VTKHDF/Points", std::vector<float>{1.0F, 2.0F});
  });
  expect_same_chain(read_scene_store(path_).response.chain, record.response.chain);
}

TEST_F(SceneStore, KeepsEveryEventWithItsJointsAndFragments) {
  SceneRecord record = motion_record({.segments = 8, .samples = 11, .frames = 3});
  record.response.chain.events.push_back({0.2, 0.5, {}, {}});  // nobody was cut
  record.response.chain.events[0].joints[0].cause = BreakCause::Torsion;
  const Response read = stored(record).response;
  EXPECT_EQ(read.status, Status::Broken);
  expect_same_events(read.chain.events, record.response.chain.events);
  EXPECT_EQ(read.chain.events[1].fragments, (std::vector<Fragment>{{0, 3}, {4, 5}, {6, 7}}));
}

TEST_F(SceneStore, KeepsOfAnInterruptedMotionTheFramesUpToThere) {
  const io::SceneFile file = io::parse_scene_file(cantilever_text(), "beam.toml");
  const Model model = prepare(file.setup.scene, file.setup.solver);
  Response response = motion_record({.segments = 4, .samples = 41, .frames = 5}).response;
  response.probes.resize(2);
  response.chain.reaction.resize(5U * 6U);  // of one support
  response.status = Status::Interrupted;
  response.samples = 25;
  const SceneRecord read = stored(io::make_scene_record(file, model, response));
  EXPECT_EQ(read.response.status, Status::Interrupted);
  EXPECT_EQ(read.response.chain.time.size(), 25U);
  EXPECT_EQ(read.response.chain.energy.size(), 25U);
  EXPECT_EQ(read.response.chain.frame_sample, (std::vector<std::size_t>{0, 10, 20}));
  EXPECT_EQ(read.response.chain.stress.size(), 3U * 5U);
  EXPECT_EQ(read.response.chain.stress[10], response.chain.stress[10]);
}

TEST_F(SceneStore, ReadsTheSetupBackWhole) {
  SceneRecord record = record_of(cantilever_text());
  Scene& scene = record.setup.scene;
  scene.initial_motions = {{{0.25, {}}, {0.75, {}}, {1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}, {0.5, {}}},
                           {{0.0, {}}, {1.0, {}}, {}, {0.0, 0.0, 1.0}, {0.0, {}}}};
  scene.cuts = {{{0.5, {}}, 0.01}, {{0.25, {}}, 0.02}};
  scene.supports[0].restitution = 0.5;
  scene.material.name = "tin";
  Region region{{0.25, {}}, {0.5, {}}, scene.section, scene.material};
  region.section.shape = SectionShape::RoundTube;
  region.section.shear_coefficient = 0.8;
  region.material.name = "lead";
  region.material.yield_stress = 12e6;
  scene.regions = {region, region};
  scene.regions[0].own = {"section.width", "material"};
  scene.regions[1].to_section = region.section;
  scene.regions[1].to_section->inner_radius = 0.003;
  scene.regions[1].to_section->name = "narrow";
  scene.regions[1].section.shear_coefficient.reset();
  scene.beam.segment_fractions = {0.1, 0.2, 0.3, 0.4};
  scene.beam.joint_lengths = {0.2, 0.3, 0.4};
  scene.beam.arc_towards = {1.0, 0.0, 0.0};
  scene.beam.points = {{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
  record.setup.solver.control_at = Place{0.75, {}};
  record.setup.solver.control_motion = {0.0, -0.1, 0.0};

  const auto read = stored(record).setup;
  ASSERT_EQ(read.scene.initial_motions.size(), 2U);
  const InitialMotion& motion = read.scene.initial_motions[0];
  EXPECT_EQ(motion.from.fraction, 0.25);
  EXPECT_EQ(motion.to.fraction, 0.75);
  EXPECT_EQ(motion.about.fraction, 0.5);
  EXPECT_EQ(motion.velocity, (std::array<double, 3>{1.0, 2.0, 3.0}));
  EXPECT_EQ(motion.spin, (std::array<double, 3>{4.0, 5.0, 6.0}));
  EXPECT_EQ(read.scene.initial_motions[1].spin[2], 1.0);
  ASSERT_EQ(read.scene.cuts.size(), 2U);
  EXPECT_EQ(read.scene.cuts[1].at.fraction, 0.25);
  EXPECT_EQ(read.scene.cuts[1].time, 0.02);
  EXPECT_EQ(read.scene.supports[0].restitution, 0.5);
  EXPECT_EQ(read.scene.material.name, "tin");
  ASSERT_EQ(read.scene.regions.size(), 2U);
  EXPECT_EQ(read.scene.regions[0].from.fraction, 0.25);
  EXPECT_EQ(read.scene.regions[0].own, (std::vector<std::string>{"section.width", "material"}));
  EXPECT_EQ(read.scene.regions[1].own, Region{}.own);
  EXPECT_FALSE(read.scene.regions[0].to_section.has_value());
  ASSERT_TRUE(read.scene.regions[1].to_section.has_value());
  EXPECT_EQ(read.scene.regions[1].to_section->inner_radius, 0.003);
  EXPECT_EQ(read.scene.regions[1].to_section->shear_coefficient, 0.8);
  EXPECT_EQ(read.scene.regions[1].to_section->name, "narrow");
  EXPECT_EQ(read.scene.regions[0].section.shape, SectionShape::RoundTube);
  EXPECT_EQ(read.scene.regions[0].section.shear_coefficient, 0.8);
  EXPECT_FALSE(read.scene.regions[1].section.shear_coefficient);
  EXPECT_EQ(read.scene.regions[1].material.name, "lead");
  EXPECT_EQ(read.scene.regions[1].material.yield_stress, 12e6);
  EXPECT_EQ(read.scene.beam.segment_fractions, scene.beam.segment_fractions);
  EXPECT_EQ(read.scene.beam.joint_lengths, scene.beam.joint_lengths);
  EXPECT_EQ(read.scene.beam.arc_towards, scene.beam.arc_towards);
  EXPECT_EQ(read.scene.beam.points, scene.beam.points);
  ASSERT_TRUE(read.solver.control_at);
  EXPECT_EQ(read.solver.control_at->fraction, 0.75);
  EXPECT_EQ(read.solver.control_motion, record.setup.solver.control_motion);
}

TEST_F(SceneStore, HasPlacesAsFractionsOfTheLength) {
  io::SceneFile file = io::parse_scene_file(cantilever_text(), "beam.toml");
  file.setup.scene.initial_motions = {{{0.0, 1}, {0.0, 3}, {}, {}, {0.0, 2}}};
  file.setup.scene.cuts = {{{0.0, 3}, 0.1}};
  file.setup.solver.analysis = Analysis::Dynamics;
  const Model model = prepare(file.setup.scene, file.setup.solver);
  const SceneRecord read = stored(io::make_scene_record(file, model, make_response(model)));
  EXPECT_EQ(read.setup.scene.initial_motions.at(0).from.fraction, 0.25);
  EXPECT_EQ(read.setup.scene.initial_motions.at(0).to.fraction, 0.75);
  EXPECT_EQ(read.setup.scene.initial_motions.at(0).about.fraction, 0.5);
  EXPECT_EQ(read.setup.scene.cuts.at(0).at.fraction, 0.75);
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
  EXPECT_EQ(reading(), path_ + ": version = 4: must be 2 to 3, which this Plastica reads");
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

TEST_F(SceneStore, WhoseFramesOrEventsAreNotOfTheBeamIsRefused) {
  const SceneRecord whole = motion_record({.segments = 4, .samples = 11, .frames = 3});
  const auto refusal = [&](const auto& spoil) {
    SceneRecord record = whole;
    spoil(record.response.chain);
    write_scene_store(path_, record);
    return message_of([&] { read_scene_store(path_); });
  };
  EXPECT_EQ(refusal([](ChainHistory& chain) { chain.frame_sample[2] = 11; }),
            path_ + ": /path/frame_sample: must rise and be samples of the file");
  EXPECT_EQ(refusal([](ChainHistory& chain) { chain.frame_sample[1] = 0; }),
            path_ + ": /path/frame_sample: must rise from each to the next");
  EXPECT_EQ(refusal([](ChainHistory& chain) { chain.events[1].joints[0].joint = 5; }),
            path_ + ": /events/joints/joint: must be a joint of the beam");
  EXPECT_EQ(refusal([](ChainHistory& chain) { chain.events[0].fragments[1].last = 4; }),
            path_ + ": /events/fragments: must be ranges of the beam's segments");
}

}  // namespace
}  // namespace plastica::io
