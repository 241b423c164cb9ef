#include "plastica/solve/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/chain.hpp"

namespace plastica::solve {
namespace {

using chain::Planar;
using chain::Spatial;
using chain::View;
using testing::cantilever;
using testing::SolvedChain;

template <class S>
using Elastic = law::ElasticSection<S>;
template <class S>
using Ideal = law::PerAxisSection<S, law::IdealPlastic<S>>;
template <class S>
using Hardening = law::PerAxisSection<S, law::LinearHardening<S>>;

/// Each imbalance is below a constant times the square of the one before, once they are small.
void expect_quadratic(const NewtonOutcome<double>& outcome) {
  ASSERT_TRUE(outcome.converged);
  ASSERT_GE(outcome.iterations, 3);
  int seen = 0;
  for (std::size_t i = 1; i < static_cast<std::size_t>(outcome.iterations); ++i) {
    const double before = outcome.imbalance[i];
    const double after = outcome.imbalance[i + 1];
    if (before > 0.05 || before < 1e-9) continue;
    ++seen;
    EXPECT_LT(after, 3.0 * before * before + 1e-13) << i;
  }
  EXPECT_GE(seen, 2);
}

TEST(Newton, ConvergesQuadraticallyOnALargeElasticStepInSpace) {
  using L = Spatial<double>;
  const Scene scene = cantilever(16, {700.0, -1200.0, 300.0});
  SolvedChain<L, false, Elastic<double>> solved(scene, material_values(scene.material));
  solved.go_to(0.5, 1);
  expect_quadratic(solved.go_to(1.0, 1));
}

TEST(Newton, ConvergesQuadraticallyWithStretchAndShear) {
  using L = Spatial<double>;
  Scene scene = cantilever(16, {700.0, -1200.0, 300.0});
  scene.material.youngs_modulus = 1e9;
  scene.loads[0].force = {4.0, -6.0, 50.0};
  SolvedChain<L, true, Elastic<double>> solved(scene, material_values(scene.material));
  expect_quadratic(solved.go_to(1.0, 1));
}

TEST(Newton, ConvergesQuadraticallyWhileJointsYieldAndHarden) {
  using L = Planar<double>;
  Scene scene = cantilever(32, {0.0, -600.0, 0.0});
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 20e9;
  SolvedChain<L, false, Hardening<double>> solved(scene, material_values(scene.material),
                                                  View<L>{1});
  solved.go_to(0.8, 4);
  const auto outcome = solved.go_to(1.0, 1);
  ASSERT_TRUE(outcome.converged);
  // The joints that yield change in the first iterations; from then on the square.
  const auto last = static_cast<std::size_t>(outcome.iterations);
  EXPECT_LT(outcome.imbalance[last], 3.0 * std::pow(outcome.imbalance[last - 1], 2) + 1e-13);
  EXPECT_GT(solved.joints->work_increment()[0], 0.0);
}

TEST(Newton, FeelsNoStrainInARigidMotionOfAnySize) {
  using L = Spatial<double>;
  Scene scene = cantilever(8, {0.0, 0.0, 0.0});
  scene.supports[0].translation = {0.3, -2.0, 1.1};
  scene.supports[0].rotation = {2.0, -1.0, 1.5};
  SolvedChain<L, false, Elastic<double>> solved(scene, material_values(scene.material));
  solved.go_to(1.0, 1);
  for (const auto& angle : solved.work.q.angle) {
    EXPECT_LT(std::sqrt(dot(angle, angle)), 1e-14);
  }
  const Vec<double, 3> tip =
      chain::rotation_matrix(Vec<double, 3>{{2.0, -1.0, 1.5}}) * Vec<double, 3>{{0.0, 0.0, 1.0}};
  EXPECT_NEAR(solved.tip()[0], 0.3 + tip[0], 1e-14 * 10);
  EXPECT_NEAR(solved.tip()[1], -2.0 + tip[1], 1e-14 * 10);
  EXPECT_NEAR(solved.tip()[2], 1.1 + tip[2], 1e-14 * 10);
}

TEST(Newton, KeepsEverySupportAtItsPlaceToRounding) {
  using L = Spatial<double>;
  Scene scene = cantilever(24, {200.0, -900.0, 100.0});
  scene.loads[0].at = {0.4, {}};
  Support roller;
  roller.at = Place::end();
  roller.kind = SupportKind::Roller;
  scene.supports.push_back(roller);
  SolvedChain<L, false, Elastic<double>> solved(scene, material_values(scene.material));
  ASSERT_TRUE(solved.go_to(1.0, 4).converged);
  EXPECT_NEAR(solved.tip()[0], 0.0, 1e-14);
  EXPECT_NEAR(solved.tip()[1], 0.0, 1e-14);
}

TEST(Newton, SaysSoWhereThereIsNoEquilibrium) {
  using L = Planar<double>;
  Scene scene = cantilever(8, {0.0, -5000.0, 0.0});
  scene.material.youngs_modulus *= 1e3;
  SolvedChain<L, false, Ideal<double>> solved(scene, material_values(scene.material), View<L>{1});
  solved.work.time = 1.0;
  const auto outcome = equilibrate(solved.build.chain, *solved.joints, {}, solved.work);
  EXPECT_FALSE(outcome.converged);
}

/// What looks for the end of one solve without slopes assembles once more if it was none; contacts,
/// which an assembly decides, must not be decided again.
TEST(Newton, AssemblesOnceAnIterationWhereThereAreContacts) {
  using L = Planar<double>;
  for (const bool contact : {false, true}) {
    Scene scene = cantilever(8, {0.0, -50.0, 0.0});
    if (contact) {
      Support pillar{.at = {0.5, {}}, .kind = SupportKind::Pillar};
      pillar.normal = {0.0, 1.0, 0.0};
      scene.supports.push_back(pillar);
    }
    SolvedChain<L, false, Elastic<double>> solved(scene, material_values(scene.material),
                                                  View<L>{1});
    solved.work.time = 1.0;
    NewtonOptions options;
    options.one_solve = true;
    options.max_iterations = 4;
    int all = 0;
    int looks = 0;
    equilibrate(
        solved.build.chain,
        [&](NewtonWork<L, false>& work, bool slopes) {
          ++all;
          if (!slopes) ++looks;
          detail::assemble(solved.build.chain, *solved.joints, work);
        },
        options, solved.work, [](const NewtonWork<L, false>&) { return PathCondition<L>{}; });
    EXPECT_EQ(looks == 0, contact);
    EXPECT_LE(all, options.max_iterations + 1 + looks);
  }
}

TEST(Newton, TakesNoImbalanceThatIsNoNumberForASmallOne) {
  const double nan = std::nan("");
  EXPECT_TRUE(std::isnan(detail::larger_size(1.0, nan)));
  EXPECT_TRUE(std::isnan(detail::larger_size(nan, 1.0)));
  EXPECT_EQ(detail::larger_size(1.0, -3.0), 3.0);
  EXPECT_EQ(detail::larger_size(1.0, 0.5), 1.0);
}

}  // namespace
}  // namespace plastica::solve
