#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "plastica/solve/motion_step.hpp"
#include "tests/support/chain.hpp"
#include "tests/support/motion_scene.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica {
namespace {

template <class L>
class MotionStepOf : public ::testing::Test {
 public:
  using Law = law::ElasticSection<double>;
  using Step = solve::MotionStep<L, false>;

  static testing::SolvedChain<L, false, Law> flying_chain(int segments) {
    const Scene scene = testing::flying_scene(segments, false);
    testing::SolvedChain<L, false, Law> solved(scene, material_values(scene.material));
    auto& work = solved.work;
    chain::place<false>(solved.build.chain, work.q, 0.0, work.placement);
    work.q.open[0] = true;
    work.q.pose[0] = {work.placement.position[0], work.placement.frame[0]};
    return solved;
  }
  Step step_of(testing::SolvedChain<L, false, Law>& solved) const {
    const chain::View<L> view{};
    return Step(solved.build.chain, *solved.joints, view.section_axes(), options_, solved.work);
  }
  /// Thrown and turning, all alike.
  static std::vector<solve::SegmentMotion<L>> throw_of(std::size_t segments, double length) {
    std::vector<solve::SegmentMotion<L>> motion(segments);
    for (std::size_t i = 0; i < segments; ++i) {
      motion[i].spin[0] = 3.0;
      const double arm = (static_cast<double>(i) + 0.5) / static_cast<double>(segments) - 0.5;
      // About x in space, y falls as z grows; in the plane of (z, y) the spin counts the other way.
      motion[i].velocity[1] = 0.2 + (L::kRotations == 3 ? -3.0 : 3.0) * arm * length;
    }
    return motion;
  }

 private:
  const solve::MotionOptions options_{.scheme = Scheme::EnergyMomentum};
};

using Levels = ::testing::Types<chain::Planar<double>, chain::Spatial<double>>;
TYPED_TEST_SUITE(MotionStepOf, Levels);

TYPED_TEST(MotionStepOf, GoesBackTheWayItCame) {
  auto solved = this->flying_chain(4);
  typename TestFixture::Step step = this->step_of(solved);
  auto motion = this->throw_of(4, 1.0);
  motion[3].spin[0] += 2.0;  // it bends, too
  ASSERT_TRUE(step.start(motion));
  const chain::Placement<TypeParam> begin = step.begin();
  const int steps = testing::kSanitized ? 100 : 1000;
  for (int k = 0; k < steps; ++k) {
    ASSERT_TRUE(step.attempt(1e-4));
    step.accept();
  }
  double away = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    away = std::max(away, size_of(step.begin().position[i] - begin.position[i]));
  }
  EXPECT_GT(away, 0.01);
  for (int k = 0; k < steps; ++k) {
    ASSERT_TRUE(step.attempt(-1e-4));
    step.accept();
  }
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(size_of(step.begin().position[i] - begin.position[i]), 1e-8);
  }
}

TYPED_TEST(MotionStepOf, ChangesNoMomentumAndNoPlaceByACut) {
  auto solved = this->flying_chain(6);
  typename TestFixture::Step step = this->step_of(solved);
  ASSERT_TRUE(step.start(this->throw_of(6, 1.0)));
  for (int k = 0; k < 10; ++k) {
    ASSERT_TRUE(step.attempt(1e-3));
    step.accept();
  }
  const auto before = step.motions();
  const auto placed = step.begin();
  step.open(2);
  step.open(4);
  step.opened();
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(size_of(step.motions()[i].velocity - before[i].velocity), 0.0);
    EXPECT_EQ(size_of(step.motions()[i].spin - before[i].spin), 0.0);
    EXPECT_LT(size_of(step.begin().position[i] - placed.position[i]), 1e-15);
  }
  // From then on each fragment keeps its own.
  const auto momentum = [&](std::size_t first, std::size_t last) {
    typename TypeParam::Point sum{};
    for (std::size_t i = first; i <= last; ++i) {
      sum += solved.build.chain.inertias[i].mass * step.motions()[i].velocity;
    }
    return sum;
  };
  const auto turning = [&](std::size_t first, std::size_t last) {
    typename TypeParam::Spin sum{};
    for (std::size_t i = first; i <= last; ++i) {
      const auto& inertia = solved.build.chain.inertias[i];
      sum += TypeParam::moment(step.begin().point(i, inertia.center),
                               inertia.mass * step.motions()[i].velocity) +
             solve::angular_momentum(inertia, step.begin().frame[i], step.motions()[i].spin);
    }
    return sum;
  };
  for (const auto& [first, last] : {std::pair{0UL, 1UL}, {2UL, 3UL}, {4UL, 5UL}}) {
    const auto p = momentum(first, last);
    const auto l = turning(first, last);
    ASSERT_TRUE(step.attempt(1e-3));
    step.accept();
    EXPECT_LT(size_of(momentum(first, last) - p), 1e-12 * size_of(p));
    EXPECT_LT(size_of(turning(first, last) - l), 1e-12 * size_of(l));
  }
}

TYPED_TEST(MotionStepOf, LetsAThrownBeamTurnAsARigidBody) {
  auto solved = this->flying_chain(5);
  typename TestFixture::Step step = this->step_of(solved);
  ASSERT_TRUE(step.start(this->throw_of(5, 1.0)));
  const double energy = step.kinetic();
  for (int k = 0; k < 100; ++k) {
    ASSERT_TRUE(step.attempt(1e-3));
    step.accept();
  }
  EXPECT_NEAR(step.kinetic(), energy, 1e-4 * energy);  // it stretches its joints a little
}

}  // namespace
}  // namespace plastica
