#include "plastica/model/choose_level.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "tests/lib/model/chain_scenes.hpp"
#include "tests/support/message.hpp"

namespace plastica {
namespace {

using testing::cantilever;

constexpr std::array<double, 3> kNothing{};
const char* const kInYZ = "planar: every load, support and joint axis lies in the y-z plane";
const char* const kInXZ = "planar: every load, support and joint axis lies in the x-z plane";

LevelChoice choice_of(const Scene& scene, Level asked = Level::Auto) {
  SolverOptions options;
  options.level = asked;
  return choose_level(scene, options);
}

std::string error_of(const Scene& scene, Level asked) {
  return testing::message_of([&] { (void)choice_of(scene, asked); });
}

Scene twisted() {
  Scene scene = cantilever(kNothing);
  scene.loads[0].moment = {0.0, 0.0, 10.0};
  return scene;
}

TEST(ChooseLevel, TakesACouponForADrive) {
  Scene scene;
  scene.drive.strain = {0.0, 0.01};
  EXPECT_EQ(choice_of(scene).level, Level::Coupon);
  EXPECT_EQ(choice_of(scene).reason, "coupon: a strain history drives all joints alike");
  EXPECT_EQ(choice_of(scene, Level::Coupon).reason, "coupon: as the scene asks");
  EXPECT_EQ(error_of(scene, Level::Planar),
            "solver.level: must be auto or coupon in a scene with a drive");
}

TEST(ChooseLevel, TakesTwistForMomentsAboutTheBeam) {
  EXPECT_EQ(choice_of(twisted()).level, Level::Twist);
  EXPECT_EQ(choice_of(twisted()).reason, "twist: every load and motion is about the beam's axis");
  Scene turned = cantilever(kNothing);
  turned.loads.clear();
  turned.supports.push_back({Place::end(), SupportKind::Guide});
  turned.supports[1].rotation = {0.0, 0.0, 0.5};
  EXPECT_EQ(choice_of(turned).level, Level::Twist);
}

TEST(ChooseLevel, TakesThePlaneOfTheLoads) {
  const LevelChoice along_y = choice_of(cantilever());
  EXPECT_EQ(along_y.level, Level::Planar);
  EXPECT_EQ(along_y.bending, BendingAxis::X);
  EXPECT_EQ(along_y.reason, kInYZ);
  const LevelChoice along_x = choice_of(cantilever({5.0, 0.0, 3.0}));
  EXPECT_EQ(along_x.level, Level::Planar);
  EXPECT_EQ(along_x.bending, BendingAxis::Y);
  EXPECT_EQ(along_x.reason, kInXZ);
}

/// Things that belong to the y-z plane, and the same turned into space.
struct PlaneCase {
  const char* name;
  std::function<void(Scene&)> in_plane;
  std::function<void(Scene&)> out_of_plane;
  const char* reason;
};

class ChooseLevelBy : public ::testing::TestWithParam<PlaneCase> {};

TEST_P(ChooseLevelBy, WhetherItLiesInThePlane) {
  Scene flat = cantilever();
  GetParam().in_plane(flat);
  EXPECT_EQ(choice_of(flat).reason, kInYZ);
  Scene solid = cantilever();
  GetParam().out_of_plane(solid);
  const LevelChoice choice = choice_of(solid);
  EXPECT_EQ(choice.level, Level::Spatial);
  EXPECT_EQ(choice.reason, std::string("spatial: ") + GetParam().reason);
  EXPECT_EQ(error_of(solid, Level::Planar),
            std::string("solver.level = planar: ") + GetParam().reason);
}

INSTANTIATE_TEST_SUITE_P(
    Part, ChooseLevelBy,
    ::testing::Values(
        PlaneCase{"Force", [](Scene& s) { s.loads[0].force[2] = 7.0; },
                  [](Scene& s) { s.loads[0].force[0] = 7.0; },
                  "load[1].force has a component along x, out of the y-z plane"},
        PlaneCase{"Moment", [](Scene& s) { s.loads[0].moment[0] = 7.0; },
                  [](Scene& s) { s.loads[0].moment[1] = 7.0; },
                  "load[1].moment has a component about y, out of the y-z plane"},
        PlaneCase{"Torque", [](Scene& s) { s.loads[0].moment[0] = 7.0; },
                  [](Scene& s) { s.loads[0].moment[2] = 7.0; },
                  "load[1].moment has a component about z, which twists the beam"},
        PlaneCase{"SecondLoad", [](Scene& s) { s.loads.push_back(s.loads[0]); },
                  [](Scene& s) {
                    s.loads.push_back(s.loads[0]);
                    s.loads[1].force = {1.0, 0.0, 0.0};
                  },
                  "load[2].force has a component along x, out of the y-z plane"},
        PlaneCase{"Gravity",
                  [](Scene& s) {
                    s.gravity = {0.0, -9.81, 0.0};
                  },
                  [](Scene& s) {
                    s.gravity = {-9.81, 0.0, 0.0};
                  },
                  "gravity has a component along x, out of the y-z plane"},
        PlaneCase{"Translation", [](Scene& s) { s.supports[0].translation[1] = 0.01; },
                  [](Scene& s) { s.supports[0].translation[0] = 0.01; },
                  "support[1].translation has a component along x, out of the y-z plane"},
        PlaneCase{"Rotation", [](Scene& s) { s.supports[0].rotation[0] = 0.01; },
                  [](Scene& s) { s.supports[0].rotation[1] = 0.01; },
                  "support[1].rotation has a component about y, out of the y-z plane"},
        PlaneCase{"InitialVelocity",
                  [](Scene& s) {
                    s.initial_motions.push_back({.velocity = {0.0, 1.0, 2.0}});
                  },
                  [](Scene& s) {
                    s.initial_motions.push_back({.velocity = {1.0, 0.0, 0.0}});
                  },
                  "initial_motion[1].velocity has a component along x, out of the y-z plane"},
        PlaneCase{"InitialSpin",
                  [](Scene& s) {
                    s.initial_motions.push_back({.spin = {1.0, 0.0, 0.0}});
                  },
                  [](Scene& s) {
                    s.initial_motions.push_back({.spin = {1.0, 0.0, 2.0}});
                  },
                  "initial_motion[1].spin has a component about z, which twists the beam"},
        PlaneCase{"Pillar",
                  [](Scene& s) {
                    s.supports.push_back({{0.5, {}}, SupportKind::Pillar});
                  },
                  [](Scene& s) {
                    s.supports.push_back({{0.5, {}}, SupportKind::Pillar});
                    s.supports[1].normal = {0.6, 0.8, 0.0};
                  },
                  "support[2].normal has a component along x, out of the y-z plane"},
        PlaneCase{"Arc",
                  [](Scene& s) {
                    s.beam.shape = BeamShape::Arc;
                    s.beam.arc_angle = 0.5;
                  },
                  [](Scene& s) {
                    s.beam.shape = BeamShape::Arc;
                    s.beam.arc_angle = 0.5;
                    s.beam.arc_towards = {1.0, 0.0, 0.0};
                  },
                  "beam.arc_towards has a component along x, out of the y-z plane"},
        PlaneCase{"Polyline",
                  [](Scene& s) {
                    s.beam.shape = BeamShape::Polyline;
                    s.beam.points = {{0.0, 0.0, 0.0}, {0.0, 0.6, 0.8}};
                  },
                  [](Scene& s) {
                    s.beam.shape = BeamShape::Polyline;
                    s.beam.points = {{0.0, 0.0, 0.0}, {0.6, 0.0, 0.8}};
                  },
                  "beam.points[2] has a component along x, out of the y-z plane"}),
    [](const ::testing::TestParamInfo<PlaneCase>& tested) { return tested.param.name; });

TEST(ChooseLevel, AsksNothingOfWhatOnlyHoldsStill) {
  Scene scene = cantilever();
  scene.supports.push_back({{0.5, {}}, SupportKind::Roller});
  scene.supports.push_back({Place::end(), SupportKind::Elastic});
  scene.supports[2].stiffness = {1e3, 1e3, 1e3};
  EXPECT_EQ(choice_of(scene).reason, kInYZ);
}

TEST(ChooseLevel, TakesAPlaneForABeamInFreeFlight) {
  Scene scene = cantilever();
  scene.supports.clear();
  scene.loads.clear();
  scene.initial_motions.push_back({.velocity = {0.0, 3.0, 0.0}, .spin = {2.0, 0.0, 0.0}});
  EXPECT_EQ(choice_of(scene).reason, kInYZ);
  scene.initial_motions.push_back({.velocity = {1.0, 0.0, 0.0}});
  EXPECT_EQ(choice_of(scene).level, Level::Spatial);
  scene.initial_motions = {{.velocity = {1.0, 0.0, 0.0}, .spin = {0.0, 2.0, 0.0}}};
  EXPECT_EQ(choice_of(scene).reason, kInXZ);
  EXPECT_EQ(error_of(scene, Level::Coupon),
            "solver.level = coupon: a scene without a drive is no coupon");
  scene.initial_motions = {{.spin = {0.0, 0.0, 2.0}}};
  EXPECT_EQ(choice_of(scene).level, Level::Twist);
}

TEST(ChooseLevel, TakesTheWeakerPlaneForLoadsAlongTheBeam) {
  Scene scene = cantilever({0.0, 0.0, -1000.0});
  scene.section.width = 0.01;
  EXPECT_EQ(choice_of(scene).bending, BendingAxis::Y);
  EXPECT_EQ(choice_of(scene).reason,
            "planar: all acts along the beam, which is weakest in the x-z plane");
  scene.section.width = 0.03;
  EXPECT_EQ(choice_of(scene).bending, BendingAxis::X);
  EXPECT_EQ(choice_of(scene).reason,
            "planar: all acts along the beam, which is weakest in the y-z plane");
  scene.section = {SectionShape::RectangularTube};
  scene.section.inner_width = 0.09;
  scene.section.inner_height = 0.02;
  // b h^3 - b_i h_i^3 is (0.1)^4 - 0.09 0.02^3 about x, less about y: (0.1)^4 - 0.02 0.09^3.
  EXPECT_EQ(choice_of(scene).bending, BendingAxis::Y);
}

TEST(ChooseLevel, TakesALargerLevelIfTheSceneAsks) {
  const LevelChoice choice = choice_of(cantilever(), Level::Spatial);
  EXPECT_EQ(choice.level, Level::Spatial);
  EXPECT_EQ(choice.reason, "spatial: as the scene asks; planar would hold it");
  EXPECT_EQ(choice_of(twisted(), Level::Spatial).reason,
            "spatial: as the scene asks; twist would hold it");
  EXPECT_EQ(choice_of(cantilever(), Level::Planar).reason, "planar: as the scene asks");
  EXPECT_EQ(choice_of(cantilever({1.0, 0.0, 0.0}), Level::Planar).bending, BendingAxis::Y);
  EXPECT_EQ(choice_of(cantilever({1.0, 1.0, 0.0}), Level::Spatial).reason,
            "spatial: as the scene asks");
}

TEST(ChooseLevel, RefusesALevelThatDoesNotHoldTheScene) {
  EXPECT_EQ(error_of(cantilever(), Level::Twist),
            "solver.level = twist: load[1].force has a component along y, and twist is about the "
            "beam's axis z alone");
  EXPECT_EQ(error_of(twisted(), Level::Planar),
            "solver.level = planar: load[1].moment has a component about z, which twists the beam");
  EXPECT_EQ(error_of(cantilever(), Level::Coupon),
            "solver.level = coupon: a scene with supports is no coupon");
}

}  // namespace
}  // namespace plastica
