#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "tests/support/motion_scene.hpp"
#include "tests/support/tolerance.hpp"

// Momentum of what no support holds, against sums and integrals in closed form.

namespace plastica {
namespace {

using testing::add_probe;
using testing::chain_scene;
using testing::flying_scene;
using testing::last_of;
using testing::motion_options;

constexpr double kSpin = 180.0;  // [rad/s]

/// A steel bar that spins about its middle.
Scene spinning_scene(int segments, bool in_space) {
  Scene scene = chain_scene(segments);
  scene.material.density = 7850.0;
  InitialMotion spin;
  spin.about = {0.5, {}};
  spin.spin = {kSpin, 0.0, 0.0};
  scene.initial_motions = {spin};
  if (in_space) {
    InitialMotion along;
    along.velocity = {1.0, 0.0, 0.0};
    scene.initial_motions.push_back(along);
  }
  add_probe(scene, ProbeQuantity::AngularMomentum, {}, Component::X);
  return scene;
}

/// m L^2/12 of the straight bar, and its section's rho I L.
double inertia_of(const Scene& scene) {
  const SectionProperties p = testing::properties_of(scene);
  return scene.material.density * (p.area / 12.0 + p.second_moment_x);
}

class Spin : public ::testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Levels, Spin, ::testing::Bool(),
                         [](const auto& each) { return each.param ? "spatial" : "planar"; });

// One linear solve leaves a moment out of balance, in every step the same way.
TEST_P(Spin, OfAFreeBarIsKeptByTheLinearlyImplicitMidpointAtEveryStep) {
  for (const double step : {4e-4, 2e-4, 1e-4, 5e-5}) {
    const Scene scene = spinning_scene(8, GetParam());
    SolverOptions options = motion_options(Scheme::LinearlyImplicitMidpoint, step, 4);
    options.duration = 0.2;
    const Response response = simulate(scene, options);
    ASSERT_EQ(response.status, Status::Completed) << step;
    const double momentum = kSpin * inertia_of(scene);
    EXPECT_NEAR(last_of(response, 0) / momentum, 1.0, testing::tolerance(1e-10)) << step;
    EXPECT_LT(response.momentum_error, 1e-9) << step;
    EXPECT_LT(response.energy_balance_error, 1e-8) << step;
  }
}

TEST_P(Spin, OfABarThatBendsIsKeptToo) {
  Scene scene = flying_scene(8, GetParam());
  add_probe(scene, ProbeQuantity::AngularMomentum, {}, Component::X);
  add_probe(scene, ProbeQuantity::Momentum, {}, Component::Y);
  for (const double step : {1e-3, 2e-4}) {
    SolverOptions options = motion_options(Scheme::LinearlyImplicitMidpoint, step, 100);
    options.duration = 0.2;
    const Response response = simulate(scene, options);
    ASSERT_EQ(response.status, Status::Completed);
    EXPECT_LT(testing::drift_of(response, 0), 1e-10) << step;
    EXPECT_LT(testing::drift_of(response, 1), 1e-10) << step;
  }
}

// x1 x m (v1 - v0) = 0 makes L1 = L0 + h v1 x m v0, so dw/dt = -h w^3 and 1/w^2 = 1/w0^2 + 2 h t:
// the scheme's own loss, of first order, which the account has to say as large as it is.
TEST_P(Spin, ThatImplicitEulerLosesIsInTheAccount) {
  const Scene scene = spinning_scene(8, GetParam());
  const double momentum = kSpin * inertia_of(scene);
  std::array<double, 2> error{};
  for (std::size_t k = 0; k < 2; ++k) {
    const double step = k == 0 ? 1e-4 : 5e-5;
    SolverOptions options = motion_options(Scheme::LinearlyImplicitEuler, step, 4);
    options.duration = 0.05;
    const Response response = simulate(scene, options);
    EXPECT_EQ(response.status, Status::NotBalanced);
    EXPECT_EQ(response.samples, 5U);
    const double lost = 1.0 - last_of(response, 0) / momentum;
    const double expected =
        1.0 - 1.0 / std::sqrt(1.0 + 2.0 * step * options.duration * kSpin * kSpin);
    EXPECT_NEAR(lost / expected, 1.0, 0.05) << step;
    EXPECT_NEAR(response.momentum_error / lost, 1.0, testing::tolerance(1e-5));
    error[k] = lost;
  }
  EXPECT_NEAR(std::log2(error[0] / error[1]), 1.0, 0.15);
}

struct Flight {
  Scheme scheme;
  double tolerance;
};

class Impulse : public ::testing::TestWithParam<Flight> {};

INSTANTIATE_TEST_SUITE_P(Schemes, Impulse,
                         ::testing::Values(Flight{Scheme::EnergyMomentum, 1e-8},
                                           Flight{Scheme::LinearlyImplicitMidpoint, 1e-8},
                                           Flight{Scheme::GeneralizedAlpha, 2e-3},
                                           Flight{Scheme::LinearlyImplicitEuler, 5e-3}),
                         [](const auto& each) {
                           return "scheme" + std::to_string(static_cast<int>(each.param.scheme));
                         });

constexpr double kTime = 0.05;  // [s]

/// A free bar at rest, pushed at its middle by a history of the integral kTime/2.
Scene pushed_scene(double force, double moment) {
  Scene scene = chain_scene(8);
  scene.material.density = 7850.0;
  Load push;
  push.at = {0.5, {}};
  push.force = {0.0, force, 0.0};
  push.moment = {moment, 0.0, 0.0};
  push.history = {{0.0, 0.4 * kTime, kTime}, {0.0, 1.0, 0.0}};
  scene.loads = {push};
  add_probe(scene, ProbeQuantity::Momentum, {}, Component::Y);
  add_probe(scene, ProbeQuantity::AngularMomentum, {}, Component::X);
  return scene;
}

// m v is the integral of the force, and the angular momentum that of the moment.
TEST_P(Impulse, OfLoadsIsTheMomentumOfAFreeBar) {
  constexpr double kForce = 40.0;  // [N]
  constexpr double kMoment = 6.0;  // [N m]
  SolverOptions options = motion_options(GetParam().scheme, 1e-4, 20);
  options.duration = 2.0 * kTime;
  const Response pushed = simulate(pushed_scene(kForce, 0.0), options);
  ASSERT_EQ(pushed.status, Status::Completed);
  EXPECT_NEAR(last_of(pushed, 0) / (0.5 * kForce * kTime), 1.0, GetParam().tolerance);
  EXPECT_LT(pushed.momentum_error, GetParam().tolerance);
  const Response turned = simulate(pushed_scene(0.0, kMoment), options);
  ASSERT_EQ(turned.status, Status::Completed);
  EXPECT_NEAR(last_of(turned, 1) / (0.5 * kMoment * kTime), 1.0, GetParam().tolerance);
  EXPECT_LT(turned.momentum_error, GetParam().tolerance);
}

// The kernels' beams hang from their start: about a pin no moment acts on them. They are not in the
// account, so that this is the only look at their momentum.
TEST(ArticulatedSchemes, KeepTheAngularMomentumAboutAPinByTheirOrder) {
  Scene scene = flying_scene(8, false);
  scene.supports.push_back({Place::start(), SupportKind::Pin});
  scene.initial_motions[0].velocity = {};
  add_probe(scene, ProbeQuantity::AngularMomentum, {}, Component::X);
  const auto drift = [&](Scheme scheme, double step) {
    SolverOptions options = motion_options(scheme, step, 20);
    options.duration = 0.1;
    const Response response = simulate(scene, options);
    EXPECT_EQ(response.status, Status::Completed);
    return testing::drift_of(response, 0);
  };
  const double middle = drift(Scheme::ArticulatedMidpoint, 2e-5);
  EXPECT_LT(middle, 1e-4);
  EXPECT_GT(std::log2(middle / drift(Scheme::ArticulatedMidpoint, 1e-5)), 1.7);
}

// What a cut has freed keeps the momentum that it then has, though the rest is held.
TEST(MomentumAccount, IsOfTheFragmentsThatNothingHolds) {
  Scene scene = testing::struck_scene(8, 10.0, YieldModel::Elastic);
  scene.cuts.push_back({{0.5, {}}, 0.02});
  SolverOptions options = motion_options(Scheme::LinearlyImplicitEuler, 1e-4, 10);
  options.duration = 0.02;
  EXPECT_EQ(simulate(scene, options).momentum_error, 0.0);  // held until then
  options.duration = 0.1;
  EXPECT_GT(simulate(scene, options).momentum_error, 1e-6);
  options.scheme = Scheme::LinearlyImplicitMidpoint;
  EXPECT_LT(simulate(scene, options).momentum_error, 1e-8);
}

}  // namespace
}  // namespace plastica
