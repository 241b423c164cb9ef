#include "plastica/law/fibre.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "plastica/base/dual.hpp"
#include "plastica/base/pack.hpp"
#include "plastica/law/per_axis.hpp"
#include "tests/lib/law/fibre_joint.hpp"
#include "tests/reference/reference_table.hpp"

namespace plastica::law {
namespace {

using plastica::testing::ReferenceTable;
using testing::form_of;
using testing::sees;
using testing::Shaker;
using testing::steel;
using testing::strain_of;
using testing::upright;
using testing::values_of;
using testing::yield_strain;

constexpr FibrePlane kPlanes[] = {FibrePlane::AboutX, FibrePlane::AboutY, FibrePlane::Both,
                                  FibrePlane::Torsion};

Section circle() { return {.shape = SectionShape::Circle}; }
Section round_tube() { return {.shape = SectionShape::RoundTube}; }  // 0.04 in 0.05
Section box() { return {.shape = SectionShape::RectangularTube}; }   // 0.08 in 0.1

template <class S, class Uniaxial>
using Joint = testing::FibreJoint<S, Uniaxial>;
using Ideal = IdealPlastic<double>;

TEST(FibreSection, HasTheExactElasticStiffnessWithAnyNumberOfFibres) {
  const Material material = steel();
  for (const Section& section : {upright(), circle(), round_tube(), box()}) {
    const auto elastic =
        elastic_section(form_of(section, material), material_values(material)).stiffness;
    for (const FibrePlane plane : kPlanes) {
      for (const int fibres : {2, 7, 40}) {
        Joint<double, Ideal> joint(section, material, plane, fibres);
        SectionStrain<double> strain{{1e-3, -2e-3, 1e-3, 1e-5}};
        for (std::size_t i = 0; i < 4; ++i) {
          if (!sees(plane, i)) strain[i] = 0.0;
        }
        const auto now = joint(strain);
        for (std::size_t i = 0; i < 4; ++i) {
          if (!sees(plane, i)) continue;
          EXPECT_NEAR(now.tangent(i, i), elastic[i], 1e-12 * elastic[i]) << i << fibres;
          EXPECT_NEAR(now.force[i], elastic[i] * strain[i], 1e-12 * elastic[i] * 1e-3);
          for (std::size_t j = 0; j < 4; ++j) {
            if (i != j) {
              EXPECT_NEAR(now.tangent(i, j), 0.0, 1e-12 * elastic[3]);
            }
          }
        }
        EXPECT_EQ(now.plastic_work, 0.0);
        EXPECT_NEAR(now.elastic_energy, 0.5 * dot(now.force, strain), 1e-12 * now.elastic_energy);
      }
    }
  }
}

TEST(FibreSection, GivesPositiveMomentsForPositiveCurvatures) {
  // A positive curvature about x pulls the fibres at y > 0, one about y those at x < 0.
  const FibreLayout grid =
      fibre_layout(upright(), section_properties(upright(), 0.3), FibrePlane::Both, 8);
  Joint<double, Ideal> joint(upright(), steel(), FibrePlane::Both, 8);
  const auto now = joint({{0.01, 0.02, 0.0, 0.0}});
  EXPECT_GT(now.force[kBendingX], 0.0);
  EXPECT_GT(now.force[kBendingY], 0.0);
  EXPECT_EQ(grid.across.size(), grid.area.size());
}

/// Largest difference to a column of the table, relative.
double largest_error(const Section& section, FibrePlane plane, int fibres,
                     const std::string& column, bool about_y = false) {
  const ReferenceTable table("elastoplastic-section/moment_curvature.csv");
  const Material material = steel();
  const SectionForm form = form_of(section, material);
  const std::size_t axis = about_y ? kBendingY : kBendingX;
  const double yield = yield_strain(form, material)[axis];
  Joint<double, Ideal> joint(section, material, plane, fibres);
  double worst = 0.0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    SectionStrain<double> strain;
    strain[axis] = table.at("kappa_over_kappa_y", i) * yield;
    const double ratio = joint(strain).force[axis] / (form.modulus[axis] * 300e6);
    worst = std::max(worst, std::fabs(ratio / table.at(column, i) - 1.0));
  }
  return worst;
}

TEST(FibreSection, FollowsTheMomentCurvatureCurveWithFortyFibres) {
  const std::string rectangle = "M_over_My_rectangle_PragerHodge";
  const std::string disc = "M_over_My_solid_circle";
  const std::string tube = "M_over_My_tube_ri_ro_0.8";
  const std::string hollow = "M_over_My_box_inner_0.8x0.8";
  for (const FibrePlane plane : {FibrePlane::AboutX, FibrePlane::Both}) {
    EXPECT_LT(largest_error(upright(), plane, 40, rectangle), 1e-3);
    EXPECT_LT(largest_error(box(), plane, 40, hollow), 1e-3);
  }
  EXPECT_LT(largest_error(upright(), FibrePlane::AboutY, 40, rectangle, true), 1e-3);
  EXPECT_LT(largest_error(circle(), FibrePlane::AboutX, 40, disc), 1e-3);
  EXPECT_LT(largest_error(round_tube(), FibrePlane::AboutX, 40, tube), 1e-3);
  EXPECT_LT(largest_error(circle(), FibrePlane::Both, 40, disc), 1e-3);
  EXPECT_LT(largest_error(round_tube(), FibrePlane::Both, 40, tube), 1e-3);
  EXPECT_LT(largest_error(circle(), FibrePlane::Both, 40, disc, true), 1e-3);
  // Second order: a quarter of the fibres cost a factor of about 16.
  EXPECT_GT(largest_error(upright(), FibrePlane::AboutX, 8, rectangle), 1e-3);
}

void expect_torque_twist(FibrePlane plane, int fibres) {
  const ReferenceTable table("torsion-elastoplastic-circle/torque_twist.csv");
  const Material material = steel();
  const SectionForm form = form_of(circle(), material);
  const double yield = yield_strain(form, material)[kTorsion];
  const double cap = form.modulus[kTorsion] * 150e6;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    Joint<double, Ideal> joint(circle(), material, plane, fibres);
    const double twist = table.at("theta_over_theta_y", i);
    const double torque = joint({{0.0, 0.0, twist * yield, 0.0}}).force[kTorsion];
    EXPECT_NEAR(torque / cap, table.at("T_over_Ty", i), 1e-3 * table.at("T_over_Ty", i));
    const double rest = table.at("residual_theta_over_theta_y_after_unload", i);
    EXPECT_NEAR(joint({{0.0, 0.0, rest * yield, 0.0}}).force[kTorsion] / cap, 0.0, 2e-3) << twist;
  }
}

TEST(FibreSection, FollowsTheTorqueTwistCurveOfACircleAndItsResidualTwist) {
  expect_torque_twist(FibrePlane::Torsion, 40);
  expect_torque_twist(FibrePlane::Both, 80);
}

TEST(FibreSection, KeepsACurvatureAndResidualStressAfterUnloading) {
  const Material material = steel();
  const SectionForm form = form_of(upright(), material);
  const double yield = yield_strain(form, material)[kBendingX];
  const double cap = form.modulus[kBendingX] * 300e6;
  Joint<double, Ideal> joint(upright(), material, FibrePlane::AboutX, 40);
  // At twice the curvature of first yield M = 1.375 M_y; unloading by that leaves 0.625.
  const auto loaded = joint({{2.0 * yield, 0.0, 0.0, 0.0}});
  const auto now = joint({{0.625 * yield, 0.0, 0.0, 0.0}});
  EXPECT_NEAR(now.force[kBendingX] / cap, 0.0, 1e-3);
  EXPECT_EQ(now.plastic_work, 0.0);
  // What stays is the energy of the residual stress, which the unloading did not give back.
  EXPECT_NEAR(loaded.elastic_energy - now.elastic_energy,
              0.5 * loaded.force[kBendingX] * 1.375 * yield, 2e-3 * loaded.elastic_energy);
  EXPECT_GT(now.elastic_energy, 0.01 * loaded.elastic_energy);
}

TEST(FibreSection, IsExactFullyPlastic) {
  const Material material = steel();
  for (const Section& section : {upright(), circle(), round_tube(), box()}) {
    const SectionProperties p = section_properties(section, 0.3);
    for (const FibrePlane plane : {FibrePlane::AboutX, FibrePlane::Both}) {
      Joint<double, Ideal> joint(section, material, plane, 40);
      const double moment = joint({{1e5, 0.0, 0.0, 0.0}}).force[kBendingX];
      const bool polar = plane == FibrePlane::Both && section.radius == 0.05 &&
                         section.shape != SectionShape::Rectangle &&
                         section.shape != SectionShape::RectangularTube;
      // The sum of |sin| over evenly spaced angles is off by 1/sectors^2.
      EXPECT_NEAR(moment / (300e6 * p.plastic_section_modulus_x), 1.0, polar ? 6e-4 : 1e-10);
    }
  }
}

TEST(FibreSection, YieldsUnderBothMomentsAsThePlasticSurfaceOfARectangle) {
  // Curvature along (0.1 kappa_x = 0.05 kappa_y of a 1:2 rectangle) puts the axis on its diagonal:
  // m_x = m_y = 2/3.
  const Material material = steel();
  const SectionProperties p = section_properties(upright(), 0.3);
  Joint<double, Ideal> joint(upright(), material, FibrePlane::Both, 40);
  const auto force = joint({{1e5, 2e5, 0.0, 0.0}}).force;
  EXPECT_NEAR(force[kBendingX] / (300e6 * p.plastic_section_modulus_x), 2.0 / 3.0, 2e-3);
  EXPECT_NEAR(force[kBendingY] / (300e6 * p.plastic_section_modulus_y), 2.0 / 3.0, 2e-3);
}

TEST(FibreSection, YieldsUnderMomentAndTensionTogether) {
  const Material material = steel();
  const SectionProperties p = section_properties(upright(), 0.3);
  Joint<double, Ideal> joint(upright(), material, FibrePlane::AboutX, 40);
  // The axis at a quarter of the depth: n = 1/2, m = 3/4.
  const auto force = joint({{1e5, 0.0, 0.0, 1e5 * 0.025}}).force;
  EXPECT_NEAR(force[kAxial] / (300e6 * p.area), 0.5, 1e-9);
  EXPECT_NEAR(force[kBendingX] / (300e6 * p.plastic_section_modulus_x), 0.75, 1e-9);
}

TEST(FibreSection, AccountsForTheWorkDoneOnIt) {
  const Material material = steel(HardeningLaw::Linear);
  for (const Section& section : {upright(), circle()}) {
    const auto yield = yield_strain(form_of(section, material), material);
    for (const FibrePlane plane : kPlanes) {
      Joint<double, LinearHardening<double>> joint(section, material, plane, 12);
      SectionStrain<double> strain;
      SectionForce<double> force;
      double external = 0.0;
      double plastic = 0.0;
      double elastic = 0.0;
      for (int i = 1; i <= 2000; ++i) {
        const double s = 3.0 * std::sin(4e-3 * i);
        SectionStrain<double> next{
            {s * yield[0], -0.5 * s * yield[1], 0.4 * s * yield[2], 0.2 * s * yield[3]}};
        for (std::size_t k = 0; k < 4; ++k) {
          if (!sees(plane, k)) next[k] = 0.0;
        }
        if (plane == FibrePlane::Torsion) next = 2.5 * next;
        const auto now = joint(next);
        external += 0.5 * dot(force + now.force, next - strain);
        plastic += now.plastic_work;
        elastic = now.elastic_energy;
        strain = next;
        force = now.force;
      }
      EXPECT_NEAR(elastic + plastic, external, 1e-4 * external);
      EXPECT_GT(plastic, 0.5 * elastic);
    }
  }
}

TEST(FibreSection, HasAConsistentTangent) {
  const Material material = steel(HardeningLaw::VoceChaboche);
  const auto yield = yield_strain(form_of(upright(), material), material);
  for (const FibrePlane plane : kPlanes) {
    Joint<double, VoceChaboche<double>> joint(upright(), material, plane, 12);
    Shaker shake(21);
    for (int step = 0; step < 20; ++step) {
      SectionStrain<double> strain;
      for (std::size_t k = 0; k < 4; ++k) {
        strain[k] = sees(plane, k) ? 2.0 * shake() * yield[k] : 0.0;
      }
      const auto start = joint;
      const auto now = joint(strain);
      for (std::size_t j = 0; j < 4; ++j) {
        if (!sees(plane, j)) continue;
        const double h = 1e-7 * yield[j];
        auto copy = start;
        SectionStrain<double> more = strain;
        more[j] += h;
        const auto a = copy(more);
        copy = start;
        more[j] -= 2.0 * h;
        const auto b = copy(more);
        for (std::size_t k = 0; k < 4; ++k) {
          const double scale = yield[j] / (yield[k] * now.tangent(k, k) + 1.0);
          const double slope = (a.force[k] - b.force[k]) / (2.0 * h);
          // A fibre that crosses its yield point within h costs a little.
          EXPECT_NEAR(slope * scale, now.tangent(k, j) * scale, 2e-4) << step << j << k;
        }
      }
    }
  }
}

template <class S, template <class> class Law>
SectionForce<S> force_after(FibrePlane plane, const MaterialValues<S>& values,
                            const Material& material) {
  const auto yield = yield_strain(form_of(upright(), material), material);
  Joint<S, Law<S>> joint(upright(), material, plane, 8, values);
  SectionForce<S> force;
  Shaker shake(22);
  for (int i = 0; i < 6; ++i) {
    std::array<double, 4> strain{};
    for (std::size_t k = 0; k < 4; ++k) {
      strain[k] = sees(plane, k) ? 3.0 * yield[k] * shake() : 0.0;
    }
    force = joint(strain_of<S>(strain)).force;
  }
  return force;
}

template <template <class> class Law>
void expect_same_for_all_scalars() {
  using Lanes = Pack<double, 8>;
  using D = Dual<double, 1>;
  constexpr auto kYield = static_cast<std::size_t>(MaterialField::YieldStress);
  const Material material = steel();
  const SectionForm form = form_of(upright(), material);
  for (const FibrePlane plane : {FibrePlane::AboutX, FibrePlane::Both, FibrePlane::Torsion}) {
    const auto values = material_values(material);
    const auto expected = force_after<double, Law>(plane, values, material);
    const auto lanes = force_after<Lanes, Law>(plane, values_of<Lanes>(material), material);
    const auto single = force_after<float, Law>(plane, values_of<float>(material), material);
    MaterialValues<D> seeded = values_of<D>(material);
    seeded[kYield] = D::parameter(values[kYield], 0);
    const auto dual = force_after<D, Law>(plane, seeded, material);
    const auto moved = [&](double step) {
      MaterialValues<double> other = values;
      other[kYield] += step;
      return force_after<double, Law>(plane, other, material);
    };
    const auto more = moved(1e2);
    const auto less = moved(-1e2);
    for (std::size_t k = 0; k < 4; ++k) {
      const double cap = form.modulus[k] * 300e6;
      EXPECT_EQ(lanes[k][6], expected[k]);
      // The step that gives a dual number its derivative moves the warping by its tolerance.
      EXPECT_NEAR(dual[k].value(), expected[k], plane == FibrePlane::Both ? 1e-9 * cap : 0.0);
      EXPECT_NEAR(dual[k].derivative(0), (more[k] - less[k]) / 2e2, 1e-5 * cap / 300e6);
      EXPECT_NEAR(single[k], expected[k], 1e-3 * cap);
    }
  }
}

TEST(FibreSection, GivesTheSameForEveryScalar) {
  expect_same_for_all_scalars<IdealPlastic>();
  expect_same_for_all_scalars<LinearHardening>();
  expect_same_for_all_scalars<VoceChaboche>();
}

}  // namespace
}  // namespace plastica::law
