#include <gtest/gtest.h>

#include <cmath>

#include "plastica/base/dual.hpp"
#include "plastica/base/pack.hpp"
#include "plastica/chain/builder.hpp"
#include "tests/support/chain.hpp"

/// The same kernels with a scenario in each lane, and with derivatives by the material.
namespace plastica::solve {
namespace {

using testing::cantilever;
using testing::SolvedChain;

template <class S>
using Ideal = law::PerAxisSection<S, law::IdealPlastic<S>>;

Scene pushed_scene() {
  Scene scene = cantilever(12, {40.0, -420.0, 0.0});
  scene.loads[0].moment = {0.0, 0.0, 60.0};
  Support roller;
  roller.at = {0.75, {}};
  roller.kind = SupportKind::Pillar;
  roller.gap = 0.01;
  scene.supports.push_back(roller);
  return scene;
}

constexpr auto kYoung = static_cast<std::size_t>(MaterialField::YoungsModulus);
constexpr auto kYield = static_cast<std::size_t>(MaterialField::YieldStress);

template <template <class> class Level, class S>
typename Level<S>::Point tip_of(const Scene& scene, const MaterialValues<S>& material,
                                const chain::View<Level<S>>& view) {
  SolvedChain<Level<S>, false, Ideal<S>> solved(scene, material, view);
  NewtonOptions options;
  options.max_iterations = 40;
  solved.go_to(1.0, 8, options);
  return solved.tip();
}

template <template <class> class Level, class MakeView>
void expect_lanes_and_derivatives(const Scene& scene, const MakeView& view_of) {
  using P = Pack<double, 8>;
  using D = Dual<double, 2>;
  const MaterialValues<double> plain = material_values(scene.material);
  MaterialValues<P> lanes;
  MaterialValues<D> dual;
  for (std::size_t i = 0; i < kMaterialFields; ++i) {
    lanes[i] = P(plain[i]);
    dual[i] = D(plain[i]);
  }
  for (int lane = 0; lane < 8; ++lane) lanes[kYoung].set(lane, plain[kYoung] * (1.0 + 0.02 * lane));
  dual[kYoung] = D::parameter(plain[kYoung], 0);
  dual[kYield] = D::parameter(plain[kYield], 1);
  const auto in_lanes = tip_of<Level, P>(scene, lanes, view_of.template operator()<P>());
  const auto derived = tip_of<Level, D>(scene, dual, view_of.template operator()<D>());
  const auto alone = [&](double young, double yield) {
    MaterialValues<double> material = plain;
    material[kYoung] = young;
    material[kYield] = yield;
    return tip_of<Level, double>(scene, material, view_of.template operator()<double>());
  };
  const auto tip = alone(plain[kYoung], plain[kYield]);
  const double h = 1e-6;
  const auto stiffer = alone(plain[kYoung] * (1.0 + h), plain[kYield]);
  const auto softer = alone(plain[kYoung] * (1.0 - h), plain[kYield]);
  for (std::size_t k = 0; k < tip.at.size(); ++k) {
    for (int lane = 0; lane < 8; ++lane) {
      const auto lone = alone(lanes[kYoung][lane], plain[kYield]);
      EXPECT_NEAR(in_lanes[k][lane], lone[k], 1e-10);
    }
    EXPECT_NEAR(derived[k].value(), tip[k], 1e-10);
    // By differences; what the step's square and rounding leave is below 1e-6 of the slope.
    const double slope = (stiffer[k] - softer[k]) / (2.0 * h);
    EXPECT_NEAR(derived[k].derivative(0) * plain[kYoung], slope, 1e-6 * (1.0 + std::fabs(slope)));
  }
}

TEST(Scalars, AgreeInThePlane) {
  Scene scene = pushed_scene();
  scene.loads[0].force[0] = 0.0;
  scene.loads[0].moment = {};
  expect_lanes_and_derivatives<chain::Planar>(
      scene, []<class S>() { return chain::View<chain::Planar<S>>{1}; });
}

TEST(Scalars, AgreeInSpace) {
  expect_lanes_and_derivatives<chain::Spatial>(
      pushed_scene(), []<class S>() { return chain::View<chain::Spatial<S>>{}; });
}

TEST(Scalars, AgreeInTwist) {
  Scene scene = cantilever(12, {});
  scene.loads[0].moment = {0.0, 0.0, 100.0};
  using P = Pack<double, 8>;
  using D = Dual<double, 1>;
  const auto turn = [&]<class S>(const MaterialValues<S>& material) {
    SolvedChain<chain::Twist<S>, false, Ideal<S>> solved(scene, material);
    solved.go_to(1.0, 2);
    return solved.work.placement.frame.back().angle;
  };
  const MaterialValues<double> plain = material_values(scene.material);
  MaterialValues<P> lanes;
  MaterialValues<D> dual;
  for (std::size_t i = 0; i < kMaterialFields; ++i) {
    lanes[i] = P(plain[i]);
    dual[i] = D(plain[i]);
  }
  dual[kYoung] = D::parameter(plain[kYoung], 0);
  const double alone = turn(plain);
  EXPECT_NEAR(turn(lanes)[3], alone, 1e-10);
  // The twist is T L/(G J): its derivative by E is -twist/E.
  EXPECT_NEAR(turn(dual).derivative(0) * plain[kYoung], -alone, 1e-10);
}

}  // namespace
}  // namespace plastica::solve
