#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include "calibrate/store/fit_store.hpp"
#include "plastica/io/hdf5.hpp"
#include "tests/calibrate/store/synthetic_fits.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::message_of;

class FitStoreErrors : public ::testing::Test {
 protected:
  std::string reading(const std::string& path) const {
    return message_of([&] { read_fit_store(path); });
  }
  void expect_refused(const FitStoreContents& contents) const {
    EXPECT_THROW(write_fit_store(path_, contents), std::logic_error);
    EXPECT_FALSE(std::filesystem::exists(path_));
    EXPECT_FALSE(std::filesystem::exists(path_ + ".part"));
  }

  io::ScratchFolder folder_;
  std::string path_ = folder_.file("out.h5");
  FitStoreContents contents_{{filled_record("a"), filled_record("b")}, {}, ideal_options(), {}};
};

TEST_F(FitStoreErrors, TwoRecordsOfOneNameAreRefused) {
  contents_.records[1].target.name = "a";
  expect_refused(contents_);
}

TEST_F(FitStoreErrors, ParametersThatAreNotThoseOfTheOptionsAreRefused) {
  contents_.records[1].result.parameters.pop_back();
  expect_refused(contents_);
}

TEST_F(FitStoreErrors, ACurveWithoutAStressToEachStrainIsRefused) {
  contents_.records[0].target.raw.stress.pop_back();
  expect_refused(contents_);
}

TEST_F(FitStoreErrors, ATraceWithoutAPointToEachCostIsRefused) {
  contents_.records[0].result.trace.costs.pop_back();
  expect_refused(contents_);
}

TEST_F(FitStoreErrors, AMovedParameterThatTheOptionsDoNotHaveIsRefused) {
  contents_.records[0].result.trace.active = {0, 3};
  expect_refused(contents_);
  contents_.records[0].result.trace.active = {2, 0};
  expect_refused(contents_);
}

TEST_F(FitStoreErrors, ACostOfAFitThatGaveNoneIsRefused) {
  contents_.records[0].result.status = FitStatus::Failed;
  expect_refused(contents_);
}

TEST_F(FitStoreErrors, NumbersThatNoFitHasAreRefusedOnReading) {
  const auto refusal = [&](const auto& spoil) {
    FitStoreContents contents = contents_;
    spoil(contents);
    write_fit_store(path_, contents);
    const std::string message = reading(path_);
    return message.substr(std::min(message.size(), path_.size() + 2));
  };
  using Contents = FitStoreContents;
  EXPECT_EQ(
      refusal([](Contents& c) { c.records[1].result.parameters[0].value = NAN; }).substr(0, 12),
      "/parameters/");
  EXPECT_EQ(refusal([](Contents& c) { c.records[1].result.fitted.stress[0] = INFINITY; }),
            "/curves/fitted/stress = inf: must be finite");
  EXPECT_EQ(refusal([](Contents& c) { c.records[0].result.stages[0].evaluations = -1; }),
            "/stages/evaluations = -1: must be from 0 to 2147483647");
  EXPECT_EQ(refusal([](Contents& c) { c.records[0].result.correlation.pop_back(); }),
            "/correlation: must have a row and a column for each free parameter");
  EXPECT_EQ(refusal([](Contents& c) { c.options.confidence = 1.0; }),
            "/options/confidence = 1: must be above 0 and below 1");
  EXPECT_EQ(refusal([](Contents& c) { c.options.stopping.local_evaluations = -1; }),
            "/options/local_evaluations = -1: must be from 0 to 2147483647");
}

TEST_F(FitStoreErrors, AFileThatIsNotThereIsNamed) {
  EXPECT_NE(reading(folder_.file("none.h5")).find("none.h5: cannot be read"), std::string::npos);
}

TEST_F(FitStoreErrors, AFileOfAnotherFormatIsNamed) {
  EXPECT_EQ(reading(folder_.write("a.h5", "strain,stress")),
            folder_.file("a.h5") + ": is not an HDF5 file");
}

TEST_F(FitStoreErrors, AnHdf5FileOfSomebodyElseIsNamed) {
  {
    auto file = io::Hdf5File::create(path_);
    file.root().write("x", 1.0);
    file.commit();
  }
  EXPECT_EQ(reading(path_),
            path_ + ": is not a result file of Plastica: it has no attribute schema");
}

TEST_F(FitStoreErrors, PartsOfAnotherNumberAreRefused) {
  contents_.records[1].result.held_out.pop_back();
  write_fit_store(path_, contents_);
  EXPECT_EQ(reading(path_),
            path_ + ": /held_out: must have a number for each part of a fit, or none");
}

TEST_F(FitStoreErrors, AnotherSchemaAndAnotherVersionAreNamed) {
  const auto write = [&](const std::string& schema, int version) {
    auto file = io::Hdf5File::create(path_);
    file.root().set_attribute(".", "schema", schema);
    file.root().set_attribute(".", "version", version);
    file.commit();
  };
  write("plastica/sweep", 1);
  EXPECT_EQ(reading(path_), path_ + ": schema = plastica/sweep: must be plastica/fits");
  write("plastica/fits", kFitStoreVersion + 1);
  EXPECT_EQ(reading(path_), path_ + ": version = 12: must be 3 to 11, which this Plastica reads");
  write("plastica/fits", kFitStoreVersion);
  EXPECT_NE(reading(path_).find("/options"), std::string::npos);
}

}  // namespace
}  // namespace plastica::calibrate
