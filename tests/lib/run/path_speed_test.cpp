#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "plastica/chain/level.hpp"
#include "plastica/solve/path_options.hpp"
#include "tests/support/chain_scene.hpp"

// A path at rest depends on where loads and motions go, and not on how fast: what a history with
// any points gives is what the straight one gives, up to a limit load and beyond first yield.

namespace plastica {
namespace {

using testing::add_probe;
using testing::cantilever_scene;
using testing::completed;
using testing::last_of;
using testing::yield_moment_of;

/// From 0 to 1 in two seconds, and what of it is reached after the first one.
std::vector<History> histories() {
  std::vector<History> all;
  for (const double half : {0.5, 1e-2, 1e-4, 1e-6, 0.3, 0.999}) {
    all.push_back({{0.0, 1.0, 2.0}, {0.0, half, 1.0}});
  }
  // That begins with rounding in place of 0.
  all.push_back({{0.0, 1.0, 2.0}, {0.0, 1e-14, 1.0}});
  // Smooth ones, that begin later than the path, or slowly.
  all.push_back(History::smooth_step(0.5, 2.0));
  all.push_back(History::smooth_step(0.0, 2.0));
  all.push_back(History::spline({0.0, 1.0, 2.0}, {0.0, 0.3, 1.0}));
  // That nearly rests on its way, and goes on.
  all.push_back({{0.0, 0.5, 1.0, 2.0}, {0.0, 0.45, 0.45 + 1e-10, 1.0}});
  all.push_back({{0.0, 0.5, 1.0, 2.0}, {0.0, 0.45, 0.45, 1.0}});
  // As measured curves are followed: a point for each sample, at uneven distances.
  History uneven{{0.0}, {0.0}};
  for (int i = 1; i <= 40; ++i) {
    const double x = i / 40.0;
    uneven.time.push_back(0.05 * i);
    uneven.factor.push_back(x * x * (1.0 + 0.02 * (i % 3)) / 1.02);
  }
  uneven.factor.back() = 1.0;
  all.push_back(uneven);
  return all;
}

/// A cantilever whose tip is moved, or pushed, to well beyond first yield.
Scene bent(YieldModel yields, bool pushed) {
  Scene scene = cantilever_scene(12);
  scene.yield_model = yields;
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 0.02 * scene.material.youngs_modulus;
  const double stiffness = 3.0 * testing::bending_stiffness_of(scene);
  const double first_yield = yield_moment_of(scene);
  if (pushed) {
    scene.loads.push_back({.force = {0.0, -1.6 * first_yield, 0.0}});
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  } else {
    Support tip{.at = Place::end(), .kind = SupportKind::Roller};
    tip.translation = {0.0, -2.0 * first_yield / stiffness, 0.0};
    scene.supports.push_back(tip);
    add_probe(scene, ProbeQuantity::Reaction, Place::start(), Component::Y);
  }
  return scene;
}

History& history_of(Scene& scene) {
  return scene.loads.empty() ? scene.supports.back().history : scene.loads.back().history;
}

TEST(PathSpeed, DoesNotChangeWhatABeamBearsBeyondYield) {
  for (const YieldModel yields : {YieldModel::Fibre, YieldModel::PerAxis}) {
    for (const bool pushed : {false, true}) {
      for (const Level level : {Level::Planar, Level::Spatial}) {
        Scene scene = bent(yields, pushed);
        history_of(scene) = {{0.0, 2.0}, {0.0, 1.0}};
        const SolverOptions options{.level = level, .steps = 20};
        const Response straight = completed(scene, options);
        for (const History& history : histories()) {
          history_of(scene) = history;
          const Response response = completed(scene, options);
          EXPECT_NEAR(last_of(response, 0) / last_of(straight, 0), 1.0, 1e-6)
              << history.factor[1] << ' ' << pushed;
        }
      }
    }
  }
}

TEST(PathSpeed, LeavesALimitLoadWhereItIs) {
  // A hinge of the fully plastic moment at the clamp; stiffened, so that the shape stays.
  Scene scene = cantilever_scene(8);
  scene.yield_model = YieldModel::PerAxis;
  scene.yield_cap = YieldCap::FullyPlastic;
  scene.material.youngs_modulus *= 1e3;
  const double limit = 1.5 * yield_moment_of(scene);
  scene.loads.push_back({.force = {0.0, -2.0 * limit, 0.0}});
  for (const History& history : histories()) {
    scene.loads[0].history = history;
    const Response response = simulate(scene, {.steps = 20});
    ASSERT_EQ(response.status, Status::LimitLoad) << history.factor[1];
    // Bracketed to 1e-4 of the time, in which the factor grows by up to 1.5 a second.
    EXPECT_LE(response.limit->below, 0.5 + 1e-9) << history.factor[1];
    EXPECT_GE(response.limit->above, 0.5 - 1e-9) << history.factor[1];
    EXPECT_LT(response.limit->above - response.limit->below, 1.5e-4) << history.factor[1];
  }
}

TEST(PathSpeed, OfALoadThatHardlyActedBeforeIsNoLimit) {
  // What the first load does sets no scale for what the second one does.
  for (const bool pushed : {false, true}) {
    Scene scene = bent(YieldModel::Fibre, pushed);
    history_of(scene) = {{1.0, 2.0}, {0.0, 1.0}};
    const double alone = last_of(completed(scene, {.steps = 20}), 0);
    Load slight{.at = {0.5, {}}};
    slight.force = {0.0, -1e-4, 0.0};
    slight.history = {{0.0, 1.0}, {0.0, 1.0}};
    scene.loads.insert(scene.loads.begin(), slight);
    const Response response = completed(scene, {.steps = 20});
    EXPECT_NEAR(last_of(response, 0) / alone, 1.0, 1e-5) << pushed;
  }
}

TEST(PathSpeed, OfWhatFallsHidesNoBucklingOutOfThePlane) {
  // A thin strip, stable at its end, that has left its plane on the way: P_c = 4.013
  // sqrt(EI GJ)/L^2 (Timoshenko and Gere, Theory of Elastic Stability, 1961, art. 6.3).
  Scene scene = cantilever_scene(20);
  scene.beam.length = 2.0;
  scene.section.width = 0.005;
  scene.section.height = 0.06;
  const SectionProperties p = testing::properties_of(scene);
  const double e = scene.material.youngs_modulus;
  const double g = e / (2.0 * (1.0 + scene.material.poisson_ratio));
  const double critical = 4.013 * std::sqrt(e * p.second_moment_y * g * p.torsion_constant) / 4.0;
  const Load load{.at = Place::end(), .force = {0.0, -critical, 0.0}};
  const auto status = [&](const History& history, int steps, double duration) {
    scene.loads = {load};
    scene.loads[0].history = history;
    return simulate(scene, {.level = Level::Planar, .duration = duration, .steps = steps}).status;
  };
  // It acts at once and only falls; its peak is no sample; a smooth peak.
  EXPECT_EQ(status({{0.0, 1.0, 2.0}, {1.5, 1.2, 0.2}}, 20, 2.0), Status::Unstable);
  EXPECT_EQ(status({{0.0, 1.0, 3.0}, {0.0, 1.5, 0.2}}, 20, 3.0), Status::Unstable);
  EXPECT_EQ(status({{0.0, 1.0, 3.0}, {0.0, 0.9, 0.2}}, 20, 3.0), Status::Completed);
  History swing = History::sine(1.0, 0.5);
  for (double& factor : swing.factor) factor *= 1.5;
  for (double& slope : swing.slope) slope *= 1.5;
  EXPECT_EQ(status(swing, 7, 0.5), Status::Unstable);
  // It stays, and another lifts it ever more.
  scene.loads = {load, load};
  for (double& force : scene.loads[0].force) force *= 1.5;
  for (double& force : scene.loads[1].force) force *= -1.2;
  scene.loads[0].history = History::constant();
  scene.loads[1].history = {{0.0, 1.0, 2.0}, {0.0, 0.1, 1.0}};
  EXPECT_EQ(simulate(scene, {.level = Level::Planar, .steps = 20}).status, Status::Unstable);
}

TEST(PathSpeed, ChangesByOneFactorOrHasACorner) {
  const auto change_at_1 = [](std::vector<History> histories) {
    chain::Chain<chain::Planar<double>> chain;
    chain.histories = std::move(histories);
    return solve::speed_change(chain, 1.0, 1e-9);
  };
  const History faster{{0.0, 1.0, 2.0}, {0.0, 0.1, 0.4}};
  const History alike{{0.0, 1.0, 3.0}, {1.0, 0.8, -0.4}};
  const History back{{0.0, 1.0, 2.0}, {0.0, 0.2, -0.2}};
  const History rests = History::constant();
  const auto expect = [&](const solve::SpeedChange& change, double factor) {
    ASSERT_TRUE(change.factor.has_value());
    EXPECT_NEAR(*change.factor, factor, 1e-12);
    EXPECT_EQ(change.is_corner(), factor < 0.0);
  };
  expect(change_at_1({rests, faster}), 3.0);
  expect(change_at_1({faster, alike}), 3.0);
  expect(change_at_1({back}), -2.0);
  expect(change_at_1({rests, History::ramp(), History::smooth_step(0.5, 2.0)}), 1.0);
  for (const std::vector<History>& corner : {std::vector<History>{faster, History::ramp()},
                                             {faster, back},
                                             {{{1.0, 2.0}, {0.0, 1.0}}},
                                             {{{0.0, 1.0}, {0.0, 1.0}}},
                                             {History::smooth_step(0.0, 1.0), History::ramp()}}) {
    const solve::SpeedChange change = change_at_1(corner);
    EXPECT_FALSE(change.factor.has_value());
    EXPECT_TRUE(change.is_corner());
  }
}

}  // namespace
}  // namespace plastica
