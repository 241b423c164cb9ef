#include "plastica/law/rated.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "plastica/base/dual.hpp"
#include "plastica/law/biaxial.hpp"
#include "plastica/law/interaction.hpp"
#include "plastica/law/per_axis.hpp"
#include "tests/lib/law/section_of.hpp"

namespace plastica::law {
namespace {

using testing::form_of;
using testing::Shaker;
using testing::steel;
using testing::upright;

using Table = Rated<Multilinear<double>>;
using Voce = Rated<VoceChaboche<double>>;

/// Mild steel of Cowper and Symonds: C = 40.4/s, P = 5.
Material cowper_symonds(HardeningLaw law = HardeningLaw::Ideal) {
  Material material = steel(law);
  material.rate = {RateLaw::CowperSymonds, 40.4, 5.0, {}, {}};
  return material;
}
Material johnson_cook(HardeningLaw law = HardeningLaw::Ideal) {
  Material material = steel(law);
  material.rate = {RateLaw::JohnsonCook, 1e-2, {}, 0.03, {}};
  return material;
}

template <class Law>
Law law_of(const Material& material, Axis axis = kAxial) {
  MaterialValues<double> values = material_values(material);
  as_table(material.hardening.law, values);
  return Law::of(uniaxial_material(form_of(upright(), material).axis[axis], values), values);
}

double factor_by_hand(const Material& material, double rate) {
  const RateDependence& r = material.rate;
  if (r.law == RateLaw::CowperSymonds) return 1.0 + std::pow(rate / *r.reference_rate, 0.2);
  return rate > *r.reference_rate ? 1.0 + 0.03 * std::log(rate / *r.reference_rate) : 1.0;
}

/// Of any increment in any time, from 1e-12 of the yield strain beyond it to a hundred of it, and
/// from a nanosecond to years.
TEST(Rated, FlowsUntilTheStressIsWhatTheRateCarries) {
  for (const Material& material : {cowper_symonds(), johnson_cook()}) {
    Table law = law_of<Table>(material);
    const double yield = law.yield / law.stiffness;
    for (double beyond = 1e-12; beyond < 200.0; beyond *= 10.0) {
      for (double seconds = 1e-9; seconds < 1e9; seconds *= 10.0) {
        law.set_time(seconds);
        const auto now = respond(law, {}, -yield * (1.0 + beyond));
        const double p = now.state.accumulated;
        ASSERT_GT(p, 0.0) << beyond << " " << seconds;
        EXPECT_NEAR(-now.stress, law.yield * factor_by_hand(material, p / seconds),
                    1e-9 * law.yield)
            << beyond << " " << seconds;
        EXPECT_NEAR(plastic_work(law, {}, now), -now.stress * p, 1e-9 * law.yield * p);
      }
    }
  }
}

TEST(Rated, DoesNotFlowInNoTimeAndAsAtRestInALongOne) {
  Voce law = law_of<Voce>(cowper_symonds(HardeningLaw::VoceChaboche));
  law.set_time(0.0);
  EXPECT_EQ(respond(law, {}, 0.1).stress, 0.1 * law.stiffness);
  law.set_time(std::numeric_limits<double>::infinity());
  const VoceChaboche<double>& at_rest = law;
  EXPECT_NEAR(respond(law, {}, 0.1).stress, respond(at_rest, {}, 0.1).stress, 1e-9 * law.yield);
}

/// A steady test has the stress of its own rate, whatever the increments.
TEST(Rated, HasTheStressOfASteadyRate) {
  for (const Material& material : {cowper_symonds(), johnson_cook()}) {
    for (const double rate : {1e-4, 1.0, 500.0}) {
      Table law = law_of<Table>(material);
      Table::State state;
      const double step = 0.05 * law.yield / law.stiffness;
      law.set_time(step / rate);
      double stress = 0.0;
      for (int i = 1; i <= 2000; ++i) {
        const auto now = respond(law, state, i * step);
        state = now.state;
        stress = now.stress;
      }
      EXPECT_NEAR(stress, law.yield * factor_by_hand(material, rate), 1e-6 * law.yield) << rate;
    }
  }
}

/// Held still, the overstress x over Y falls by x' = -(E C/Y) x^P: x^(1-P) grows evenly.
TEST(Rated, RelaxesAsItsDifferentialEquationSays) {
  const double young = 200e9, yield = 300e6, begins = 0.5, time = 2e-4;
  const double exact = std::pow(std::pow(begins, -4.0) + 4.0 * young * 40.4 / yield * time, -0.25);
  double before = 0.0;
  for (const int steps : {100, 200, 400}) {
    Table law = law_of<Table>(cowper_symonds());
    const double strain = yield * (1.0 + begins) / young;
    law.set_time(time / steps);
    Table::State state;
    double stress = 0.0;
    for (int i = 0; i < steps; ++i) {
      const auto now = respond(law, state, strain);
      state = now.state;
      stress = now.stress;
    }
    const double error = std::fabs((stress / yield - 1.0) / exact - 1.0);
    EXPECT_LT(error, 2.0 / steps);
    if (before > 0.0) {
      EXPECT_NEAR(before / error, 2.0, 0.1);  // of first order
    }
    before = error;
  }
}

/// Equal plastic work: shear stresses are over r, and shear strain rates times r.
TEST(Rated, OfShearHasTheEquivalentRate) {
  const Material material = cowper_symonds();
  Table law = law_of<Table>(material, kTorsion);
  law.set_time(1e-3);
  const auto now = respond(law, {}, 0.02);
  const double r = 2.0;  // 300 MPa over 150 MPa
  EXPECT_NEAR(now.stress, 150e6 * factor_by_hand(material, now.state.accumulated / r / 1e-3),
              1e-9 * law.yield);
}

template <class Law>
void expect_slopes(const Material& material) {
  Law law = law_of<Law>(material);
  law.set_time(1e-3);
  typename Law::State state;
  Shaker shake(5);
  for (int i = 0; i < 50; ++i) {
    const double strain = 4.0 * shake() * law.yield / law.stiffness;
    const auto now = respond(law, state, strain);
    const double h = 1e-7 * law.yield / law.stiffness;
    const double slope =
        (respond(law, state, strain + h).stress - respond(law, state, strain - h).stress) /
        (2.0 * h);
    EXPECT_NEAR(now.tangent, slope, 2e-6 * law.stiffness);
    state = now.state;
  }
}

TEST(Rated, HasTheTangentOfItsStress) {
  for (const HardeningLaw law : {HardeningLaw::Ideal, HardeningLaw::Linear}) {
    expect_slopes<Table>(cowper_symonds(law));
    expect_slopes<Table>(johnson_cook(law));
  }
  expect_slopes<Voce>(cowper_symonds(HardeningLaw::VoceChaboche));
  expect_slopes<Voce>(johnson_cook(HardeningLaw::VoceChaboche));
}

/// Ideal plasticity and linear hardening as tables: the laws that they stand for.
TEST(Rated, TablesStandForIdealPlasticityAndLinearHardening) {
  const auto expect_same = [](auto tag, HardeningLaw hardening) {
    using Law = typename decltype(tag)::type;
    const Material material = steel(hardening);
    const MaterialValues<double> values = material_values(material);
    const auto point = uniaxial_material(UniaxialForm{}, values);
    const Law law = Law::of(point, values);
    MaterialValues<double> table_values = values;
    EXPECT_EQ(as_table(hardening, table_values), HardeningLaw::Multilinear);
    const auto table = Multilinear<double>::of(point, table_values);
    typename Law::State state;
    Multilinear<double>::State table_state;
    Shaker shake(9);
    for (int i = 0; i < 60; ++i) {
      const double strain = 10.0 * shake() * law.yield / law.stiffness;
      const auto truth = respond(law, state, strain);
      const auto now = respond(table, table_state, strain);
      EXPECT_NEAR(now.stress, truth.stress, 1e-9 * law.yield);
      state = truth.state;
      table_state = now.state;
    }
  };
  expect_same(std::type_identity<IdealPlastic<double>>{}, HardeningLaw::Ideal);
  expect_same(std::type_identity<LinearHardening<double>>{}, HardeningLaw::Linear);
}

/// One stress alone is the uniaxial law, under one surface and in a fibre.
template <class Law>
void expect_uniaxial(const Material& material) {
  MaterialValues<double> values = material_values(material);
  as_table(material.hardening.law, values);
  const SectionForm form = form_of(upright(), material);
  auto axes = per_axis_section<Law>(form, values);
  const FirstYieldGauge<double, 1, false> gauge{{1.0}, {1.0}, {1.0}};
  auto surface = interaction_section<Law>(form, gauge, values);
  const auto take_time = [](auto& law) { law.set_time(2e-3); };
  axes.each_uniaxial(take_time);
  surface.each_uniaxial(take_time);
  for (std::size_t k = 0; k < kSectionAxes; ++k) {
    typename decltype(axes)::State alone;
    typename decltype(surface)::State together;
    Shaker shake(31);
    for (int i = 0; i < 30; ++i) {
      SectionStrain<double> strain;
      strain[k] = 4.0 * shake() * axes.axis[k].yield / axes.axis[k].stiffness / form.lever[k];
      const auto truth = respond(axes, alone, alone, strain);
      const auto now = respond(surface, together, together, strain);
      EXPECT_NEAR(now.force[k], truth.force[k], 1e-8 * surface.cap[k]);
      EXPECT_NEAR(now.tangent(k, k), truth.tangent(k, k), 1e-6 * surface.stiffness[k]);
    }
  }
}

/// Also where the rate lets less through than rounding of the strain.
TEST(Rated, OnASurfaceBeginsToFlowAsTheUniaxialLaw) {
  const Material material = cowper_symonds();
  MaterialValues<double> values = material_values(material);
  as_table(material.hardening.law, values);
  const SectionForm form = form_of(upright(), material);
  auto axes = per_axis_section<Table>(form, values);
  auto surface = interaction_section<Table>(
      form, FirstYieldGauge<double, 1, false>{{1.0}, {1.0}, {1.0}}, values);
  for (double seconds = 1e-9; seconds < 1e3; seconds *= 10.0) {
    const auto take_time = [&](auto& law) { law.set_time(seconds); };
    axes.each_uniaxial(take_time);
    surface.each_uniaxial(take_time);
    for (double beyond = 1e-10; beyond < 100.0; beyond *= 3.0) {
      SectionStrain<double> strain;
      strain[kBendingX] = (1.0 + beyond) * axes.axis[kBendingX].yield /
                          axes.axis[kBendingX].stiffness / form.lever[kBendingX];
      typename decltype(axes)::State alone;
      typename decltype(surface)::State together;
      const auto truth = respond(axes, {}, alone, strain);
      const auto now = respond(surface, {}, together, strain);
      EXPECT_NEAR(now.force[kBendingX] / truth.force[kBendingX], 1.0, 1e-10) << beyond;
      EXPECT_NEAR(now.tangent(0, 0), truth.tangent(0, 0), 1e-5 * surface.stiffness[0])
          << seconds << " " << beyond;
    }
  }
}

TEST(Rated, IsTheUniaxialLawWhereOneForceActs) {
  expect_uniaxial<Table>(cowper_symonds());
  expect_uniaxial<Table>(johnson_cook(HardeningLaw::Linear));
  expect_uniaxial<Voce>(cowper_symonds(HardeningLaw::VoceChaboche));
}

TEST(Rated, OfAFibreIsTheUniaxialLawOfEachStress) {
  const Material material = cowper_symonds();
  MaterialValues<double> values = material_values(material);
  as_table(material.hardening.law, values);
  const SectionForm form = form_of(upright(), material);
  const auto normal = uniaxial_material(form.axis[kAxial], values);
  const auto shear = uniaxial_material(form.axis[kTorsion], values);
  auto fibre = biaxial_law<Table>(normal, shear, values);
  fibre.normal.set_time(1e-3);
  for (const std::size_t along : {0U, 1U}) {
    Table alone = Table::of(along == 0 ? normal : shear, values);
    alone.set_time(1e-3);
    typename Biaxial<double, Table>::State state;
    Table::State expected;
    Shaker shake(13);
    for (int i = 0; i < 40; ++i) {
      Vec<double, 2> strain;
      strain[along] = 6.0 * shake() * alone.yield / alone.stiffness;
      const auto now = respond(fibre, state, strain);
      const auto truth = respond(alone, expected, strain[along]);
      EXPECT_NEAR(now.stress[along], truth.stress, 1e-8 * alone.yield);
      EXPECT_NEAR(now.tangent(along, along), truth.tangent, 1e-6 * alone.stiffness);
      state = now.state;
      expected = truth.state;
    }
  }
}

/// A rate that all has is a material whose yield stress, and its growth, are so much larger.
TEST(GivenRate, RaisesTheYieldStressAndItsGrowth) {
  for (const HardeningLaw hardening : {HardeningLaw::Ideal, HardeningLaw::Linear,
                                       HardeningLaw::VoceChaboche, HardeningLaw::Multilinear}) {
    for (Material material : {cowper_symonds(hardening), johnson_cook(hardening)}) {
      material.hardening.kinematic_fraction = 0.0;
      material.rate.strain_rate = 7.0;
      const double factor = factor_by_hand(material, 7.0);
      Material raised = steel(hardening);
      Hardening& h = raised.hardening;
      h.kinematic_fraction = 0.0;
      raised.yield_stress *= factor;
      *raised.shear_yield_stress *= factor;
      h.saturation_stress *= factor;
      const double modulus = factor * plastic_modulus(200e9, h.tangent_modulus);
      h.tangent_modulus = 200e9 * modulus / (200e9 + modulus);
      for (double& stress : h.flow_stress) stress *= factor;
      for (const Axis axis : {kBendingX, kTorsion, kAxial}) {
        const auto values = material_values(material);
        const auto raised_values = material_values(raised);
        with_law_type<double>(hardening, [&]<class Law>(std::type_identity<Law>) {
          const Law law =
              Law::of(uniaxial_material(form_of(upright(), material).axis[axis], values), values);
          const Law truth =
              Law::of(uniaxial_material(form_of(upright(), raised).axis[axis], raised_values),
                      raised_values);
          for (const double strain : {0.001, 0.004, 0.03, 0.2}) {
            EXPECT_NEAR(respond(law, {}, strain).stress, respond(truth, {}, strain).stress,
                        1e-9 * law.yield);
          }
        });
      }
    }
  }
}

/// Derivatives by the parameters of a rate law, against the closed form.
TEST(GivenRate, HasDerivativesByItsParameters) {
  using D = Dual<double, 3>;
  Material material = cowper_symonds();
  material.rate.strain_rate = 7.0;
  auto values = testing::values_of<D>(material);
  const auto free = [&](MaterialField field, std::size_t k) {
    auto& value = values[static_cast<std::size_t>(field)];
    value = D::parameter(value.value(), k);
  };
  free(MaterialField::ReferenceRate, 0);
  free(MaterialField::RateExponent, 1);
  UniaxialForm form{.rate = RateLaw::CowperSymonds, .strain_rate = 7.0};
  const D yield = uniaxial_material(form, values).yield;
  const double power = std::pow(7.0 / 40.4, 0.2);
  EXPECT_NEAR(yield.value(), 300e6 * (1.0 + power), 1.0);
  EXPECT_NEAR(yield.derivative(0), -300e6 * power * 0.2 / 40.4, 1e-3);
  EXPECT_NEAR(yield.derivative(1), -300e6 * power * std::log(7.0 / 40.4) / 25.0, 1e-3);
  form.rate = RateLaw::JohnsonCook;
  values = testing::values_of<D>(johnson_cook());
  free(MaterialField::RateCoefficient, 2);
  EXPECT_NEAR(uniaxial_material(form, values).yield.derivative(2), 300e6 * std::log(7.0 / 1e-2),
              1e-3);
}

}  // namespace
}  // namespace plastica::law
