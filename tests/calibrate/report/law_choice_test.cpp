#include "calibrate/report/law_choice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "tests/calibrate/report/records.hpp"
#include "tests/calibrate/report/scene_records.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::message_of;
using testing::failed_record;
using testing::fitted_record;

FitRecord fit_of(Law law, double misfit, const std::string& target = "a") {
  FitRecord record = fitted_record(target);
  record.result.law = law;
  record.result.misfit_rms = misfit;
  record.result.misfit_fraction = misfit / 280e6;
  record.result.effective_samples = 200.0;
  return record;
}

FitRecord failure_of(Law law, const std::string& target = "a") {
  FitRecord record = failed_record(target, "no curve");
  record.result.law = law;
  return record;
}

TEST(LawChoice, PutsTheAdvisedLawToTheFront) {
  std::vector<FitRecord> records{fit_of(Law::Ideal, 9e6), fit_of(Law::Linear, 1e6),
                                 fit_of(Law::Voce, 8e6)};
  EXPECT_EQ(advised_first(records), 1U);
  EXPECT_EQ(records.front().result.law, Law::Linear);
}

TEST(LawChoice, GoesOnWithoutALawThatFailed) {
  std::vector<FitRecord> records{failure_of(Law::Ideal), fit_of(Law::Linear, 9e6),
                                 fit_of(Law::Voce, 1e6)};
  EXPECT_EQ(advised_first(records), 1U);
  EXPECT_EQ(records.front().result.law, Law::Voce);
}

TEST(LawChoice, SaysWhyALawFailed) {
  const std::vector<FitRecord> records{failure_of(Law::Ideal), fit_of(Law::Linear, 9e6)};
  const std::string text = laws_report(std::span<const FitRecord>(records));
  EXPECT_NE(text.find("ideal: no curve"), std::string::npos) << text;
  // So do tables of many specimens.
  std::vector<FitRecord> many;
  for (int i = 0; i < 9; ++i) {
    many.push_back(failure_of(Law::Ideal, "s" + std::to_string(i)));
    many.push_back(fit_of(Law::Linear, 9e6, "s" + std::to_string(i)));
  }
  const std::string all = laws_report(std::span<const FitRecord>(many));
  EXPECT_NE(all.find("s8, ideal: no curve"), std::string::npos) << all;
}

TEST(LawChoice, HoldsResidualsAgainstAStatedNoise) {
  std::vector<FitRecord> records{fit_of(Law::Ideal, 2e6), fit_of(Law::Linear, 1e6)};
  std::vector<FittedParameter>& parameters = records[1].result.parameters;
  parameters.push_back(parameters[1]);
  parameters.back().path = "material.hardening.tangent_modulus";
  EXPECT_EQ(compare_laws(std::span<const FitRecord>(records)).laws[0].fit.law, Law::Linear);
  for (FitRecord& record : records) record.result.noise = 50e6;
  const LawComparison laws = compare_laws(std::span<const FitRecord>(records));
  EXPECT_EQ(laws.laws[0].fit.law, Law::Ideal);
}

TEST(LawChoice, CountsTheWorkForStarts) {
  std::vector<FitRecord> records{fit_of(Law::Ideal, 2e6), fit_of(Law::Linear, 1e6)};
  records[1].result.simpler_evaluations = 58;
  const LawComparison laws = compare_laws(std::span<const FitRecord>(records));
  EXPECT_EQ(laws.laws[0].fit.evaluations, 200U);
}

TEST(LawChoice, TakesTheAdvisedLawWhereNoneIsNamed) {
  const std::vector<FitRecord> records{fit_of(Law::Ideal, 9e6), fit_of(Law::Linear, 1e6)};
  ASSERT_EQ(of_law(records, "").size(), 1U);
  EXPECT_EQ(of_law(records, "").front().result.law, Law::Linear);
  EXPECT_EQ(of_law(records, "ideal").front().result.law, Law::Ideal);
  EXPECT_EQ(message_of([&] { (void)of_law(records, "voce"); }),
            "--law = voce: is no law of this file; it has ideal, linear");
}

SceneFitRecord scene_fit_of(Law law, double cost) {
  SceneFitRecord record = testing::lone_scene_record("bar", 205e9, 380e6);
  record.result.law = law;
  TargetFit& fit = record.result.targets[0];
  fit.cost = cost;
  const std::vector<double>& measured = record.targets[0].ordinate;
  const double off = std::sqrt(cost / static_cast<double>(measured.size()));
  for (std::size_t i = 0; i < measured.size(); ++i) {
    fit.fitted[i] = measured[i] + (i % 2 == 0 ? off : -off);
  }
  return record;
}

TEST(LawChoice, IsTheSameThroughScenes) {
  std::vector<SceneFitRecord> records{scene_fit_of(Law::Ideal, 900.0),
                                      scene_fit_of(Law::Voce, 9.0)};
  EXPECT_TRUE(compares_laws(std::span<const SceneFitRecord>(records)));
  EXPECT_EQ(label_of(records[0], true), "bar:ideal");
  EXPECT_EQ(advised_first(records), 1U);
  EXPECT_EQ(records.front().result.law, Law::Voce);
  records.front().result.search_runs = 61;
  records.front().seconds = 1.5;
  const std::string text = laws_report(std::span<const SceneFitRecord>(records));
  EXPECT_TRUE(text.starts_with("Laws for bar, by BIC\n")) << text;
  for (const char* said : {"misfit, rms", "  N ", "of the largest value", "runs of scenes", " 61",
                           "time", "1.5", "advised   voce: BIC lower by"}) {
    EXPECT_NE(text.find(said), std::string::npos) << said << '\n' << text;
  }
  EXPECT_EQ(laws_report(std::span<const SceneFitRecord>(records).first(1)), "");
}

TEST(LawChoice, SumsTheTargetsThatAllLawsHaveFitted) {
  // Over both targets ideal would win; over that of all laws linear does.
  std::vector<FitRecord> records{fit_of(Law::Ideal, 9e6, "a"), fit_of(Law::Linear, 1e6, "a"),
                                 fit_of(Law::Ideal, 1e3, "b"), failure_of(Law::Linear, "b")};
  EXPECT_EQ(advised_first(records), 2U);
  EXPECT_EQ(records.front().result.law, Law::Linear);
}

}  // namespace
}  // namespace plastica::calibrate
