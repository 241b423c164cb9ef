#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "plastica/io/hdf5.hpp"
#include "tests/lib/io/message_from.hpp"
#include "tests/lib/io/scratch_folder.hpp"

namespace plastica::io {
namespace {

using Strings = std::vector<std::string>;

/// A file with one of each kind, for asking it the wrong things.
class Hdf5Errors : public ::testing::Test {
 protected:
  Hdf5Errors() : path_(folder_.file("a.h5")) {
    Hdf5File file = Hdf5File::create(path_);
    file.root().write("x", std::vector<double>{1.0, 2.0});
    file.root().write_texts("t", Strings{"a", "b"});
    file.root().group("g");
    file.root().write("rows/values", std::vector<double>{1.0});
    file.root().write("rows/offsets", std::vector<std::uint64_t>{0, 2});
    file.root().set_attribute("x", "units", "Pa");
    file.root().set_attribute("x", "scale", 0.5);
    file.root().set_attribute("x", "names", Strings{"a", "b"});
    file.commit();
  }

  template <typename Action>
  std::string on_reading(const Action& action) {
    const Hdf5File file = Hdf5File::open(path_);
    return message_from<InputError>([&] { action(file.root()); });
  }

  ScratchFolder folder_;
  std::string path_;
};

TEST_F(Hdf5Errors, AFileThatIsMissingOrSomethingElseIsBadInput) {
  EXPECT_EQ(message_from<InputError>([] { Hdf5File::open("no/such.h5"); }),
            "no/such.h5: cannot be read: No such file or directory");
  const std::string text = folder_.write("t.h5", "Strain,Stress\n");
  EXPECT_EQ(message_from<InputError>([&] { Hdf5File::open(text); }),
            text + ": is not an HDF5 file");
}

TEST_F(Hdf5Errors, ACutOffFileIsSaidToBeDamaged) {
  const std::string whole = content_of(path_);
  const std::string cut = folder_.write("cut.h5", whole.substr(0, whole.size() / 2));
  const std::string message = message_from<InputError>([&] { Hdf5File::open(cut); });
  EXPECT_TRUE(message.starts_with(cut + ": is cut off: ")) << message;
}

TEST_F(Hdf5Errors, WhatIsNotThereIsNamed) {
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.read<double>("y"); }),
            path_ + ": /y: is not in this file");
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.open_group("x"); }),
            path_ + ": /x: is not a group of this file");
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.open_group("g").read<double>("."); }),
            path_ + ": /g: is not a dataset");
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.text_attribute("x", "note"); }),
            path_ + ": /x: has no attribute note");
}

TEST_F(Hdf5Errors, AnotherTypeOrShapeIsNamed) {
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.read<double>("t"); }),
            path_ + ": /t: does not hold numbers");
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.read<std::int64_t>("x"); }),
            path_ + ": /x: does not hold integers");
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.read_texts("x"); }),
            path_ + ": /x: does not hold text");
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.read_scalar<double>("x"); }),
            path_ + ": /x: is not a single value");
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.read_text("t"); }),
            path_ + ": /t: is not a single value");
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.read_ragged<double>("rows"); }),
            path_ + ": /rows: has offsets that do not fit its values");
}

TEST_F(Hdf5Errors, AnotherShapeIsNamed) {
  const std::array<std::size_t, 1> three{3};
  const std::array<std::size_t, 2> table{Hdf5Group::kAnyExtent, 2};
  EXPECT_EQ(on_reading([&](const Hdf5Group& root) { root.read_array<double>("x", three); }),
            path_ + ": /x: must have the extents 3");
  EXPECT_EQ(on_reading([&](const Hdf5Group& root) { root.read_array<double>("x", table); }),
            path_ + ": /x: must have the extents n x 2");
}

TEST_F(Hdf5Errors, IntegersThatHdf5WouldChangeAreRefused) {
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.read<std::int64_t>("rows/offsets"); }),
            path_ + ": /rows/offsets: does not hold signed integers of 64 bits");
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.read<std::uint8_t>("rows/offsets"); }),
            path_ + ": /rows/offsets: does not hold unsigned integers of 8 bits");
}

TEST_F(Hdf5Errors, AnAttributeOfAnotherTypeIsNamed) {
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.texts_attribute("x", "scale"); }),
            path_ + ": /x: attribute scale is not text");
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.text_attribute("x", "names"); }),
            path_ + ": /x: attribute names is not a single text");
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.real_attribute("x", "units"); }),
            path_ + ": /x: attribute units is not a single number");
  EXPECT_EQ(on_reading([](const Hdf5Group& root) { root.integer_attribute("x", "scale"); }),
            path_ + ": /x: attribute scale is not a single integer");
}

TEST_F(Hdf5Errors, AFolderThatIsNotThereIsAFailureOfStorage) {
  const std::string path = folder_.file("none/a.h5");
  EXPECT_EQ(message_from<StorageError>([&] { Hdf5File::create(path); }),
            path + ": cannot be written: No such file or directory");
}

TEST_F(Hdf5Errors, WritingTwiceToAPathIsRefused) {
  Hdf5File file = Hdf5File::create(path_);
  file.root().write("x", 1.0);
  EXPECT_EQ(message_from<StorageError>([&] { file.root().write("x", 2.0); }),
            path_ + ": cannot write /x: it exists already");
  EXPECT_EQ(message_from<StorageError>([&] { file.root().group("x"); }),
            path_ + ": cannot create group /x: there is a dataset");
}

TEST_F(Hdf5Errors, TextThatHdf5WouldCutIsRefused) {
  Hdf5File file = Hdf5File::create(path_);
  const std::string text("a\0b", 3);
  EXPECT_EQ(message_from<StorageError>([&] { file.root().write_text("t", text); }),
            path_ + ": cannot write /t: the text has a zero byte");
  EXPECT_EQ(message_from<StorageError>([&] { file.root().write_texts("t", Strings{text}); }),
            path_ + ": cannot write /t: the text has a zero byte");
  EXPECT_EQ(message_from<StorageError>([&] { file.root().set_attribute(".", "n", text); }),
            path_ + ": cannot write /@n: the text has a zero byte");
}

TEST_F(Hdf5Errors, Hdf5sInnermostMessageIsPassedOn) {
  Hdf5File file = Hdf5File::open(path_);
  EXPECT_EQ(message_from<StorageError>([&] { file.root().write("new", 1.0); }),
            path_ + ": cannot create /new: no write intent on file");
}

TEST_F(Hdf5Errors, ProgrammingErrorsAreLogicErrors) {
  Hdf5File file = Hdf5File::create(path_);
  const std::vector<double> five(5, 0.0);
  EXPECT_THROW(file.root().write_table("t", std::span<const double>(five), 2), std::logic_error);
  file.commit();
  EXPECT_THROW(file.commit(), std::logic_error);
}

TEST_F(Hdf5Errors, AFullDiskIsReportedAndLeavesTheOlderFile) {
  const std::string before = content_of(path_);
  // In a process of its own: HDF5 keeps a file that it could not write open until the end.
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{20'000, 20'000};
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string message = message_from<StorageError>([&] {
      Hdf5File file = Hdf5File::create(path_);
      file.root().write("big", std::vector<double>(10'000, 1.0));
      file.commit();
    });
    const bool named = message.starts_with(path_ + ": cannot ") &&
                       message.find("File too large") != std::string::npos;
    const bool tidy = folder_.names() == std::vector<std::string>{"a.h5"};
    _exit((named ? 0 : 1) + (tidy ? 0 : 2));
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_TRUE(content_of(path_) == before);
}

}  // namespace
}  // namespace plastica::io
