#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "plastica/base/former_names.hpp"
#include "plastica/io/hdf5.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/io/toml.hpp"
#include "plastica/model/field.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/former_names.hpp"
#include "tests/support/message.hpp"

namespace plastica::io {
namespace {

using Notes = std::vector<std::string>;
using testing::message_of;

TomlTable parsed(const std::string& text) { return TomlDocument::parse(text, "f.toml").root(); }

TEST(FormerNames, OfKeysAreReadAndToldOnceWithTheirPlace) {
  const testing::FormerNames said;
  const TomlTable table = parsed("a = 1\ndrop_share = 0.3\n");
  EXPECT_TRUE(table.contains("drop_fraction"));
  EXPECT_EQ(said.notes(), Notes{});
  EXPECT_EQ(table.at("drop_fraction").number(), 0.3);
  EXPECT_EQ(table.find("drop_fraction")->key(), "drop_share");
  EXPECT_EQ(said.notes(), Notes{"f.toml:2: drop_share is now drop_fraction"});
  EXPECT_FALSE(table.find("zero_fraction"));
  (void)table.find("a");
  EXPECT_NO_THROW(table.check_unused());
}

TEST(FormerNames, BesidePresentOnesAreRefused) {
  const TomlTable table = parsed("drop_fraction = 0.3\ndrop_share = 0.3\n");
  EXPECT_EQ(message_of([&] { (void)table.find("drop_fraction"); }),
            "f.toml:2: drop_share = 0.3: is the former name of drop_fraction, which is there, too");
}

TEST(FormerNames, OfFieldsAreReadAsTheirPresentOnes) {
  const testing::FormerNames said;
  const Field& now = find_field("material.hardening.kinematic_fraction");
  EXPECT_EQ(&find_field("material.hardening.kinematic_share", {"f.toml", 3}), &now);
  EXPECT_EQ(&find_field("kinematic_share", {"f.toml", 4}), &now);
  EXPECT_EQ(find_field_or_null("material.hardening.kinematic_share"), &now);
  EXPECT_EQ(said.notes(), (Notes{"f.toml:3: material.hardening.kinematic_share is now "
                                 "material.hardening.kinematic_fraction",
                                 "f.toml:4: kinematic_share is now kinematic_fraction"}));
}

TEST(FormerNames, OfInputsThatNoUserWroteAreNotTold) {
  const testing::FormerNames said;
  find_field("kinematic_share", {"results.h5", 0});
  const UnnotedFormerNames unnoted;
  EXPECT_EQ(parsed("drop_share = 0.3\n").at("drop_fraction").number(), 0.3);
  EXPECT_EQ(said.notes(), Notes{});
}

TEST(FormerNames, AreThoseThatDigestsAreMadeOf) {
  EXPECT_EQ(first_path("material.hardening.kinematic_fraction"),
            "material.hardening.kinematic_share");
  EXPECT_EQ(first_path("material.yield_stress"), "material.yield_stress");
  EXPECT_EQ(present_path("material.hardening.kinematic_share"),
            "material.hardening.kinematic_fraction");
}

TEST(FormerNames, OfScenesAreRead) {
  const std::string scene =
      "beam = { length = '1 m', segments = 4 }\n"
      "section = { shape = 'circle', radius = '10 mm' }\n"
      "[material]\nname = 'S355'\n"
      "hardening = { law = 'linear', tangent_modulus = '2 GPa', kinematic_share = 0.3 }\n"
      "[[support]]\nat = 'start'\nkind = 'clamp'\n"
      "[[load]]\nat = 'end'\nforce = ['0 N', '1 N', '0 N']\n";
  const testing::FormerNames said;
  const auto read = parse_scene_file(scene, "f.toml");
  EXPECT_EQ(read.setup.scene.material.hardening.kinematic_fraction, 0.3);
  EXPECT_EQ(said.notes(), Notes{"f.toml:5: kinematic_share is now kinematic_fraction"});
}

TEST(FormerNames, OfDatasetsAndGroupsAreReadWhereTheFileHasNoPresentOne) {
  const ScratchFolder folder;
  const std::string path = folder.file("a.h5");
  {
    Hdf5File file = Hdf5File::create(path);
    file.root().write("fits/misfit_share", std::vector<double>{0.1});
    file.root().write("parameters/kinematic_share/value", std::vector<double>{0.2});
    file.commit();
  }
  const Hdf5File file = Hdf5File::open(path);
  const Hdf5Group& root = file.root();
  EXPECT_EQ(root.kind("fits/misfit_fraction"), Hdf5Kind::Real);
  EXPECT_EQ(root.read<double>("fits/misfit_fraction"), std::vector<double>{0.1});
  EXPECT_EQ(root.read<double>("parameters/kinematic_fraction/value"), std::vector<double>{0.2});
  const Hdf5Group group = root.open_group("parameters/kinematic_fraction");
  EXPECT_EQ(group.path(), "/parameters/kinematic_fraction");
  EXPECT_EQ(group.read<double>("value"), std::vector<double>{0.2});
  EXPECT_FALSE(root.exists("fits/kinematic_fraction"));
  EXPECT_EQ(message_of([&] { (void)root.read<double>("fits/kinematic_fraction"); }),
            path + ": /fits/kinematic_fraction: is not in this file");
}

}  // namespace
}  // namespace plastica::io
