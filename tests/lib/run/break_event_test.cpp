#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/lib/run/break_chain.hpp"
#include "tests/support/tolerance.hpp"

// Break as a criterion of a chain at rest: who breaks, what is told of it, and what wears out.

namespace plastica {
namespace {

using testing::break_by_tip_force;
using testing::breaking_cantilever;
using testing::kBreakingPlasticMoment;
using testing::tolerance;

/// The tip goes up and down by a tenth of the length, `turns` ways.
Response bend_to_and_fro(Scene scene, int turns) {
  Support tip;
  tip.at = Place::end();
  tip.kind = SupportKind::Roller;
  tip.hold = HeldFreedoms{false, true, false, false, false, false};
  tip.translation = {0.0, -0.1, 0.0};
  std::vector<double> factors;
  for (int k = 0; k < turns; ++k) factors.push_back(k % 2 == 0 ? 1.0 : -1.0);
  tip.history = History::turning_points(factors);
  scene.supports.push_back(tip);
  SolverOptions options;
  options.steps = 20 * turns;
  return simulate(scene, options);
}

TEST(BreakEvent, TellsWhoBrokeAndWhy) {
  const Response response = break_by_tip_force(breaking_cantilever(10));
  ASSERT_EQ(response.status, Status::Broken);
  ASSERT_FALSE(response.chain.events.empty());
  const ChainBreak& event = response.chain.events.front();
  ASSERT_EQ(event.joints.size(), 1U);
  const BrokenJoint& joint = event.joints.front();
  EXPECT_EQ(joint.joint, 0);
  EXPECT_EQ(joint.cause, BreakCause::BendingX);
  EXPECT_EQ(joint.limit, 0.1);
  EXPECT_GT(joint.strain, 0.1);
  EXPECT_NEAR(joint.strain, 0.1, tolerance(1.1e-5));  // 1e-4 of the limit
  EXPECT_NEAR(std::fabs(joint.moment[0]), kBreakingPlasticMoment, tolerance(1e-6));
  EXPECT_NEAR(std::fabs(joint.angle[0]), joint.strain * 0.05 / 0.025, tolerance(1e-12));
  EXPECT_GT(joint.angle[0] * joint.moment[0], 0.0);
  EXPECT_NEAR(joint.dissipation, kBreakingPlasticMoment * std::fabs(joint.angle[0]),
              tolerance(1e-6));
  // The last sample is the break.
  const std::size_t last = response.samples - 1;
  EXPECT_EQ(event.time, response.chain.time[last]);
  EXPECT_EQ(event.factor, response.chain.factor[last]);
  EXPECT_EQ(response.permanent_strain, joint.strain);
  EXPECT_EQ(response.chain.plastic_strain[last * response.chain.joints], joint.strain);
  EXPECT_EQ(response.chain.energy[last].plastic, joint.dissipation);
}

TEST(BreakEvent, NamesTheAxisWhoseLimitIsPassed) {
  Scene scene = breaking_cantilever(8);
  scene.break_limit_x = 0.5;
  scene.break_limit_y = 0.02;
  scene.break_limit_z = 0.03;
  const auto broken_by = [&](const std::array<double, 3>& rotation) {
    Scene turned = scene;
    Support end;
    end.at = Place::end();
    end.hold = HeldFreedoms{false, false, false, true, true, true};
    end.rotation = rotation;
    turned.supports.push_back(end);
    const Response response = simulate(turned, {.steps = 100});
    EXPECT_EQ(response.status, Status::Broken);
    return response.chain.events.front().joints.front();
  };
  const BrokenJoint bent = broken_by({0.0, 1.5, 0.0});
  EXPECT_EQ(bent.cause, BreakCause::BendingY);
  EXPECT_EQ(bent.limit, 0.02);
  const BrokenJoint twisted = broken_by({0.0, 0.0, 2.0});
  EXPECT_EQ(twisted.cause, BreakCause::Torsion);
  EXPECT_EQ(twisted.limit, 0.03);
  EXPECT_NEAR(twisted.strain, 0.03, tolerance(1.1e-4 * 0.03));
}

TEST(BreakEvent, DoesNotHappenWithoutALimit) {
  Scene scene = breaking_cantilever(10);
  scene.material.break_strain.reset();
  const Response response = break_by_tip_force(scene);
  EXPECT_EQ(response.status, Status::Completed);
  EXPECT_TRUE(response.chain.events.empty());
  EXPECT_GT(response.permanent_strain, 0.5);  // far beyond what would have broken it
}

TEST(BreakEvent, IsOnlyRecordedWhereTheScenePrefersThat) {
  const Response cut = break_by_tip_force(breaking_cantilever(10));
  Scene scene = breaking_cantilever(10);
  scene.on_break = BreakPolicy::RecordOnly;
  const Response response = break_by_tip_force(scene);
  EXPECT_EQ(response.status, Status::Completed);
  EXPECT_GT(response.samples, cut.samples);
  ASSERT_FALSE(response.chain.events.empty());
  const BrokenJoint& joint = response.chain.events.front().joints.front();
  EXPECT_EQ(joint.joint, 0);
  EXPECT_NEAR(joint.strain, 0.1, 1e-5) << "steps are cut back to meet it";
  EXPECT_NEAR(response.chain.events.front().time, cut.chain.events.front().time, 1e-4);
  EXPECT_GT(response.permanent_strain, joint.strain);
}

/// Of a beam between clamps whose middle is pushed, both clamps and the middle pass the limit: the
/// middle turns twice as far.
TEST(BreakEvent, IsRecordedOfEachJointOnceWhenItComes) {
  for (const int steps : {20, 200}) {
    Scene scene = breaking_cantilever(20);
    scene.on_break = BreakPolicy::RecordOnly;
    Support slides{.at = Place::end()};
    slides.hold = HeldFreedoms{false, true, false, true, true, true};
    scene.supports.push_back(slides);
    Support push{.at = {0.5, {}}, .kind = SupportKind::Roller};
    push.hold = HeldFreedoms{false, true, false, false, false, false};
    push.translation = {0.0, -0.15, 0.0};
    scene.supports.push_back(push);
    const Response response = simulate(scene, {.steps = steps});
    ASSERT_EQ(response.status, Status::Completed);
    std::vector<int> joints;
    for (const ChainBreak& event : response.chain.events) {
      for (const BrokenJoint& joint : event.joints) {
        joints.push_back(joint.joint);
        EXPECT_NEAR(joint.strain, 0.1, 2e-5) << steps;
        // (h/2) theta/h, theta by the chord: asin of twice the travel over the length, twice that
        // in the middle.
        const double chord = std::asin(0.3 * event.factor);
        EXPECT_NEAR(joint.joint == 10 ? 2.0 * chord : chord, 0.2, 0.02) << steps;
      }
    }
    EXPECT_EQ(joints.front(), 10);
    std::ranges::sort(joints);
    EXPECT_EQ(joints, (std::vector{0, 10, 20})) << steps;
  }
}

TEST(BreakEvent, OfBendingToAndFroComesByTheAccumulatedStrainAlone) {
  Scene scene = breaking_cantilever(10);
  const Response net = bend_to_and_fro(scene, 12);
  EXPECT_EQ(net.status, Status::Completed);
  EXPECT_TRUE(net.chain.events.empty());
  EXPECT_LT(net.permanent_strain, 0.05);

  scene.break_measure = BreakMeasure::Accumulated;
  const Response worn = bend_to_and_fro(scene, 12);
  ASSERT_EQ(worn.status, Status::Broken);
  const BrokenJoint& joint = worn.chain.events.front().joints.front();
  EXPECT_EQ(joint.joint, 0);
  EXPECT_NEAR(joint.strain, 0.1, tolerance(1.1e-5));
  // Ideal: the work is M_p times the angle turned to and fro, which is what wears out.
  EXPECT_NEAR(joint.dissipation / (kBreakingPlasticMoment * joint.strain * 0.05 / 0.025), 1.0,
              tolerance(1e-9));
  EXPECT_LT(std::fabs(joint.angle[0]), 0.5 * 0.2);  // the present angle is no reason to break
  EXPECT_GT(worn.chain.events.front().time, 1.0);
}

TEST(BreakEvent, OfTheReportMeetsItsEquationAtTheLimit) {
  Scene scene = breaking_cantilever(5);
  scene.formulas = Formulas::Report;
  scene.yield_cap = YieldCap::FirstYield;  // Wendelius' report has no other
  const Response response = break_by_tip_force(scene);
  ASSERT_EQ(response.status, Status::Broken);
  const BrokenJoint& joint = response.chain.events.front().joints.front();
  EXPECT_EQ(joint.joint, 1);  // the first segment is clamped
  // (24): (h/l) sin(theta/2) = eps, so theta = 2 asin(0.4) = 0.823 rad against 0.8 of mechanics.
  EXPECT_NEAR(std::fabs(joint.angle[0]), 2.0 * std::asin(0.4), tolerance(1e-4));
}

}  // namespace
}  // namespace plastica
