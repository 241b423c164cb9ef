#include "calibrate/trial/remesh.hpp"

#include <gtest/gtest.h>

#include "plastica/run/simulate.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::message_of;

/// A bar on two pins, pushed in the middle.
Setup bar(int segments) {
  Setup setup;
  Scene& scene = setup.scene;
  scene.beam.segments = segments;
  scene.supports.resize(2);
  scene.supports[0].kind = SupportKind::Pin;
  scene.supports[1].kind = SupportKind::Roller;
  scene.supports[1].at = Place::end();
  scene.loads.resize(1);
  scene.loads[0].at = {0.5, {}};
  scene.loads[0].force = {0.0, -1.0, 0.0};
  scene.probes = {{"tip", ProbeQuantity::Displacement, {0.5, {}}}};
  return setup;
}

TEST(Remeshed, HalvesAndDoublesTheSegments) {
  EXPECT_EQ(remeshed(bar(8), Division::Half).scene.beam.segments, 4);
  EXPECT_EQ(remeshed(bar(8), Division::Twice).scene.beam.segments, 16);
  EXPECT_EQ(remeshed(bar(7), Division::Twice).scene.beam.segments, 14);
  // Segments whose end ones are half as long: 9 are as 8 whole ones.
  plastica::Setup half = bar(9);
  half.scene.end_rule = EndRule::Half;
  half.scene.loads[0].at = Place::end();
  EXPECT_EQ(remeshed(half, Division::Half).scene.beam.segments, 5);
  EXPECT_EQ(remeshed(half, Division::Twice).scene.beam.segments, 17);
}

TEST(Remeshed, CutsUnevenSegmentsInTwoAndJoinsThem) {
  plastica::Setup setup = bar(4);
  setup.scene.beam.segment_fractions = {0.1, 0.2, 0.3, 0.4};
  setup.scene.loads[0].at = {0.0, 2};  // at 0.3 of the length
  const plastica::Setup twice = remeshed(setup, Division::Twice);
  EXPECT_EQ(twice.scene.beam.segment_fractions,
            (std::vector<double>{0.05, 0.05, 0.1, 0.1, 0.15, 0.15, 0.2, 0.2}));
  EXPECT_FALSE(twice.scene.loads[0].at.segment);
  EXPECT_DOUBLE_EQ(twice.scene.loads[0].at.fraction, 0.3);
  const plastica::Setup half = remeshed(setup, Division::Half);
  ASSERT_EQ(half.scene.beam.segment_fractions.size(), 2U);
  EXPECT_DOUBLE_EQ(half.scene.beam.segment_fractions[0], 0.3);
  EXPECT_TRUE(usable(simulate(half.scene, half.solver).status));
}

TEST(Remeshed, RefusesWhatWouldBeAnotherScene) {
  const auto refusal = [](const plastica::Setup& setup, Division division) {
    return message_of([&] { (void)remeshed(setup, division); });
  };
  EXPECT_EQ(refusal(bar(7), Division::Half),
            "beam.segments = 7: cannot be halved: it is no even number");
  EXPECT_EQ(refusal(bar(2), Division::Half),
            "beam.segments = 2: cannot be halved: it is too small");
  EXPECT_EQ(refusal(bar(6), Division::Half), "load[1].at: would fall within a segment");
  plastica::Setup region = bar(8);
  region.scene.regions.resize(1);
  region.scene.regions[0].from = {0.0, 3};
  EXPECT_EQ(refusal(region, Division::Half), "region[1].from: would fall within a segment");
  plastica::Setup lengths = bar(4);
  lengths.scene.beam.joint_lengths = {0.2, 0.3, 0.2};
  EXPECT_EQ(refusal(lengths, Division::Twice), "beam.joint_lengths: are given for each joint");
}

TEST(Remeshed, KnowsTheOrderOfTheJoints) {
  Scene scene;
  EXPECT_EQ(order_of_joints(scene), 2.0);
  scene.end_rule = EndRule::Equal;
  EXPECT_EQ(order_of_joints(scene), 1.0);
  scene.end_rule = EndRule::Auto;
  scene.formulas = Formulas::Report;
  EXPECT_EQ(order_of_joints(scene), 1.0);
}

}  // namespace
}  // namespace plastica::calibrate
