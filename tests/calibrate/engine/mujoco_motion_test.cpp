#include <gtest/gtest.h>

#ifdef PLASTICA_HAS_MUJOCO

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "calibrate/engine/engine_world.hpp"
#include "tests/calibrate/engine/mujoco_beam.hpp"

namespace plastica::testing {
namespace {

TEST(MujocoMotion, SwingsAsOursBetweenTwoClampsAtTheStepOfTheScene) {
  Scene scene = bar(8);
  scene.gravity = {0.0, -9.81, 0.0};
  scene.gravity_history = {{0.0}, {1.0}};  // from the beginning, as in MuJoCo
  scene.supports.push_back({.at = Place::end(),
                            .kind = SupportKind::Clamp,
                            .hold = HeldFreedoms{true, true, false, true, true, true}});
  calibrate::EngineBeam numbers = beam_of(scene, {.time_step = 1e-4});
  numbers.damping_time = 0.0;
  MujocoBeam beam(numbers);
  EXPECT_EQ(beam.model().opt.timestep, 1e-4);
  const int body = beam.body("segment_4");
  constexpr int kSteps = 200;
  std::vector<double> theirs{0.0};
  for (int i = 0; i < kSteps; ++i) {
    beam.step(1, body, 0.125, {});
    theirs.push_back(beam.point(body, 0.125)[1]);
  }
  add_probe(scene, ProbeQuantity::Displacement, {0.5, {}}, Component::Y);
  const Response ours = completed(scene, {.analysis = Analysis::Dynamics,
                                          .duration = kSteps * 1e-4,
                                          .steps = kSteps,
                                          .scheme = Scheme::EnergyMomentum,
                                          .time_step = 2e-5});
  const double largest = std::fabs(*std::ranges::min_element(ours.probes[0]));
  ASSERT_EQ(ours.probes[0].size(), theirs.size());
  // Three swings of the first mode, 163 Hz; both lag by less than 1 % of one in all.
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    EXPECT_NEAR(theirs[i], ours.probes[0][i], 0.05 * largest) << i;
  }
}

/// 150 steps of each shipped beam, as long as those of its scene, under gravity: nothing blows up
/// (without armature the column does at the 116th), and what supports hold stays there.
TEST(MujocoMotion, StepsTheBeamOfEveryShippedSceneStably) {
  int stepped = 0;
  for (const calibrate::EngineBeam& shipped : shipped_beams()) {
    if (shipped.segments.size() > 96) continue;
    SCOPED_TRACE(shipped.name);
    calibrate::EngineBeam numbers = shipped;
    calibrate::put_into({.gravity = 9.81}, numbers);
    MujocoBeam beam(numbers);
    const bool floats = numbers.joints.front().parent.has_value();
    double length = 0.0;
    for (const calibrate::EngineSegment& segment : numbers.segments) length += segment.length;
    const int last = beam.body("segment_" + std::to_string(numbers.segments.size()));
    beam.step(150, last, 0.0, {});
    EXPECT_DOUBLE_EQ(beam.model().opt.timestep, numbers.time_step);
    EXPECT_LT(beam.support_drift(), 1e-4 * length);
    EXPECT_TRUE(floats || beam.reach() < 1.5 * length) << beam.reach();
    ++stepped;
  }
  EXPECT_GE(stepped, 20);
}

/// MuJoCo takes damping implicitly, but not in its constraints: without armature for it this one,
/// held by a clamp inside, blew up.
TEST(MujocoMotion, StepsAClampedBeamStablyHoweverItIsDamped) {
  Scene scene = cantilever_scene(32);
  scene.section.height = 0.005;
  scene.supports[0].at = {0.43, {}};
  for (const double damping : {0.0, 1e-3, 1e-2, 1.0}) {
    SCOPED_TRACE(damping);
    calibrate::EngineBeam numbers = beam_of(scene);
    calibrate::put_into({.gravity = 9.81, .damping_time = damping}, numbers);
    MujocoBeam beam(numbers);
    beam.step(400, beam.body("segment_32"), 0.0, {});
    EXPECT_LT(beam.support_drift(), 1e-4);
  }
}

/// Without --up a slanted gravity keeps its direction.
TEST(MujocoMotion, GravityIsAsLargeAsItIsAskedForWhereTheScenesPoints) {
  calibrate::EngineBeam numbers = beam_of(bar(2));
  numbers.gravity = {3.0, -4.0, 0.0};
  calibrate::put_into({.gravity = 10.0}, numbers);
  EXPECT_EQ(numbers.gravity, (Point{6.0, -8.0, 0.0}));
}

TEST(MujocoMotion, BeamsThatAreTurnedUpSagDown) {
  const Scene scene = bar(32);
  const SectionProperties p = properties_of(scene);
  const double sag = 7850.0 * p.area * 9.81 / (8.0 * 200e9 * p.second_moment_x);
  const std::map<std::string_view, Point> downs{{"x", {-sag, 0.0, 0.0}}, {"y", {0.0, -sag, 0.0}},
                                                {"z", {0.0, 0.0, -sag}}, {"-x", {sag, 0.0, 0.0}},
                                                {"-y", {0.0, sag, 0.0}}, {"-z", {0.0, 0.0, sag}}};
  for (const auto& [up, down] : downs) {
    SCOPED_TRACE(up);
    calibrate::EngineBeam numbers = beam_of(scene);
    calibrate::put_into({.up = up, .gravity = 9.81, .damping_time = 0.01}, numbers);
    MujocoBeam beam(numbers);
    const int body = beam.body("segment_32");
    const Point before = beam.point(body, 0.03125);
    beam.step(1000, body, 0.03125, {});
    const Point after = beam.point(body, 0.03125);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(after[k] - before[k], down[k], 0.01 * sag) << k;
    }
  }
}

TEST(MujocoMotion, ARollerThatIsTurnedUpStillRollsAlongTheBeam) {
  Scene scene = bar(8);
  scene.supports[0].kind = SupportKind::Pin;
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  const auto sag_in = [&](std::string_view up, std::size_t axis) {
    calibrate::EngineBeam numbers = beam_of(scene);
    calibrate::put_into({.up = up, .gravity = 9.81, .damping_time = 0.01}, numbers);
    MujocoBeam beam(numbers);
    const int body = beam.body("segment_5");
    const double before = beam.point(body, 0.0)[axis];
    beam.step(1000, body, 0.0, {});
    return before - beam.point(body, 0.0)[axis];
  };
  const SectionProperties p = properties_of(scene);
  const double exact = 5.0 * 7850.0 * p.area * 9.81 / (384.0 * 200e9 * p.second_moment_x);
  const double sag = sag_in("y", 1);
  EXPECT_NEAR(sag, exact, 0.05 * exact);  // eight segments
  EXPECT_NEAR(sag_in("z", 2), sag, 1e-6 * sag);
  EXPECT_NEAR(sag_in("x", 0), sag, 1e-6 * sag);
}

TEST(MujocoMotion, SegmentsTouchWhatTheyAreAskedTo) {
  for (const auto& [contacts, others, own] :
       {std::tuple{calibrate::EngineContacts::None, false, false},
        std::tuple{calibrate::EngineContacts::Others, true, false},
        std::tuple{calibrate::EngineContacts::All, true, true}}) {
    calibrate::EngineBeam numbers = beam_of(bar(4));
    numbers.contacts = contacts;
    MujocoBeam beam(numbers);
    const mjModel& model = beam.model();
    ASSERT_EQ(model.ngeom, 4);
    const auto touch = [](int type_a, int affinity_a, int type_b, int affinity_b) {
      return (type_a & affinity_b) != 0 || (type_b & affinity_a) != 0;
    };
    const int type = model.geom_contype[0];
    const int affinity = model.geom_conaffinity[0];
    EXPECT_EQ(touch(type, affinity, 1, 1), others);  // MuJoCo's defaults
    EXPECT_EQ(touch(type, affinity, type, affinity), own);
    beam.step(1, beam.body("segment_4"), 0.0, {});
    EXPECT_EQ(beam.data().ncon, 0);  // neighbours do not touch each other
  }
}

}  // namespace
}  // namespace plastica::testing

#endif
