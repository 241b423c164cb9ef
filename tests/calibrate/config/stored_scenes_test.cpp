#include "calibrate/config/stored_scenes.hpp"

#include <gtest/gtest.h>

namespace plastica::calibrate {
namespace {

const std::string kBar =
    "[beam]\nlength = \"1 m\"\nsegments = 4\n"
    "section = { shape = \"rectangle\", width = \"20 mm\", height = \"20 mm\" }\n"
    "[[support]]\nat = \"start\"\nkind = \"clamp\"\n"
    "[[load]]\nat = \"end\"\nforce = [\"0 N\", \"-1 N\", \"0 N\"]\n";

std::string target(const std::string& scene, const std::string& more = "") {
  return "[[target]]\nfiles = \"gone.csv\"\nscene = \"" + scene + "\"\n" + more;
}

std::optional<StoredSceneFit> stored(const std::string& fit,
                                     std::vector<io::InputText> scenes = {{"bar.toml", kBar}}) {
  scenes.insert(scenes.begin(), {"fit.toml", fit});
  return read_stored_scenes(scenes);
}

TEST(StoredScenes, HaveWhatTheirTargetsChange) {
  const auto fit = stored(target("../scenes/bar.toml", "beam = { segments = 8 }\n"));
  ASSERT_TRUE(fit);
  ASSERT_EQ(fit->scenes.size(), 1U);
  EXPECT_EQ(fit->scenes[0].name, "bar.toml");
  ASSERT_TRUE(fit->scenes[0].setup) << fit->scenes[0].why_not;
  EXPECT_EQ(fit->scenes[0].setup->scene.beam.segments, 8);
  EXPECT_EQ(fit->scenes[0].setup->scene.supports.size(), 1U);
}

TEST(StoredScenes, HaveTheSegmentsOfTheFit) {
  const auto fit = stored("[fit]\nsegments = 12\n" + target("bar.toml"));
  ASSERT_TRUE(fit);
  ASSERT_TRUE(fit->scenes[0].setup) << fit->scenes[0].why_not;
  EXPECT_EQ(fit->scenes[0].setup->scene.beam.segments, 12);
}

TEST(StoredScenes, AreListedOnceIfTheyAreEqual) {
  const auto fit = stored(target("bar.toml") + target("./bar.toml") +
                          target("bar.toml", "beam = { segments = 8 }\n"));
  ASSERT_EQ(fit->scenes.size(), 2U);
  EXPECT_EQ(fit->scenes[0].setup->scene.beam.segments, 4);
  EXPECT_EQ(fit->scenes[1].setup->scene.beam.segments, 8);
  EXPECT_EQ(fit->scene_of_table, (std::vector<std::size_t>{0, 0, 1}));
}

TEST(StoredScenes, OfOneNameInTwoFoldersAreTwo) {
  std::string longer = kBar;
  longer.replace(longer.find("1 m"), 3, "3 m");
  const auto fit = stored(target("a/bar.toml") + target("b/bar.toml") + target("a/bar.toml"),
                          {{"bar.toml", kBar}, {"bar.toml", longer}});
  ASSERT_EQ(fit->scenes.size(), 2U);
  EXPECT_EQ(fit->scenes[0].setup->scene.beam.length, 1.0);
  EXPECT_EQ(fit->scenes[1].setup->scene.beam.length, 3.0);
  EXPECT_EQ(fit->scene_of_table, (std::vector<std::size_t>{0, 1, 0}));
}

TEST(StoredScenes, ComeWithTheParametersOfTheFit) {
  const auto fit = stored(
      "[fit.parameters]\nyield_stress = { bounds = [\"100 MPa\", \"1 GPa\"] }\n"
      "material.density = { value = \"2700 kg/m^3\", fixed = true }\n" +
      target("bar.toml"));
  ASSERT_EQ(fit->parameters.size(), 2U);
  EXPECT_EQ(fit->parameters[0].role, ParameterRole::Free);
  EXPECT_EQ(fit->parameters[1].role, ParameterRole::Fixed);
  EXPECT_EQ(fit->parameters[1].value, 2700.0);
}

TEST(StoredScenes, SayWhyOneCannotBeRead) {
  const auto fit =
      stored(target("bar.toml"),
             {{"bar.toml", "[drive]\nstrain = { table = \"gone.csv\", column = 1 }\n"}});
  ASSERT_EQ(fit->scenes.size(), 1U);
  EXPECT_FALSE(fit->scenes[0].setup);
  EXPECT_NE(fit->scenes[0].why_not.find("gone.csv"), std::string::npos) << fit->scenes[0].why_not;
}

TEST(StoredScenes, AreNoneWhereTheTextsAreNotAllThere) {
  EXPECT_FALSE(read_stored_scenes({}));
  EXPECT_FALSE(stored(target("bar.toml"), {}));
  EXPECT_FALSE(stored(target("other.toml")));
  EXPECT_FALSE(stored("[fit]\n"));
}

}  // namespace
}  // namespace plastica::calibrate
