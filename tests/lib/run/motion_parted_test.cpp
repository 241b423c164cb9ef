#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/support/motion_scene.hpp"

/// What stands where a beam parts is of both fragments: each moves as a beam of its own does whose
/// end has half of it.
namespace plastica {
namespace {

using testing::add_probe;

constexpr int kHalf = 6;  // segments of one fragment
constexpr std::size_t kProbes = 4;

struct Standing {
  std::string name;
  /// Adds it at a place, so much of it.
  std::function<void(Scene&, const Place&, double part)> add;
};

/// A bar of plastics, bent by loads at both ends, which are alike from the middle.
Scene bar(double length, int segments) {
  Scene scene = testing::chain_scene(segments);
  scene.beam.length = length;
  scene.material.youngs_modulus = 2e9;
  scene.material.density = 1200.0;
  scene.gravity = {0.0, -9.81, 0.0};
  scene.gravity_history = History::constant();
  return scene;
}

void push(Scene& scene, const Place& at, double force) {
  scene.loads.push_back({.at = at, .force = {0.0, force, 0.0}, .history = History::constant()});
}

void watch(Scene& scene, const Place& tip, const Place& inside) {
  for (const Place& at : {tip, inside}) {
    add_probe(scene, ProbeQuantity::Displacement, at, Component::Y);
    add_probe(scene, ProbeQuantity::Rotation, at, Component::X);
  }
}

/// Two fragments from the cut of the middle on.
Scene whole_bar(const Standing& standing, double cut) {
  Scene scene = bar(1.0, 2 * kHalf);
  standing.add(scene, {0.5, {}}, 1.0);
  push(scene, Place::start(), -3.0);
  push(scene, Place::end(), -3.0);
  scene.cuts.push_back({{0.5, {}}, cut});
  watch(scene, Place::start(), {0.1, {}});
  watch(scene, Place::end(), {0.9, {}});
  return scene;
}

Response run(const Scene& scene, Scheme scheme) {
  Response response = simulate(scene, testing::motion_options(scheme, 1e-4, 300));
  EXPECT_TRUE(usable(response.status)) << name_of(response.status);
  return response;
}

/// Half of what acts at an end as it does within.
std::vector<Standing> like_an_end() {
  return {
      Standing{"nothing", [](Scene&, const Place&, double) {}},
      Standing{"mass", [](Scene& scene, const Place& at,
                          double part) { scene.masses.push_back({.at = at, .mass = 2.0 * part}); }},
      Standing{"force",
               [](Scene& scene, const Place& at, double part) { push(scene, at, 8.0 * part); }},
      Standing{"pillar",
               [](Scene& scene, const Place& at, double) {
                 scene.supports.push_back(
                     {.at = at, .kind = SupportKind::Pillar, .normal = {0.0, 1.0, 0.0}});
               }},
      Standing{"roller",
               [](Scene& scene, const Place& at, double) {
                 scene.supports.push_back({.at = at, .kind = SupportKind::Roller});
               }},
      Standing{"clamp",
               [](Scene& scene, const Place& at, double) {
                 scene.supports.push_back({.at = at, .kind = SupportKind::Clamp});
               }},
      Standing{"spring", [](Scene& scene, const Place& at, double part) {
                 scene.supports.push_back(
                     {.at = at, .kind = SupportKind::Elastic, .stiffness = {0.0, 2e4 * part, 0.0}});
               }}};
}

/// A rotational spring within has the half joints on both sides in series.
std::vector<Standing> all_standings() {
  std::vector<Standing> all = like_an_end();
  all.push_back(Standing{"rotational_spring", [](Scene& scene, const Place& at, double part) {
                           scene.supports.push_back(
                               {.at = at,
                                .kind = SupportKind::Elastic,
                                .stiffness = {0.0, 2e4 * part, 0.0},
                                .rotational_stiffness = {30.0 * part, 0.0, 0.0}});
                         }});
  return all;
}

class Parted : public ::testing::TestWithParam<Standing> {};
class PartedAsAlone : public ::testing::TestWithParam<Standing> {};

TEST_P(Parted, ActsOnBothFragmentsAlike) {
  for (const Scheme scheme :
       {Scheme::GeneralizedAlpha, Scheme::EnergyMomentum, Scheme::LinearlyImplicitMidpoint}) {
    const Response response = run(whole_bar(GetParam(), 0.01), scheme);
    ASSERT_EQ(response.chain.events.size(), 1U);
    double moved = 0.0;
    for (std::size_t i = 0; i < response.samples; ++i) {
      for (std::size_t k = 0; k < kProbes; ++k) {
        const bool turns = k % 2 != 0;
        const double left = response.probes[k][i];
        const double right = response.probes[kProbes + k][i];
        EXPECT_NEAR(left, turns ? -right : right, 1e-6) << "sample " << i << ", probe " << k;
        moved = std::max(moved, std::fabs(left));
      }
    }
    EXPECT_GT(moved, 1e-3);
    EXPECT_LT(testing::largest_residual(response), 1e-5);
  }
}

TEST_P(PartedAsAlone, IsABeamOfItsOwnWithHalfOfWhatStandsThere) {
  Scene half = bar(0.5, kHalf);
  GetParam().add(half, Place::end(), 0.5);
  push(half, Place::start(), -3.0);
  watch(half, Place::start(), {0.2, {}});
  const Response alone = run(half, Scheme::GeneralizedAlpha);
  const Response whole = run(whole_bar(GetParam(), 0.0), Scheme::GeneralizedAlpha);
  for (std::size_t i = 0; i < alone.samples; ++i) {
    for (std::size_t k = 0; k < kProbes; ++k) {
      EXPECT_NEAR(whole.probes[k][i], alone.probes[k][i], 1e-6)
          << "sample " << i << ", probe " << k;
    }
  }
}

/// Where a joint that stretches and shears lets go, the support holds the end beyond where it is:
/// to bring it back in one step would take a speed that grows as steps are made shorter.
TEST(PartedByElasticJoints, KeepsItsEnergyWithAnyStep) {
  Scene scene = bar(1.0, 2 * kHalf);
  scene.supports.push_back({.at = {0.5, {}}, .kind = SupportKind::Pin});
  push(scene, Place::start(), -3.0);
  push(scene, Place::end(), -3.0);
  for (const double side : {-1.0, 1.0}) {
    scene.loads.push_back({.at = side < 0.0 ? Place::start() : Place::end(),
                           .force = {0.0, 0.0, 500.0 * side},
                           .history = History::constant()});
  }
  Scene cut = scene;
  cut.cuts.push_back({{0.5, {}}, 0.002});
  for (const double step : {1e-4, 1e-5}) {
    SolverOptions options =
        testing::motion_options(Scheme::GeneralizedAlpha, step, static_cast<int>(0.01 / step));
    options.translation = JointTranslation::Elastic;
    const Response parted = simulate(cut, options);
    ASSERT_EQ(parted.status, Status::Broken) << step;
    EXPECT_LT(testing::largest_residual(parted), 1e-5) << step;
    // Each half swings along itself as before, held by the pin.
    const double whole = testing::last_energy(simulate(scene, options)).kinetic;
    EXPECT_LT(testing::last_energy(parted).kinetic, 2.0 * whole) << step;
  }
}

const auto kName = [](const auto& of) { return of.param.name; };
INSTANTIATE_TEST_SUITE_P(Motion, Parted, ::testing::ValuesIn(all_standings()), kName);
INSTANTIATE_TEST_SUITE_P(Motion, PartedAsAlone, ::testing::ValuesIn(like_an_end()), kName);

}  // namespace
}  // namespace plastica
