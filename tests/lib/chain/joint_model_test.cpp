#include "plastica/chain/joint_model.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/chain.hpp"

namespace plastica::chain {
namespace {

using std::numbers::pi;
using testing::cantilever;

template <class L>
std::vector<JointModel> models_of(const Scene& scene, const View<L>& view = {}) {
  const Layout layout = make_layout(scene, segment_ends(scene));
  const Build<L> build = build_chain<L>(scene, layout, view);
  return joint_set(scene, layout, build, material_values(scene.material), view).at_nodes;
}

/// A cantilever of a solid circle of 20 mm, 250 MPa, shear 250/sqrt(3) MPa, E = 200 GPa.
Scene circle(YieldCap cap) {
  Scene scene = cantilever(4, {0.0, -1.0, 0.0});
  scene.section = {};
  scene.section.shape = SectionShape::Circle;
  scene.section.radius = 0.01;
  scene.material.yield_stress = 250e6;
  scene.material.shear_yield_stress = 250e6 / std::sqrt(3.0);
  scene.material.break_strain = 0.2;
  scene.yield_model = YieldModel::PerAxis;
  scene.yield_cap = cap;
  return scene;
}

TEST(JointModel, HasTheCapsAndLeversOfACircle) {
  const double d = 0.02;
  for (const bool plastic : {false, true}) {
    const auto joints =
        models_of<Spatial<double>>(circle(plastic ? YieldCap::FullyPlastic : YieldCap::FirstYield));
    ASSERT_EQ(joints.size(), 5U);
    const JointModel& inner = joints[2];
    const double bending = 250e6 * d * d * d * (plastic ? 1.0 / 6.0 : pi / 32.0);
    const double scene_stiffness = 200e9 * pi / 64.0 * d * d * d * d;
    const double torsion =
        250e6 / std::sqrt(3.0) * pi * d * d * d * (plastic ? 1.0 / 12.0 : 1.0 / 16.0);
    EXPECT_NEAR(inner.cap[0], bending, 1e-12 * bending);
    EXPECT_NEAR(inner.cap[1], bending, 1e-12 * bending);
    EXPECT_NEAR(inner.cap[2], torsion, 1e-12 * torsion);
    EXPECT_NEAR(inner.stiffness[0], scene_stiffness, 1e-12 * scene_stiffness);
    EXPECT_NEAR(inner.stiffness[3], 200e9 * pi / 4.0 * d * d, 1e-4);
    EXPECT_NEAR(inner.cap[3], 250e6 * pi / 4.0 * d * d, 1e-6);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(inner.strain_per_angle(k), 0.5 * d / 0.25, 1e-14) << k;
    }
    EXPECT_NEAR(inner.stress(0, bending), plastic ? 250e6 * 16.0 / (3.0 * pi) : 250e6, 1e-3);
    EXPECT_NEAR(inner.bending_together(3.0, 4.0), 5.0, 1e-15);
    EXPECT_EQ(inner.limit[0], 0.2);
    EXPECT_EQ(inner.own_length(), 0.25);
  }
}

TEST(JointModel, NeverYieldsWhereTheSceneIsElastic) {
  Scene scene = circle(YieldCap::FirstYield);
  scene.yield_model = YieldModel::Elastic;
  for (const JointModel& joint : models_of<Planar<double>>(scene, {1})) {
    for (const double cap : joint.cap) EXPECT_EQ(cap, JointModel::kNever);
  }
}

TEST(JointModel, OfAFreeEndHasNoJoint) {
  const auto joints = models_of<Spatial<double>>(circle(YieldCap::FirstYield));
  EXPECT_EQ(joints[0].joint, 0U);
  EXPECT_EQ(joints[4].joint, JointModel::kNone);
  // They share the axis without gap or overlap.
  EXPECT_EQ(joints[0].begin, 0.0);
  for (std::size_t i = 1; i < joints.size(); ++i) {
    EXPECT_NEAR(joints[i].begin, joints[i - 1].end, 1e-15) << i;
  }
  EXPECT_EQ(joints[4].end, 1.0);
}

/// Where a thick region meets a thin one, the thin one owns the joint: its numbers, and the length
/// of it that is as soft as half a segment of each, l_thin/2 + l_thick/2 I_thin/I_thick.
TEST(JointModel, BetweenUnlikePartsIsOfTheWeakerOne) {
  Scene scene = circle(YieldCap::FirstYield);
  Region thin{{0.5, {}}, {1.0, {}}, scene.section, scene.material};
  thin.section.radius = 0.005;
  thin.material.break_strain = 0.05;
  scene.regions.push_back(thin);
  const auto joints = models_of<Spatial<double>>(scene);
  const JointModel& between = joints[2];
  EXPECT_EQ(between.owner, 1U);
  EXPECT_EQ(between.limit[0], 0.05);
  EXPECT_EQ(between.height, 0.01);
  const double length = 0.125 + 0.125 / 16.0;
  EXPECT_NEAR(between.own_length(), length, 1e-15);
  EXPECT_NEAR(between.strain_per_angle(0), 0.005 / length, 1e-12);
  EXPECT_NEAR(between.length[3], 0.125 + 0.125 / 4.0, 1e-15);
  // What gathers there is of the thin region alone.
  EXPECT_EQ(between.begin, 0.5);
  EXPECT_EQ(between.end, 0.625);
}

}  // namespace
}  // namespace plastica::chain
