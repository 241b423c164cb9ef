#include "plastica/chain/recursion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plastica/law/fibre.hpp"
#include "plastica/law/fibre_grid.hpp"
#include "plastica/law/interaction.hpp"
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

/// The Newton step d of a state out of balance r solves r + (dr/dq) d = 0, constraints included; so
/// the difference of r over a small part of d is -r. That checks every term of the tangent.
///
/// @param make  a chain in its virgin state
/// @param rest  what joints keep for Newton's method beside their laws, over a radian [N m]
template <class L, bool kElastic, class Make>
void expect_consistent_tangent_of(const Make& make, double rest = 0.0) {
  const auto state_at = [&](double part, auto&& read) {
    auto solved = make();
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
    one_step.max_iterations = 1;
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
    one_step.max_iterations = 0;
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
    EXPECT_NEAR((ahead[i] - behind[i]) / (2.0 * h), -at[i], 1e-8 * scale + rest) << i;
  }
}

template <class L, bool kElastic>
void expect_consistent_tangent(const View<L>& view) {
  const Scene scene = busy_scene();
  expect_consistent_tangent_of<L, kElastic>([&] {
    return SolvedChain<L, kElastic, law::ElasticSection<double>>(
        scene, material_values(scene.material), view);
  });
}

/// The same with joints that yield under moments and the axial force from equilibrium, half joints
/// at a clamped end and on both sides of a guide among them, whose nodes have a spring and a
/// follower, too.
Scene yielding_scene() {
  Scene scene = busy_scene();
  scene.material.yield_stress = 40e6;
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 20e9;
  Support clamp;
  clamp.at = Place::end();
  clamp.kind = SupportKind::Clamp;
  scene.supports.push_back(clamp);
  Support spring;
  spring.at = Place::end();
  spring.kind = SupportKind::Elastic;
  spring.stiffness = {100.0, 200.0, 300.0};
  scene.supports.push_back(spring);
  scene.loads.push_back({Place::end(), {}, {100.0, 80.0, 500.0}, {}, true, {}});
  scene.loads.push_back({Place{0.0, {}}, {}, {100.0, 80.0, 500.0}, {}, false, {}});
  const Place guide{0.0, 6};  // of the busy scene
  spring.at = guide;
  scene.supports.push_back(spring);
  scene.loads.push_back({guide, {}, {-120.0, 180.0, 800.0}, {}, true, {}});
  return scene;
}

/// Reads how far the axial forces go.
template <class Solved>
void expect_axial_forces_matter(const Scene& scene, Solved solved) {
  solve::NewtonOptions none;
  none.max_iterations = 0;
  solved.work.time = 1.0;
  solve::equilibrate(solved.build.chain, *solved.joints, none, solved.work);
  double largest = 0.0;
  for (const double n : solved.work.joints.axial) largest = std::max(largest, std::fabs(n));
  const double yield = scene.material.yield_stress * scene.section.width * scene.section.height;
  EXPECT_GT(largest, 0.02 * yield);
  EXPECT_LT(largest, 0.98 * yield);
}

/// 1e-9 of E I/l (SectionJoints): here it is seen, for joints yield and moments are small.
double kept_slope(const Scene& scene) {
  const double second_moment = std::pow(scene.section.width, 3) * scene.section.height / 12.0;
  const double length = scene.beam.length / scene.beam.segments;
  return 1e-9 * scene.material.youngs_modulus * second_moment / length;
}

template <class L, bool kElastic>
void expect_consistent_tangent_of_surface(const View<L>& view) {
  using Uniaxial = law::LinearHardening<double>;
  using Gauge = law::PlasticGauge<double>;
  Scene scene = yielding_scene();
  scene.yield_cap = YieldCap::FullyPlastic;
  const auto material = material_values(scene.material);
  const auto make = [&] {
    return SolvedChain<L, kElastic, law::InteractionSection<double, Gauge, Uniaxial>>(
        scene, material, view, [&](const law::SectionForm& form) {
          return law::interaction_section<Uniaxial>(form, Gauge{1.0}, material);
        });
  };
  expect_axial_forces_matter(scene, make());
  expect_consistent_tangent_of<L, kElastic>(make, kept_slope(scene));
}

template <class L, bool kElastic>
void expect_consistent_tangent_of_fibres(const View<L>& view, law::FibrePlane plane) {
  using Uniaxial = law::LinearHardening<double>;
  const Scene scene = yielding_scene();
  const auto material = material_values(scene.material);
  const auto properties = section_properties(scene.section, scene.material.poisson_ratio);
  const law::FibreLayout layout = law::fibre_layout(scene.section, properties, plane, 8);
  const auto law_of = [&](const law::SectionForm& of) {
    if constexpr (L::kRotations == 3) {
      return law::fibre_grid<Uniaxial>(layout, of, material);
    } else {
      return law::fibre_section<Uniaxial>(layout, of, material);
    }
  };
  using Law = std::remove_cvref_t<decltype(law_of(law::SectionForm{}))>;
  const auto make = [&] { return SolvedChain<L, kElastic, Law>(scene, material, view, law_of); };
  expect_axial_forces_matter(scene, make());
  expect_consistent_tangent_of<L, kElastic>(make, kept_slope(scene));
}

TEST(Recursion, HasTheConsistentTangentUnderAxialForceInThePlane) {
  expect_consistent_tangent_of_surface<Planar<double>, false>(View<Planar<double>>{1});
}
TEST(Recursion, HasTheConsistentTangentUnderAxialForceInThePlaneOfFibres) {
  expect_consistent_tangent_of_fibres<Planar<double>, false>(View<Planar<double>>{0},
                                                             law::FibrePlane::AboutY);
}
TEST(Recursion, HasTheConsistentTangentUnderAxialForceAtTheGroundAlone) {
  expect_consistent_tangent_of_fibres<Planar<double>, true>(View<Planar<double>>{1},
                                                            law::FibrePlane::AboutX);
}
TEST(Recursion, HasTheConsistentTangentUnderAxialForceInSpace) {
  expect_consistent_tangent_of_surface<Spatial<double>, false>({});
}
TEST(Recursion, HasTheConsistentTangentUnderAxialForceInSpaceOfFibres) {
  expect_consistent_tangent_of_fibres<Spatial<double>, false>({}, law::FibrePlane::Both);
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
