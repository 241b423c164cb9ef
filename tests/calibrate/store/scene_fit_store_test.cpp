#include "calibrate/store/scene_fit_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "plastica/base/check.hpp"
#include "tests/calibrate/store/stored_objects.hpp"
#include "tests/calibrate/store/synthetic_scene_fits.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::message_of;

SceneFitContents scene_contents_of(std::vector<SceneFitRecord> records) {
  SceneFitContents contents;
  contents.records = std::move(records);
  contents.confidence = 0.9;
  contents.inputs = {{"fit.toml", "[fit]\n# Maß: µm\n"}, {"bend.toml", ""}};
  contents.meta.start_time = "2024-05-31T12:00:00Z";
  contents.meta.command_line = "plastica calibrate fit.toml";
  contents.meta.threads = 2;
  return contents;
}

/// A record whose fit did not get as far as its targets.
SceneFitRecord untried_record(const std::string& name) {
  SceneFitRecord record = filled_scene_record(name);
  record.result = {};
  record.result.reason = "no scene";
  return record;
}

std::vector<SceneFitRecord> mixed_scene_records() {
  return {filled_scene_record("a"), failed_scene_record("b"), untried_record("c"),
          filled_scene_record("Ω")};
}

class SceneFitStore : public ::testing::Test {
 protected:
  SceneFitContents round_trip(const SceneFitContents& contents) const {
    write_scene_fit_store(path_, contents);
    return read_scene_fit_store(path_);
  }

  io::ScratchFolder folder_;
  std::string path_ = folder_.file("out.h5");
};

TEST_F(SceneFitStore, GivesBackEveryFieldOfEveryRecordBitByBit) {
  const auto contents = scene_contents_of(mixed_scene_records());
  const auto read = round_trip(contents);
  ASSERT_EQ(read.records.size(), contents.records.size());
  for (std::size_t i = 0; i < read.records.size(); ++i) {
    EXPECT_TRUE(same_bits(read.records[i], contents.records[i])) << i;
  }
}

TEST_F(SceneFitStore, GivesBackEveryWordOfEachEnumeration) {
  std::vector<SceneFitRecord> records;
  for (int word = 0; word <= static_cast<int>(kLastDimension); ++word) {
    SceneFitRecord& record =
        records.emplace_back(filled_scene_record(std::string(1, static_cast<char>('a' + word))));
    record.targets[0].kind = static_cast<Abscissa>(word % 5);
    record.result.targets[0].level = static_cast<Level>(word % 5);
    record.result.parameters[0].judgement->verdict = static_cast<Verdict>(word % 5);
    record.targets[1].abscissa_is = static_cast<Dimension>(word);
    record.result.starts[0].outcome = static_cast<LeastSquaresOutcome>(word % 5);
  }
  const std::vector<SceneFitRecord> read = round_trip(scene_contents_of(records)).records;
  for (std::size_t i = 0; i < records.size(); ++i) EXPECT_TRUE(same_bits(read[i], records[i])) << i;
}

TEST_F(SceneFitStore, HoldsNoFitsAtAll) {
  EXPECT_TRUE(round_trip(scene_contents_of({})).records.empty());
}

TEST_F(SceneFitStore, HoldsLawsBesideEachOtherInTheirOrder) {
  std::vector<SceneFitRecord> records{filled_scene_record("a"), filled_scene_record("a")};
  records[0].result.law = Law::Voce;
  records[1].result.law = Law::Ideal;
  records[1].seconds = 0.5;
  const std::vector<SceneFitRecord> read = round_trip(scene_contents_of(records)).records;
  ASSERT_EQ(read.size(), 2U);
  EXPECT_TRUE(same_bits(read[0], records[1]));
  EXPECT_TRUE(same_bits(read[1], records[0]));
  records[1].result.law = Law::Voce;
  EXPECT_THROW(round_trip(scene_contents_of(records)), std::logic_error) << "two fits of one law";
}

TEST_F(SceneFitStore, HoldsWhatOneLawSearchesAndAnotherTies) {
  std::vector<SceneFitRecord> records{filled_scene_record("a"), filled_scene_record("a")};
  records[1].result.law = Law::Voce;
  FittedParameter& last = records[0].result.parameters.back();
  last.role = ParameterRole::Tied;
  records[0].result.correlation.assign(4, 0.5);
  records[0].result.segments.reset();
  records[0].result.intervals = {};
  const std::vector<SceneFitRecord> read = round_trip(scene_contents_of(records)).records;
  ASSERT_EQ(read.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(same_bits(read[i], records[i])) << i;
}

TEST_F(SceneFitStore, GivesBackConfidenceInputsAndMeta) {
  const auto contents = scene_contents_of({});
  const auto read = round_trip(contents);
  EXPECT_EQ(read.confidence, 0.9);
  ASSERT_EQ(read.inputs.size(), 2U);
  EXPECT_EQ(read.inputs[0].text, contents.inputs[0].text);
  EXPECT_EQ(read.meta.start_time, contents.meta.start_time);
  EXPECT_EQ(read.meta.threads, 2);
}

TEST_F(SceneFitStore, HasTheSameBytesWhateverTheOrderOfTheRecords) {
  auto contents = scene_contents_of(mixed_scene_records());
  write_scene_fit_store(folder_.file("a.h5"), contents);
  std::reverse(contents.records.begin(), contents.records.end());
  write_scene_fit_store(folder_.file("b.h5"), contents);
  EXPECT_TRUE(io::content_of(folder_.file("a.h5")) == io::content_of(folder_.file("b.h5")));
}

TEST_F(SceneFitStore, DiffersBetweenTwoRunsInMetaAlone) {
  auto contents = scene_contents_of(mixed_scene_records());
  write_scene_fit_store(folder_.file("a.h5"), contents);
  contents.meta = io::begin_meta("another command line", 8);
  write_scene_fit_store(folder_.file("b.h5"), contents);
  const auto first = objects_of(folder_.file("a.h5"));
  EXPECT_EQ(first, objects_of(folder_.file("b.h5")));
  contents.records[0].result.starts[0].to[1] += 1.0;
  write_scene_fit_store(folder_.file("c.h5"), contents);
  EXPECT_NE(first, objects_of(folder_.file("c.h5")));
}

TEST_F(SceneFitStore, HasNoDatasetThatItsDocumentationDoesNotName) {
  write_scene_fit_store(path_, scene_contents_of(mixed_scene_records()));
  const std::string page = io::content_of(PLASTICA_SOURCE_DIR "/docs/hdf5.md");
  const std::size_t from = page.find("## The result file of fits through scenes (HDF5)");
  ASSERT_NE(from, std::string::npos);
  const std::string chapter = page.substr(from, page.find("\n## ", from) - from);
  const io::Hdf5File file = io::Hdf5File::open(path_);
  for (const auto& [path, text] : objects_of(path_)) {
    if (file.root().kind(path) == io::Hdf5Kind::Group) continue;
    const std::string name = path.substr(path.rfind('/') + 1);
    EXPECT_NE(chapter.find("`" + name + "`"), std::string::npos) << path;
  }
  for (const std::string& group : file.root().children()) {
    EXPECT_NE(chapter.find("`/" + group), std::string::npos) << group;
  }
}

TEST_F(SceneFitStore, NamesTheUnitsOfColumnsThatMixThem) {
  write_scene_fit_store(path_, scene_contents_of({filled_scene_record("a")}));
  const io::Hdf5File file = io::Hdf5File::open(path_);
  EXPECT_EQ(file.root().read_texts("targets/abscissa_units"),
            (std::vector<std::string>{"m", "rad"}));
  EXPECT_EQ(file.root().read_texts("targets/ordinate_units"),
            (std::vector<std::string>{"N", "N m"}));
}

TEST_F(SceneFitStore, RefusesRecordsThatAreNotWhole) {
  const auto refused = [&](const std::function<void(std::vector<SceneFitRecord>&)>& spoil) {
    std::vector<SceneFitRecord> records{filled_scene_record("a"), filled_scene_record("b")};
    spoil(records);
    EXPECT_THROW(write_scene_fit_store(path_, scene_contents_of(records)), std::logic_error);
    EXPECT_FALSE(std::filesystem::exists(path_));
    EXPECT_FALSE(std::filesystem::exists(path_ + ".target"));
  };
  refused([](auto& all) { all[1].name = "a"; });
  refused([](auto& all) { all[0].weights.pop_back(); });
  refused([](auto& all) { all[0].targets[1].ordinate.pop_back(); });
  refused([](auto& all) { all[0].result.targets.pop_back(); });
  refused([](auto& all) { all[0].result.targets[0].name = "x"; });
  refused([](auto& all) { all[0].result.targets[0].fitted.pop_back(); });
}

TEST_F(SceneFitStore, NamesAFileOfAnotherSchemaOrVersion) {
  const auto write = [&](const std::string& schema, int version) {
    auto file = io::Hdf5File::create(path_);
    file.root().set_attribute(".", "schema", schema);
    file.root().set_attribute(".", "version", version);
    file.commit();
    return message_of([&] { read_scene_fit_store(path_); });
  };
  EXPECT_EQ(write("plastica/fits", 1),
            path_ + ": schema = plastica/fits: must be plastica/scene-fits");
  EXPECT_EQ(write("plastica/scene-fits", kSceneFitVersion + 1),
            path_ + ": version = 12: must be 3 to 11, which this Plastica reads");
  EXPECT_NE(write("plastica/scene-fits", kSceneFitVersion).find("/fits/name"), std::string::npos);
}

TEST_F(SceneFitStore, NamesAParameterThatIsNotInARowOfItsOwn) {
  write_scene_fit_store(path_, scene_contents_of({filled_scene_record("a")}));
  const std::string other = folder_.file("other.h5");
  const std::string row = "parameters/yield_stress/row";
  for (const std::int64_t wrong : {0, 7, -2}) {
    const io::Hdf5File from = io::Hdf5File::open(path_);
    EXPECT_EQ(from.root().read<std::int64_t>(row), std::vector<std::int64_t>{1});
    auto to = io::Hdf5File::create(other);
    io::write_schema(to.root(), kSceneFitSchema, kSceneFitVersion);
    copy_but(from.root(), to.root(), row);
    to.root().write(row, std::vector<std::int64_t>{wrong});
    to.commit();
    EXPECT_EQ(message_of([&] { read_scene_fit_store(other); }),
              other + ": /parameters: must have each parameter of a fit in a row of its own");
  }
}

TEST_F(SceneFitStore, NamesARowOfAFitThatIsNotThere) {
  const auto contents = scene_contents_of({filled_scene_record("a")});
  const auto spoilt = [&](const std::string& table) {
    write_scene_fit_store(path_, contents);
    const std::string other = folder_.file("other.h5");
    {
      const io::Hdf5File from = io::Hdf5File::open(path_);
      auto rows = from.root().read<std::uint64_t>(table + "/fit");
      rows.back() = 1;
      auto to = io::Hdf5File::create(other);
      io::write_schema(to.root(), kSceneFitSchema, kSceneFitVersion);
      copy_but(from.root(), to.root(), table + "/fit");
      to.root().write(table + "/fit", rows);
      to.commit();
    }
    return message_of([&] { read_scene_fit_store(other); });
  };
  for (const std::string table : {"segments", "targets", "starts", "warnings"}) {
    EXPECT_EQ(spoilt(table), folder_.file("other.h5") + ": /" + table +
                                 "/fit: names a fit that is not in the file");
  }
}

TEST_F(SceneFitStore, NamesSegmentsOfAFitThatWasNotRepeated) {
  SceneFitRecord bare = filled_scene_record("b");
  bare.result.segments.reset();
  write_scene_fit_store(path_, scene_contents_of({filled_scene_record("a"), bare}));
  const std::string other = folder_.file("other.h5");
  {
    const io::Hdf5File from = io::Hdf5File::open(path_);
    auto rows = from.root().read<std::uint64_t>("segments/fit");
    rows.back() = 1;
    auto to = io::Hdf5File::create(other);
    io::write_schema(to.root(), kSceneFitSchema, kSceneFitVersion);
    copy_but(from.root(), to.root(), "segments/fit");
    to.root().write("segments/fit", rows);
    to.commit();
  }
  EXPECT_EQ(message_of([&] { read_scene_fit_store(other); }),
            other + ": /segments/fit: names a fit that has none of these");
}

}  // namespace
}  // namespace plastica::calibrate
