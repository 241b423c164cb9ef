#include "plastica/base/renamed.hpp"

#include <gtest/gtest.h>

#include "plastica/io/toml.hpp"
#include "plastica/io/value_rule.hpp"
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

TEST(Renamed, IsFoundInAFileThatHasTheOldName) {
  const ScratchFolder folder;
  const std::string path = folder.file("old.h5");
  {
    Hdf5File file = Hdf5File::create(path);
    for (const Renamed& name : kRenamedStored) file.root().write(name.before, 0.5);
    file.root().write("now/outcome", 1.0);
    file.commit();
  }
  const Hdf5File file = Hdf5File::open(path);
  for (const Renamed& name : kRenamedStored) {
    EXPECT_EQ(file.root().read_scalar<double>(path_in_file(file.root(), name.now)), 0.5);
  }
  EXPECT_EQ(path_in_file(file.root(), "now/outcome"), "now/outcome");
}

}  // namespace
}  // namespace plastica::io
