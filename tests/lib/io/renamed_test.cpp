#include "plastica/base/renamed.hpp"

#include <gtest/gtest.h>

#include "plastica/io/hdf5.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/toml.hpp"
#include "plastica/model/field.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"

namespace plastica::io {
namespace {

using plastica::testing::message_of;

TEST(Renamed, HasEachNameOnce) {
  for (const auto names :
       {std::span<const Renamed>(kRenamedWords), std::span<const Renamed>(kRenamedStored)}) {
    for (const Renamed& name : names) {
      EXPECT_EQ(old_name(names, name.now), name.before);
      EXPECT_EQ(new_name(names, name.before), name.now);
      EXPECT_EQ(new_name(names, name.now), name.now) << "is an old name, too";
    }
  }
}

TEST(Renamed, IsReadFromAnInputWithANote) {
  for (const Renamed& name : kRenamedWords) {
    const std::string before(name.before);
    const std::string now(name.now);
    const auto document = TomlDocument::parse(before + " = 1\nword = '" + before + "'\n", "a.toml");
    EXPECT_EQ(document.root().at(now).number(), 1.0);
    EXPECT_EQ(document.root().at("word").word(std::array{name.now}), 0U);
    document.root().check_unused();
    const std::string line = ": " + before + " is now " + now;
    EXPECT_EQ(document.root().notes(),
              (std::vector<std::string>{"a.toml:1" + line, "a.toml:2" + line}));
  }
}

TEST(Renamed, IsNotedOnce) {
  const auto document = TomlDocument::parse("most_work = 1\n", "a.toml");
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(document.root().find("max_work"));
  EXPECT_EQ(document.root().notes().size(), 1U);
}

TEST(Renamed, IsRefusedBesideTheNewName) {
  const auto document = TomlDocument::parse("most_work = 1\nmax_work = 1\n", "a.toml");
  EXPECT_EQ(message_of([&] { (void)document.root().find("max_work"); }),
            "a.toml:1: most_work = 1: is the old name of max_work, which is there, too");
}

TEST(Renamed, IsTheSameForFieldsOfBothNames) {
  const Field& now = find_field("material.hardening.kinematic_fraction");
  EXPECT_EQ(&find_field("material.hardening.kinematic_share"), &now);
  EXPECT_EQ(&find_field("kinematic_share"), &now);
  EXPECT_EQ(find_field_or_null("material.hardening.kinematic_share"), &now);
}

TEST(Renamed, LeavesThePathsThatDigestsAreMadeOf) {
  EXPECT_EQ(old_path("material.hardening.kinematic_fraction"),
            "material.hardening.kinematic_share");
  EXPECT_EQ(old_path("material.yield_stress"), "material.yield_stress");
  EXPECT_EQ(new_path("material.hardening.kinematic_share"),
            "material.hardening.kinematic_fraction");
}

TEST(Renamed, IsReadFromAScene) {
  const std::string scene =
      "beam = { length = '1 m', segments = 4 }\n"
      "section = { shape = 'circle', radius = '10 mm' }\n"
      "[material]\nname = 'S355'\n"
      "hardening = { law = 'linear', tangent_modulus = '2 GPa', kinematic_share = 0.3 }\n"
      "[[support]]\nat = 'start'\nkind = 'clamp'\n"
      "[[load]]\nat = 'end'\nforce = ['0 N', '1 N', '0 N']\n";
  const SceneFile read = parse_scene_file(scene, "f.toml");
  EXPECT_EQ(read.setup.scene.material.hardening.kinematic_fraction, 0.3);
  EXPECT_EQ(read.notes,
            std::vector<std::string>{"f.toml:5: kinematic_share is now kinematic_fraction"});
}

TEST(Renamed, IsFoundInAFileThatHasTheOldName) {
  const ScratchFolder folder;
  const std::string path = folder.file("old.h5");
  {
    Hdf5File file = Hdf5File::create(path);
    for (const Renamed& name : kRenamedStored) {
      file.root().write("of/" + std::string(name.before), 0.5);
    }
    file.root().write("moved/turn/values", 0.25);
    file.root().write("now/rotation", 1.0);
    file.root().write("now/turn", 2.0);
    file.commit();
  }
  const Hdf5File file = Hdf5File::open(path);
  const Hdf5Group& root = file.root();
  for (const Renamed& name : kRenamedStored) {
    EXPECT_EQ(root.read_scalar<double>("of/" + std::string(name.now)), 0.5);
  }
  EXPECT_EQ(root.open_group("free/rotation").path(), "/free/rotation");
  EXPECT_EQ(root.read_scalar<double>("free/rotation/values"), 0.25);
  EXPECT_EQ(root.read_scalar<double>("now/rotation"), 1.0);
  EXPECT_FALSE(root.exists("now/misfit_fraction"));
  EXPECT_EQ(message_of([&] { (void)root.read_scalar<double>("now/misfit_fraction"); }),
            path + ": /now/misfit_fraction: is not in this file");
}

}  // namespace
}  // namespace plastica::io
