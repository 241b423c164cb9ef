#include "calibrate/report/csv_export.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "plastica/io/csv.hpp"
#include "tests/calibrate/report/records.hpp"

namespace plastica::calibrate {
namespace {

using testing::fitted_record;
using testing::parameter_of;
using testing::rejected_record;

std::string specimens_of(const std::vector<FitRecord>& records) {
  std::ostringstream out;
  write_fits_csv(out, records);
  return out.str();
}

std::string curves_of(const std::vector<FitRecord>& records) {
  std::ostringstream out;
  write_curves_csv(out, records);
  return out.str();
}

TEST(SpecimenTable, IsReadBackBitForBit) {
  FitRecord record = fitted_record("bar-01", 280e6 / 3.0);
  record.result.held_out = {0.0001, 0.0007};
  const io::CsvTable table =
      io::CsvTable::parse(specimens_of({record, rejected_record("bar-02", "empty")}), "t.csv");
  ASSERT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.number(0, *table.find("fit.yield_stress")), 280e6 / 3.0);
  EXPECT_EQ(table.number(0, *table.find("proof_stress")), 280e6 / 3.0);
  EXPECT_EQ(table.units()[*table.find("proof_stress")], "Pa");
  EXPECT_EQ(table.number(0, *table.find("fit.break_strain.standard_error")), 0.00025);
  EXPECT_EQ(table.cell(0, *table.find("group.temperature")), "20");
  EXPECT_EQ(table.number(0, *table.find("evaluations")), 142.0);
  EXPECT_NEAR(table.number(0, *table.find("held_out")), 0.02, 1e-15);
}

// Worked by hand: 3-4-5.
TEST(SpecimenTable, HasWhatAnotherTestOfTheSameSpecimenWouldMove) {
  FitRecord record = fitted_record();
  parameter_of(record, "break_strain").noise_error = 3e-4;
  parameter_of(record, "break_strain").sampling_error = 4e-4;
  const io::CsvTable table = io::CsvTable::parse(specimens_of({record}), "t.csv");
  EXPECT_NEAR(table.number(0, *table.find("fit.break_strain.scatter_error")), 5e-4, 1e-18);
}

TEST(SpecimenTable, LeavesEmptyWhatASpecimenDoesNotHave) {
  FitRecord record = fitted_record();
  parameter_of(record, "yield_stress").standard_error = std::numeric_limits<double>::quiet_NaN();
  const io::CsvTable table =
      io::CsvTable::parse(specimens_of({record, rejected_record("bar-02", "empty")}), "t.csv");
  EXPECT_EQ(table.cell(0, *table.find("reh")), "");
  EXPECT_EQ(table.cell(0, *table.find("fit.yield_stress.standard_error")), "");
  EXPECT_EQ(table.cell(1, *table.find("status")), "rejected");
  EXPECT_EQ(table.cell(1, *table.find("reason")), "empty");
  EXPECT_EQ(table.cell(1, *table.find("fit.yield_stress")), "");
  EXPECT_EQ(table.cell(1, *table.find("cost")), "");
}

TEST(SpecimenTable, QuotesSeparatorsQuotesAndLineEnds) {
  const std::string text = specimens_of({rejected_record("a,\"b\"", "two\nlines")});
  EXPECT_NE(
      text.find("\n\"a,\"\"b\"\"\",ideal,rejected,\"two\nlines\",\"targets/a,\"\"b\"\".csv\","),
      std::string::npos)
      << text;
}

TEST(CurveTable, PairsMeasuredAndFittedSamples) {
  FitRecord record = rejected_record("bar", "");
  record.target.corrected = {{0.0, 0.001, 0.002}, {0.0, 70e6, 130e6}};
  record.result.fitted = {{0.0, 0.001, 0.002, 0.0025}, {1.0, 69e6, 131e6, 0.0}};
  EXPECT_EQ(curves_of({record}),
            "specimen,strain [1],stress_measured [Pa],stress_fitted [Pa]\n"
            "bar,0,0,1\n"
            "bar,0.001,70000000,69000000\n"
            "bar,0.002,130000000,131000000\n"
            "bar,0.0025,,0\n");
}

TEST(CurveTable, FallsWhereTheModelBreaks) {
  FitRecord record = rejected_record("bar", "");
  record.target.corrected = {{0.0, 0.001, 0.002}, {0.0, 70e6, 130e6}};
  record.result.fitted = {{0.0, 0.001, 0.002, 0.003}, {0.0, 70e6, 131e6, 0.0}};
  record.result.break_strain_total = 0.0025;
  EXPECT_EQ(curves_of({record}),
            "specimen,strain [1],stress_measured [Pa],stress_fitted [Pa]\n"
            "bar,0,0,0\n"
            "bar,0.001,70000000,70000000\n"
            "bar,0.002,130000000,131000000\n"
            "bar,0.0025,,131000000\n"
            "bar,0.0025,,0\n"
            "bar,0.003,,0\n");
}

TEST(CurveTable, PutsABreakBetweenSamplesInItsPlace) {
  FitRecord record = rejected_record("bar", "");
  record.target.corrected = {{0.0, 0.001, 0.002}, {0.0, 70e6, 0.0}};
  record.result.fitted = {{0.0, 0.001, 0.0015, 0.002}, {0.0, 70e6, 100e6, 0.0}};
  EXPECT_EQ(curves_of({record}),
            "specimen,strain [1],stress_measured [Pa],stress_fitted [Pa]\n"
            "bar,0,0,0\n"
            "bar,0.001,70000000,70000000\n"
            "bar,0.0015,,100000000\n"
            "bar,0.002,0,0\n");
}

TEST(CurveTable, WritesTheSamplesAsReadOfARejectedSpecimen) {
  FitRecord record = rejected_record("b,1", "bad");
  record.target.raw = {{0.0, std::numeric_limits<double>::quiet_NaN()}, {1.0, 2.0}};
  EXPECT_EQ(curves_of({record}),
            "specimen,strain [1],stress_measured [Pa],stress_fitted [Pa]\n"
            "\"b,1\",0,1,\n"
            "\"b,1\",,2,\n");
}

}  // namespace
}  // namespace plastica::calibrate
