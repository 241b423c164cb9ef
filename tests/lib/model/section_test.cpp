#include "plastica/model/section.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "plastica/model/torsion.hpp"

namespace plastica {
namespace {

using std::numbers::pi;

constexpr double kNu = 0.3;

SectionProperties properties(const Section& section) {
  check_section(section);
  return section_properties(section, kNu);
}

TEST(Section, RectangleHasTheTextbookProperties) {
  const auto p = properties({.shape = SectionShape::Rectangle, .width = 0.02, .height = 0.03});
  EXPECT_DOUBLE_EQ(p.area, 6e-4);
  EXPECT_DOUBLE_EQ(p.second_moment_x, 0.02 * 0.03 * 0.03 * 0.03 / 12.0);
  EXPECT_DOUBLE_EQ(p.second_moment_y, 0.03 * 0.02 * 0.02 * 0.02 / 12.0);
  EXPECT_DOUBLE_EQ(p.outer_distance_x, 0.015);
  EXPECT_DOUBLE_EQ(p.outer_distance_y, 0.01);
  EXPECT_DOUBLE_EQ(p.section_modulus_x, 0.02 * 0.03 * 0.03 / 6.0);
  EXPECT_DOUBLE_EQ(p.section_modulus_y, 0.03 * 0.02 * 0.02 / 6.0);
  EXPECT_DOUBLE_EQ(p.plastic_section_modulus_x / p.section_modulus_x, 1.5);
  EXPECT_DOUBLE_EQ(p.plastic_section_modulus_y / p.section_modulus_y, 1.5);
  EXPECT_DOUBLE_EQ(p.torsion_constant, saint_venant_beta(1.5) * 0.03 * 8e-6);
  EXPECT_DOUBLE_EQ(p.torsion_modulus, saint_venant_alpha(1.5) * 0.03 * 4e-4);
  EXPECT_DOUBLE_EQ(p.plastic_torsion_modulus, 4e-4 * (0.09 - 0.02) / 6.0);
  EXPECT_DOUBLE_EQ(p.shear_coefficient_x, 13.0 / 15.3);
  EXPECT_DOUBLE_EQ(p.shear_coefficient_y, p.shear_coefficient_x);
  EXPECT_FALSE(p.bredt_torsion_constant.has_value());
}

TEST(Section, TurnedRectangleSwapsItsAxes) {
  const auto lying = properties({.width = 0.03, .height = 0.01});
  const auto standing = properties({.width = 0.01, .height = 0.03});
  EXPECT_DOUBLE_EQ(lying.second_moment_x, standing.second_moment_y);
  EXPECT_DOUBLE_EQ(lying.outer_distance_x, standing.outer_distance_y);
  EXPECT_DOUBLE_EQ(lying.plastic_section_modulus_y, standing.plastic_section_modulus_x);
  EXPECT_DOUBLE_EQ(lying.torsion_constant, standing.torsion_constant);
  EXPECT_DOUBLE_EQ(lying.plastic_torsion_modulus, standing.plastic_torsion_modulus);
}

TEST(Section, CircleHasTheTextbookProperties) {
  const double R = 0.01;
  const auto p = properties({.shape = SectionShape::Circle, .radius = R});
  EXPECT_DOUBLE_EQ(p.area, pi * 1e-4);
  EXPECT_NEAR(p.second_moment_x, pi * 1e-8 / 4.0, 1e-22);
  EXPECT_DOUBLE_EQ(p.torsion_constant, 2.0 * p.second_moment_x);
  EXPECT_NEAR(p.torsion_modulus, pi * 1e-6 / 2.0, 1e-20);
  EXPECT_NEAR(p.plastic_torsion_modulus / p.torsion_modulus, 4.0 / 3.0, 1e-14);
  EXPECT_NEAR(p.plastic_section_modulus_x / p.section_modulus_x, 16.0 / (3.0 * pi), 1e-14);
  EXPECT_NEAR(p.shear_coefficient_x, 6.0 * 1.3 / 8.8, 1e-15);
}

TEST(Section, RoundTubeIsTheDifferenceOfTwoCircles) {
  const Section tube{.shape = SectionShape::RoundTube, .radius = 0.05, .inner_radius = 0.04};
  const auto p = properties(tube);
  const auto outer = properties({.shape = SectionShape::Circle, .radius = 0.05});
  const auto inner = properties({.shape = SectionShape::Circle, .radius = 0.04});
  EXPECT_NEAR(p.area, outer.area - inner.area, 1e-16);
  EXPECT_NEAR(p.second_moment_y, outer.second_moment_y - inner.second_moment_y, 1e-19);
  EXPECT_NEAR(p.torsion_constant, outer.torsion_constant - inner.torsion_constant, 1e-19);
  EXPECT_NEAR(p.plastic_section_modulus_y,
              outer.plastic_section_modulus_y - inner.plastic_section_modulus_y, 1e-17);
  EXPECT_NEAR(p.plastic_torsion_modulus,
              outer.plastic_torsion_modulus - inner.plastic_torsion_modulus, 1e-17);
  EXPECT_NEAR(p.torsion_modulus, p.torsion_constant / 0.05, 1e-18);
}

TEST(Section, ThinRoundTubeTendsToBredtAndCowper) {
  const auto p = properties(
      {.shape = SectionShape::RoundTube, .radius = 0.05, .inner_radius = 0.05 * (1.0 - 1e-5)});
  EXPECT_NEAR(*p.bredt_torsion_constant / p.torsion_constant, 1.0, 1e-9);
  EXPECT_NEAR(*p.bredt_torsion_modulus / p.torsion_modulus, 1.0, 1e-4);
  // Cowper's thin ring: 2(1+nu)/(4+3nu).
  EXPECT_NEAR(p.shear_coefficient_x, 2.6 / 4.9, 1e-6);
}

TEST(Section, RectangularTubeIsTheDifferenceOfTwoRectanglesInBending) {
  const Section tube{.shape = SectionShape::RectangularTube,
                     .width = 0.1,
                     .height = 0.2,
                     .inner_width = 0.08,
                     .inner_height = 0.15};
  const auto p = properties(tube);
  const auto outer = properties({.width = 0.1, .height = 0.2});
  const auto inner = properties({.width = 0.08, .height = 0.15});
  EXPECT_NEAR(p.area, outer.area - inner.area, 1e-16);
  EXPECT_NEAR(p.second_moment_x, outer.second_moment_x - inner.second_moment_x, 1e-18);
  EXPECT_NEAR(p.second_moment_y, outer.second_moment_y - inner.second_moment_y, 1e-18);
  EXPECT_NEAR(p.section_modulus_x, p.second_moment_x / 0.1, 1e-18);
  EXPECT_NEAR(p.plastic_section_modulus_x,
              outer.plastic_section_modulus_x - inner.plastic_section_modulus_x, 1e-17);
  EXPECT_NEAR(p.plastic_section_modulus_y,
              outer.plastic_section_modulus_y - inner.plastic_section_modulus_y, 1e-17);
  EXPECT_GT(p.plastic_torsion_modulus, p.torsion_modulus);
}

TEST(Section, RectangularTubeWithoutBreadthHasTheShearCoefficientOfARectangle) {
  // Walls along the force only: Cowper's m -> 0.
  const auto p = properties({.shape = SectionShape::RectangularTube,
                             .width = 1e-3,
                             .height = 1.0,
                             .inner_width = 1e-6,
                             .inner_height = 1.0 - 1e-6});
  EXPECT_NEAR(p.shear_coefficient_y, 13.0 / 15.3, 1e-4);
}

TEST(Section, SquareTubeIsTheSameAlongBothAxes) {
  const auto p = properties({.shape = SectionShape::RectangularTube});
  EXPECT_DOUBLE_EQ(p.second_moment_x, p.second_moment_y);
  EXPECT_DOUBLE_EQ(p.shear_coefficient_x, p.shear_coefficient_y);
  EXPECT_NEAR(*p.bredt_torsion_constant, 0.09 * 0.09 * 0.09 * 0.01, 1e-17);
  EXPECT_NEAR(*p.bredt_torsion_modulus, 2.0 * 0.09 * 0.09 * 0.01, 1e-17);
}

TEST(Section, GivenShearCoefficientReplacesCowpers) {
  const auto p = properties({.shape = SectionShape::Circle, .shear_coefficient = 0.75});
  EXPECT_DOUBLE_EQ(p.shear_coefficient_x, 0.75);
  EXPECT_DOUBLE_EQ(p.shear_coefficient_y, 0.75);
}

struct BadSection {
  Section section;
  std::string message;
};

class SectionRejects : public ::testing::TestWithParam<BadSection> {};

TEST_P(SectionRejects, ByNamingFieldValueAndRule) {
  try {
    check_section(GetParam().section, {.file = "a.toml", .line = 7});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "a.toml:7: section." + GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Section, SectionRejects,
    ::testing::Values(
        BadSection{{.width = 0.0}, "width = 0: must be positive and finite"},
        BadSection{{.height = -1.0}, "height = -1: must be positive and finite"},
        BadSection{{.width = std::numeric_limits<double>::infinity()},
                   "width = inf: must be positive and finite"},
        BadSection{{.shape = SectionShape::Circle, .radius = std::nan("")},
                   "radius = nan: must be positive and finite"},
        BadSection{{.shape = SectionShape::RoundTube, .radius = 0.05, .inner_radius = 0.05},
                   "inner_radius = 0.05: must be below section.radius = 0.05"},
        BadSection{{.shape = SectionShape::RoundTube, .inner_radius = 0.0},
                   "inner_radius = 0: must be positive and finite"},
        BadSection{{.shape = SectionShape::RectangularTube, .width = 0.1, .inner_width = 0.2},
                   "inner_width = 0.2: must be below section.width = 0.1"},
        BadSection{{.shape = SectionShape::RectangularTube, .height = 0.1, .inner_height = 0.1},
                   "inner_height = 0.1: must be below section.height = 0.1"},
        BadSection{{.shear_coefficient = 0.0},
                   "shear_coefficient = 0: must be positive and finite"}));

TEST(Section, FieldsOfOtherShapesAreIgnored) {
  EXPECT_NO_THROW(check_section({.shape = SectionShape::Circle, .width = -1.0}));
  EXPECT_NO_THROW(check_section({.shape = SectionShape::Rectangle, .inner_width = 9.0}));
}

TEST(Section, DefaultsAreValidForEveryShape) {
  for (const auto shape : {SectionShape::Rectangle, SectionShape::Circle, SectionShape::RoundTube,
                           SectionShape::RectangularTube}) {
    EXPECT_NO_THROW(check_section({.shape = shape}));
  }
}

}  // namespace
}  // namespace plastica
