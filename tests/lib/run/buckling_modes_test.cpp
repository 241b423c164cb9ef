#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "plastica/theory/lumped_chain.hpp"
#include "tests/support/chain_scene.hpp"

/// Load factors at which a beam buckles, looked for about a state far below them.
namespace plastica {
namespace {

using std::numbers::pi;

HeldFreedoms sliding_clamp() { return {true, true, false, true, true, true}; }

Scene pinned_column(int segments, double thrust) {
  Scene scene = testing::chain_scene(segments);
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  scene.loads.push_back({.force = {0.0, 0.0, -thrust}});
  return scene;
}

BucklingModes buckling_of(const Scene& scene, SolverOptions options, int count) {
  options.buckling = count;
  const Response response = simulate(scene, options);
  EXPECT_TRUE(response.buckling.has_value()) << name_of(response.status);
  return response.buckling.value_or(BucklingModes{});
}

/// A joint is stiffer than its law by 1e-9.
constexpr double kExact = 1.1e-9;

/// P_m of N equal segments on joints of E I/l: 2 E I/l^2 (1 - cos(m pi/N)), l = 1/N.
double pinned_chain_load(int n, int m, double stiffness) {
  return 2.0 * n * n * stiffness * (1.0 - std::cos(m * pi / n));
}

TEST(BucklingModes, OfAPinnedChainAreExactFromAnyLoad) {
  constexpr int kSegments = 12;
  Scene scene = pinned_column(kSegments, 1.0);
  const double stiffness = testing::bending_stiffness_of(scene);
  const double first = pinned_chain_load(kSegments, 1, stiffness);
  for (const double fraction : {1e-6, 0.3, 0.99}) {
    scene.loads[0].force[2] = -fraction * first;
    const BucklingModes modes = buckling_of(scene, {.level = Level::Planar}, 4);
    EXPECT_EQ(modes.about, 1.0);
    ASSERT_EQ(modes.factor.size(), 8U / 2U);
    // Square: each mode once in the plane, once out of it.
    for (std::size_t k = 0; k < 4; ++k) {
      const int m = static_cast<int>(k) / 2 + 1;
      const double exact = pinned_chain_load(kSegments, m, stiffness);
      EXPECT_NEAR(modes.factor[k] * fraction * first / exact, 1.0, kExact) << fraction << ' ' << k;
      const std::size_t across = modes.out_of_plane[k] != 0 ? 0 : 1;
      const double top = std::sin(m * pi * (m == 1 ? 0.5 : 0.25));
      for (std::size_t node = 0; node <= kSegments; ++node) {
        const double sine = std::sin(m * pi * static_cast<double>(node) / kSegments) / top;
        const double displacement = modes.mode[(k * (kSegments + 1) + node) * 3 + across];
        EXPECT_NEAR(std::fabs(displacement), std::fabs(sine), 1e-7) << k << ' ' << node;
      }
    }
    EXPECT_EQ(modes.out_of_plane[0] + modes.out_of_plane[1], 1);
    EXPECT_EQ(modes.out_of_plane[2] + modes.out_of_plane[3], 1);
  }
}

TEST(BucklingModes, ThatShareALoadAreApart) {
  // In space a square column buckles twice at each load.
  constexpr int kSegments = 8;
  const Scene scene = pinned_column(kSegments, 100.0);
  const BucklingModes modes = buckling_of(scene, {.level = Level::Spatial}, 2);
  ASSERT_EQ(modes.factor.size(), 2U);
  const double exact =
      pinned_chain_load(kSegments, 1, testing::bending_stiffness_of(scene)) / 100.0;
  double along = 0.0;
  double sizes[2] = {0.0, 0.0};
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(modes.factor[k] / exact, 1.0, kExact);
  for (std::size_t i = 0; i < 3 * (kSegments + 1); ++i) {
    const double a = modes.mode[i];
    const double b = modes.mode[3 * (kSegments + 1) + i];
    along += a * b;
    sizes[0] += a * a;
    sizes[1] += b * b;
  }
  EXPECT_NEAR(along / std::sqrt(sizes[0] * sizes[1]), 0.0, 1e-6);
}

TEST(BucklingModes, OfACantileverAreThoseOfTheLumpedChain) {
  Scene scene = testing::cantilever_scene(10);
  scene.section.width = 0.1;
  const double exact = theory::buckling_load(10, testing::bending_stiffness_of(scene), 1.0);
  scene.loads.push_back({.force = {0.0, 0.0, -0.2 * exact}});
  for (const Level level : {Level::Planar, Level::Spatial}) {
    EXPECT_NEAR(0.2 * buckling_of(scene, {.level = level}, 1).factor.at(0), 1.0, kExact);
  }
}

TEST(BucklingModes, BeyondTheFirstAreAboutTheLastStableState) {
  const double thrust =
      1.5 * pinned_chain_load(10, 1, testing::bending_stiffness_of(testing::chain_scene(10)));
  Scene scene = pinned_column(10, thrust);
  const BucklingModes modes = buckling_of(scene, {.level = Level::Spatial, .steps = 4}, 1);
  EXPECT_LT(modes.about, 1.0 / 1.5);
  EXPECT_GT(modes.about, 0.4);
  EXPECT_NEAR(modes.factor.at(0) * 1.5, 1.0, kExact);
}

TEST(BucklingModes, OfALoadBesideADeadWeightLeaveTheWeight) {
  // A rigid bar of the length 1 on a hinge of stiffness c under its weight G and a thrust P at its
  // top: c = G/2 + P.
  Scene scene = testing::chain_scene(1);
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  scene.supports.push_back({.at = Place::end(),
                            .kind = SupportKind::Elastic,
                            .rotational_stiffness = {700.0, 900.0, 0}});
  const double weight = scene.material.density * 4e-4 * 9.81;
  scene.gravity = {0.0, 0.0, -9.81};
  scene.gravity_history = History::constant();
  scene.loads.push_back({.force = {0.0, 0.0, -50.0}});
  const BucklingModes modes = buckling_of(scene, {.level = Level::Planar}, 1);
  EXPECT_NEAR(modes.factor.at(0) * 50.0, 700.0 - 0.5 * weight, 1e-6);
}

TEST(BucklingModes, OfABarOnASpringAcrossItsEnd) {
  // P = k L.
  Scene scene = testing::chain_scene(1);
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  scene.supports.push_back(
      {.at = Place::end(), .kind = SupportKind::Elastic, .stiffness = {3e5, 1e5, 0.0}});
  scene.loads.push_back({.force = {0.0, 0.0, -1e4}});
  EXPECT_NEAR(buckling_of(scene, {.level = Level::Planar}, 1).factor.at(0), 10.0, 1e-8);
}

TEST(BucklingModes, SeeTheForceThatASpringAlongTheBeamTakes) {
  // The thrust goes from the start, which slides, through the beam into the spring.
  Scene scene = testing::chain_scene(12);
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Roller});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  scene.supports.push_back(
      {.at = Place::end(), .kind = SupportKind::Elastic, .stiffness = {0.0, 0.0, 1e12}});
  scene.section.width = 0.1;
  scene.loads.push_back({.at = Place::start(), .force = {0.0, 0.0, 1e3}});
  const double exact = pinned_chain_load(12, 1, testing::bending_stiffness_of(scene));
  EXPECT_NEAR(buckling_of(scene, {.level = Level::Planar}, 1).factor.at(0) * 1e3 / exact, 1.0,
              1e-6);
}

TEST(BucklingModes, AreWhereThePathBifurcatesThoughItsShapeChanges) {
  // A strip between clamps under a force at its middle: out of its plane with moments of both
  // clamps, and twist. Its shape hardly changes before.
  Scene scene = testing::cantilever_scene(16);
  scene.section.width = 1e-4;
  scene.section.height = 0.1;
  scene.supports.push_back(
      {.at = Place::end(), .kind = SupportKind::Clamp, .hold = sliding_clamp()});
  scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, -60.0, 0.0}});
  const Response path = simulate(scene, {.level = Level::Spatial, .buckling = 1});
  ASSERT_EQ(path.status, Status::Unstable);
  EXPECT_NEAR(path.buckling->factor.at(0) / path.critical->factor.at(0), 1.0, 1e-6);
  scene.loads[0].force[1] = -0.6;
  const double exact = 60.0 * path.critical->factor.at(0);
  for (const Level level : {Level::Planar, Level::Spatial}) {
    EXPECT_NEAR(0.6 * buckling_of(scene, {.level = level}, 1).factor.at(0) / exact, 1.0, 1e-5);
  }
}

/// A strip on edge, a million times as stiff in its plane as across, clamped at its start.
Scene strip(int segments) {
  Scene scene = testing::cantilever_scene(segments);
  scene.section.width = 1e-4;
  scene.section.height = 0.1;
  return scene;
}

struct Sideways {
  const char* name;
  std::function<void(Scene&, double)> load;  ///< by a fraction of what is far beyond buckling
};

TEST(BucklingModes, OfStripsAreThoseOfTheirPathsHoweverCoarseTheChain) {
  const auto hold_end = [](Scene& scene, HeldFreedoms held) {
    scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Clamp, .hold = held});
  };
  const std::vector<Sideways> cases{
      {"propped, force at its middle",
       [&](Scene& scene, double fraction) {
         hold_end(scene, {true, true, false, false, false, true});
         scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, -fraction, 0.0}});
       }},
      {"guided, force at its end",
       [&](Scene& scene, double fraction) {
         hold_end(scene, {true, false, false, true, true, true});
         scene.loads.push_back({.force = {0.0, -fraction, 0.0}});
       }},
      {"both clamps turned",
       [&](Scene& scene, double fraction) {
         hold_end(scene, sliding_clamp());
         scene.supports[0].rotation = {-1e-4 * fraction, 0.0, 0.0};
         scene.supports[1].rotation = {1e-4 * fraction, 0.0, 0.0};
       }},
      {"turned by a soft spring", [&](Scene& scene, double fraction) {
         scene.supports.push_back({.at = Place::end(),
                                   .kind = SupportKind::Elastic,
                                   .rotational_stiffness = {500.0, 500.0, 500.0},
                                   .rotation = {-1e-3 * fraction, 0.0, 0.0}});
       }}};
  for (const Sideways& one : cases) {
    for (const int segments : {4, 8, 16, 32}) {
      SCOPED_TRACE(one.name + std::string(" ") + std::to_string(segments));
      Scene far = strip(segments);
      one.load(far, 1.0);
      const Response path = simulate(far, {.level = Level::Spatial, .buckling = 1});
      EXPECT_EQ(path.status, Status::Unstable) << name_of(path.status);
      ASSERT_TRUE(path.critical && path.buckling);
      // A step's bracket is told by the determinant, whose bend costs some 1e-6.
      EXPECT_NEAR(path.buckling->factor.at(0) / path.critical->factor[0], 1.0, 1e-5);
      Scene near = strip(segments);
      one.load(near, 1e-5);
      for (const Level level : {Level::Planar, Level::Spatial}) {
        const BucklingModes modes = buckling_of(near, {.level = level}, 2);
        ASSERT_EQ(modes.factor.size(), 2U);
        EXPECT_NEAR(1e-5 * modes.factor[0] / path.critical->factor[0], 1.0, 1e-4);
        EXPECT_LT(modes.rotation[0], 1e-2);
        if (path.critical->factor.size() < 2 || path.critical->unstable_modes[1] != 2) continue;
        EXPECT_NEAR(1e-5 * modes.factor[1] / path.critical->factor[1], 1.0, 1e-4);
      }
    }
  }
}

/// A strip that has bent far under its load has the same factors read from its other end: what a
/// clamp takes is in equilibrium with the rest, whichever end of the chain it holds.
TEST(BucklingModes, OfABentStripDoNotDependOnWhichEndIsHeld) {
  const auto factors = [](bool from_start, bool propped, Level level) {
    Scene scene = testing::chain_scene(16);
    scene.section.width = 0.002;
    scene.section.height = 0.008;
    const auto at = [&](double fraction) {
      return Place{from_start ? fraction : 1.0 - fraction, {}};
    };
    scene.supports.push_back({.at = at(0.0), .kind = SupportKind::Clamp});
    scene.loads.push_back({.at = at(1.0), .force = {0.0, -2.0, from_start ? -0.5 : 0.5}});
    if (propped) {
      Support prop{.at = at(0.5), .kind = SupportKind::Roller};
      prop.hold = HeldFreedoms{true, false, false, false, false, false};
      scene.supports.push_back(prop);
    }
    return buckling_of(scene, {.level = level, .steps = 8}, 3).factor;
  };
  for (const bool propped : {false, true}) {
    const std::vector<double> one = factors(true, propped, Level::Spatial);
    const std::vector<double> other = factors(false, propped, Level::Spatial);
    ASSERT_FALSE(one.empty());
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t m = 0; m < one.size(); ++m) {
      EXPECT_NEAR(one[m], other[m], 1e-5 * one[m]) << propped << m;
    }
  }
}

TEST(BucklingModes, GrowInProportionWhereHistoriesHold) {
  Scene scene = pinned_column(12, 1000.0);
  const double exact = pinned_chain_load(12, 1, testing::bending_stiffness_of(scene)) / 1000.0;
  for (const History& history : {History::constant(), History{{0.0, 1.0, 2.0}, {0.0, 1.0, 1.0}},
                                 History{{0.0, 1.0, 2.0}, {0.0, 1.0, 0.5}}}) {
    scene.loads[0].history = history;
    const BucklingModes modes = buckling_of(scene, {.duration = 2.0}, 1);
    EXPECT_EQ(modes.about, history.at(2.0));
    EXPECT_NEAR(modes.factor.at(0) / exact, 1.0, kExact);
  }
  // A unit load on a stocky column.
  scene = pinned_column(12, 1.0);
  scene.section.width = scene.section.height = 0.5;
  EXPECT_NEAR(buckling_of(scene, {}, 1).factor.at(0) /
                  pinned_chain_load(12, 1, testing::bending_stiffness_of(scene)),
              1.0, kExact);
}

// Where a search has come upon the very root a pivot is 0: there the mode had no numbers.
TEST(BucklingModes, AreThereAtTheRootItself) {
  Scene scene = testing::cantilever_scene(40);
  scene.material.youngs_modulus = 2e9;
  scene.material.poisson_ratio = 0.3;
  scene.section = {.width = 0.01, .height = 0.02};
  scene.supports[0].at = Place::end();
  for (const double force : {12.0, 16.0, 18.0, 20.0, 22.0}) {
    for (const int steps : {20, 40, 50, 100}) {
      scene.loads = {{.at = Place::start(), .force = {0.0, force, 0.0}}};
      const BucklingModes modes = buckling_of(scene, {.level = Level::Planar, .steps = steps}, 3);
      ASSERT_FALSE(modes.mode.empty());
      for (const double u : modes.mode) ASSERT_TRUE(std::isfinite(u)) << force << ", " << steps;
    }
  }
}

TEST(BucklingModes, SayHowFarTheShapeChangesUpToThem) {
  // A square cantilever bends in the plane of its load, and leaves it only on paper.
  Scene scene = testing::cantilever_scene(16);
  scene.loads.push_back({.force = {0.0, -100.0, 0.0}});
  const BucklingModes modes = buckling_of(scene, {.level = Level::Planar}, 1);
  const double turn = 50.0 / testing::bending_stiffness_of(scene);  // P L^2/2EI
  EXPECT_NEAR(modes.rotation.at(0) / (turn * (modes.factor.at(0) - 1.0)), 1.0, 0.05);
  EXPECT_GT(modes.rotation[0], 0.1);
}

TEST(BucklingModes, OfABeamInTensionAreNone) {
  const BucklingModes modes = buckling_of(pinned_column(8, -100.0), {}, 3);
  EXPECT_TRUE(modes.factor.empty());
}

}  // namespace
}  // namespace plastica
