#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "plastica/theory/cantilever.hpp"
#include "plastica/theory/limit_load.hpp"
#include "plastica/theory/lumped_chain.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

/// Beams of fibre section beyond yield, at rest: the cantilever, one bent and released, and limit
/// loads.
namespace plastica {
namespace {

using testing::tolerance;
using theory::BeamEnds;

/// With a thousandth of the yield stress all displacements are a thousandth: rotations are linear.
constexpr double kSmall = 1e-3;

Scene yielding(Scene scene, double yield_scale) {
  scene.yield_model = YieldModel::Fibre;
  scene.material.yield_stress *= yield_scale;
  return scene;
}

Scene yielding_cantilever(double load_ratio, double yield_scale) {
  Scene scene = yielding(testing::cantilever_scene(160), yield_scale);
  scene.loads.push_back({.force = {0.0, load_ratio * testing::yield_moment_of(scene), 0.0}});
  testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  return scene;
}

double first_yield_deflection(const Scene& scene) {
  return testing::yield_moment_of(scene) / (3.0 * testing::bending_stiffness_of(scene));
}

TEST(ElastoplasticRun, CantileverBendsAsPragerAndHodgeSay) {
  for (const double ratio : {1.25, 1.4, 1.48}) {
    SCOPED_TRACE(ratio);
    const Scene scene = yielding_cantilever(ratio, kSmall);
    const double tip = testing::last_of(testing::completed(scene), 0);
    EXPECT_NEAR(tip / first_yield_deflection(scene) / theory::tip_deflection_ratio(ratio), 1.0,
                tolerance(0.002));
  }
}

TEST(ElastoplasticRun, CantileverPathEndsAtTheLimitLoad) {
  const Scene scene = yielding_cantilever(1.6, kSmall);
  const Response response = simulate(scene, {.steps = 40});
  ASSERT_EQ(response.status, Status::LimitLoad) << name_of(response.status);
  ASSERT_TRUE(response.limit.has_value());
  EXPECT_NEAR(1.6 * response.limit->below / 1.5, 1.0, tolerance(0.005));
  EXPECT_NEAR(1.6 * response.limit->above / 1.5, 1.0, tolerance(0.005));
  // Fibres near the limit without reaching it: the truth lies between both.
  EXPECT_LE(1.6 * response.limit->below, 1.5);
  EXPECT_GE(1.6 * response.limit->above, 1.5);
}

/// What the tip keeps after 1.2 P_y.
double kept_tip(Scene scene) {
  scene.loads.back().history = History::turning_points({1.0, 0.0});
  return testing::last_of(testing::completed(scene, {.steps = 40}), 0);
}

TEST(ElastoplasticRun, BendAndReleaseKeepsWhatTheSectionKeeps) {
  const Scene linear = yielding_cantilever(1.2, kSmall);
  EXPECT_NEAR(kept_tip(linear) / kSmall / 0.5409e-3, 1.0, tolerance(0.005));
  EXPECT_NEAR(kept_tip(linear) / (theory::residual_tip_ratio(1.2) * first_yield_deflection(linear)),
              1.0, tolerance(0.005));
}

TEST(ElastoplasticRun, BendAndReleaseKeepsLessWithFiniteRotations) {
  EXPECT_NEAR(kept_tip(yielding_cantilever(1.2, 1.0)) / 0.5247e-3, 1.0, tolerance(0.005));
}

TEST(ElastoplasticRun, AnIdealJointCappedAtTheFullyPlasticMomentKeepsNothing) {
  Scene scene = yielding_cantilever(1.2, 1.0);
  scene.yield_model = YieldModel::PerAxis;
  scene.yield_cap = YieldCap::FullyPlastic;
  EXPECT_NEAR(kept_tip(scene), 0.0, tolerance(1e-9));
}

TEST(ElastoplasticRun, AnIdealJointCappedAtFirstYieldCollapses) {
  Scene scene = yielding_cantilever(1.2, kSmall);
  scene.yield_model = YieldModel::PerAxis;
  scene.yield_cap = YieldCap::FirstYield;
  const Response response = simulate(scene);
  EXPECT_EQ(response.status, Status::LimitLoad);
  EXPECT_NEAR(1.2 * response.limit->below, 1.0, tolerance(1e-4));
  // With finite rotations it comes to rest where the lever is 1/1.2 of the length.
  scene.material.yield_stress /= kSmall;
  scene.loads.back().force[1] /= kSmall;
  const Response fallen = testing::completed(scene);
  EXPECT_NEAR(testing::last_position(fallen, 160)[2], 1.0 / 1.2, tolerance(1e-6));
}

struct Frame {
  const char* name;
  BeamEnds ends;
  bool distributed;
  double position;
};

const std::array kFrames{Frame{"cantilever", BeamEnds::ClampedFree, false, 1.0},
                         Frame{"simple", BeamEnds::PinnedPinned, false, 0.5},
                         Frame{"propped", BeamEnds::ClampedPinned, false, 0.5},
                         Frame{"fixed", BeamEnds::ClampedClamped, false, 0.5},
                         Frame{"fixed, distributed", BeamEnds::ClampedClamped, true, 0.0}};

/// Ends that leave the beam free to shorten: a chain of rigid segments that cannot would hang.
Scene framed(const Frame& frame, double load) {
  Scene scene = yielding(testing::chain_scene(40), kSmall);
  const bool pinned_start = frame.ends == BeamEnds::PinnedPinned;
  scene.supports.push_back(
      {.at = Place::start(), .kind = pinned_start ? SupportKind::Pin : SupportKind::Clamp});
  if (frame.ends == BeamEnds::ClampedClamped) {
    scene.supports.push_back({.at = Place::end(),
                              .kind = SupportKind::Clamp,
                              .hold = HeldFreedoms{true, true, false, true, true, true}});
  } else if (frame.ends != BeamEnds::ClampedFree) {
    scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  }
  Load applied{.at = Place{frame.position, {}}, .force = {0.0, -load, 0.0}};
  if (frame.distributed) applied.to = Place::end();
  scene.loads.push_back(applied);
  return scene;
}

double exact_limit(const Frame& frame, double plastic_moment) {
  return frame.distributed ? theory::limit_distributed(frame.ends, plastic_moment, 1.0)
                           : theory::limit_force(frame.ends, plastic_moment, 1.0, frame.position);
}

TEST(ElastoplasticRun, FiveFramesOfSupportReachTheirLimitLoads) {
  const double plastic_moment = 1.5 * kSmall * testing::yield_moment_of(testing::chain_scene(1));
  for (const Frame& frame : kFrames) {
    SCOPED_TRACE(frame.name);
    const double exact = exact_limit(frame, plastic_moment);
    const Response response = simulate(framed(frame, 1.2 * exact), {.steps = 24});
    ASSERT_EQ(response.status, Status::LimitLoad) << name_of(response.status);
    EXPECT_NEAR(1.2 * response.limit->below, 1.0, tolerance(0.01));
    EXPECT_NEAR(1.2 * response.limit->above, 1.0, tolerance(0.01));
  }
}

TEST(ElastoplasticRun, IdealHingesReachTheSameLimitLoads) {
  const double plastic_moment = 1.5 * kSmall * testing::yield_moment_of(testing::chain_scene(1));
  for (const Frame& frame : kFrames) {
    if (frame.distributed) continue;  // its hinge lies between two joints, second order in h
    SCOPED_TRACE(frame.name);
    Scene scene = framed(frame, 1.2 * exact_limit(frame, plastic_moment));
    scene.yield_model = YieldModel::PerAxis;
    scene.yield_cap = YieldCap::FullyPlastic;
    const Response response = simulate(scene, {.steps = 24});
    ASSERT_EQ(response.status, Status::LimitLoad) << name_of(response.status);
    // A limit load is bracketed within 1e-4 of it.
    EXPECT_NEAR(1.2 * response.limit->below, 1.0, tolerance(1.01e-4));
    EXPECT_NEAR(1.2 * response.limit->above, 1.0, tolerance(1.01e-4));
  }
}

}  // namespace
}  // namespace plastica
