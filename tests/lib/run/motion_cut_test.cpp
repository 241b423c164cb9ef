#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/chain_scene.hpp"

namespace plastica {
namespace {

/// When a beam in free flight for 0.7 s of seven samples is cut.
double time_of_cut(double asked) {
  Scene scene = testing::chain_scene(4);
  scene.initial_motions.push_back({.velocity = {0.0, 3.0, 0.0}});
  scene.cuts.push_back({{0.5, {}}, asked});
  const SolverOptions options{
      .analysis = Analysis::Dynamics, .duration = 0.7, .steps = 7, .time_step = 0.01};
  const Response response = simulate(scene, options);
  EXPECT_EQ(response.chain.events.size(), 1U);
  return response.chain.events.at(0).time;
}

TEST(MotionCut, ComesAtItsTimeBetweenSamplesAndAtOne) {
  EXPECT_DOUBLE_EQ(time_of_cut(0.25), 0.25);
  // In numbers, the third of seven parts of 0.7 s is a little less than 0.3 s.
  ASSERT_LT(0.7 * 3 / 7, 0.3);
  EXPECT_DOUBLE_EQ(time_of_cut(0.3), 0.3);
  EXPECT_EQ(time_of_cut(0.0), 0.0);
}

TEST(MotionCut, AtTheEndLeavesWhatElseHoldsTheLastSegment) {
  // The clamp at the end is cut; a roller within the last segment holds on.
  Scene scene = testing::cantilever_scene(4);
  scene.beam.segment_fractions = {0.25, 0.25, 0.25, 0.25};
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Clamp});
  scene.supports.back().hold = HeldFreedoms{true, true, false, true, true, true};
  scene.supports.push_back({.at = {0.9, {}}, .kind = SupportKind::Roller});
  scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, -100.0, 0.0}});
  scene.cuts.push_back({.at = Place::end(), .time = 0.0});
  testing::add_probe(scene, ProbeQuantity::Displacement, {0.9, {}}, Component::Y);
  testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const SolverOptions options{
      .analysis = Analysis::Dynamics, .duration = 0.02, .steps = 20, .time_step = 1e-3};
  const Response response = simulate(scene, options);
  ASSERT_EQ(response.samples, 21U);
  double held = 0.0;
  double moved = 0.0;
  for (std::size_t i = 0; i < response.samples; ++i) {
    held = std::max(held, std::fabs(response.probes[0][i]));
    moved = std::max(moved, std::fabs(response.probes[1][i]));
  }
  EXPECT_LT(held, 1e-9);
  EXPECT_GT(moved, 1e-6);
}

/// A cantilever whose clamp moves across, and is cut.
Response moved_and_cut(Place clamp, Scheme scheme, double time_step) {
  Scene scene = testing::chain_scene(20);
  scene.material.density = 7850.0;
  scene.yield_model = YieldModel::Elastic;
  Support held{.at = clamp, .kind = SupportKind::Clamp};
  held.translation = {0.0, 0.1, 0.0};
  held.history = History::smooth_step(0.0, 0.05);
  scene.supports = {held};
  scene.cuts.push_back({clamp, 0.01});
  SolverOptions options{
      .analysis = Analysis::Dynamics, .duration = 0.02, .steps = 40, .time_step = time_step};
  options.scheme = scheme;
  return simulate(scene, options);
}

/// The work of a moving clamp, the beam's mirror image and its energy must agree, whichever end
/// it holds, though the clamp at the start is the ground and that at the end is not.
TEST(MotionCut, LeavesTheWorkOfAMovingClampThatOfItsMirrorImage) {
  for (const double step : {1e-4, 2e-5}) {
    const Response start = moved_and_cut(Place::start(), Scheme::GeneralizedAlpha, step);
    const Response end = moved_and_cut(Place::end(), Scheme::GeneralizedAlpha, step);
    const Response other = moved_and_cut(Place::start(), Scheme::EnergyMomentum, step);
    for (const Response* response : {&start, &end, &other}) {
      ASSERT_EQ(response->status, Status::Broken) << step;
    }
    const Energies& of_start = start.chain.energy.back();
    const Energies& of_end = end.chain.energy.back();
    EXPECT_GT(of_start.external, 1.0);
    EXPECT_NEAR(of_start.external / of_end.external, 1.0, 1e-5) << step;
    EXPECT_NEAR(of_start.external / other.chain.energy.back().external, 1.0, 1e-3) << step;
    EXPECT_LT(std::fabs(of_start.residual), 2e-4 * of_start.external) << step;
  }
}

}  // namespace
}  // namespace plastica
