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
TEST(DampingBy, AnglesIsThatByMomentsOfAnElasticBeam) {
  for (const bool in_space : {false, true}) {
    const Scene scene = pushed(in_space, YieldModel::Elastic);
    const auto angles = tip(scene, Scheme::EnergyMomentum, Damping::Stiffness, 1e-3);
    const auto moments = tip(scene, Scheme::EnergyMomentum, Damping::Relaxation, 1e-3);
    const double size = -*std::min_element(angles.begin(), angles.end());
    // In space they differ by how a step turns.
    EXPECT_LT(largest_difference(angles, moments), (in_space ? 1e-5 : 1e-9) * size) << in_space;
  }
}

/// A beam that begins with speeds has a moment's rate at once; of second order where it is elastic.
TEST(DampingBy, MomentsBeginsWithTheirRate) {
  Scene scene = testing::cantilever_scene(8);
  scene.yield_model = YieldModel::Elastic;
  InitialMotion blow;
  blow.from = {0.5, {}};
  blow.velocity = {0.0, -0.5, 0.0};
  scene.initial_motions = {blow};
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const auto exact = tip(scene, Scheme::EnergyMomentum, Damping::Relaxation, 1e-5);
  const double size = -*std::min_element(exact.begin(), exact.end());
  const auto error = [&](double step) {
    SolverOptions options = motion_options(Scheme::GeneralizedAlpha, step, 50);
    options.duration = 0.1;
    options.damping = Damping::Relaxation;
    options.damping_time = 2e-3;
    return largest_difference(simulate(scene, options).probes[0], exact) / size;
  };
  EXPECT_LT(error(2.5e-4), 2e-3);
  EXPECT_LT(error(6.25e-5), 2e-4);
}

/// So it is where joints stretch and shear, with a damping time of several steps.
TEST(DampingBy, AnglesIsThatByMomentsWhereJointsStretch) {
  const Scene scene = pushed(false, YieldModel::Elastic);
  for (const Scheme scheme : {Scheme::EnergyMomentum, Scheme::LinearlyImplicitMidpoint}) {
    const auto damped = [&](Damping damping) {
      SolverOptions options = motion_options(scheme, 1e-3, 100);
      options.translation = JointTranslation::Elastic;
      options.damping = damping;
      options.damping_time = 5e-3;
      const Response response = testing::completed(scene, options);
      EXPECT_EQ(response.counters.cutbacks, 0);
      return response.probes[0];
    };
    const auto angles = damped(Damping::Stiffness);
    const auto moments = damped(Damping::Relaxation);
    const double size = -*std::min_element(angles.begin(), angles.end());
    EXPECT_LT(largest_difference(angles, moments), 1e-9 * size) << static_cast<int>(scheme);
  }
}

/// Elastic or flowing, at a plane level or in space; the truth is another scheme's.
TEST(DampingBy, MomentsIsOfSecondOrderInTheStep) {
  for (const bool in_space : {false, true}) {
    for (const YieldModel model : {YieldModel::Elastic, YieldModel::PerAxis}) {
      Scene scene = pushed(in_space, model);
      // The clamp yields from 0.83 of its load on.
      if (model != YieldModel::Elastic) {
        scene.loads[0].force[1] = -1.2 * testing::yield_moment_of(scene);
      }
      const auto exact = tip(scene, Scheme::EnergyMomentum, Damping::Relaxation, 1e-5);
      const auto error = [&](double step) {
        return largest_difference(tip(scene, Scheme::GeneralizedAlpha, Damping::Relaxation, step),
                                  exact);
      };
      const double coarse = error(1e-3);
      const double fine = error(1.25e-4);
      EXPECT_GT(std::log2(coarse / fine) / 3.0, model == YieldModel::Elastic ? 1.9 : 1.6)
          << in_space << ' ' << static_cast<int>(model);
      EXPECT_LT(coarse, 1e-3 * -*std::min_element(exact.begin(), exact.end()));
    }
  }
}

}  // namespace
}  // namespace plastica
