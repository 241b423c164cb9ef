#include "sweeps/report/spread.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/sweeps/run_record.hpp"

namespace plastica::sweeps {
namespace {

TEST(Quantile, IsStraightBetweenNeighbours) {
  const std::vector<double> sorted{1.0, 2.0, 4.0};
  EXPECT_EQ(quantile(sorted, 0.0), 1.0);
  EXPECT_EQ(quantile(sorted, 0.25), 1.5);
  EXPECT_EQ(quantile(sorted, 0.75), 3.0);
  EXPECT_EQ(quantile(sorted, 1.0), 4.0);
  EXPECT_EQ(quantile(std::vector<double>{7.0}, 0.3), 7.0);
}

TEST(RankCorrelation, SeesWhatRisesHoweverSteeply) {
  const std::vector<double> x{3.0, 1.0, 2.0, 4.0};
  EXPECT_DOUBLE_EQ(rank_correlation(x, std::vector<double>{30.0, -1.0, 0.0, 1e9}).value_or(0), 1.0);
  EXPECT_DOUBLE_EQ(rank_correlation(x, std::vector<double>{-3, -1, -2, -4}).value_or(0), -1.0);
}

TEST(RankCorrelation, GivesEqualNumbersTheirMeanRank) {
  // Ranks 0, 1.5, 1.5, 3 and 0, 1, 2, 3: 4.5 over the root of 4.5 times 5.
  const auto found =
      rank_correlation(std::vector<double>{1, 2, 2, 3}, std::vector<double>{1, 2, 3, 4});
  EXPECT_NEAR(found.value_or(0.0), 4.5 / 4.743416490252569, 1e-15);
}

TEST(RankCorrelation, IsNoneOfWhatDoesNotVary) {
  EXPECT_FALSE(rank_correlation(std::vector<double>{1, 1}, std::vector<double>{1, 2}).has_value());
}

TEST(SpreadReport, CountsFailuresWithTheirFirstReasons) {
  SweepRecord record = two_groups();
  for (const std::size_t i : {0U, 2U, 3U}) {
    record.results[i] = CaseResult{};
    record.results[i].status = Status::Rejected;
    record.results[i].reason = i == 3 ? "other" : "one";
  }
  const std::string text = spread_report(record);
  EXPECT_NE(text.find("\n3 rejected:\n  - one\n  - other\n"), std::string::npos) << text;
}

TEST(SpreadReport, NamesTheCasesAtBothEnds) {
  SweepRecord record = two_groups();
  for (std::size_t i = 0; i < 6; ++i) record.results[i].value = 1.0 + static_cast<double>(i % 4);
  EXPECT_NE(spread_report(record).find("tip, end is least in case " + record.ids[0] +
                                       ", largest in case " + record.ids[3]),
            std::string::npos);
}

}  // namespace
}  // namespace plastica::sweeps
