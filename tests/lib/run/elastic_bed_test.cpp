#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "plastica/run/natural_frequencies.hpp"
#include "tests/support/chain_scene.hpp"

// Beams on a bed of springs (Winkler's foundation) against closed forms: Hetenyi, Beams on Elastic
// Foundation (1946), and Timoshenko & Gere, Theory of Elastic Stability, 2.10. Loads are small.

namespace plastica {
namespace {

using std::numbers::pi;
using testing::add_probe;
using testing::bending_stiffness_of;
using testing::completed;
using testing::last_of;

constexpr double kBetaL = 4.0;

/// 1 m of beam on a bed with L (k/4EI)^(1/4) = 4, held along itself alone.
Scene on_bed(int segments) {
  Scene scene = testing::chain_scene(segments);
  const double stiffness = 4.0 * bending_stiffness_of(scene) * std::pow(kBetaL, 4);
  scene.supports.push_back({.at = Place::start(),
                            .kind = SupportKind::Elastic,
                            .stiffness = {0.0, stiffness, 0.0},
                            .to = Place::end()});
  scene.supports.push_back(
      {.at = Place::start(), .hold = HeldFreedoms{false, false, true, false, false, false}});
  return scene;
}

/// Errors of a probe against theory at N = 16, 64, 256.
void expect_errors_fall(const std::function<double(int)>& error, double largest, double order) {
  const double coarse = std::fabs(error(16));
  const double middle = std::fabs(error(64));
  const double fine = std::fabs(error(256));
  EXPECT_LT(coarse, largest);
  EXPECT_NEAR(std::log(coarse / middle) / std::log(4.0), order, 0.1);
  EXPECT_NEAR(std::log(middle / fine) / std::log(4.0), order, 0.1);
}

double deflection(int segments, double at, double force) {
  Scene scene = on_bed(segments);
  scene.loads.push_back({.at = {at, {}}, .force = {0.0, force, 0.0}});
  add_probe(scene, ProbeQuantity::Displacement, {at, {}}, Component::Y);
  add_probe(scene, ProbeQuantity::Reaction, Place::start(), Component::Y);
  const Response response = completed(scene, {.level = Level::Planar, .steps = 1});
  // The bed takes the load.
  EXPECT_NEAR(last_of(response, 1), -force, 1e-9 * force);
  return last_of(response, 0);
}

/// The bed holds a free beam against a load at its end: its moment about where it begins is the
/// load's, turned round, also of one in space.
TEST(ElasticBed, HasTheMomentThatItsForcesHave) {
  Scene scene = testing::chain_scene(12);
  scene.supports = {{.at = {0.25, {}},
                     .kind = SupportKind::Elastic,
                     .stiffness = {1e5, 2e5, 3e5},
                     .to = Place::end()}};
  scene.supports.push_back(
      {.at = Place::start(), .hold = HeldFreedoms{false, false, false, false, false, true}});
  scene.loads.push_back({.at = Place::end(), .force = {2.0, 5.0, 0.0}});
  for (const Component component : {Component::X, Component::Y, Component::Z}) {
    add_probe(scene, ProbeQuantity::ReactionMoment, {0.25, {}}, component);
    add_probe(scene, ProbeQuantity::Reaction, {0.25, {}}, component);
  }
  const Response response = completed(scene, {.level = Level::Spatial, .steps = 1});
  // 0.75 m along z, but for how far the beam has moved.
  EXPECT_NEAR(last_of(response, 0), 0.75 * 5.0, 2e-4);
  EXPECT_NEAR(last_of(response, 2), -0.75 * 2.0, 2e-4);
  EXPECT_NEAR(last_of(response, 4), 0.0, 1e-3);
  EXPECT_NEAR(last_of(response, 1), -2.0, 1e-9);
  EXPECT_NEAR(last_of(response, 3), -5.0, 1e-9);
}

TEST(ElasticBed, BendsUnderALoadInTheMiddleAsHetenyiSays) {
  const double b = kBetaL;
  const double shape = (std::cosh(b) + std::cos(b) + 2.0) / (std::sinh(b) + std::sin(b));
  const Scene scene = on_bed(4);
  const double exact = 0.01 * b / (2.0 * scene.supports[0].stiffness[1]) * shape;
  expect_errors_fall([&](int n) { return deflection(n, 0.5, 0.01) / exact - 1.0; }, 0.025, 2.0);
}

/// No joint has a force: each segment's load is the bed's beneath it, y = q/k everywhere.
TEST(ElasticBed, SettlesEvenlyUnderALoadThatIsSpreadAsItIs) {
  for (const Level level : {Level::Planar, Level::Spatial}) {
    for (const int segments : {1, 2, 20, 200}) {
      for (const double begin : {0.0, 0.3}) {
        if (segments == 1 && begin > 0.0) continue;  // a segment ends where the bed begins
        Scene scene = on_bed(segments);
        scene.supports[0].at = {begin, {}};
        if (level == Level::Spatial) {
          scene.supports[1].hold = HeldFreedoms{true, false, true, false, true, true};
        }
        scene.loads.push_back({.at = {begin, {}}, .to = Place::end(), .force = {0.0, 0.01, 0.0}});
        add_probe(scene, ProbeQuantity::Displacement, Place::start(), Component::Y);
        add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
        const double settled = 0.01 / scene.supports[0].stiffness[1];
        const Response response = completed(scene, {.level = level, .steps = 2});
        for (const std::size_t end : {0U, 1U}) {
          EXPECT_NEAR(last_of(response, end), settled, 1e-9 * settled) << segments;
        }
      }
    }
  }
}

/// Even of order 4: where the load acts the chain has the beam's slope.
TEST(ElasticBed, BendsUnderALoadAtItsEndAsHetenyiSays) {
  const double b = kBetaL;
  const double s = std::sinh(b);
  const double shape =
      (s * std::cosh(b) - std::sin(b) * std::cos(b)) / (s * s - std::sin(b) * std::sin(b));
  const Scene scene = on_bed(4);
  const double exact = 0.01 * 2.0 * b / scene.supports[0].stiffness[1] * shape;
  expect_errors_fall([&](int n) { return deflection(n, 1.0, 0.01) / exact - 1.0; }, 0.02, 4.0);
}

/// A pinned beam on a bed, across it both ways.
Scene pinned(int segments, double stiffness) {
  Scene scene = testing::chain_scene(segments);
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  scene.supports.push_back({.at = Place::start(),
                            .kind = SupportKind::Elastic,
                            .stiffness = {stiffness, stiffness, 0.0},
                            .to = Place::end()});
  return scene;
}

/// Waves of m halves: P = EI (m pi/L)^2 + k (L/(m pi))^2; with k L^4/EI = 6 pi^4 the second mode
/// comes first (5.5), then the first (7) and the third (9 2/3), of Euler's load.
TEST(ElasticBed, HoldsAColumnByTheWaveThatIsSoftest) {
  std::vector<double> errors;
  for (const int segments : {16, 64}) {
    Scene scene = pinned(segments, 0.0);
    const double bending = bending_stiffness_of(scene);
    scene = pinned(segments, 6.0 * std::pow(pi, 4) * bending);
    scene.loads.push_back({.force = {0.0, 0.0, -pi * pi * bending}});
    const Response response = completed(scene, {.level = Level::Planar, .steps = 1, .buckling = 1});
    ASSERT_TRUE(response.buckling.has_value());
    errors.push_back(response.buckling->factor.front() / 5.5 - 1.0);
  }
  EXPECT_LT(std::fabs(errors[1]), 2e-3);
  EXPECT_NEAR(std::log(errors[0] / errors[1]) / std::log(4.0), 2.0, 0.15);
}

/// omega^2 = ((n pi/L)^4 EI + k)/(rho A).
TEST(ElasticBed, RaisesTheFrequenciesOfAPinnedBeam) {
  Scene scene = pinned(64, 0.0);
  const double bending = bending_stiffness_of(scene);
  const double stiffness = 3.0 * std::pow(pi, 4) * bending;
  scene = pinned(64, stiffness);
  scene.loads.push_back({.force = {0.0, 1.0, 0.0}});
  const auto found = unloaded_frequencies(scene, {.level = Level::Planar}, 2);
  const double mass = scene.material.density * testing::properties_of(scene).area;
  for (int n = 1; n <= 2; ++n) {
    const double exact = std::sqrt((std::pow(n * pi, 4) * bending + stiffness) / mass) / (2.0 * pi);
    EXPECT_NEAR(found[static_cast<std::size_t>(n) - 1] / exact, 1.0, 1e-3) << n;
  }
}

/// On the bed alone the beam is held in its plane; a bed of part of the length ends there, whatever
/// the number of segments.
TEST(ElasticBed, OfAPartEndsWhereItSays) {
  const auto tip = [](double to, int segments) {
    Scene scene = testing::cantilever_scene(segments);
    const double bed = 100.0 * bending_stiffness_of(scene);
    scene.supports.push_back({.at = {0.25, {}},
                              .kind = SupportKind::Elastic,
                              .stiffness = {0.0, bed, 0.0},
                              .to = Place{to, {}}});
    scene.loads.push_back({.force = {0.0, 0.01, 0.0}});
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
    return last_of(completed(scene, {.level = Level::Planar, .steps = 1}), 0);
  };
  const double fine = tip(0.61, 640);
  EXPECT_NEAR(tip(0.61, 40) / fine, 1.0, 2e-3);
  EXPECT_NEAR(tip(0.6101, 40) / tip(0.61, 40), 1.0, 5e-4);
  EXPECT_GT(std::fabs(tip(0.7, 40) / tip(0.61, 40) - 1.0), 0.02);
}

}  // namespace
}  // namespace plastica
