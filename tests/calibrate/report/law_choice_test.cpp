#include "calibrate/report/law_choice.hpp"

#include <gtest/gtest.h>

#include "tests/calibrate/report/records.hpp"

namespace plastica::calibrate {
namespace {

using testing::failed_record;
using testing::fitted_record;

FitRecord fit_of(Law law, double misfit, const std::string& target = "a") {
  FitRecord record = fitted_record(target);
  record.result.law = law;
  record.result.misfit_rms = misfit;
  record.result.misfit_share = misfit / 280e6;
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

TEST(LawChoice, SumsTheTargetsThatAllLawsHaveFitted) {
  // Over both targets ideal would win; over that of all laws linear does.
  std::vector<FitRecord> records{fit_of(Law::Ideal, 9e6, "a"), fit_of(Law::Linear, 1e6, "a"),
                                 fit_of(Law::Ideal, 1e3, "b"), failure_of(Law::Linear, "b")};
  EXPECT_EQ(advised_first(records), 2U);
  EXPECT_EQ(records.front().result.law, Law::Linear);
}

}  // namespace
}  // namespace plastica::calibrate
