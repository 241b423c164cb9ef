#include "sweeps/store/sweep_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sweeps/report/text.hpp"
#include "sweeps/run/result_bytes.hpp"
#include "sweeps/store/sweep_rules.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"
#include "tests/sweeps/run_record.hpp"

namespace plastica::sweeps {
namespace {

const std::string kAxes = segments_axis("[4, 8, 16]") +
                          "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half_joint', 'equal']\n"
                          "[[axis]]\nfield = 'rules.hinge_length'\nvalues = ['unset', '1 m']\n";

class SweepStoreTest : public ::testing::Test {
 protected:
  SweepRecord read_back(const SweepRecord& record) {
    write_sweep_store(path_, record);
    return read_sweep_store(path_);
  }
  io::ScratchFolder folder_;
  std::string path_ = folder_.file("out.h5");
};

TEST_F(SweepStoreTest, GivesBackWhatWasWritten) {
  const SweepRecord record = record_of(kAxes + kTipError + "scale = '1 m'\n");
  const SweepRecord read = read_back(record);
  EXPECT_EQ(read.name, record.name);
  EXPECT_EQ(read.scene_name, "cantilever");
  EXPECT_EQ(read.against, "theory:elastica");
  EXPECT_EQ(read.error_scale, 1.0);
  EXPECT_EQ(read.refined, 0U);
  EXPECT_EQ(read.quantity.unit, "m");
  EXPECT_EQ(read.quantity.dimension, Dimension::Length);
  EXPECT_EQ(read.ids, record.ids);
  EXPECT_EQ(read.position, record.position);
  ASSERT_EQ(read.axes.size(), 3U);
  for (std::size_t a = 0; a < 3; ++a) {
    EXPECT_EQ(read.axes[a].field, record.axes[a].field);
    EXPECT_EQ(read.axes[a].values, record.axes[a].values);
  }
  ASSERT_EQ(read.results.size(), 12U);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(bytes_of(read.results[i]), bytes_of(record.results[i]));
  }
  EXPECT_EQ(read.comparison.error, record.comparison.error);
  EXPECT_EQ(read.comparison.reference, record.comparison.reference);
  ASSERT_EQ(read.groups.size(), 4U);
  EXPECT_EQ(read.groups[3].label, record.groups[3].label);
  EXPECT_EQ(read.groups[3].cases, record.groups[3].cases);
  EXPECT_EQ(read.groups[3].size, record.groups[3].size);
  EXPECT_EQ(sweep_report(read), sweep_report(record));
}

TEST_F(SweepStoreTest, GivesBackTheWarningsOfCases) {
  SweepRecord record = record_of(kAxes + kTipError);
  for (CaseResult& result : record.results) result.warnings.reset();
  record.results[0].warnings.emplace();  // watched, without any
  record.results[3].warnings = {"one", "another"};
  record.results[11].warnings = {"a third"};
  const SweepRecord read = read_back(record);
  for (std::size_t i = 0; i < read.results.size(); ++i) {
    EXPECT_EQ(read.results[i].warnings, record.results[i].warnings) << i;
  }
}

TEST_F(SweepStoreTest, GivesBackCurvesAndFailedCases) {
  const SweepRecord record = record_of(
      "[set]\nsolver.steps = 2\nsolver.smallest_step = 1\n"
      "[[axis]]\nfield = 'solver.max_iterations'\nvalues = [1, 25]\n"
      "[error]\nprobe = 'tip'\ntake = 'curve'\n");
  const SweepRecord read = read_back(record);
  EXPECT_TRUE(read.results[0].curve.empty());
  EXPECT_EQ(read.results[0].status, Status::NotConverged);
  EXPECT_EQ(read.results[1].curve, record.results[1].curve);
  EXPECT_EQ(read.results[1].time.size(), 3U);
  EXPECT_TRUE(read.groups.empty());
}

TEST_F(SweepStoreTest, GivesBackTheReferencesOfCurves) {
  const SweepRecord record =
      record_of("[set]\nsolver.steps = 2\n" + segments_axis("[4, 8]") +
                "[error]\nprobe = 'tip'\ntake = 'curve'\nagainst = 'finest'\n");
  const SweepRecord read = read_back(record);
  EXPECT_EQ(read.comparison.reference_curve[0], record.results[1].curve);
  EXPECT_TRUE(read.comparison.reference_curve[1].empty()) << "the finest is the reference";
}

TEST_F(SweepStoreTest, GivesBackWhatErrorsDoNotHaveInThem) {
  SweepRecord record = record_of(
      "[[axis]]\nfield = 'beam.segments'\nvalues = [4, 8]\nzip = 'a'\n"
      "[[axis]]\nfield = 'solver.steps'\nvalues = [20, 10]\nzip = 'a'\n"
      "[error]\nprobe = 'tip'\nagainst = 'finest'\n");
  ASSERT_EQ(record.comparison.lacks[0], "solver.steps");
  record.comparison.reference_error[0] = 0.125;
  record.comparison.coarser_in[0] = "solver.steps";
  record.results[0].break_joint = 3;
  record.results[0].break_place = 0.75;
  const SweepRecord read = read_back(record);
  EXPECT_EQ(read.comparison.lacks, record.comparison.lacks);
  EXPECT_EQ(read.comparison.coarser_in, record.comparison.coarser_in);
  EXPECT_EQ(read.comparison.reference_error, record.comparison.reference_error);
  EXPECT_EQ(read.comparison.notes, record.comparison.notes);
  EXPECT_EQ(read.results[0].break_joint, 3);
  EXPECT_EQ(read.results[0].break_place, 0.75);
  EXPECT_EQ(read.results[1].break_joint, -1);
}

TEST_F(SweepStoreTest, GivesEarlierResultsById) {
  const SweepRecord record = record_of(segments_axis("[4, 8]") + kTipError);
  write_sweep_store(path_, record);
  const EarlierResults earlier = earlier_results(path_);
  ASSERT_EQ(earlier.size(), 2U);
  EXPECT_EQ(bytes_of(earlier.at(record.ids[1])), bytes_of(record.results[1]));
}

TEST_F(SweepStoreTest, RefusesResultsThatNoSweepHas) {
  const SweepRecord whole = record_of(kAxes + kTipError);
  const auto refusal = [&](const auto& spoil) {
    SweepRecord record = whole;
    spoil(record);
    const std::string message = plastica::testing::message_of([&] { read_back(record); });
    return message.substr(std::min(message.size(), path_.size() + 2));
  };
  EXPECT_EQ(refusal([](SweepRecord& record) { record.results[3].segments = -1; }),
            "/cases/segments = -1: must be from 0 to 9007199254740992");
  EXPECT_EQ(refusal([](SweepRecord& record) { record.results[3].iterations = kMaxWork / 2; }),
            "/cases/iterations = 4503599627370496: must be fewer for so many segments");
  EXPECT_EQ(refusal([](SweepRecord& record) { record.results[3].value = INFINITY; }),
            "/cases/value = inf: must be finite");
  EXPECT_EQ(refusal([](SweepRecord& record) { record.groups[1].size[0] = 0.0; }),
            "/groups/size/values = 0: must be above 0");
  EXPECT_EQ(refusal([](SweepRecord& record) { record.groups[1].size.pop_back(); }),
            "/groups: does not go with the number of cases");
  EXPECT_EQ(refusal([](SweepRecord& record) { record.comparison.lacks.pop_back(); }),
            "/cases/error_lacks: does not go with the number of cases");
  EXPECT_EQ(refusal([](SweepRecord& record) {
              record.comparison.lacks[2] = "solver.time_step";
              record.refined.reset();
            }),
            "/cases/error_lacks: does not go without an axis that refines");
  EXPECT_EQ(refusal([](SweepRecord& record) { record.comparison.reference_error[0] = -1.0; }),
            "/cases/reference_error = -1: must be at least 0");
  EXPECT_EQ(refusal([](SweepRecord& record) { record.timed_runs = -1; }),
            "/sweep/timed_runs = -1: must be a number from 0 on");
}

TEST_F(SweepStoreTest, RefusesAFileThatIsNone) {
  { io::Hdf5File::create(path_).commit(); }
  EXPECT_EQ(plastica::testing::message_of([&] { read_sweep_store(path_); }),
            path_ + ": is not a result file of Plastica: it has no attribute schema");
}

}  // namespace
}  // namespace plastica::sweeps
