#include "plastica/io/result_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"

namespace plastica::io {
namespace {

using plastica::testing::message_of;

class OutputPath : public ::testing::Test {
 protected:
  ScratchFolder folder_;
  std::string path_ = folder_.file("out.h5");
};

TEST_F(OutputPath, AnOutputThatExistsIsRefusedUnlessForced) {
  folder_.write("out.h5", "");
  EXPECT_EQ(message_of([&] { check_output_path(path_, false); }),
            path_ + ": exists already: use --force to overwrite it");
  EXPECT_NO_THROW(check_output_path(path_, true));
}

TEST_F(OutputPath, AnOutputWithoutAFolderIsRefused) {
  const std::string path = folder_.file("none/out.h5");
  EXPECT_EQ(message_of([&] { check_output_path(path, true); }),
            path + ": cannot be written: there is no folder " + folder_.file("none"));
  folder_.write("file", "");
  EXPECT_EQ(message_of([&] { check_output_path(folder_.file("file/out.h5"), false); }),
            folder_.file("file/out.h5") + ": cannot be written: " + folder_.file("file") +
                " is no folder");
}

TEST_F(OutputPath, AnOutputThatIsAFolderIsRefused) {
  std::filesystem::create_directory(path_);
  EXPECT_EQ(message_of([&] { check_output_path(path_, true); }),
            path_ + ": cannot be written: it is a folder");
}

TEST_F(OutputPath, AnOutputWithoutANameIsRefused) {
  EXPECT_EQ(message_of([&] { check_output_path("", false); }), "output: must name a file");
}

TEST_F(OutputPath, AnOutputInAFolderClosedToWritingIsRefused) {
  // Also the system's administrator cannot write here.
  if (!std::filesystem::is_directory("/proc/self")) GTEST_SKIP() << "no /proc/self";
  EXPECT_THROW(check_output_path("/proc/self/out.h5", false), InputError);
}

TEST_F(OutputPath, AnOutputInTheWorkingFolderIsFine) {
  EXPECT_NO_THROW(check_output_path("surely-not-there.h5", false));
}

using ResultFile = OutputPath;

TEST_F(ResultFile, SaysItsSchema) {
  Hdf5File file = Hdf5File::create(path_);
  write_schema(file.root(), "plastica/test", 3);
  file.commit();
  EXPECT_EQ(schema_of(path_), "plastica/test");
  const Hdf5File read = Hdf5File::open(path_);
  EXPECT_NO_THROW(check_schema(read.root(), "plastica/test", 3));
  EXPECT_EQ(message_of([&] { check_schema(read.root(), "plastica/other", 3); }),
            path_ + ": schema = plastica/test: must be plastica/other");
  EXPECT_EQ(message_of([&] { check_schema(read.root(), "plastica/test", 4); }),
            path_ + ": version = 3: must be 4, which this Plastica reads");
}

TEST_F(ResultFile, OfAnotherProgramHasNoSchema) {
  Hdf5File file = Hdf5File::create(path_);
  file.root().write("x", 1.0);
  file.commit();
  EXPECT_EQ(message_of([&] { schema_of(path_); }),
            path_ + ": is not a result file of Plastica: it has no attribute schema");
}

TEST_F(ResultFile, KeepsInputsMetaAndSetup) {
  RunMeta meta = begin_meta("plastica simulate", 2);
  EXPECT_EQ(meta.threads, 2);
  EXPECT_EQ(meta.start_time.size(), 20U);
  meta.seconds = 1.5;
  plastica::Setup setup;
  setup.scene.material.yield_stress = 123e6;
  setup.scene.hinge_length = 0.02;
  Hdf5File file = Hdf5File::create(path_);
  write_inputs(file.root(), {{"a.toml", "x = 1"}, {"b.csv", ""}});
  write_meta(file.root(), meta);
  Hdf5Group options = file.root().group("options");
  write_setup(options, setup);
  file.commit();

  const Hdf5File read = Hdf5File::open(path_);
  const auto inputs = read_inputs(read.root());
  ASSERT_EQ(inputs.size(), 2U);
  EXPECT_EQ(inputs[0].name + inputs[0].text + inputs[1].name, "a.tomlx = 1b.csv");
  const RunMeta found = read_meta(read.root());
  EXPECT_EQ(found.start_time, meta.start_time);
  EXPECT_EQ(found.seconds, 1.5);
  EXPECT_EQ(found.versions, meta.versions);
  plastica::Setup again;
  read_setup(read.root().open_group("options"), again);
  for (const Field& field : fields()) EXPECT_EQ(field.get(again), field.get(setup)) << field.path;
}

}  // namespace
}  // namespace plastica::io
