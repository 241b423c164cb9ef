#include <gtest/gtest.h>

#include <cmath>

#include "plastica/law/fibre_layout.hpp"
#include "plastica/law/gauge_form.hpp"
#include "plastica/model/profile_table.hpp"
#include "tests/lib/law/gauge_of.hpp"
#include "tests/support/axial_limit.hpp"

// I-sections cut into fibres, and their yield surfaces, against sums over strips.

namespace plastica::law {
namespace {

const Section& profile() { return named_profile("IPE 240"); }

TEST(ISectionFibres, KeepAreaAndMomentsWhateverTheirNumber) {
  const Section& s = profile();
  const SectionProperties p = section_properties(s, 0.3);
  for (const int fibres : {4, 8, 20, 50}) {
    for (const FibrePlane plane : {FibrePlane::AboutX, FibrePlane::AboutY, FibrePlane::Both}) {
      const FibreLayout layout = fibre_layout(s, p, plane, fibres);
      double area = 0.0, first = 0.0, second = 0.0, plastic = 0.0, across = 0.0;
      for (std::size_t i = 0; i < layout.area.size(); ++i) {
        area += layout.area[i];
        first += layout.area[i] * layout.depth[i];
        second += layout.area[i] * layout.depth[i] * layout.depth[i];
        plastic += layout.area[i] * std::fabs(layout.depth[i]);
        if (plane == FibrePlane::Both) {
          across += layout.area[i] * layout.across[i] * layout.across[i];
        }
      }
      const bool about_y = plane == FibrePlane::AboutY;
      EXPECT_NEAR(area / p.area, 1.0, 1e-12);
      EXPECT_NEAR(first, 0.0, 1e-15);
      EXPECT_NEAR(second / (about_y ? p.second_moment_y : p.second_moment_x), 1.0, 1e-12);
      EXPECT_NEAR(plastic / (about_y ? p.plastic_section_modulus_y : p.plastic_section_modulus_x),
                  1.0, 1e-12);
      if (plane == FibrePlane::Both) {
        EXPECT_NEAR(across / p.second_moment_y, 1.0, 1e-12);
      }
    }
  }
}

TEST(ISectionFibres, TwistWithTheSectionsStiffnessAndStrength) {
  const Section& s = profile();
  const SectionProperties p = section_properties(s, 0.3);
  for (const FibrePlane plane : {FibrePlane::Torsion, FibrePlane::Both}) {
    const FibreLayout layout = fibre_layout(s, p, plane, 20);
    double stiffness = 0.0, strength = 0.0, longest = 0.0;
    for (std::size_t i = 0; i < layout.area.size(); ++i) {
      stiffness += layout.area[i] * layout.lever[i] * layout.lever[i];
      strength += layout.area[i] * layout.lever[i];
      longest = std::max(longest, layout.lever[i]);
    }
    EXPECT_NEAR(stiffness / p.torsion_constant, 1.0, 1e-9);
    EXPECT_NEAR(strength / p.plastic_torsion_modulus, 1.0, 1e-9);
    EXPECT_LE(longest, p.torsion_constant / p.torsion_modulus * (1.0 + 1e-12));
  }
}

TEST(ISectionSurface, InAPlaneIsTheSectionsWithAxialForce) {
  for (const char* name : {"IPE 240", "HEA 200", "HEB 600"}) {
    const Section& s = named_profile(name);
    for (const bool about_x : {true, false}) {
      const GaugeForm form =
          gauge_form(s, YieldModel::Interaction, YieldCap::FullyPlastic, Formulas::Mechanics,
                     about_x ? GaugePlane::AboutX : GaugePlane::AboutY);
      for (double n = 0.0; n < 0.96; n += 0.05) {
        const double m = plastica::testing::plastic_moment_left(s, n, about_x);
        SectionForce<double> z{};
        z[about_x ? kBendingX : kBendingY] = m;
        z[kAxial] = n;
        // Along the ray of the surface.
        EXPECT_NEAR(testing::gauge_at(form, z), 1.0, 0.02) << name << ' ' << about_x << ' ' << n;
      }
    }
  }
}

/// In both moments an I-section yields where m_x^2 + m_y = 1 (web and flanges apart): nowhere may
/// the surface be outside of that.
TEST(ISectionSurface, InSpaceIsSafe) {
  const GaugeForm form =
      gauge_form(profile(), YieldModel::Interaction, YieldCap::FullyPlastic, Formulas::Mechanics);
  for (double mx = 0.0; mx <= 1.0; mx += 0.05) {
    SectionForce<double> z{};
    z[kBendingX] = mx;
    z[kBendingY] = 1.0 - mx * mx;
    EXPECT_GE(testing::gauge_at(form, z), 1.0 - 1e-12);
    EXPECT_LE(testing::gauge_at(form, z), 1.26);
  }
}

/// With one more the fibres are others.
TEST(TakenFibres, AreTheMostThatAreTheSame) {
  const Section tube{.shape = SectionShape::RectangularTube,
                     .width = 0.03,
                     .height = 0.04,
                     .inner_width = 0.026,
                     .inner_height = 0.036};
  const Section circle{.shape = SectionShape::Circle, .radius = 0.02};
  const Section ring{.shape = SectionShape::RoundTube, .radius = 0.02, .inner_radius = 0.018};
  for (const Section& s : {Section{.width = 0.02, .height = 0.03}, tube, circle, ring, profile()}) {
    const SectionProperties p = section_properties(s, 0.3);
    for (const FibrePlane plane : {FibrePlane::AboutX, FibrePlane::AboutY, FibrePlane::Both}) {
      for (int fibres = 2; fibres < 20; ++fibres) {
        const int taken = taken_fibres(s, plane, fibres);
        const FibreLayout few = fibre_layout(s, p, plane, fibres);
        const FibreLayout as_taken = fibre_layout(s, p, plane, taken);
        EXPECT_EQ(few.depth, as_taken.depth) << fibres;
        EXPECT_EQ(few.across, as_taken.across) << fibres;
        EXPECT_NE(few.depth, fibre_layout(s, p, plane, taken + 1).depth) << fibres;
      }
    }
  }
  EXPECT_EQ(taken_fibres(tube, FibrePlane::AboutX, 2), 8);
  EXPECT_EQ(taken_fibres(circle, FibrePlane::AboutX, 2), 4);
}

}  // namespace
}  // namespace plastica::law
