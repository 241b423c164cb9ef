#include "plastica/model/region.hpp"

#include <gtest/gtest.h>

namespace plastica {
namespace {

Setup with(std::vector<std::string> own) {
  Setup setup;
  Region region;
  region.section = setup.scene.section;
  region.own = std::move(own);
  setup.scene.regions = {region};
  return setup;
}

TEST(Region, KeepsWhatItSaysItself) {
  plastica::Setup setup = with({"section.width", "material.hardening"});
  setup.scene.regions[0].section.width = 0.5;
  set_everywhere(setup, find_field("section.width"), 0.3);
  set_everywhere(setup, find_field("section.height"), 0.2);
  set_everywhere(setup, find_field("material.yield_stress"), 235e6);
  set_everywhere(setup, find_field("material.hardening.law"), std::string("linear"));
  const Region& region = setup.scene.regions[0];
  EXPECT_EQ(region.section.width, 0.5);
  EXPECT_EQ(region.section.height, 0.2);
  EXPECT_EQ(region.material.yield_stress, 235e6);
  EXPECT_EQ(region.material.hardening.law, HardeningLaw::Ideal);
}

TEST(Region, FollowsNothingUnlessItIsTold) {
  plastica::Setup setup;
  setup.scene.regions.emplace_back();
  set_everywhere(setup, find_field("material.yield_stress"), 235e6);
  EXPECT_EQ(setup.scene.regions[0].material.yield_stress, Material{}.yield_stress);
  EXPECT_FALSE(stands_in_regions(setup.scene, find_field("material.yield_stress")));
}

TEST(Region, TellsWhichFieldsItFollows) {
  const Scene scene = with({"section.width", "material"}).scene;
  EXPECT_FALSE(stands_in_regions(scene, find_field("section.width")));
  EXPECT_TRUE(stands_in_regions(scene, find_field("section.height")));
  EXPECT_FALSE(stands_in_regions(scene, find_field("material.density")));
  EXPECT_FALSE(stands_in_regions(scene, find_field("beam.length")));
  // The beginning of a word is not the word.
  const Region region{.own = {"section.w"}};
  EXPECT_FALSE(is_own(region, "section.width"));
}

TEST(Region, TakesNamesAlong) {
  plastica::Setup setup = with({"section.width"});
  setup.scene.material.name = "copper";
  setup.scene.section.name = "IPE 200";
  follow_beam(setup.scene);
  EXPECT_EQ(setup.scene.regions[0].material.name, "copper");
  EXPECT_EQ(setup.scene.regions[0].section.name, "");  // of another width
  setup.scene.regions[0].own.clear();
  follow_beam(setup.scene);
  EXPECT_EQ(setup.scene.regions[0].section.name, "IPE 200");
}

}  // namespace
}  // namespace plastica
