#include "plastica/law/axial_control.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "plastica/base/dual.hpp"
#include "plastica/base/pack.hpp"
#include "plastica/law/fibre.hpp"
#include "plastica/law/interaction.hpp"
#include "tests/lib/law/section_of.hpp"

namespace plastica::law {
namespace {

using testing::form_of;
using testing::steel;
using testing::upright;
using testing::values_of;

/// A law with its committed state, driven by curvatures and an axial force.
template <class S, class Law>
struct Driven {
  Law law;
  S stiffness, yield;
  typename Law::State state{};
  AxialState<S> axial{};

  ForcedResponse<S> at(const SectionStrain<S>& strain, const S& force) {
    const auto found =
        respond_to_force([&](const SectionStrain<S>& e) { return respond(law, state, after, e); },
                         strain, force, axial, stiffness, yield);
    return found;
  }
  void commit(const ForcedResponse<S>& found) {
    state = after;
    axial = found.after;
  }
  typename Law::State after{};
};

template <class S, class Uniaxial>
auto plastic_rectangle(HardeningLaw hardening) {
  const Material material = steel(hardening);
  const SectionForm form = form_of(upright(), material, YieldCap::FullyPlastic);
  const auto law =
      interaction_section<Uniaxial>(form, PlasticGauge<S>{constant<S>(1)}, values_of<S>(material));
  return Driven<S, std::remove_cvref_t<decltype(law)>>{law, law.stiffness[kAxial], law.cap[kAxial]};
}

constexpr double kForces[] = {0.0, 0.05, 0.3, -0.6, 0.95, -0.99};

/// Far beyond yield an ideal rectangle has m = 1 - n^2, and goes back to it from the other side.
TEST(AxialControl, GivesTheMomentThatIsLeftOfARectangle) {
  for (const double n : kForces) {
    auto driven = plastic_rectangle<double, IdealPlastic<double>>(HardeningLaw::Ideal);
    const double cap = driven.law.cap[kBendingX];
    const double yields = cap / driven.law.stiffness[kBendingX];
    for (const double times : {3.0, 20.0, -30.0, 2.0}) {
      const auto found = driven.at({{times * yields, 0.0, 0.0, 0.0}}, n * driven.yield);
      EXPECT_TRUE(found.carries);
      EXPECT_NEAR(found.section.force[kAxial], n * driven.yield, 1e-12 * driven.yield);
      const double sense = times == 3.0 || times == 20.0 || times == 2.0 ? 1.0 : -1.0;
      EXPECT_NEAR(found.section.force[kBendingX] / cap, sense * (1.0 - n * n), 1e-10) << n;
      // So dm/dN = -2 n M_p/N_p, and no curvature changes it.
      EXPECT_NEAR(found.by_force[kBendingX] * driven.yield / cap, -sense * 2.0 * n, 1e-6) << n;
      EXPECT_NEAR(found.section.tangent(kBendingX, kBendingX) / driven.law.stiffness[kBendingX],
                  0.0, 1e-6);
      driven.commit(found);
    }
  }
}

/// At first yield |m| + |n| = 1 has a corner at n = 0, where N rests while the section flows: far
/// beyond it a force that is nearly none is carried all the same, m = 1 - |n|.
TEST(AxialControl, FindsALittleForceBesideACorner) {
  using Corner = FirstYieldGauge<double, 1, false>;
  const Material material = steel(HardeningLaw::Ideal);
  const SectionForm form = form_of(upright(), material, YieldCap::FirstYield);
  const auto law = interaction_section<IdealPlastic<double>>(form, Corner{{1.0}, {1.0}, {0.0}},
                                                             values_of<double>(material));
  for (const double times : {1.01, 30.0, 300.0}) {
    for (const double n : {1e-12, 1e-10, -1e-9, 1e-6, 1e-3}) {
      Driven<double, std::remove_cvref_t<decltype(law)>> driven{law, law.stiffness[kAxial],
                                                                law.cap[kAxial]};
      const double cap = law.cap[kBendingX];
      const double curvature = times * cap / law.stiffness[kBendingX];
      const auto found = driven.at({{curvature, 0.0, 0.0, 0.0}}, n * driven.yield);
      EXPECT_TRUE(found.carries) << times << ' ' << n;
      // What rounding of so large a strain leaves of a force.
      const double rounding = 1e-12 + 1e-15 * times;
      EXPECT_NEAR(found.section.force[kAxial] / driven.yield, n, rounding) << times << ' ' << n;
      EXPECT_NEAR(found.section.force[kBendingX] / cap, 1.0 - std::fabs(n), rounding)
          << times << ' ' << n;
    }
  }
}

/// Elastic: N is not seen, and costs nothing.
TEST(AxialControl, LeavesAnElasticSectionAlone) {
  auto driven = plastic_rectangle<double, IdealPlastic<double>>(HardeningLaw::Ideal);
  const double k = 0.3 * driven.law.cap[kBendingX] / driven.law.stiffness[kBendingX];
  const auto found = driven.at({{k, 0.0, 0.0, 0.0}}, 0.4 * driven.yield);
  EXPECT_DOUBLE_EQ(found.section.force[kBendingX], driven.law.stiffness[kBendingX] * k);
  EXPECT_EQ(found.by_force[kBendingX], 0.0);
  EXPECT_EQ(found.section.plastic_work, 0.0);
  EXPECT_NEAR(found.section.elastic_energy, 0.5 * driven.law.stiffness[kBendingX] * k * k,
              1e-12 * driven.law.stiffness[kBendingX] * k * k);
}

/// What is put in by the moments is stored or dissipated: N does no work on what is not shown. By
/// small steps, as the sum of trapezoids is the work up to their square.
template <class Driver>
void expect_energy_of_bending(Driver& driven, double stored_before) {
  const double yields = driven.law.cap[kBendingX] / driven.law.stiffness[kBendingX];
  double work = 0.0;
  double plastic = 0.0;
  double stored = stored_before;
  SectionStrain<double> before{};
  SectionForce<double> force_before{};
  constexpr int kSteps = 1000;
  for (int i = 1; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    const SectionStrain<double> strain{
        {4.0 * yields * std::sin(3.0 * t), 2.0 * yields * t * t, 0.0, 0.0}};
    const auto found = driven.at(strain, 0.7 * std::sin(2.0 * t) * driven.yield);
    for (std::size_t k = 0; k < kAxial; ++k) {
      work += 0.5 * (found.section.force[k] + force_before[k]) * (strain[k] - before[k]);
    }
    plastic += found.section.plastic_work;
    stored = found.section.elastic_energy;
    before = strain;
    force_before = found.section.force;
    driven.commit(found);
  }
  EXPECT_GT(plastic, 0.5 * stored);
  EXPECT_NEAR((stored + plastic - stored_before) / work, 1.0, 2e-4);
}

TEST(AxialControl, AccountsForTheEnergyOfBending) {
  auto ideal = plastic_rectangle<double, IdealPlastic<double>>(HardeningLaw::Ideal);
  expect_energy_of_bending(ideal, 0.0);
  auto linear = plastic_rectangle<double, LinearHardening<double>>(HardeningLaw::Linear);
  expect_energy_of_bending(linear, 0.0);
}

/// d(moment) by curvatures and N against difference quotients, with derivatives of dual numbers.
TEST(AxialControl, HasTheConsistentTangent) {
  using D = Dual<double, 1>;
  const auto driver = plastic_rectangle<double, VoceChaboche<double>>(HardeningLaw::VoceChaboche);
  const auto dual = plastic_rectangle<D, VoceChaboche<D>>(HardeningLaw::VoceChaboche);
  const double x = driver.law.cap[kBendingX] / driver.law.stiffness[kBendingX];
  const double y = driver.law.cap[kBendingY] / driver.law.stiffness[kBendingY];
  const double t = driver.law.cap[kTorsion] / driver.law.stiffness[kTorsion];
  const SectionStrain<double> strain{{2.0 * x, -0.7 * y, 0.5 * t, 0.0}};
  const double force = 0.5 * driver.yield;
  const auto force_at = [&](std::size_t moved, double by) {
    auto fresh = driver;
    SectionStrain<double> at = strain;
    if (moved < kAxial) at[moved] += by;
    return fresh.at(at, force + (moved == kAxial ? by : 0.0)).section.force;
  };
  auto fresh = driver;
  const auto found = fresh.at(strain, force);
  for (std::size_t j = 0; j < kSectionAxes; ++j) {
    const double unit = j == kAxial ? driver.yield : std::array{x, y, t}[j];
    const double h = 1e-5 * unit;
    const auto ahead = force_at(j, h);
    const auto behind = force_at(j, -h);
    auto of_dual = dual;
    SectionStrain<D> at;
    for (std::size_t k = 0; k < kAxial; ++k) {
      at[k] = k == j ? D::parameter(strain[k], 0) : constant<D>(strain[k]);
    }
    const D pull = j == kAxial ? D::parameter(force, 0) : constant<D>(force);
    const auto derived = of_dual.at(at, pull);
    for (std::size_t i = 0; i < kAxial; ++i) {
      const double slope = j == kAxial ? found.by_force[i] : found.section.tangent(i, j);
      const double scale = driver.law.cap[i] / unit;
      EXPECT_NEAR((ahead[i] - behind[i]) / (2.0 * h) / scale, slope / scale, 2e-6) << i << j;
      EXPECT_NEAR(derived.section.force[i].derivative(0) / scale, slope / scale, 1e-7) << i << j;
    }
  }
}

/// From N_p on there is no axial strain; nearly all of N_p acts, and the lane says so. Its
/// neighbours do not notice.
TEST(AxialControl, SaysWhereNoStrainCarriesTheForce) {
  using Lanes = Pack<double, 8>;
  auto lanes = plastic_rectangle<Lanes, IdealPlastic<Lanes>>(HardeningLaw::Ideal);
  auto alone = plastic_rectangle<double, IdealPlastic<double>>(HardeningLaw::Ideal);
  const double k = 2.0 * alone.law.cap[kBendingX] / alone.law.stiffness[kBendingX];
  // What becomes of just all of it is for rounding to say.
  const double n[] = {0.0, 0.2, 1.001, -0.7, -1.0 - 1e-9, 10.0, 0.999, -0.05};
  Lanes force;
  for (int lane = 0; lane < 8; ++lane) force.set(lane, n[lane] * alone.yield);
  const auto found = lanes.at({{Lanes(k), Lanes(0.0), Lanes(0.0), Lanes(0.0)}}, force);
  for (int lane = 0; lane < 8; ++lane) {
    auto one = alone;
    const auto expected = one.at({{k, 0.0, 0.0, 0.0}}, n[lane] * alone.yield);
    EXPECT_EQ(expected.carries, std::fabs(n[lane]) < 1.0) << n[lane];
    EXPECT_NEAR(found.section.force[kBendingX][lane], expected.section.force[kBendingX],
                1e-9 * alone.law.cap[kBendingX]);
    EXPECT_NEAR(found.section.force[kAxial][lane] / alone.yield,
                expected.carries ? n[lane] : std::copysign(0.999, n[lane]), 1e-11);
  }
}

/// Fibres: fully plastic moments beside N of a rectangle, and of a section that was bent before.
TEST(AxialControl, OfFibresGivesTheMomentThatIsLeft) {
  const Material material = steel();
  const SectionForm form = form_of(upright(), material);
  const FibreLayout layout =
      fibre_layout(upright(), section_properties(upright(), 0.3), FibrePlane::AboutX, 40);
  const auto law = fibre_section<IdealPlastic<double>>(layout, form, values_of<double>(material));
  const SectionProperties p = section_properties(upright(), 0.3);
  const double yield = material.yield_stress * p.area;
  const double plastic = material.yield_stress * p.plastic_section_modulus_x;
  using State = IdealPlastic<double>::State;
  for (const double n : kForces) {
    std::vector<State> before(layout.states()), after(layout.states());
    AxialState<double> axial;
    for (const double k : {1.5, -2.0, 3.0}) {  // the edge at 50 times its yield strain and more
      const auto found = respond_to_force(
          [&](const SectionStrain<double>& e) {
            return respond(law, before.data(), after.data(), e);
          },
          SectionStrain<double>{{k, 0.0, 0.0, 0.0}}, n * yield, axial,
          material.youngs_modulus * p.area, yield);
      EXPECT_TRUE(found.carries);
      EXPECT_NEAR(found.section.force[kAxial], n * yield, 1e-12 * yield);
      // Half of one of the outer twentieths of the depth has one stress; of 1 - n^2 that is less
      // than 1 % up to n = 0.95.
      const double exact = plastic * (1.0 - n * n);
      if (std::fabs(n) < 0.96) {
        EXPECT_NEAR(found.section.force[kBendingX] / exact, k > 0.0 ? 1.0 : -1.0, 0.01) << n;
      }
      before = after;
      axial = found.after;
    }
  }
}

}  // namespace
}  // namespace plastica::law
