#include <gtest/gtest.h>

#include <cmath>
#include <iterator>

#include "plastica/theory/lumped_chain.hpp"
#include "tests/lib/run/break_chain.hpp"
#include "tests/reference/reference_table.hpp"
#include "tests/support/tolerance.hpp"

// How the break of a chain depends on its segments (design 2.3), h = 0.05 L, break strain 10 %.

namespace plastica {
namespace {

using testing::break_by_tip_force;
using testing::break_by_uniform_moment;
using testing::breaking_cantilever;
using testing::broken_angle;
using testing::kBreakingPlasticMoment;
using testing::plastic_rotation;
using testing::plastic_work;

/// The break is met within 1e-4 of the limit strain, and so are angle and work.
constexpr double kMet = 1.1e-4;
constexpr int kCounts[] = {5, 10, 20, 40, 80, 160};

Scene hardening(Scene scene) {
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 2e9;
  return scene;
}

TEST(BreakOfAChain, OfTheReportTurnsAndTakesInverselyToTheSegments) {
  const testing::ReferenceTable table("lumped-chain-exact/break_mesh_dependence.csv");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const int segments = static_cast<int>(table.at("N", row));
    Scene scene = breaking_cantilever(segments);
    scene.hinge_length = 0.0;
    scene.end_rule = EndRule::Equal;
    const Response clamped = break_by_tip_force(scene);
    ASSERT_EQ(clamped.status, Status::Broken) << segments;
    const double angle = table.at("joint_break_angle_rad", row);
    const double energy =
        kBreakingPlasticMoment / 0.05 * table.at("energy_to_break_over_MpxL_over_h", row);
    EXPECT_NEAR(broken_angle(clamped) / angle, 1.0, testing::tolerance(kMet)) << segments;
    EXPECT_NEAR(plastic_work(clamped) / energy, 1.0, testing::tolerance(kMet)) << segments;

    scene.end_rule = EndRule::HalfJoint;
    const Response half = break_by_tip_force(scene);
    ASSERT_EQ(half.status, Status::Broken) << segments;
    EXPECT_NEAR(broken_angle(half) / angle, 0.5, testing::tolerance(kMet)) << segments;
    EXPECT_NEAR(plastic_work(half) / energy, 0.5, testing::tolerance(kMet)) << segments;
  }
}

TEST(BreakOfAChain, OfTheReportHasTheSlopeMinusOneOverTheSegments) {
  for (const EndRule rule : {EndRule::Equal, EndRule::HalfJoint}) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, first = 0.0;
    for (const int segments : kCounts) {
      Scene scene = breaking_cantilever(segments);
      scene.hinge_length = 0.0;
      scene.end_rule = rule;
      const double angle = broken_angle(break_by_tip_force(scene));
      if (segments == 5) first = angle;
      x += std::log(segments);
      y += std::log(angle);
      xx += std::log(segments) * std::log(segments);
      xy += std::log(segments) * std::log(angle);
    }
    const double count = std::size(kCounts);
    EXPECT_NEAR((count * xy - x * y) / (count * xx - x * x), -1.0, testing::tolerance(0.02));
    EXPECT_NEAR(first, rule == EndRule::Equal ? 0.80 : 0.40, testing::tolerance(1e-4));
  }
}

TEST(BreakOfAChain, WithAHingeLengthIsTheSameForAllSegmentsUnderATipForce) {
  const theory::HingeBreak hinge =
      theory::hinge_break(0.1, 0.05, 0.05, kBreakingPlasticMoment, 1.0);
  for (const int segments : kCounts) {
    for (const EndRule rule : {EndRule::Equal, EndRule::HalfJoint}) {
      Scene scene = breaking_cantilever(segments);
      scene.end_rule = rule;
      const Response response = break_by_tip_force(scene);
      ASSERT_EQ(response.status, Status::Broken) << segments;
      EXPECT_NEAR(broken_angle(response) / hinge.angle, 1.0, testing::tolerance(kMet)) << segments;
      EXPECT_NEAR(plastic_work(response) / hinge.energy, 1.0, testing::tolerance(kMet)) << segments;
    }
  }
}

TEST(BreakOfAChain, WithAHingeLengthIsTheSameForAllSegmentsUnderUniformMoment) {
  // All joints reach the permanent curvature 2 eps/h together.
  const double rotation = 2.0 * 0.1 / 0.05;
  for (const int segments : kCounts) {
    const auto joints = static_cast<std::size_t>(segments) + 1;
    const Response ideal = break_by_uniform_moment(breaking_cantilever(segments));
    ASSERT_EQ(ideal.status, Status::Broken) << segments;
    EXPECT_NEAR(plastic_rotation(ideal) / rotation, 1.0, testing::tolerance(kMet)) << segments;
    EXPECT_NEAR(plastic_work(ideal) / (kBreakingPlasticMoment * rotation), 1.0,
                testing::tolerance(kMet))
        << segments;
    EXPECT_EQ(ideal.chain.events.front().joints.size(), joints);
    const Response hard = break_by_uniform_moment(hardening(breaking_cantilever(segments)));
    ASSERT_EQ(hard.status, Status::Broken) << segments;
    EXPECT_NEAR(plastic_rotation(hard) / rotation, 1.0, testing::tolerance(kMet)) << segments;
    EXPECT_EQ(hard.chain.events.front().joints.size(), joints);
  }
}

TEST(BreakOfAChain, WithTheRigidClampLosesTheHalfSegmentsAtTheEnds) {
  for (const int segments : kCounts) {
    Scene scene = breaking_cantilever(segments);
    scene.end_rule = EndRule::Equal;
    const Response response = break_by_uniform_moment(scene);
    EXPECT_NEAR(plastic_rotation(response), 4.0 * (segments - 1) / segments,
                testing::tolerance(4.0 * kMet));
  }
}

TEST(BreakOfAChain, ThatHardensConvergesUnderATipForce) {
  // What is left is the discretisation of the plastic zone: 2.15 % at N = 5, of second order.
  const auto broken = [](int segments) {
    Response response = break_by_tip_force(hardening(breaking_cantilever(segments)));
    EXPECT_EQ(response.status, Status::Broken) << segments;
    return response;
  };
  const Response finest = broken(160);
  const double rotation = plastic_rotation(finest);
  const double work = plastic_work(finest);
  for (const int segments : {10, 20, 40, 80}) {
    const Response response = broken(segments);
    EXPECT_NEAR(plastic_rotation(response) / rotation, 1.0, testing::tolerance(0.004)) << segments;
    EXPECT_NEAR(plastic_work(response) / work, 1.0, testing::tolerance(0.012)) << segments;
  }
  const double coarse = plastic_rotation(broken(5)) / rotation - 1.0;
  const double next = plastic_rotation(broken(10)) / rotation - 1.0;
  EXPECT_NEAR(coarse, 0.0, testing::tolerance(0.022));
  EXPECT_GT(std::log2(coarse / next), 1.95);

  // The rigid clamp costs an order: it takes half a segment out of the plastic zone.
  const auto clamped = [&](int segments) {
    Scene scene = hardening(breaking_cantilever(segments));
    scene.end_rule = EndRule::Equal;
    return plastic_rotation(break_by_tip_force(scene)) / rotation - 1.0;
  };
  EXPECT_NEAR(std::log2(clamped(40) / clamped(80)), 1.0, testing::tolerance(0.05));
}

// Probe, picture and break are one quantity; only the strain over a joint's own length falls with
// it.
TEST(BreakOfAChain, IsReadByItsProbesAsTheLimitWhateverTheSegments) {
  for (const BreakMeasure measure : {BreakMeasure::Net, BreakMeasure::Accumulated}) {
    const bool net = measure == BreakMeasure::Net;
    for (const int segments : {8, 16, 32, 64}) {
      Scene scene = breaking_cantilever(segments);
      scene.break_measure = measure;
      scene.probes = {
          {"hinge", net ? ProbeQuantity::PlasticStrain : ProbeQuantity::AccumulatedStrain,
           Place::start(), Component::X},
          {"local", net ? ProbeQuantity::LocalPlasticStrain : ProbeQuantity::LocalAccumulatedStrain,
           Place::start(), Component::X}};
      const Response response = break_by_tip_force(scene);
      ASSERT_EQ(response.status, Status::Broken) << segments;
      const double limit = *scene.material.break_strain;
      const double hinge = std::fabs(response.probes[0][response.samples - 1]);
      EXPECT_NEAR(hinge / limit, 1.0, testing::tolerance(kMet)) << segments;
      const ChainHistory& chain = response.chain;
      const double pictured = chain.plastic_strain[(response.samples - 1) * chain.joints];
      EXPECT_DOUBLE_EQ(hinge, pictured) << segments;
      EXPECT_DOUBLE_EQ(hinge, chain.events.front().joints.front().strain) << segments;
      // The hinge's rotation is 2 x 0.1 rad; the clamp's joint stands for half a segment.
      const double local = std::fabs(response.probes[1][response.samples - 1]);
      EXPECT_NEAR(local / (limit * 0.05 * 2.0 * segments), 1.0, testing::tolerance(kMet))
          << segments;
    }
  }
}

}  // namespace
}  // namespace plastica
