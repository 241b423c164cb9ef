#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/motion_scene.hpp"

namespace plastica {
namespace {

using testing::add_probe;
using testing::motion_options;

/// Pushed and twisted with a smooth history, by forces in a plane or not.
Scene pushed(bool in_space, YieldModel model) {
  Scene scene = testing::cantilever_scene(8);
  scene.yield_model = model;
  Load push;
  push.force = {in_space ? 15.0 : 0.0, -30.0, 0.0};
  push.moment = {0.0, 0.0, in_space ? 5.0 : 0.0};
  push.history = History::smooth_step(0.0, 0.05);
  scene.loads.push_back(push);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  return scene;
}

std::vector<double> tip(const Scene& scene, Scheme scheme, Damping damping, double step) {
  SolverOptions options = motion_options(scheme, step, 0);
  options.steps = 50;
  options.duration = 0.1;
  options.damping = damping;
  options.damping_time = 2e-3;
  return testing::completed(scene, options).probes[0];
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
  return largest;
}

/// tau K dtheta/dt is tau ds/dt where nothing yields: two formulations of one equation.
TEST(Damping, OfAnElasticBeamIsAlikeByItsAnglesAndByItsMoments) {
  for (const Scheme scheme : {Scheme::GeneralizedAlpha, Scheme::EnergyMomentum}) {
    for (const bool in_space : {false, true}) {
      const Scene scene = pushed(in_space, YieldModel::Elastic);
      const auto angles = tip(scene, scheme, Damping::Stiffness, 1e-3);
      const auto moments = tip(scene, scheme, Damping::Relaxation, 1e-3);
      const double size = -*std::min_element(angles.begin(), angles.end());
      // In space, of large turns, they differ by the geometry of a step.
      EXPECT_LT(largest_difference(angles, moments), (in_space ? 1e-5 : 1e-9) * size)
          << static_cast<int>(scheme) << in_space;
    }
  }
}

TEST(Damping, ByMomentsIsOfSecondOrderInTheStep) {
  for (const bool in_space : {false, true}) {
    const Scene scene = pushed(in_space, YieldModel::Elastic);
    const auto exact = tip(scene, Scheme::EnergyMomentum, Damping::Relaxation, 1e-5);
    const auto error = [&](double step) {
      return largest_difference(tip(scene, Scheme::GeneralizedAlpha, Damping::Relaxation, step),
                                exact);
    };
    EXPECT_NEAR(std::log2(error(1e-3) / error(5e-4)), 2.0, 0.15) << in_space;
    EXPECT_NEAR(std::log2(error(5e-4) / error(2.5e-4)), 2.0, 0.15) << in_space;
  }
}

/// Plastic flow is not damped: of the clamp that yields, the law's moment alone is left.
TEST(Damping, ByMomentsLeavesPlasticFlowAlone) {
  Scene scene = pushed(false, YieldModel::PerAxis);
  scene.loads[0].force[1] = -1.2 * testing::yield_moment_of(scene);
  const auto exact = tip(scene, Scheme::EnergyMomentum, Damping::Relaxation, 2e-5);
  const double size = std::fabs(exact.back());
  const auto error = [&](double step) {
    return largest_difference(tip(scene, Scheme::GeneralizedAlpha, Damping::Relaxation, step),
                              exact) /
           size;
  };
  // Where a joint begins to yield its damping falls to nothing within one step.
  EXPECT_LT(error(1e-3), 0.01);
  EXPECT_LT(error(2.5e-4), 0.0025);
}

}  // namespace
}  // namespace plastica
