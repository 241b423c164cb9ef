#include "plastica/chain/recursion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/chain.hpp"

namespace plastica::chain {
namespace {

using testing::cantilever;
using testing::SolvedChain;

/// Bent and twisted, with everything that acts on a chain: dead and follower loads, springs, a
/// rotational spring, a half joint to the ground and a pin off the root, a regional load.
Scene busy_scene() {
  Scene scene = cantilever(9, {300.0, -500.0, 200.0});
  scene.section.width = 0.03;
  scene.material.shear_modulus = 60e9;
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = 0.8;
  scene.loads[0].moment = {20.0, 30.0, 40.0};
  scene.loads.push_back({{0.6, {}}, {}, {100.0, 50.0, -80.0}, {10.0, -15.0, 5.0}, true, {}});
  scene.loads.push_back(
      {{0.2, {}}, Place{0.7, {}}, {0.0, -400.0, 0.0}, {0.0, 3.0, 0.0}, false, {}});
  Support spring;
  spring.at = {0.4, {}};
  spring.kind = SupportKind::Elastic;
  spring.stiffness = {3e4, 2e4, 1e4};
  spring.rotational_stiffness = {200.0, 300.0, 100.0};
  scene.supports.push_back(spring);
  Support guide;
  guide.at.segment = 6;
  guide.kind = SupportKind::Guide;
  scene.supports.push_back(guide);
  Support roller;
  roller.at = {0.9, {}};
  roller.kind = SupportKind::Roller;
  scene.supports.push_back(roller);
  return scene;
}

/// The Newton step d of a state out of balance r solves r + (dr/dq) d = 0, closures included; so
/// the difference of r over a small part of d is -r. That checks every term of the tangent.
template <class L, bool kElastic>
void expect_consistent_tangent(const View<L>& view) {
  using Law = law::ElasticSection<double>;
  const Scene scene = busy_scene();
  const auto state_at = [&](double part, auto&& read) {
    SolvedChain<L, kElastic, Law> solved(scene, material_values(scene.material), view);
    auto& w = solved.work;
    w.time = 1.0;
    // Some state far from equilibrium, the same each time.
    for (std::size_t i = 0; i < w.q.angle.size(); ++i) {
      for (std::size_t k = 0; k < L::kRotations; ++k) {
        w.q.angle[i][k] = 0.15 * std::sin(1.0 + 2.0 * static_cast<double>(i + 3 * k));
      }
      if constexpr (kElastic) {
        for (std::size_t k = 0; k < L::kTranslations; ++k) {
          w.q.shift[i][k] = 2e-3 * std::cos(static_cast<double>(i + 5 * k));
        }
      }
    }
    for (std::size_t k = 0; k < w.q.multiplier.size(); ++k) {
      w.q.multiplier[k] = 50.0 * static_cast<double>(k + 1);
    }
    solve::NewtonOptions one_step;
    one_step.most_iterations = 1;
    if (part != 0.0) {
      // `part` of the step, by hand.
      const auto before = w.q;
      solve::equilibrate(solved.build.chain, *solved.joints, one_step, w);
      const auto after = w.q;
      w.q = before;
      for (std::size_t i = 0; i < before.angle.size(); ++i) {
        w.q.angle[i] += part * (after.angle[i] - before.angle[i]);
        if constexpr (kElastic) w.q.shift[i] += part * (after.shift[i] - before.shift[i]);
      }
      for (std::size_t k = 0; k < before.multiplier.size(); ++k) {
        w.q.multiplier[k] += part * (after.multiplier[k] - before.multiplier[k]);
      }
    }
    one_step.most_iterations = 0;
    solve::equilibrate(solved.build.chain, *solved.joints, one_step, w);
    read(solved);
  };
  const auto residual = [&](double part) {
    std::vector<double> r;
    state_at(part, [&](auto& solved) {
      for (const auto& balance : solved.work.recursion.balance()) {
        for (const double value : balance.at) r.push_back(value);
      }
      for (const double gap : solved.work.gap) r.push_back(gap);
    });
    return r;
  };
  const double h = 1e-5;
  const auto at = residual(0.0);
  const auto ahead = residual(h);
  const auto behind = residual(-h);
  double scale = 0.0;
  for (const double r : at) scale = std::max(scale, std::fabs(r));
  for (std::size_t i = 0; i < at.size(); ++i) {
    // h^2 of the third derivative and rounding over h are both below 1e-9 of the scale.
    EXPECT_NEAR((ahead[i] - behind[i]) / (2.0 * h), -at[i], 1e-8 * scale) << i;
  }
}

TEST(Recursion, HasTheConsistentTangentInTheYZPlane) {
  expect_consistent_tangent<Planar<double>, false>(View<Planar<double>>{1});
}
TEST(Recursion, HasTheConsistentTangentInTheXZPlane) {
  expect_consistent_tangent<Planar<double>, false>(View<Planar<double>>{0});
}
TEST(Recursion, HasTheConsistentTangentInThePlaneWithStretchAndShear) {
  expect_consistent_tangent<Planar<double>, true>(View<Planar<double>>{1});
}
TEST(Recursion, HasTheConsistentTangentInSpace) {
  expect_consistent_tangent<Spatial<double>, false>({});
}
TEST(Recursion, HasTheConsistentTangentInSpaceWithStretchAndShear) {
  expect_consistent_tangent<Spatial<double>, true>({});
}
TEST(Recursion, HasTheConsistentTangentInTwist) {
  expect_consistent_tangent<Twist<double>, false>({});
}

/// The residual of the joints at ten thousand segments is the sum of ten thousand levers; what
/// rounding leaves of the exact discrete deflection is the conditioning of the whole.
TEST(Recursion, KeepsTenDigitsAtTenThousandSegments) {
  constexpr int kSegments = 10000;
  const double alpha = 1e-6;  // P L^2/EI: finite rotations cost alpha^2
  const double bending = 200e9 * std::pow(0.02, 4) / 12.0;
  using L = Planar<double>;
  const Scene scene = cantilever(kSegments, {0.0, -alpha * bending, 0.0});
  SolvedChain<L, false, law::ElasticSection<double>> solved(scene, material_values(scene.material),
                                                            View<L>{1});
  solved.go_to(1.0, 1);
  const double exact = alpha / 3.0 * (1.0 + 0.5 / kSegments / kSegments);
  EXPECT_NEAR(-solved.tip()[1] / exact, 1.0, 1e-10);
}

}  // namespace
}  // namespace plastica::chain
