#include "plastica/model/local_buckling.hpp"

#include "plastica/model/profile_table.hpp"

#include <gtest/gtest.h>

#include "plastica/run/scene_warnings.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/lib/model/chain_scenes.hpp"

// EN 1993-1-1, table 5.2.

namespace plastica {
namespace {

using model_detail::worst_wall;

Material steel(double yield_stress) {
  Material material;
  material.youngs_modulus = 210e9;
  material.yield_stress = yield_stress;
  return material;
}

Section round_tube(double diameter, double wall) {
  Section section;
  section.shape = SectionShape::RoundTube;
  section.radius = 0.5 * diameter;
  section.inner_radius = 0.5 * diameter - wall;
  return section;
}

Section box(double width, double height, double wall) {
  Section section;
  section.shape = SectionShape::RectangularTube;
  section.width = width;
  section.height = height;
  section.inner_width = width - 2.0 * wall;
  section.inner_height = height - 2.0 * wall;
  return section;
}

int class_of(const Section& section, double yield_stress, bool about_x = true,
             bool about_y = false) {
  return worst_wall(section, steel(yield_stress), about_x, about_y)->section_class;
}

TEST(TubeWall, IsOfTheClassOfItsDiameterOverThickness) {
  // S235: e = 1, limits 50, 70, 90. S355: e^2 = 0.66197, limits 33.1, 46.3, 59.6.
  EXPECT_EQ(class_of(round_tube(0.049, 0.001), 235e6), 1);
  EXPECT_EQ(class_of(round_tube(0.051, 0.001), 235e6), 2);
  EXPECT_EQ(class_of(round_tube(0.071, 0.001), 235e6), 3);
  EXPECT_EQ(class_of(round_tube(0.091, 0.001), 235e6), 4);
  EXPECT_EQ(class_of(round_tube(0.033, 0.001), 355e6), 1);
  EXPECT_EQ(class_of(round_tube(0.034, 0.001), 355e6), 2);
  EXPECT_EQ(class_of(round_tube(0.046, 0.001), 355e6), 2);
  EXPECT_EQ(class_of(round_tube(0.047, 0.001), 355e6), 3);
  EXPECT_EQ(class_of(round_tube(0.059, 0.001), 355e6), 3);
  EXPECT_EQ(class_of(round_tube(0.060, 0.001), 355e6), 4);
}

TEST(TubeWall, OfAnotherMaterialHasItsModulusInTheLimits) {
  Material aluminium = steel(235e6);
  aluminium.youngs_modulus = 70e9;  // e^2 = 1/3
  EXPECT_EQ(worst_wall(round_tube(0.016, 0.001), aluminium, true, false)->section_class, 1);
  EXPECT_EQ(worst_wall(round_tube(0.031, 0.001), aluminium, true, false)->section_class, 4);
}

TEST(TubeWall, OfABoxIsThatOfTheWallThatDecides) {
  // S235, wall 1 mm: compressed 33, 38, 42 mm clear, bent 72, 83, 124 mm.
  EXPECT_EQ(class_of(box(0.034, 0.034, 0.001), 235e6), 1);
  EXPECT_EQ(class_of(box(0.039, 0.034, 0.001), 235e6), 2);
  EXPECT_EQ(class_of(box(0.043, 0.034, 0.001), 235e6), 3);
  EXPECT_EQ(class_of(box(0.045, 0.034, 0.001), 235e6), 4);
  EXPECT_EQ(class_of(box(0.034, 0.070, 0.001), 235e6), 1);
  EXPECT_EQ(class_of(box(0.034, 0.080, 0.001), 235e6), 2);
  EXPECT_EQ(class_of(box(0.034, 0.120, 0.001), 235e6), 3);
  EXPECT_EQ(class_of(box(0.034, 0.130, 0.001), 235e6), 4);
  // About y the walls change places; about both, both are compressed.
  EXPECT_EQ(class_of(box(0.080, 0.034, 0.001), 235e6, false, true), 2);
  EXPECT_EQ(class_of(box(0.034, 0.070, 0.001), 235e6, true, true), 4);
}

/// EN 1993-1-1, table 5.2, with the values that section catalogues print: of S355 in bending, HEA
/// 180, 200, 260 and 300 are of class 2 or 3 by their flanges, IPE 200 of class 1.
TEST(WallClass, OfProfilesIsThatOfTheCatalogues) {
  EXPECT_EQ(class_of(named_profile("IPE 200"), 355e6), 1);
  EXPECT_EQ(class_of(named_profile("HEB 300"), 355e6), 1);
  EXPECT_EQ(class_of(named_profile("HEA 200"), 355e6), 2);
  EXPECT_EQ(class_of(named_profile("HEA 260"), 355e6), 3);
  EXPECT_EQ(class_of(named_profile("HEA 260"), 235e6), 1);
}

TEST(TubeWall, IsOfTubesAlone) { EXPECT_FALSE(worst_wall({}, steel(355e6), true, false)); }

bool warns(const Scene& scene, const std::string& text) {
  for (const std::string& warning : scene_warnings(prepare(scene, {}))) {
    if (warning.find(text) != std::string::npos) return true;
  }
  return false;
}

TEST(ThinWall, IsWarnedOfWhereTheBeamYields) {
  Scene scene = testing::cantilever();
  scene.material = steel(355e6);
  scene.section = round_tube(0.1, 0.0001);
  scene.yield_model = YieldModel::Interaction;
  EXPECT_TRUE(warns(scene, "d/t = 1000 (beyond 59.6, class 4 of EN 1993-1-1, table 5.2)"));
  EXPECT_TRUE(warns(scene, "buckles before first yield"));
  scene.yield_model = YieldModel::Elastic;
  EXPECT_FALSE(warns(scene, "EN 1993"));
}

TEST(ThinWall, OfClassTwoMattersToHingesAlone) {
  Scene scene = testing::cantilever();
  scene.material = steel(355e6);
  scene.section = round_tube(0.04, 0.001);
  scene.yield_model = YieldModel::Interaction;
  EXPECT_FALSE(warns(scene, "EN 1993"));
  scene.yield_cap = YieldCap::FullyPlastic;
  EXPECT_TRUE(warns(scene, "reaches its plastic moment"));
  scene.section = round_tube(0.03, 0.001);
  EXPECT_FALSE(warns(scene, "EN 1993"));
}

TEST(ThinWall, OfARegionIsNamed) {
  Scene scene = testing::cantilever();
  scene.yield_model = YieldModel::PerAxis;
  Region region;
  region.to = {0.5, {}};
  region.section = round_tube(0.1, 0.0001);
  scene.regions = {region};
  EXPECT_TRUE(warns(scene, "the section of region[1] is thin"));
}

TEST(FirstYield, IsWarnedOfWithTheShapeFactorWhereTheCapIsThatOfFirstYield) {
  Scene scene = testing::cantilever();
  scene.yield_model = YieldModel::Interaction;
  const auto warning = [&] { return first_yield_warning(prepare(scene, {})).value_or(""); };
  EXPECT_NE(warning().find("up to 1.5 times"), std::string::npos);  // rectangle
  EXPECT_NE(warning().find("fully_plastic"), std::string::npos);
  scene.section.shape = SectionShape::Circle;
  scene.section.radius = 0.01;
  EXPECT_NE(warning().find("up to 1.7 times"), std::string::npos);  // 16/(3 pi) = 1.698
  scene.yield_cap = YieldCap::FullyPlastic;
  EXPECT_EQ(warning(), "");
  scene.yield_cap = YieldCap::FirstYield;
  scene.yield_model = YieldModel::Fibre;
  EXPECT_EQ(warning(), "");
  scene.yield_model = YieldModel::Interaction;
  scene.material.hardening.law = HardeningLaw::Linear;
  EXPECT_EQ(warning(), "");
}

TEST(FirstYield, OfABeamThatTwistsIsThatOfItsTorqueWhichFibresFollow) {
  Scene scene = testing::cantilever({0.0, 0.0, 0.0});
  scene.loads[0].moment = {0.0, 0.0, 1.0};
  scene.yield_model = YieldModel::Interaction;
  scene.section.shape = SectionShape::Circle;
  const std::string warning = first_yield_warning(prepare(scene, {})).value_or("");
  EXPECT_NE(warning.find("up to 1.33 times"), std::string::npos) << warning;  // 4/3
  EXPECT_NE(warning.find("\"fibre\" for rules.yield_model follows it from first yield on"),
            std::string::npos)
      << warning;
}

}  // namespace
}  // namespace plastica
