#include "plastica/io/durable_file.hpp"

#include <gtest/gtest.h>

#include "tests/lib/io/message_from.hpp"
#include "tests/lib/io/scratch_folder.hpp"

namespace plastica::io {
namespace {

TEST(DurableFile, NamesTheFileThatCannotBeSynced) {
  const ScratchFolder folder;
  sync_to_disk(folder.write("a", "new"));
  const std::string none = folder.file("none/a");
  EXPECT_EQ(message_from<StorageError>([&] { sync_to_disk(none); }),
            none + ": cannot be opened: No such file or directory");
}

TEST(DurableFile, KnowsTheFolderOfABareName) {
  EXPECT_EQ(folder_of("a.h5"), ".");
  EXPECT_EQ(folder_of("x/a.h5"), "x");
  EXPECT_EQ(folder_of("/a.h5"), "/");
}

TEST(StorageError, IsAFailureOfTheMachineThatKnowsItsPath) {
  try {
    sync_to_disk("/nowhere/x");
    FAIL() << "no error";
  } catch (const MachineError& error) {
    const auto* storage = dynamic_cast<const StorageError*>(&error);
    ASSERT_NE(storage, nullptr);
    EXPECT_EQ(storage->path(), "/nowhere/x");
    EXPECT_EQ(std::string(error.what()), storage->path() + ": " + storage->reason());
  }
}

}  // namespace
}  // namespace plastica::io
