#include "plastica/io/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "plastica/base/check.hpp"
#include "plastica/io/text_file.hpp"
#include "tests/lib/io/message_from.hpp"
#include "tests/lib/io/scratch_folder.hpp"

namespace plastica::io {
namespace {

using Names = std::vector<std::string>;
namespace fs = std::filesystem;

mode_t mode_of(const std::string& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0);
  return status.st_mode & 07777U;
}

TEST(OutputFile, TakesItsPlaceWholeWhenCommitted) {
  const ScratchFolder folder;
  const std::string path = folder.write("a", "old");
  OutputFile file(path, Overwrite::Allowed);
  file.write("ne");
  file.write("w");
  EXPECT_EQ(content_of(path), "old");
  file.commit();
  EXPECT_EQ(content_of(path), "new");
  EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(OutputFile, LeavesNothingBehindWithoutACommit) {
  const ScratchFolder folder;
  const std::string path = folder.write("a", "old");
  {
    OutputFile begun(path, Overwrite::Allowed);
    begun.write("new");
    const OutputFile moved = std::move(begun);
  }
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(OutputFile, WritesBesideFilesAndLinksThatHaveTheNamesOfItsOwn) {
  const ScratchFolder folder;
  const std::string path = folder.file("a");
  const std::string first = OutputFile(path, Overwrite::Allowed).part();
  const std::string target = folder.write("target", "mine");
  fs::create_symlink(target, first);
  folder.write("a.part", "mine too");
  write_text_file(path, "new");
  EXPECT_EQ(content_of(path), "new");
  EXPECT_EQ(content_of(target), "mine");
  EXPECT_TRUE(fs::is_symlink(first));
  EXPECT_EQ(content_of(folder.file("a.part")), "mine too");
}

TEST(OutputFile, KeepsTheModeOfWhatItReplaces) {
  const ScratchFolder folder;
  const std::string path = folder.write("a", "old");
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  write_text_file(path, "new");
  EXPECT_EQ(mode_of(path), 0640U);
  const mode_t mask = ::umask(0027);
  write_text_file(folder.file("b"), "new");
  ::umask(mask);
  EXPECT_EQ(mode_of(folder.file("b")), 0640U);
}

TEST(OutputFile, KeepsAFileThatHasAppearedAndItsOwnContentToo) {
  const ScratchFolder folder;
  const std::string path = folder.file("a");
  OutputFile file(path, Overwrite::Refused);
  file.write("mine");
  folder.write("a", "theirs");
  const std::string part = file.part();
  EXPECT_EQ(message_from<StorageError>([&] { file.commit(); }),
            path +
                ": has appeared since the run began, and is left as it is; the result is kept as " +
                part);
  EXPECT_EQ(content_of(path), "theirs");
  EXPECT_EQ(content_of(part), "mine");
}

TEST(OutputFile, ReplacesNoLinkFolderOrPipe) {
  const ScratchFolder folder;
  const std::string target = folder.write("target", "theirs");
  const std::string link = folder.file("link");
  fs::create_symlink(target, link);
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(no_output_reason(link), "is a link: name the file that it leads to");
  EXPECT_EQ(no_output_reason(pipe), "cannot be written: it is a named pipe");
  EXPECT_EQ(no_output_reason(folder.file(".")), "cannot be written: it is a folder");
  EXPECT_EQ(no_output_reason("/dev/null"), "cannot be written: it is a device");
  EXPECT_EQ(no_output_reason(target), "");
  EXPECT_EQ(no_output_reason(folder.file("none")), "");
  for (const std::string& path : {link, pipe}) {
    EXPECT_THROW(write_text_file(path, "new"), StorageError) << path;
  }
  EXPECT_EQ(content_of(target), "theirs");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(OutputFile, HasRoomForTheLongestName) {
  const ScratchFolder folder;
  const std::string path = folder.file(std::string(255, 'n'));
  write_text_file(path, "new");
  EXPECT_EQ(content_of(path), "new");
  EXPECT_THROW(write_text_file(folder.file(std::string(256, 'n')), "new"), StorageError);
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(OutputLock, IsOneRunsAtATimeAndGoesWithIt) {
  const ScratchFolder folder;
  const std::string path = folder.file("a.h5");
  {
    const OutputLock lock(path);
    EXPECT_EQ(folder.names(), Names{"a.h5.lock"});
    EXPECT_EQ(message_from<StorageError>([&] { const OutputLock second(path); }),
              path + ": is in use by another run");
    EXPECT_EQ(folder.names(), Names{"a.h5.lock"});
  }
  EXPECT_TRUE(folder.names().empty());
  const OutputLock again(path);
}

TEST(OutputLock, OfARunThatWasKilledIsFree) {
  const ScratchFolder folder;
  const std::string path = folder.file("a.h5");
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const OutputLock lock(path);
    ::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(folder.names(), Names{"a.h5.lock"});
  { const OutputLock lock(path); }
  EXPECT_TRUE(folder.names().empty());
}

TEST(OutputLock, IsNoLink) {
  const ScratchFolder folder;
  const std::string target = folder.write("target", "theirs");
  fs::create_symlink(target, folder.file("a.h5.lock"));
  EXPECT_THROW(OutputLock(folder.file("a.h5")), InputError);
  EXPECT_EQ(content_of(target), "theirs");
}

TEST(OutputLock, IsNoFileOfAnother) {
  const ScratchFolder folder;
  const std::string mine = folder.write("a.h5.lock", "mine");
  EXPECT_EQ(message_from<InputError>([&] { const OutputLock lock(folder.file("a.h5")); }),
            mine +
                ": is a file of another kind in the place of the lock: move it, or name another "
                "output");
  EXPECT_EQ(content_of(mine), "mine");
  {
    const OutputLock lock(folder.file("b.h5"));
    fs::remove(folder.file("b.h5.lock"));
    folder.write("b.h5.lock", "mine, too");
  }
  EXPECT_EQ(content_of(folder.file("b.h5.lock")), "mine, too");
}

}  // namespace
}  // namespace plastica::io
