#include "sweeps/report/json.hpp"

#include <gtest/gtest.h>

#include <limits>

#include <nlohmann/json.hpp>

#include "tests/sweeps/run_record.hpp"

namespace plastica::sweeps {
namespace {

using Json = nlohmann::json;

TEST(SweepJson, HasTheCasesTheGroupsAndTheCounts) {
  SweepRecord record = two_groups();
  record.results[5].status = Status::LimitLoad;
  const Json all = Json::parse(sweep_json(record));
  EXPECT_EQ(all["statuses"], (Json{{"completed", 5}, {"limit-load", 1}}));
  EXPECT_EQ(all["refined"], "beam.segments");
  EXPECT_EQ(all["quantity"]["unit"], "m");
  ASSERT_EQ(all["groups"].size(), 2U);
  const Json& group = all["groups"][0];
  EXPECT_EQ(group["label"], "rules.end_rule = half_joint");
  EXPECT_NEAR(group["order"].get<double>(), 2.0, 0.1);
  EXPECT_GT(group["correlation"].get<double>(), 0.999);
  EXPECT_NEAR(group["three_finest"]["extrapolated"].get<double>(), -0.7353, 1e-3);
  EXPECT_GT(group["three_finest"]["gci"].get<double>(), 0.0);
  EXPECT_EQ(group["three_finest"]["safety_factor"], 1.25);
  EXPECT_EQ(group["cases"], (Json{record.ids[0], record.ids[2], record.ids[4]}));
  ASSERT_EQ(all["cases"].size(), 6U);
  const Json& row = all["cases"][3];
  EXPECT_EQ(row["axes"], (Json{{"beam.segments", 8.0}, {"rules.end_rule", "equal"}}));
  EXPECT_EQ(row["value"].get<double>(), record.results[3].value);
  EXPECT_EQ(row["level"], "planar");
}

TEST(SweepJson, HasNullForWhatThereIsNot) {
  SweepRecord record = two_groups();
  record.results[0].last_value = std::numeric_limits<double>::infinity();
  record.results[0].value.reset();
  record.comparison.error[0].reset();
  const Json row = Json::parse(sweep_json(record))["cases"][0];
  for (const char* key : {"value", "error", "reason", "standard_error", "last_value"}) {
    EXPECT_TRUE(row[key].is_null()) << key;
  }
}

}  // namespace
}  // namespace plastica::sweeps
