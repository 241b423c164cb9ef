#include "plastica/theory/lumped_chain.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "plastica/theory/bending.hpp"
#include "plastica/theory/cantilever.hpp"
#include "tests/reference/reference_table.hpp"

namespace plastica::theory {
namespace {

constexpr std::array kConventions{ChainConvention::Clamp, ChainConvention::FullJoint,
                                  ChainConvention::HalfJoint, ChainConvention::HalfEnds,
                                  ChainConvention::ThreeHalvesEnds};

/// The chain's sum over its joints: w s^power.
double moment_sum(ChainConvention convention, int count, int power) {
  double sum = 0.0;
  for (const ChainJoint& joint : chain_joints(convention, count)) {
    sum += joint.length * std::pow(joint.lever, power);
  }
  return sum;
}

TEST(LumpedChain, MatchesTheReferenceTable) {
  const testing::ReferenceTable table("lumped-chain-exact/discretisation_error.csv");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const std::string& letter = table.text("convention", i);
    const int n = static_cast<int>(table.at("N", i));
    SCOPED_TRACE(letter + " " + std::to_string(n));
    const ChainConvention convention = kConventions.at(static_cast<std::size_t>(letter[0] - 'A'));
    EXPECT_NEAR(tip_force_ratio(convention, n), table.at("tipforce_deflection_ratio", i), 1e-9);
    EXPECT_NEAR(self_weight_ratio(convention, n), table.at("selfweight_deflection_ratio", i), 1e-9);
    EXPECT_NEAR(tip_moment_ratio(convention, n), table.at("tipmoment_deflection_ratio", i), 1e-9);
  }
}

TEST(LumpedChain, ClosedFormsAreTheSumsOverTheJoints) {
  for (const ChainConvention convention : kConventions) {
    for (const int n : {2, 3, 7, 1000}) {
      SCOPED_TRACE(n);
      EXPECT_NEAR(tip_moment_ratio(convention, n), 2.0 * moment_sum(convention, n, 1), 1e-12);
      EXPECT_NEAR(tip_force_ratio(convention, n), 3.0 * moment_sum(convention, n, 2), 1e-12);
      EXPECT_NEAR(self_weight_ratio(convention, n), 4.0 * moment_sum(convention, n, 3), 1e-12);
    }
  }
}

TEST(LumpedChain, ConvergesWithOrderTwoExceptWithTheRigidClampAndTheFullJoint) {
  for (const ChainConvention convention : kConventions) {
    const double coarse = std::abs(self_weight_ratio(convention, 1000) - 1.0);
    const double fine = std::abs(self_weight_ratio(convention, 2000) - 1.0);
    const bool first_order =
        convention == ChainConvention::Clamp || convention == ChainConvention::FullJoint;
    EXPECT_NEAR(std::log2(coarse / fine), first_order ? 1.0 : 2.0, 2e-3);
  }
}

TEST(LumpedChain, WithTheRectanglesYieldLawMatchesTheReferenceTable) {
  const testing::ReferenceTable table("lumped-chain-exact/prager_hodge_chain_convergence.csv");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double p = table.at("P_over_Py", i);
    const int n = static_cast<int>(table.at("N", i));
    SCOPED_TRACE(std::to_string(p) + " " + std::to_string(n));
    EXPECT_NEAR(elastoplastic_tip_ratio(ChainConvention::HalfEnds, n, p),
                table.at("tip_over_delta_y_lumped_midpoint", i), 1e-8);  // the printed digits
    EXPECT_NEAR(tip_deflection_ratio(p), table.at("closed_form", i), 1e-8);
    const ChainJoint root = chain_joints(ChainConvention::HalfEnds, n).front();
    EXPECT_NEAR(curvature_ratio_rectangle(p * root.lever),
                table.at("root_joint_curvature_over_ky", i), 1e-8);
    EXPECT_NEAR(curvature_ratio_rectangle(p), table.at("closed_form_root_curvature", i), 1e-8);
  }
}

TEST(LumpedChain, WithTheHalfJointErrsInYieldAsTheTrapezoidalRuleDoes) {
  // Its sum is that rule for 3 s k(p s); the leading term of the error is h^2/12 times the slope at
  // the clamp, k(p) + p k'(p) with k' = k^3 (at the tip the slope is zero).
  constexpr int kCount = 160;
  for (const double p : {1.25, 1.4, 1.48}) {
    const double k = curvature_ratio_rectangle(p);
    const double leading = 3.0 / 12.0 * (k + p * k * k * k) / (kCount * kCount);
    const double error =
        elastoplastic_tip_ratio(ChainConvention::HalfJoint, kCount, p) - tip_deflection_ratio(p);
    EXPECT_NEAR(error / leading, 1.0, 0.02) << p;
    EXPECT_LT(error, 0.001 * tip_deflection_ratio(p)) << p;
  }
}

TEST(HingeBreak, MatchesTheReferenceTable) {
  const testing::ReferenceTable table("lumped-chain-exact/break_mesh_dependence.csv");
  constexpr double kLength = 3.0, kDepth = 0.05 * kLength, kMoment = 7.0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double n = table.at("N", i);
    SCOPED_TRACE(n);
    const HingeBreak joint = hinge_break(0.1, kDepth, kLength / n, kMoment, kLength);
    EXPECT_NEAR(joint.angle, table.at("joint_break_angle_rad", i), 1e-9);
    EXPECT_NEAR(joint.tip_travel / kLength, table.at("tip_plastic_deflection_at_break_over_L", i),
                1e-9);
    EXPECT_NEAR(joint.energy / (kMoment * kLength / kDepth),
                table.at("energy_to_break_over_MpxL_over_h", i), 1e-9);
    const HingeBreak material = hinge_break(0.1, kDepth, kDepth, kMoment, kLength);
    EXPECT_NEAR(material.angle, table.at("with_Lp_regularisation_angle_rad", i), 1e-9);
  }
}

TEST(HingeBreak, IsHalfAsLargeWithTheHalfJoint) {
  const double length = 1.0 / 5.0;
  EXPECT_NEAR(hinge_break(0.1, 0.05, length, 1.0, 1.0).angle, 0.8, 1e-15);
  EXPECT_NEAR(hinge_break(0.1, 0.05, 0.5 * length, 1.0, 1.0).angle, 0.4, 1e-15);
}

TEST(LumpedChain, OfPinnedEndsHasItsFrequencyToOrderFour) {
  // Of two segments, E I = rho A = L = 1: one joint of stiffness 2, turned by 4 w, and two rods of
  // the mass 1/2, of which a third swings with w.
  const double omega = std::sqrt(2.0 * 4.0 * 4.0 / (2.0 * 0.5 / 3.0));
  const double half_turn = std::numbers::pi;
  EXPECT_NEAR(pinned_chain_frequency_ratio(2, 1), omega / (half_turn * half_turn), 1e-14);
  const double coarse = pinned_chain_frequency_ratio(20, 1) - 1.0;
  const double fine = pinned_chain_frequency_ratio(40, 1) - 1.0;
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.01);
}

TEST(LumpedChain, BucklesAtEulersLoadToOrderTwo) {
  // One segment on a joint of 2 E I/L; its load moves by phi out of line.
  EXPECT_NEAR(buckling_load(1, 3.0, 2.0), 2.0 * 3.0 / (2.0 * 2.0), 1e-14);
  const double euler = 0.25 * std::numbers::pi * std::numbers::pi;
  const double coarse = buckling_load(20, 1.0, 1.0) / euler - 1.0;
  const double fine = buckling_load(40, 1.0, 1.0) / euler - 1.0;
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.01);
}

}  // namespace
}  // namespace plastica::theory
