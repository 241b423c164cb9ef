#include <gtest/gtest.h>

#ifdef PLASTICA_HAS_MUJOCO

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/calibrate/engine/mujoco_beam.hpp"

namespace plastica::testing {
namespace {

/// Deflection of our own beam at a place under a dead load there.
Point our_deflection(Scene scene, Place at, const Point& force) {
  scene.loads.push_back({.at = at, .force = force});
  for (const Component component : {Component::X, Component::Y, Component::Z}) {
    add_probe(scene, ProbeQuantity::Displacement, at, component);
  }
  const Response response = completed(scene);
  return {last_of(response, 0), last_of(response, 1), last_of(response, 2)};
}

/// How far MuJoCo's tip is from ours, over our deflection.
double tip_error(const Scene& scene, const Point& force) {
  MujocoBeam beam(beam_of(scene));
  const double last = scene.beam.length / scene.beam.segments;
  const int body = beam.body("segment_" + std::to_string(scene.beam.segments));
  const Point theirs = beam.deflect(body, last, force);
  const Point ours = our_deflection(scene, Place::end(), force);
  ::testing::Test::RecordProperty("deflection_mm", std::to_string(1e3 * length_of(ours)));
  return distance(theirs, ours) / length_of(ours);
}

TEST(Mujoco, HasOurTipDeflectionInThePlane) {
  // One hinge of three turns: the same chain, to rounding.
  EXPECT_LT(tip_error(bar(32), {0.0, -400.0, 0.0}), 1e-8);
}

TEST(Mujoco, HasOurTipDeflectionInThePlaneWhereItBendsFar) {
  Scene scene = bar(32);
  scene.material.youngs_modulus = 2e9;
  EXPECT_LT(tip_error(scene, {0.0, -200.0, 0.0}), 1e-8);
}

TEST(Mujoco, HasOurTipDeflectionInSpaceWithinAPerCent) {
  // Three hinges in a row are a rotation vector up to products of their angles.
  const double error = tip_error(bar(32), {300.0, -400.0, 0.0});
  RecordProperty("error", std::to_string(error));
  EXPECT_LT(error, 1e-4);
}

TEST(Mujoco, HasOurDeflectionOfAnArc) {
  Scene scene = bar(32);
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = 1.0;
  scene.beam.arc_towards = {1.0, 0.0, 0.0};
  // The chord of a segment is its z axis; 1.9e-6 is what is left of the hinges' products.
  const double chord = 2.0 * std::sin(0.5 / 32.0);
  const Point force{0.0, -1.0, 0.0};
  MujocoBeam beam(beam_of(scene));
  const Point theirs = beam.deflect(beam.body("segment_32"), chord, force);
  const Point ours = our_deflection(scene, Place::end(), force);
  EXPECT_LT(distance(theirs, ours), 1e-5 * length_of(ours));
}

TEST(Mujoco, HasOurDeflectionBetweenTwoClamps) {
  Scene scene = bar(8);
  scene.supports.push_back({.at = Place::end(),
                            .kind = SupportKind::Clamp,
                            .hold = HeldFreedoms{true, true, false, true, true, true}});
  const Point force{0.0, -4000.0, 0.0};
  MujocoBeam beam(beam_of(scene));
  const Point theirs = beam.deflect(beam.body("segment_4"), 0.125, force);
  const Point ours = our_deflection(scene, {0.5, {}}, force);
  EXPECT_LT(distance(theirs, ours), 1e-8 * length_of(ours));
}

TEST(Mujoco, HasOurDeflectionOnARollerInsideOfASegment) {
  Scene scene = bar(8);
  scene.beam.segment_fractions.assign(8, 0.125);
  scene.supports[0].kind = SupportKind::Pin;
  scene.supports.push_back({.at = {0.7, {}}, .kind = SupportKind::Roller});
  const Point force{0.0, -1000.0, 0.0};
  MujocoBeam beam(beam_of(scene));
  const Point theirs = beam.deflect(beam.body("segment_8"), 0.125, force);
  const Point ours = our_deflection(scene, Place::end(), force);
  EXPECT_LT(distance(theirs, ours), 1e-8 * length_of(ours));
}

TEST(Mujoco, HasOurDeflectionOnBothSidesOfAClampInside) {
  Scene scene = bar(8);
  scene.supports[0].at = {0.5, {}};
  const Point force{0.0, -1000.0, 0.0};
  MujocoBeam beam(beam_of(scene));  // its start floats
  const Point theirs = beam.deflect(beam.body("segment_8"), 0.125, force);
  const Point ours = our_deflection(scene, Place::end(), force);
  EXPECT_LT(distance(theirs, ours), 1e-8 * length_of(ours));
}

TEST(Mujoco, HoldsOurYieldMomentsAsNumbers) {
  const calibrate::EngineBeam numbers = beam_of(breakable_scene());
  MujocoBeam beam(numbers);
  const int id = mj_name2id(&beam.model(), mjOBJ_NUMERIC, "joint_0_x_yield_moment");
  ASSERT_GE(id, 0);
  EXPECT_DOUBLE_EQ(beam.model().numeric_data[beam.model().numeric_adr[id]],
                   numbers.joints[0].yield_moment[0]);
}

TEST(Mujoco, LoadsTheBeamOfEveryShippedScene) {
  int loaded = 0;
  for (const calibrate::EngineBeam& numbers : shipped_beams()) {
    SCOPED_TRACE(numbers.name);
    if (numbers.segments.size() > 96) {  // too deep for MuJoCo 2, and said so
      const auto notes = calibrate::engine_notes(numbers, calibrate::EngineFormat::Mjcf);
      EXPECT_EQ(notes.back().substr(0, 8), "MuJoCo 2");
      continue;
    }
    MujocoBeam beam(numbers);
    const auto off_start =
        std::ranges::count(numbers.joints, true, &calibrate::EngineJoint::off_start);
    EXPECT_EQ(beam.model().nbody,
              1 + static_cast<int>(numbers.segments.size()) + static_cast<int>(off_start));
    ++loaded;
  }
  EXPECT_GE(loaded, 20);
}

}  // namespace
}  // namespace plastica::testing

#else

TEST(Mujoco, IsNotInstalled) {
  GTEST_SKIP()
      << "MuJoCo is not installed (apt-get install libmujoco-dev): what is exported for it "
         "was not loaded";
}

#endif
