#include "plastica/law/biaxial.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/lib/law/section_of.hpp"

namespace plastica::law {
namespace {

using testing::form_of;
using testing::Shaker;
using testing::steel;
using testing::upright;

/// What a point of a material is under normal and under shear stress.
struct Point {
  MaterialValues<double> values;
  UniaxialMaterial<double> normal, shear;
};

Point point_of(const Material& material) {
  const SectionForm form = form_of(upright(), material);
  return {material_values(material),
          uniaxial_material(form.axis[kAxial], material_values(material)),
          uniaxial_material(form.axis[kTorsion], material_values(material))};
}

template <class Uniaxial>
Biaxial<double, Uniaxial> law_of(const Point& point) {
  return biaxial_law<Uniaxial>(point.normal, point.shear, point.values);
}

/// Drives a fibre along one stress, in both ways, and compares it with the law of that stress
/// alone.
template <class Uniaxial>
void expect_uniaxial(HardeningLaw hardening, std::size_t along) {
  const Point point = point_of(steel(hardening));
  const auto together = law_of<Uniaxial>(point);
  const auto alone = Uniaxial::of(along == 0 ? point.normal : point.shear, point.values);
  typename Biaxial<double, Uniaxial>::State state;
  typename Uniaxial::State expected;
  Shaker shake(31);
  for (int i = 0; i < 40; ++i) {
    Vec<double, 2> strain;
    strain[along] = 6.0 * shake() * alone.yield / alone.stiffness;
    const auto now = respond(together, state, strain);
    const auto truth = respond(alone, expected, strain[along]);
    EXPECT_NEAR(now.stress[along], truth.stress, 1e-9 * alone.yield);
    EXPECT_EQ(now.stress[1 - along], 0.0);
    EXPECT_NEAR(now.tangent(along, along), truth.tangent, 1e-9 * alone.stiffness);
    EXPECT_NEAR(now.plastic_work, plastic_work(alone, expected, truth),
                1e-9 * alone.yield * alone.yield / alone.stiffness);
    EXPECT_NEAR(now.elastic_energy, 0.5 * truth.stress * truth.stress / alone.stiffness,
                1e-9 * alone.yield * alone.yield / alone.stiffness);
    state = now.state;
    expected = truth.state;
  }
}

TEST(Biaxial, IsTheUniaxialLawUnderEitherStressAlone) {
  for (const std::size_t along : {0U, 1U}) {
    expect_uniaxial<IdealPlastic<double>>(HardeningLaw::Ideal, along);
    expect_uniaxial<LinearHardening<double>>(HardeningLaw::Linear, along);
    expect_uniaxial<VoceChaboche<double>>(HardeningLaw::VoceChaboche, along);
    expect_uniaxial<Multilinear<double>>(HardeningLaw::Multilinear, along);
  }
}

/// An ideal metal of von Mises that does not change its volume: E = 3 G.
Material incompressible() {
  Material material;
  material.youngs_modulus = 210e9;
  material.shear_modulus = 70e9;
  material.yield_stress = 300e6;
  material.shear_yield_stress = 300e6 / std::sqrt(3.0);
  return material;
}

TEST(Biaxial, FollowsAYieldedTubeThatIsTwistedAtConstantLength) {
  // Pulled to yield and then twisted at constant length: sigma = Y/cosh x and tau = Y/sqrt(3) tanh
  // x, x = sqrt(3) G gamma/Y. Source: Hill, The Mathematical Theory of Plasticity (1950), ch. IV.
  const auto law = law_of<IdealPlastic<double>>(point_of(incompressible()));
  const auto error = [&](int steps) {
    Biaxial<double, IdealPlastic<double>>::State state;
    double worst = 0.0;
    for (int i = 0; i <= steps; ++i) {
      const double x = 3.0 * i / steps;
      const double gamma = x * 300e6 / (std::sqrt(3.0) * 70e9);
      const auto now = respond(law, state, Vec<double, 2>{{300e6 / 210e9, gamma}});
      worst = std::max(worst, std::fabs(now.stress[0] - 300e6 / std::cosh(x)));
      worst = std::max(worst, std::fabs(std::sqrt(3.0) * now.stress[1] - 300e6 * std::tanh(x)));
      state = now.state;
    }
    return worst / 300e6;
  };
  EXPECT_LT(error(1000), 1e-3);
  EXPECT_NEAR(error(500) / error(1000), 2.0, 0.1);
}

TEST(Biaxial, StaysOnItsSurfaceAndAccountsForTheWorkDoneOnIt) {
  const Material material = steel(HardeningLaw::VoceChaboche);
  const auto law = law_of<VoceChaboche<double>>(point_of(material));
  const auto residual = [&](int steps) {
    Biaxial<double, VoceChaboche<double>>::State state;
    Vec<double, 2> strain;
    Vec<double, 2> stress;
    double external = 0.0;
    double plastic = 0.0;
    double elastic = 0.0;
    for (int i = 1; i <= steps; ++i) {
      const double t = 6.0 * i / steps;
      const Vec<double, 2> next{{6e-3 * std::sin(t), 8e-3 * std::sin(0.7 * t)}};
      const auto now = respond(law, state, next);
      external += 0.5 * dot(stress + now.stress, next - strain);
      plastic += now.plastic_work;
      elastic = now.elastic_energy;
      strain = next;
      stress = now.stress;
      state = now.state;
    }
    EXPECT_GT(plastic, 2.0 * elastic);
    return std::fabs(external - plastic - elastic) / external;
  };
  EXPECT_LT(residual(4000), 1e-3);
  EXPECT_GT(residual(2000) / residual(4000), 1.9);
}

template <class Uniaxial>
void expect_consistent_tangent(HardeningLaw hardening) {
  const Point point = point_of(steel(hardening));
  const auto law = law_of<Uniaxial>(point);
  const Vec<double, 2> yield{
      {point.normal.yield / point.normal.stiffness, point.shear.yield / point.shear.stiffness}};
  typename Biaxial<double, Uniaxial>::State state;
  Shaker shake(32);
  for (int i = 0; i < 40; ++i) {
    Vec<double, 2> strain{{3.0 * shake() * yield[0], 3.0 * shake() * yield[1]}};
    const auto now = respond(law, state, strain);
    for (std::size_t j = 0; j < 2; ++j) {
      const double h = 1e-6 * yield[j];
      Vec<double, 2> more = strain;
      more[j] += h;
      Vec<double, 2> less = strain;
      less[j] -= h;
      const auto slope =
          (0.5 / h) * (respond(law, state, more).stress - respond(law, state, less).stress);
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(slope[k], now.tangent(k, j), 1e-5 * point.normal.stiffness) << i << k << j;
      }
    }
    state = now.state;
  }
}

TEST(Biaxial, HasAConsistentTangent) {
  expect_consistent_tangent<IdealPlastic<double>>(HardeningLaw::Ideal);
  expect_consistent_tangent<LinearHardening<double>>(HardeningLaw::Linear);
  expect_consistent_tangent<VoceChaboche<double>>(HardeningLaw::VoceChaboche);
  expect_consistent_tangent<Multilinear<double>>(HardeningLaw::Multilinear);
}

}  // namespace
}  // namespace plastica::law
