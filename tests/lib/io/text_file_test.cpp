#include "plastica/io/text_file.hpp"

#include <gtest/gtest.h>

#include "plastica/io/storage_error.hpp"
#include "tests/lib/io/scratch_folder.hpp"

namespace plastica::io {
namespace {

TEST(TextFile, IsReadAsItWasWritten) {
  const ScratchFolder folder;
  const std::string path = folder.file("a.txt");
  for (const std::string text : {"", "one\r\ntwo", "\n"}) {
    write_text_file(path, text);
    EXPECT_EQ(read_text_file(path), text);
  }
}

TEST(TextFile, SaysWhereItCannotBe) {
  const ScratchFolder folder;
  EXPECT_THROW(read_text_file(folder.file("none")), StorageError);
  EXPECT_THROW(write_text_file(folder.file("none/a.txt"), "text"), StorageError);
}

}  // namespace
}  // namespace plastica::io
