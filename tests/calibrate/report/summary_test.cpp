#include "calibrate/report/summary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/calibrate/report/records.hpp"

namespace plastica::calibrate {
namespace {

using testing::failed_record;
using testing::fitted_record;
using testing::parameter_of;
using testing::rejected_record;

const GroupStatistic* find(const std::vector<GroupStatistic>& all, const std::string& name) {
  const auto at =
      std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.name == name; });
  return at == all.end() ? nullptr : &*at;
}

TEST(Statistics, AreMeanAndSampleStandardDeviation) {
  const Statistic statistic = statistic_of({2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0});
  EXPECT_EQ(statistic.n, 8U);
  EXPECT_DOUBLE_EQ(statistic.mean, 5.0);
  EXPECT_DOUBLE_EQ(statistic.standard_deviation.value_or(0.0), std::sqrt(32.0 / 7.0));
}

TEST(Statistics, OfOneNumberHaveNoDeviation) {
  const Statistic statistic = statistic_of({3.0});
  EXPECT_EQ(statistic.mean, 3.0);
  EXPECT_FALSE(statistic.standard_deviation.has_value());
  EXPECT_EQ(statistic_of({}).n, 0U);
}

TEST(Statistics, LeaveOutWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(statistic_of({1.0, nan, 3.0, HUGE_VAL}).n, 2U);
  EXPECT_EQ(statistic_of({1.0, nan, 3.0, HUGE_VAL}).mean, 2.0);
}

TEST(Statistics, HaveTheSameBitsInEveryOrder) {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(std::sin(i) * std::exp(i % 37));
  const Statistic before = statistic_of(values);
  std::reverse(values.begin() + 100, values.end());
  std::rotate(values.begin(), values.begin() + 333, values.end());
  const Statistic after = statistic_of(values);
  EXPECT_EQ(before.mean, after.mean);
  EXPECT_EQ(before.standard_deviation, after.standard_deviation);
}

// The modulus of a torsion test is G, and true stress is another one.
TEST(Groups, PartTestsAndMeasures) {
  std::vector<FitRecord> records = {fitted_record("a", 280e6, "20"),
                                    fitted_record("b", 280e6, "20"),
                                    fitted_record("c", 280e6, "20")};
  records[1].target.test = calibrate::Test::Torsion;
  std::vector<GroupSummary> groups = summarize_groups(records);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(group_label(groups[0].group), "temperature 20, test tension");
  EXPECT_EQ(group_label(groups[1].group), "temperature 20, test torsion");
  records[1].target.test = calibrate::Test::Tension;
  records[2].target.measure = Measure::True;
  groups = summarize_groups(records);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(group_label(groups[1].group), "temperature 20, measure true");
}

TEST(Groups, AreInTheOrderOfTheirNumbers) {
  const std::vector<FitRecord> records = {
      fitted_record("a", 280e6, "150"), fitted_record("b", 280e6, "20"),
      fitted_record("c", 280e6, "room"), fitted_record("d", 280e6, "-40"),
      fitted_record("e", 290e6, "20")};
  const std::vector<GroupSummary> groups = summarize_groups(records);
  ASSERT_EQ(groups.size(), 4U);
  EXPECT_EQ(group_label(groups[0].group), "temperature -40");
  EXPECT_EQ(group_label(groups[1].group), "temperature 20");
  EXPECT_EQ(group_label(groups[2].group), "temperature 150");
  EXPECT_EQ(group_label(groups[3].group), "temperature room");
  EXPECT_EQ(groups[1].specimens(), 2U);
  EXPECT_EQ(group_label({}), "all specimens");
}

TEST(Groups, CountEachStatusAndAverageWhatThereIs) {
  std::vector<FitRecord> records = {fitted_record("a", 280e6), fitted_record("b", 290e6),
                                    failed_record("c", "no number"), rejected_record("d", "empty")};
  records[3].target.characteristics.rm = 1e9;  // of a curve that nobody may believe
  const std::vector<GroupSummary> groups = summarize_groups(records);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].fitted, 2U);
  EXPECT_EQ(groups[0].failed, 1U);
  EXPECT_EQ(groups[0].rejected, 1U);
  const GroupStatistic* yield = find(groups[0].parameters, "yield_stress");
  ASSERT_NE(yield, nullptr);
  EXPECT_EQ(yield->statistic.n, 2U);
  EXPECT_DOUBLE_EQ(yield->statistic.mean, 285e6);
  const GroupStatistic* rm = find(groups[0].characteristics, "rm");
  ASSERT_NE(rm, nullptr);
  EXPECT_EQ(rm->statistic.n, 3U);
  EXPECT_EQ(find(groups[0].characteristics, "reh"), nullptr);
}

TEST(Groups, DoNotAverageAModulusThatIsHardlyKnown) {
  std::vector<FitRecord> records = {fitted_record("a"), fitted_record("b"), fitted_record("c")};
  Characteristics& doubtful = records[1].target.characteristics;
  doubtful.youngs_modulus = 300e9;
  doubtful.youngs_modulus_stderr = 40e9;
  const GroupSummary group = summarize_groups(records).front();
  const GroupStatistic* modulus = find(group.characteristics, "youngs_modulus");
  ASSERT_NE(modulus, nullptr);
  EXPECT_EQ(modulus->statistic.n, 2U);
  EXPECT_DOUBLE_EQ(modulus->statistic.mean, *records[0].target.characteristics.youngs_modulus);
}

TEST(Groups, LeaveOutFixedAndUnidentifiedParameters) {
  std::vector<FitRecord> records = {fitted_record("a"), fitted_record("b")};
  for (FitRecord& record : records) {
    parameter_of(record, "youngs_modulus").role = ParameterRole::Fixed;
  }
  parameter_of(records[1], "break_strain").identified = false;
  const GroupSummary group = summarize_groups(records).front();
  EXPECT_EQ(find(group.parameters, "youngs_modulus"), nullptr);
  EXPECT_EQ(find(group.parameters, "break_strain")->statistic.n, 1U);
  EXPECT_EQ(find(group.parameters, "yield_stress")->statistic.n, 2U);
}

// A bound is where a search ended, not what a specimen has.
TEST(Groups, LeaveOutParametersAtBounds) {
  std::vector<FitRecord> records = {fitted_record("a", 280e6), fitted_record("b", 290e6),
                                    fitted_record("c", 400e6)};
  for (FittedParameter& p : records[2].result.parameters) {
    p.at_upper = p.name() == "yield_stress";
  }
  const std::vector<GroupSummary> groups = summarize_groups(records);
  const GroupStatistic* yield = find(groups[0].parameters, "yield_stress");
  ASSERT_NE(yield, nullptr);
  EXPECT_EQ(yield->statistic.n, 2U);
  EXPECT_DOUBLE_EQ(yield->statistic.mean, 285e6);
}

TEST(Counts, AreOfAllRecords) {
  const std::vector<FitRecord> records = {fitted_record(), rejected_record("b", "x"),
                                          rejected_record("c", "y")};
  const Counts counts = count_statuses(records);
  EXPECT_EQ(counts.fitted, 1U);
  EXPECT_EQ(counts.rejected, 2U);
  EXPECT_EQ(counts.failed, 0U);
}

TEST(Summary, HasIntervalsOfMeansWhereThereAreTwo) {
  std::vector<FitRecord> records;
  for (int i = 0; i < 9; ++i) {
    records.push_back(fitted_record("bar-" + std::to_string(i), 280e6 + 4e6 * (i - 4)));
  }
  const GroupSummary group = summarize_groups(records).front();
  const GroupStatistic* yield = find(group.parameters, "yield_stress");
  ASSERT_NE(yield, nullptr);
  ASSERT_TRUE(yield->mean_interval);
  const double error = *yield->statistic.standard_deviation / 3.0;
  EXPECT_NEAR(yield->mean_interval->standard_error, error, 1e-6 * error);
  EXPECT_NEAR(yield->mean_interval->high - 280e6, 2.30600 * error, 1e-4 * error);  // t(0.975; 8)
  EXPECT_TRUE(find(group.characteristics, "rm")->mean_interval);
  records.resize(1);
  EXPECT_FALSE(find(summarize_groups(records).front().parameters, "yield_stress")->mean_interval);
}

TEST(Summary, LeavesOpenWhereBreaksLieBetweenTheSameSamples) {
  std::vector<FitRecord> records = {fitted_record("a"), fitted_record("b")};
  for (FitRecord& record : records) {
    parameter_of(record, "break_strain").sampling_error = 0.00025 / std::sqrt(3.0);
  }
  const GroupSummary group = summarize_groups(records).front();
  const auto half = [](const GroupStatistic* entry) {
    return 0.5 * (entry->mean_interval->high - entry->mean_interval->low);
  };
  EXPECT_NEAR(half(find(group.parameters, "break_strain")), 0.95 * 0.00025, 1e-9);
  // The samples of both lie at 10.4 and 10.45 %.
  EXPECT_NEAR(half(find(group.characteristics, "break_strain")), 0.95 * 0.00025, 1e-9);
  EXPECT_NEAR(half(find(group.characteristics, "break_strain_plastic")), 0.95 * 0.00025, 1e-9);
  EXPECT_EQ(half(find(group.parameters, "yield_stress")), 0.0);
}

/// Of 276, 278, 280, 282, 284 and 320 MPa the median is 281, that of the distances from it 3: the
/// last one's score is 0.6745 * 39/3.
TEST(Summary, NamesSpecimensOutOfLine) {
  std::vector<FitRecord> records{fitted_record("far", 320e6)};
  for (int i = 0; i < 5; ++i) {
    records.push_back(fitted_record("bar-" + std::to_string(i), 276e6 + 2e6 * i));
  }
  const GroupSummary group = summarize_groups(records).front();
  const GroupStatistic* yield = find(group.parameters, "yield_stress");
  ASSERT_NE(yield, nullptr);
  ASSERT_EQ(yield->out_of_line.size(), 1U);
  EXPECT_EQ(yield->out_of_line[0].record, 0U);
  EXPECT_DOUBLE_EQ(yield->out_of_line[0].value, 320e6);
  EXPECT_DOUBLE_EQ(yield->out_of_line[0].median, 281e6);
  EXPECT_NEAR(yield->out_of_line[0].score, 0.6745 * 13.0, 1e-9);
  EXPECT_EQ(find(group.characteristics, "proof_stress")->out_of_line.size(), 1U);
  // All have the same modulus.
  EXPECT_TRUE(find(group.characteristics, "youngs_modulus")->out_of_line.empty());
  // In a group of its own it is in line with itself.
  records[0].target.group = {{"temperature", "200"}};
  for (const GroupSummary& one : summarize_groups(records)) {
    EXPECT_TRUE(find(one.parameters, "yield_stress")->out_of_line.empty());
  }
}

TEST(Summary, TakesNoDifferenceBelowWhatIsKnownForOneOutOfLine) {
  std::vector<FitRecord> records;
  for (int i = 0; i < 6; ++i) {
    records.push_back(fitted_record("bar-" + std::to_string(i), 280e6 + 0.1 * i));
    parameter_of(records.back(), "break_strain").value = 0.1 + 1e-5 * i;
  }
  // By round-off, and by less than half the interval between two samples.
  parameter_of(records[5], "yield_stress").value += 100.0;
  parameter_of(records[5], "break_strain").value += 2e-4;
  parameter_of(records[5], "break_strain").sampling_error = 0.00025 / std::sqrt(3.0);
  GroupSummary group = summarize_groups(records).front();
  EXPECT_TRUE(find(group.parameters, "yield_stress")->out_of_line.empty());
  EXPECT_TRUE(find(group.parameters, "break_strain")->out_of_line.empty());
  parameter_of(records[5], "yield_stress").value += 1e6;
  parameter_of(records[5], "break_strain").value += 2e-4;
  group = summarize_groups(records).front();
  EXPECT_EQ(find(group.parameters, "yield_stress")->out_of_line.size(), 1U);
  EXPECT_EQ(find(group.parameters, "break_strain")->out_of_line.size(), 1U);
}

}  // namespace
}  // namespace plastica::calibrate
