#include "calibrate/report/json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/calibrate/report/records.hpp"

namespace plastica::calibrate {
namespace {

using OrderedJson = nlohmann::ordered_json;
using testing::failed_record;
using testing::fitted_record;
using testing::parameter_of;
using testing::rejected_record;

OrderedJson summary_of(const std::vector<FitRecord>& records) {
  return OrderedJson::parse(json_summary(records));
}

std::vector<std::string> keys_of(const OrderedJson& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST(JsonSummary, GivesCharacteristicsAndParametersInSi) {
  const OrderedJson fit = summary_of({fitted_record()})["fits"][0];
  EXPECT_EQ(fit["name"], "bar-01");
  EXPECT_EQ(fit["status"], "fitted");
  EXPECT_EQ(fit["reason"], nullptr);
  EXPECT_EQ(fit["characteristics"]["youngs_modulus"], 70e9);
  EXPECT_EQ(fit["characteristics"]["proof_stress"], 280e6);
  EXPECT_EQ(fit["characteristics"]["reh"], nullptr);
  EXPECT_EQ(fit["characteristics"]["break_strain"], 0.10425);
  const OrderedJson& yield = fit["parameters"]["yield_stress"];
  EXPECT_EQ(yield["value"], 280e6);
  EXPECT_EQ(yield["standard_error"], 0.41e6);
  EXPECT_EQ(yield["lower"], 10e6);
  EXPECT_EQ(yield["upper"], 2e9);
  EXPECT_EQ(yield["at_upper"], false);
  EXPECT_EQ(yield["unit"], "Pa");
  EXPECT_EQ(fit["cost"], 1.2e12);
  EXPECT_EQ(fit["evaluations"], 142);
  EXPECT_EQ(fit["correlation"]["matrix"][0][1], -0.62);
  EXPECT_EQ(fit["repairs"][0]["count"], 3);
  EXPECT_EQ(fit["corrections"][0]["amount"], -0.00021);
}

TEST(JsonSummary, HasItsKeysInAFixedOrder) {
  const OrderedJson all = summary_of({fitted_record()});
  EXPECT_EQ(keys_of(all), (std::vector<std::string>{"fits", "groups", "counts"}));
  const OrderedJson& fit = all["fits"][0];
  const std::vector<std::string> keys = keys_of(fit);
  EXPECT_EQ(std::vector<std::string>(keys.begin(), keys.begin() + 8),
            (std::vector<std::string>{"name", "law", "status", "reason", "file", "test", "measure",
                                      "loading"}));
  const std::vector<std::string> characteristics = keys_of(fit["characteristics"]);
  EXPECT_EQ(std::vector<std::string>(characteristics.begin(), characteristics.begin() + 8),
            (std::vector<std::string>{"youngs_modulus", "youngs_modulus_standard_error",
                                      "modulus_window_low", "modulus_window_high", "modulus_method",
                                      "proof_offset", "proof_stress", "reh"}));
  EXPECT_EQ(keys_of(fit["parameters"]),
            (std::vector<std::string>{"youngs_modulus", "yield_stress", "break_strain"}));
}

TEST(JsonSummary, OfARejectedOrFailedSpecimenHasNoNumbersOfAFit) {
  const OrderedJson all =
      summary_of({rejected_record("a", "the file is empty"), failed_record("b", "no number")});
  EXPECT_EQ(all["fits"][0]["status"], "rejected");
  EXPECT_EQ(all["fits"][0]["reason"], "the file is empty");
  EXPECT_EQ(all["fits"][0]["parameters"], OrderedJson::object());
  EXPECT_EQ(all["fits"][0]["characteristics"]["rm"], nullptr);
  EXPECT_EQ(all["fits"][0]["cost"], nullptr);
  EXPECT_EQ(all["fits"][1]["status"], "failed");
  EXPECT_EQ(all["fits"][1]["misfit_fraction"], nullptr);
  EXPECT_EQ(all["counts"]["rejected"], 1);
  EXPECT_EQ(all["counts"]["failed"], 1);
}

TEST(JsonSummary, WritesNullForWhatIsNotFinite) {
  FitRecord record = fitted_record();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  parameter_of(record, "yield_stress").standard_error = nan;
  record.result.correlation[1] = nan;
  record.result.cost = HUGE_VAL;
  const OrderedJson fit = summary_of({record})["fits"][0];
  EXPECT_EQ(fit["parameters"]["yield_stress"]["standard_error"], nullptr);
  EXPECT_EQ(fit["correlation"]["matrix"][0][1], nullptr);
  EXPECT_EQ(fit["cost"], nullptr);
}

// A specimen that does not break says nothing of the break strain: two of three are correlated.
TEST(JsonSummary, HasTheCorrelationOfThoseThatTheCurveDependsOn) {
  FitRecord record = fitted_record();
  record.result.trace.active = {0, 1};
  record.result.correlation = {1.0, -0.62, -0.62, 1.0};
  const OrderedJson correlation = summary_of({record})["fits"][0]["correlation"];
  EXPECT_EQ(correlation["parameters"], OrderedJson({"youngs_modulus", "yield_stress"}));
  EXPECT_EQ(correlation["matrix"][0][1], -0.62);
}

TEST(JsonSummary, SummarizesTheGroups) {
  const OrderedJson groups = summary_of({fitted_record("a", 280e6), fitted_record("b", 290e6),
                                         fitted_record("c", 200e6, "150")})["groups"];
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0]["group"]["temperature"], "20");
  EXPECT_EQ(groups[0]["parameters"]["yield_stress"]["n"], 2);
  EXPECT_EQ(groups[0]["parameters"]["yield_stress"]["mean"], 285e6);
  EXPECT_NEAR(groups[0]["parameters"]["yield_stress"]["standard_deviation"].get<double>(),
              5e6 * std::sqrt(2.0), 1.0);
  EXPECT_EQ(groups[1]["parameters"]["yield_stress"]["standard_deviation"], nullptr);
}

TEST(JsonSummary, EscapesWhatUsersWrite) {
  FitRecord record = rejected_record("a\"b\\c\n", "bytes \xFF are no text");
  const OrderedJson fit = summary_of({record})["fits"][0];
  EXPECT_EQ(fit["name"], "a\"b\\c\n");
  EXPECT_EQ(fit["reason"], "bytes \xEF\xBF\xBD are no text");
}

TEST(JsonSummary, OfNothingIsStillOneObject) {
  EXPECT_EQ(json_summary({}, -1),
            "{\"fits\":[],\"groups\":[],\"counts\":{\"fitted\":0,\"rejected\":0,\"failed\":0,"
            "\"unusable\":0}}\n");
}

}  // namespace
}  // namespace plastica::calibrate
