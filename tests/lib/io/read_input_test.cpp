#include "plastica/io/read_input.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "plastica/io/csv.hpp"
#include "plastica/io/toml.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"

namespace plastica::io {
namespace {

using testing::message_of;

std::string error_of(const std::string& path, std::size_t max_bytes = kMaxTableBytes) {
  return message_of([&] { read_input(path, max_bytes); });
}

TEST(ReadInput, GivesEveryByte) {
  const ScratchFolder folder;
  const std::string text = "a\r\n\xE9\xFF\x01 b";
  EXPECT_EQ(read_input(folder.write("a.csv", text), text.size()), text);
  EXPECT_EQ(read_input(folder.write("b.csv", ""), 0), "");
  EXPECT_EQ(read_input(folder.write("c.csv", std::string(1'000'000, 'x')), kMaxTableBytes).size(),
            1'000'000U);
}

TEST(ReadInput, ReadsAPipeToItsEnd) {
  const ScratchFolder folder;
  const std::string path = folder.file("pipe");
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(path) << "a,b\n" << std::flush << "1,2\n"; });
  const CsvTable table = CsvTable::read(path);
  writer.join();
  EXPECT_EQ(table.number(0, 1), 2.0);
}

TEST(ReadInput, RefusesWhatIsLargerThanTheLimit) {
  const ScratchFolder folder;
  const std::string path = folder.write("a.csv", "abc");
  EXPECT_EQ(error_of(path, 2), path + ": is larger than 2 bytes, the most that is read");
  // A hole of two limits' size takes no room.
  std::filesystem::resize_file(path, 2 * kMaxTableBytes);
  EXPECT_EQ(error_of(path), path + ": is larger than 1 GiB, the most that is read");
  EXPECT_EQ(message_of([&] { TomlDocument::read(path); }),
            path + ": is larger than 16 MiB, the most that is read");
}

TEST(ReadInput, EndsAtTheFirstZeroByte) {
  EXPECT_EQ(error_of("/dev/zero"), "/dev/zero:1: is not text (it has a zero byte)");
  EXPECT_EQ(message_of([] { TomlDocument::read("/dev/zero"); }),
            "/dev/zero:1: is not text (it has a zero byte)");
  const ScratchFolder folder;
  const std::string wide = folder.write("wide.csv", std::string("\xFF\xFE"
                                                                "a\0",
                                                                4));
  EXPECT_EQ(read_input(wide, 4), "a");
}

TEST(ReadInput, SaysWhyAFileCannotBeRead) {
  const ScratchFolder folder;
  EXPECT_EQ(error_of(folder.file("none")),
            folder.file("none") + ": cannot be read: No such file or directory");
  const std::string loop = folder.file("loop");
  std::filesystem::create_symlink("loop", loop);
  EXPECT_EQ(error_of(loop), loop + ": cannot be read: Too many levels of symbolic links");
  const std::string longest = folder.file(std::string(300, 'n'));
  EXPECT_EQ(error_of(longest), longest + ": cannot be read: File name too long");
  EXPECT_EQ(error_of("/"), "/: cannot be read: Is a directory");
}

TEST(ReadInput, TellsFilesFromWhatIsNone) {
  const ScratchFolder folder;
  const std::string file = folder.write("a.csv", "1\n");
  const std::string loop = folder.file("loop");
  const std::string nowhere = folder.file("nowhere");
  const std::string good = folder.file("good");
  std::filesystem::create_symlink("loop", loop);
  std::filesystem::create_symlink("none", nowhere);
  std::filesystem::create_symlink("a.csv", good);
  EXPECT_TRUE(is_file(file));
  EXPECT_TRUE(is_file(good));
  EXPECT_EQ(why_no_file(good), "");
  for (const std::string& link : {loop, nowhere}) {
    EXPECT_FALSE(is_file(link));
    EXPECT_TRUE(is_broken_link(link));
  }
  for (const std::string& other : {file, good, folder.file("none"), std::string("/")}) {
    EXPECT_FALSE(is_broken_link(other));
  }
  EXPECT_EQ(why_no_file(loop), ": Too many levels of symbolic links");
  EXPECT_EQ(why_no_file(folder.file("none")), "");
  EXPECT_EQ(why_no_file("/"), ": it is a folder");
  EXPECT_EQ(why_no_file("/dev/null"), ": it is a pipe or a device");
  EXPECT_EQ(why_no_file(std::string(5000, 'n')), ": File name too long");
}

TEST(ReadInput, KnowsUtf8) {
  EXPECT_TRUE(is_utf8(""));
  EXPECT_TRUE(is_utf8("a\u00e9\u20ac\U0001F600"));
  for (const char* bad : {"\xE9", "a\xC3", "\x80", "\xC0\x80", "\xF5\x80\x80\x80", "\xE2\x82"}) {
    EXPECT_FALSE(is_utf8(bad));
  }
}

}  // namespace
}  // namespace plastica::io
