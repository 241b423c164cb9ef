#include "plastica/law/per_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plastica/base/dual.hpp"
#include "plastica/base/pack.hpp"
#include "tests/lib/law/section_of.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica::law {
namespace {

using testing::form_of;
using testing::Shaker;
using testing::steel;
using testing::strain_of;
using testing::upright;
using testing::values_of;
using testing::yield_strain;

constexpr HardeningLaw kLaws[] = {HardeningLaw::Ideal, HardeningLaw::Linear,
                                  HardeningLaw::VoceChaboche, HardeningLaw::Multilinear};

/// Calls `test(law type)` for each uniaxial law on a scalar.
template <class S, class Test>
void for_each_law(const Test& test) {
  for (const HardeningLaw law : kLaws) with_law_type<S>(law, test);
}

TEST(PerAxisSection, ReproducesTheCouponComponentByComponent) {
  const Material material = steel();
  const SectionProperties p = section_properties(upright(), 0.3);
  const SectionForm form = form_of(upright(), material);
  for_each_law<double>([&]<class Law>(std::type_identity<Law>) {
    const auto section = per_axis_section<Law>(form, material_values(material));
    typename PerAxisSection<double, Law>::State state;
    const double levers[] = {0.05, 0.025, p.torsion_constant / p.torsion_modulus, 1.0};
    const double moduli[] = {p.section_modulus_x, p.section_modulus_y, p.torsion_modulus, p.area};
    typename Law::State fibre[4];
    for (const double size : {0.5, 4.0, 2.0, -3.0}) {
      SectionStrain<double> strain;
      const auto yield = yield_strain(form, material);
      for (std::size_t i = 0; i < 4; ++i)
        strain[i] = size * (1.0 + 0.1 * static_cast<double>(i)) * yield[i];
      const auto now = respond(section, state, state, strain);
      for (std::size_t i = 0; i < 4; ++i) {
        const auto alone = respond(section.axis[i], fibre[i], levers[i] * strain[i]);
        EXPECT_NEAR(now.force[i], moduli[i] * alone.stress, 1e-13 * moduli[i] * 300e6);
        EXPECT_NEAR(now.tangent(i, i), moduli[i] * levers[i] * alone.tangent,
                    1e-13 * moduli[i] * levers[i] * 200e9);
        fibre[i] = alone.state;
      }
      EXPECT_EQ(now.tangent(0, 1), 0.0);
    }
  });
}

TEST(PerAxisSection, HasTheStiffnessOfTheSectionBeforeItYields) {
  const Material material = steel();
  const SectionProperties p = section_properties(upright(), 0.3);
  const auto section = per_axis_section<IdealPlastic<double>>(form_of(upright(), material),
                                                              material_values(material));
  PerAxisSection<double, IdealPlastic<double>>::State state;
  const auto now = respond(section, state, state, {{1e-3, 2e-3, 3e-3, 1e-4}});
  const double expected[] = {200e9 * p.second_moment_x, 200e9 * p.second_moment_y,
                             70e9 * p.torsion_constant, 200e9 * p.area};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(now.tangent(i, i), expected[i], 1e-14 * expected[i]);
  }
  EXPECT_EQ(now.plastic_work, 0.0);
  const auto elastic = elastic_section(form_of(upright(), material), material_values(material));
  ElasticSection<double>::State none;
  const auto same = respond(elastic, none, none, {{1e-3, 2e-3, 3e-3, 1e-4}});
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(same.force[i], now.force[i], 1e-14 * std::fabs(now.force[i]));
  }
  EXPECT_NEAR(same.elastic_energy, now.elastic_energy, 1e-14 * now.elastic_energy);
}

TEST(PerAxisSection, CapsAtFirstYieldOrFullyPlastic) {
  const Material material = steel();
  const SectionProperties p = section_properties(upright(), 0.3);
  const auto force_of = [&](YieldCap cap, Formulas formulas) {
    const auto section = per_axis_section<IdealPlastic<double>>(
        form_of(upright(), material, cap, formulas), material_values(material));
    PerAxisSection<double, IdealPlastic<double>>::State state;
    return respond(section, state, state, {{10.0, 10.0, 10.0, 1.0}}).force;
  };
  const auto first = force_of(YieldCap::FirstYield, Formulas::Mechanics);
  EXPECT_NEAR(first[kBendingX], 300e6 * p.section_modulus_x, 1e-6);
  EXPECT_NEAR(first[kBendingY], 300e6 * p.section_modulus_y, 1e-6);
  EXPECT_NEAR(first[kTorsion], 150e6 * p.torsion_modulus, 1e-6);
  EXPECT_NEAR(first[kAxial], 300e6 * p.area, 1e-3);
  const auto plastic = force_of(YieldCap::FullyPlastic, Formulas::Mechanics);
  EXPECT_NEAR(plastic[kBendingX], 300e6 * p.plastic_section_modulus_x, 1e-6);
  EXPECT_NEAR(plastic[kBendingY], 300e6 * p.plastic_section_modulus_y, 1e-6);
  EXPECT_NEAR(plastic[kTorsion], 150e6 * p.plastic_torsion_modulus, 1e-6);
  EXPECT_NEAR(plastic[kAxial], 300e6 * p.area, 1e-3);
  // Wendelius' (4), (5), (6).
  const auto report = force_of(YieldCap::FirstYield, Formulas::Report);
  EXPECT_NEAR(report[kBendingX], 300e6 * p.second_moment_x / 0.05, 1e-6);
  EXPECT_NEAR(report[kBendingY], 300e6 * p.second_moment_y / 0.1, 1e-6);
  EXPECT_NEAR(report[kTorsion], 150e6 * 0.05 * 0.05 * 0.1 * 0.1 / (0.3 + 1.8 * 0.05), 1e-6);
}

TEST(PerAxisSection, AccountsForTheWorkDoneOnIt) {
  const Material material = steel();
  const SectionForm form = form_of(upright(), material);
  const auto yield = yield_strain(form, material);
  for_each_law<double>([&]<class Law>(std::type_identity<Law>) {
    const auto section = per_axis_section<Law>(form, material_values(material));
    typename PerAxisSection<double, Law>::State state;
    SectionStrain<double> strain;
    SectionForce<double> force;
    double external = 0.0;
    double plastic = 0.0;
    double elastic = 0.0;
    // A path of many short steps, whose work a trapezoid gives.
    for (int i = 1; i <= (plastica::testing::kSanitized ? 8000 : 20000); ++i) {
      const double s = 4.0 * std::sin(3e-4 * i);
      const SectionStrain<double> next{{s * yield[0], -s * yield[1], s * s * yield[2], 0.0}};
      const auto now = respond(section, state, state, next);
      external += 0.5 * dot(force + now.force, next - strain);
      plastic += now.plastic_work;
      elastic = now.elastic_energy;
      strain = next;
      force = now.force;
    }
    EXPECT_NEAR(elastic + plastic, external, 1e-6 * external);
    EXPECT_GT(plastic, elastic);
  });
}

/// Force at the end of a path that yields to and fro.
template <class S, template <class> class Law>
SectionForce<S> force_after(const MaterialValues<S>& values, const SectionForm& form,
                            const std::array<double, 4>& yield) {
  const auto section = per_axis_section<Law<S>>(form, values);
  typename PerAxisSection<S, Law<S>>::State state;
  SectionForce<S> force;
  Shaker shake(7);
  for (int i = 0; i < 8; ++i) {
    std::array<double, 4> strain{};
    for (std::size_t k = 0; k < 4; ++k) strain[k] = 5.0 * yield[k] * shake();
    force = respond(section, state, state, strain_of<S>(strain)).force;
  }
  return force;
}

template <template <class> class Law>
void expect_same_for_all_scalars() {
  using Lanes = Pack<double, 8>;
  using D = Dual<double, 1>;
  const Material material = steel();
  const SectionForm form = form_of(upright(), material);
  const auto yield = yield_strain(form, material);
  const auto expected = force_after<double, Law>(values_of<double>(material), form, yield);
  const auto lanes = force_after<Lanes, Law>(values_of<Lanes>(material), form, yield);
  const auto single = force_after<float, Law>(values_of<float>(material), form, yield);
  MaterialValues<D> values = values_of<D>(material);
  constexpr auto kYieldStress = static_cast<std::size_t>(MaterialField::YieldStress);
  values[kYieldStress] = D::parameter(values[kYieldStress].value(), 0);
  const auto dual = force_after<D, Law>(values, form, yield);
  const auto moved = [&](double step) {
    MaterialValues<double> other = values_of<double>(material);
    other[kYieldStress] += step;
    return force_after<double, Law>(other, form, yield);
  };
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(lanes[i][3], expected[i]);
    EXPECT_EQ(dual[i].value(), expected[i]);
    EXPECT_NEAR(static_cast<double>(single[i]), expected[i], 1e-3 * std::fabs(expected[i]));
    const double slope = (moved(1e2)[i] - moved(-1e2)[i]) / 2e2;
    EXPECT_NEAR(dual[i].derivative(0), slope, 1e-5 * std::fabs(expected[i]) / 300e6);
  }
}

TEST(PerAxisSection, GivesTheSameForEveryScalar) {
  expect_same_for_all_scalars<IdealPlastic>();
  expect_same_for_all_scalars<LinearHardening>();
  expect_same_for_all_scalars<VoceChaboche>();
}

}  // namespace
}  // namespace plastica::law
