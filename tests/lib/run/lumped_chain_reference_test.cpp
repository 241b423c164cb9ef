#include <gtest/gtest.h>

#include <string>

#include "plastica/theory/lumped_chain.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

/// A chain under loads so small that its rotations are linear, against the exact discrete sums.
namespace plastica {
namespace {

using theory::ChainConvention;

/// Rotations of 1e-5 change a deflection by 1e-10 of it.
constexpr double kAlpha = 1e-5;

struct Convention {
  const char* name;
  EndRule rule;
  ChainConvention theory;
  int more_segments;  ///< than the theory's N
};

constexpr std::array kConventions{
    Convention{"A", EndRule::Equal, ChainConvention::Clamp, 0},
    Convention{"C", EndRule::HalfJoint, ChainConvention::HalfJoint, 0},
    Convention{"D", EndRule::Half, ChainConvention::HalfEnds, 1},
    Convention{"three halves", EndRule::ThreeHalves, ChainConvention::ThreeHalvesEnds, 0}};

class LumpedChainRun : public ::testing::TestWithParam<Convention> {
 protected:
  Scene scene(int n) const {
    Scene made = testing::cantilever_scene(n + GetParam().more_segments);
    made.end_rule = GetParam().rule;
    testing::add_probe(made, ProbeQuantity::Displacement, Place::end(), Component::Y);
    return made;
  }

  /// Tip deflection over that of the continuous beam, against its exact value.
  static void expect_ratio(const Scene& made, double continuum, double exact) {
    const Response response = testing::completed(made, {.steps = 1});
    EXPECT_NEAR(testing::last_of(response, 0) / continuum / exact, 1.0, testing::tolerance(1e-8));
  }
};

constexpr std::array kCounts{2, 4, 5, 8, 10, 16, 20, 32, 40, 64, 100};

TEST_P(LumpedChainRun, BendsUnderATipForceByTheExactRatio) {
  for (const int n : kCounts) {
    SCOPED_TRACE(n);
    Scene made = scene(n);
    const double force = kAlpha * testing::bending_stiffness_of(made);
    made.loads.push_back({.force = {0.0, force, 0.0}});
    expect_ratio(made, kAlpha / 3.0, tip_force_ratio(GetParam().theory, n));
  }
}

TEST_P(LumpedChainRun, BendsUnderItsWeightByTheExactRatio) {
  for (const int n : kCounts) {
    SCOPED_TRACE(n);
    Scene made = scene(n);
    const double mass = made.material.density * testing::properties_of(made).area;
    made.gravity = {0.0, kAlpha * testing::bending_stiffness_of(made) / mass, 0.0};
    expect_ratio(made, kAlpha / 8.0, self_weight_ratio(GetParam().theory, n));
  }
}

TEST_P(LumpedChainRun, BendsUnderATipMomentByTheExactRatio) {
  for (const int n : kCounts) {
    SCOPED_TRACE(n);
    Scene made = scene(n);
    const double moment = kAlpha * testing::bending_stiffness_of(made);
    made.loads.push_back({.moment = {-moment, 0.0, 0.0}});  // turns z towards y
    // With half joints the last joint, l from the end, has the end's half, too: l/2 more at the
    // lever l, so l^2/2 more of L^2/2.
    const bool half = GetParam().theory == theory::ChainConvention::HalfJoint;
    expect_ratio(made, kAlpha / 2.0,
                 tip_moment_ratio(GetParam().theory, n) + (half ? 1.0 / (n * n) : 0.0));
  }
}

INSTANTIATE_TEST_SUITE_P(Conventions, LumpedChainRun, ::testing::ValuesIn(kConventions),
                         [](const auto& instance) {
                           const std::string name = instance.param.name;
                           return name.size() == 1 ? name : std::string("ThreeHalves");
                         });

}  // namespace
}  // namespace plastica
