#include "plastica/law/multilinear.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "plastica/base/pack.hpp"
#include "plastica/law/uniaxial.hpp"

namespace plastica::law {
namespace {

constexpr double kE = 200e9;
constexpr double kY = 300e6;
const std::vector<double> kStrain{0.0, 0.002, 0.01, 0.04};
const std::vector<double> kStress{kY, 330e6, 320e6, 400e6};

Material of_table(double kinematic_fraction) {
  Material material;
  material.youngs_modulus = kE;
  material.yield_stress = kY;
  material.hardening.law = HardeningLaw::Multilinear;
  material.hardening.kinematic_fraction = kinematic_fraction;
  std::copy(kStrain.begin() + 1, kStrain.end(), material.hardening.plastic_strain.begin());
  std::copy(kStress.begin() + 1, kStress.end(), material.hardening.flow_stress.begin());
  return material;
}

Multilinear<double> law_of(const Material& material, UniaxialForm form = {}) {
  const auto values = material_values(material);
  return Multilinear<double>::of(uniaxial_material(form, values), values);
}

/// The table by hand: stress and slope at a plastic strain.
Grown<double> table_at(double p) {
  for (std::size_t i = 1; i < kStrain.size(); ++i) {
    if (p >= kStrain[i]) continue;
    const double slope = (kStress[i] - kStress[i - 1]) / (kStrain[i] - kStrain[i - 1]);
    return {kStress[i - 1] + slope * (p - kStrain[i - 1]), slope};
  }
  return {kStress.back(), 0.0};
}

TEST(Multilinear, FollowsItsTableWhenPulledOnce) {
  for (const double fraction : {0.0, 0.4, 1.0}) {
    const auto law = law_of(of_table(fraction));
    for (const double p : {0.0, 0.001, 0.002, 0.005, 0.01, 0.025, 0.04, 0.3}) {
      const double stress = table_at(p).value;
      const auto now = respond(law, {}, p + stress / kE);
      EXPECT_NEAR(now.stress, stress, 1e-9 * kY) << p;
      EXPECT_NEAR(now.state.accumulated, p, 1e-14) << p;
      const auto pushed = respond(law, {}, -p - stress / kE);
      EXPECT_EQ(pushed.stress, -now.stress);
    }
  }
}

TEST(Multilinear, OfShearHasStressesOverRAndStrainsTimesR) {
  Material material = of_table(0.4);
  material.shear_yield_stress = kY / 1.9;
  const auto law = law_of(material, {.shear = true, .shear_yield_given = true});
  for (const double p : {0.001, 0.005, 0.025, 0.3}) {
    const double stress = table_at(p).value / 1.9;
    const auto now = respond(law, {}, 1.9 * p + stress / law.stiffness);
    EXPECT_NEAR(now.stress, stress, 1e-9 * kY) << p;
  }
}

/// d s = K (d e - d e_p), small step by small step, with the slope of the table where it is.
double stepped(double fraction, const std::vector<double>& path) {
  constexpr int kSteps = 200000;
  double stress = 0.0, back = 0.0, p = 0.0, from = 0.0;
  for (const double to : path) {
    const double de = (to - from) / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      const Grown<double> table = table_at(p);
      const double radius = kY + (1.0 - fraction) * (table.value - kY);
      const double trial = stress + kE * de;
      const double over = std::fabs(trial - back) - radius;
      if (over <= 0.0) {
        stress = trial;
        continue;
      }
      const double dp = over / (kE + table.slope);
      const double direction = trial > back ? 1.0 : -1.0;
      stress = trial - direction * kE * dp;
      back += direction * fraction * table.slope * dp;
      p += dp;
    }
    from = to;
  }
  return stress;
}

TEST(Multilinear, IsWhatSmallStepsConvergeTo) {
  for (const double fraction : {0.0, 0.4, 1.0}) {
    const auto law = law_of(of_table(fraction));
    std::vector<double> path;
    typename Multilinear<double>::State state;
    for (const double strain : {0.004, -0.006, 0.012, -0.02, 0.03}) {
      path.push_back(strain);
      const auto now = respond(law, state, strain);
      state = now.state;
      EXPECT_NEAR(now.stress, stepped(fraction, path), 1e-5 * kY) << fraction << " at " << strain;
    }
  }
}

TEST(Multilinear, YieldsBackWhereItsKindOfHardeningSays) {
  // Isotropic: after twice the radius; kinematic: after twice the first yield stress.
  const double p = 0.02;
  const double top = table_at(p).value;
  for (const double fraction : {0.0, 1.0}) {
    const auto law = law_of(of_table(fraction));
    const auto state = respond(law, {}, p + top / kE).state;
    const double range = fraction == 0.0 ? 2.0 * top : 2.0 * kY;
    const auto yields_at = [&](double direction) {
      return respond(law, state, p + (top - direction) / kE).state.accumulated > state.accumulated;
    };
    EXPECT_FALSE(yields_at(range * (1.0 - 1e-9)));
    EXPECT_TRUE(yields_at(range * (1.0 + 1e-9)));
  }
}

TEST(Multilinear, OfOneLongLineIsLinearHardening) {
  Material material = of_table(0.3);
  material.hardening.plastic_strain = {1.0};
  material.hardening.flow_stress = {kY + 5e9};
  const auto law = law_of(material);
  const LinearHardening<double> linear{kE, kY, 3.5e9, 1.5e9};
  Multilinear<double>::State state;
  LinearHardening<double>::State expected;
  for (const double strain : {0.001, 0.02, -0.01, 0.03, 0.0295, -0.05}) {
    const auto now = respond(law, state, strain);
    const auto truth = respond(linear, expected, strain);
    state = now.state;
    expected = truth.state;
    EXPECT_NEAR(now.stress, truth.stress, 1e-10 * kY);
    EXPECT_NEAR(now.tangent, truth.tangent, 1e-10 * kE);
    EXPECT_NEAR(now.state.plastic, truth.state.plastic, 1e-13);
  }
}

TEST(Multilinear, IsTheSameInEveryLane) {
  const Material material = of_table(0.4);
  const auto law = law_of(material);
  using Lanes = Pack<double, 8>;
  MaterialValues<Lanes> values;
  const auto plain = material_values(material);
  for (std::size_t i = 0; i < plain.size(); ++i) values[i] = constant<Lanes>(plain[i]);
  const auto wide = Multilinear<Lanes>::of(uniaxial_material(UniaxialForm{}, values), values);
  Multilinear<Lanes>::State state;
  Multilinear<double>::State lone[8];
  for (const double strain : {0.001, 0.004, -0.01, 0.02, 0.003}) {
    Lanes strains;
    for (int lane = 0; lane < 8; ++lane) strains.set(lane, strain * (0.1 + 0.7 * lane));
    const auto now = respond(wide, state, strains);
    state = now.state;
    for (int lane = 0; lane < 8; ++lane) {
      const auto expected = respond(law, lone[lane], strain * (0.1 + 0.7 * lane));
      lone[lane] = expected.state;
      EXPECT_EQ(now.stress[lane], expected.stress);
      EXPECT_EQ(now.tangent[lane], expected.tangent);
    }
  }
}

}  // namespace
}  // namespace plastica::law
