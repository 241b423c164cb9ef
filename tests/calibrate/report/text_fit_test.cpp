#include <gtest/gtest.h>

#include <sstream>

#include "calibrate/report/format.hpp"
#include "calibrate/report/text.hpp"
#include "tests/calibrate/report/records.hpp"
#include "tests/support/has.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::has;

using testing::failed_record;
using testing::fitted_record;
using testing::free_parameter;
using testing::parameter_of;
using testing::rejected_record;

/// Whether one of the lines is this one; the test fails with the whole text.
::testing::AssertionResult fit_has_line(const std::string& text, const std::string& wanted) {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line == wanted) return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << "no line '" << wanted << "' in\n" << text;
}

TEST(FitReport, BeginsWithWhatWasFitted) {
  const std::string text = fit_report(fitted_record());
  EXPECT_EQ(text.substr(0, text.find('\n')), "bar-01: fitted");
  EXPECT_TRUE(fit_has_line(text, "  file          targets/bar-01.csv"));
  EXPECT_TRUE(fit_has_line(text, "  test          tension, monotonic"));
  EXPECT_TRUE(fit_has_line(text, "  measure       engineering strain and stress"));
  EXPECT_TRUE(fit_has_line(text, "  samples       209 measured, 209 fitted"));
  EXPECT_TRUE(fit_has_line(text, "  group         temperature 20"));
}

TEST(FitReport, NamesRepairsAndCorrectionsWithTheirSizes) {
  FitRecord record = fitted_record();
  record.target.corrections.push_back({"trim-at-break", true, 1.0, "samples", "fell to zero"});
  record.target.corrections.push_back({"preload-offset", true, 2.5e6, "Pa", "begins at 2.5 MPa"});
  const std::string text = fit_report(record);
  EXPECT_TRUE(
      fit_has_line(text, "  nan-rows          3 samples     rows without a number were left out"));
  EXPECT_TRUE(fit_has_line(
      text, "  toe               -0.021 %      the foot below 40 MPa is softer than the modulus"));
  EXPECT_TRUE(
      fit_has_line(text, "  preload-offset    not done      the curve begins at zero load"));
  EXPECT_TRUE(fit_has_line(text, "  preload-offset    +2.5 MPa      begins at 2.5 MPa"));
  EXPECT_TRUE(fit_has_line(text, "  trim-at-break     1 sample      fell to zero"));
}

TEST(FitReport, ShowsCharacteristicsInEngineeringUnits) {
  const std::string text = fit_report(fitted_record());
  EXPECT_TRUE(
      fit_has_line(text, "  E              70.00 ± 0.21   GPa  regression from 28 to 112 MPa"));
  EXPECT_TRUE(fit_has_line(text, "  Rp0.2         280.00          MPa  proof stress"));
  EXPECT_TRUE(fit_has_line(text, "  Rm            281.40          MPa  largest stress"));
  EXPECT_TRUE(fit_has_line(text, "  strain at Rm   8.000          %"));
  EXPECT_TRUE(
      fit_has_line(text,
                   "  break strain  10.425 ± 0.025  %    total; last intact sample at 10.4 %, by "
                   "fall-to-zero"));
  EXPECT_TRUE(fit_has_line(text, "                10.025 ± 0.025  %    permanent"));
  EXPECT_FALSE(has(text, "ReH"));
}

TEST(FitReport, NamesTheProofStressAfterItsOffset) {
  FitRecord record = fitted_record();
  record.target.characteristics.offset = 0.001;
  record.target.characteristics.reh = 290e6;
  EXPECT_TRUE(has(fit_report(record), "\n  Rp0.1  "));
  EXPECT_TRUE(has(fit_report(record), "upper yield strength"));
}

TEST(FitReport, ShowsEachParameterWithErrorIntervalAndVerdict) {
  const std::string text = fit_report(fitted_record());
  EXPECT_TRUE(
      fit_has_line(text, "                   value ± error         95 % interval  verdict"));
  EXPECT_TRUE(
      fit_has_line(text,
                   "  youngs_modulus   70.00 ± 0.30   GPa   69.41 … 70.59   identified, error "
                   "0.43 %"));
  EXPECT_TRUE(
      fit_has_line(text,
                   "  yield_stress    280.00 ± 0.41   MPa  279.20 … 280.80  identified, error "
                   "0.15 %"));
}

TEST(FitReport, PrintsTheMeasureBesideTheYieldAndTheTotalBesideThePermanentBreak) {
  FitRecord record = fitted_record();
  EXPECT_TRUE(fit_has_line(fit_report(record), "                  engineering stress"));
  EXPECT_TRUE(
      fit_has_line(fit_report(record),
                   "                  permanent strain; the fitted model breaks at 10.42 % in "
                   "total"));
  record.target.measure = Measure::True;
  record.result.break_strain_total.reset();
  EXPECT_TRUE(fit_has_line(fit_report(record), "                  true stress"));
  EXPECT_TRUE(has(fit_report(record), "the fitted model does not break within this curve"));
}

TEST(FitReport, HasAVerdictForEachParameterThatWasFitted) {
  FitRecord record = fitted_record();
  EXPECT_FALSE(has(fit_report(record), "!"));
  EXPECT_FALSE(has(fit_report(record), "Advice"));
  FittedParameter& modulus = parameter_of(record, "youngs_modulus");
  modulus.at_upper = true;
  modulus.upper = 100e9;
  modulus.judgement = {Verdict::AtBound, 100e9};
  FittedParameter& yield = parameter_of(record, "yield_stress");
  yield.identified = false;
  yield.standard_error = FittedParameter::kNone;
  yield.judgement = {Verdict::NotIdentified, 0.0};
  parameter_of(record, "break_strain").judgement = {Verdict::LimitedBySampling, 0.0038};
  const std::string text = fit_report(record);
  EXPECT_TRUE(has(text, "  at bound, upper 100 GPa\n"));
  EXPECT_TRUE(has(text, "  not identified\n"));
  EXPECT_TRUE(has(text, "  limited by sampling, ± 0.38 %\n"));
  EXPECT_TRUE(has(text, "  - youngs_modulus: the best value is at the upper bound"));
  EXPECT_TRUE(has(text, "  - yield_stress: no value is better than another"));
}

TEST(FitReport, ShowsFixedAndTiedParametersWithoutVerdicts) {
  FitRecord record = fitted_record();
  FittedParameter& modulus = parameter_of(record, "youngs_modulus");
  modulus.role = ParameterRole::Fixed;
  modulus.standard_error = FittedParameter::kNone;
  modulus.interval_low = FittedParameter::kNone;
  modulus.interval_high = FittedParameter::kNone;
  modulus.judgement.reset();
  parameter_of(record, "break_strain").role = ParameterRole::Tied;
  parameter_of(record, "break_strain").judgement.reset();
  const std::string text = fit_report(record);
  const std::size_t at = text.find("  youngs_modulus");
  const std::string line = text.substr(at, text.find('\n', at) - at);
  EXPECT_TRUE(line.ends_with("fixed")) << line;
  EXPECT_FALSE(has(line, "…")) << line;
  EXPECT_TRUE(has(text, "tied\n"));
}

TEST(FitReport, ListsStrongCorrelationsOnly) {
  FitRecord record = fitted_record();
  EXPECT_FALSE(has(fit_report(record), "Correlations"));
  record.result.correlation[1] = record.result.correlation[3] = -0.962;
  const std::string text = fit_report(record);
  EXPECT_TRUE(has(text, "Correlations above 0.95\n"));
  EXPECT_TRUE(fit_has_line(text, "  youngs_modulus, yield_stress  -0.962"));
  EXPECT_FALSE(has(text, "yield_stress, break_strain"));
}

// A specimen that does not break says nothing of the break strain: two of three are correlated.
TEST(FitReport, ListsCorrelationsOfThoseThatTheCurveDependsOn) {
  FitRecord record = fitted_record();
  parameter_of(record, "break_strain").identified = false;
  record.result.trace.active = {0, 1};
  record.result.correlation = {1.0, -0.97, -0.97, 1.0};
  EXPECT_TRUE(has(fit_report(record), "  youngs_modulus, yield_stress  -0.970\n"));
}

TEST(FitReport, SaysHowWellTheModelFollowsInAPlainWord) {
  FitRecord record = fitted_record();
  const auto unwrapped = [](std::string text) {
    for (std::size_t at = text.find("\n  "); at != std::string::npos; at = text.find("\n  ", at)) {
      text.replace(at, text.find_first_not_of(' ', at + 1) - at, " ");
    }
    return text;
  };
  EXPECT_TRUE(fit_has_line(fit_report(record),
                           "  misfit        0.39 % of Rm (rms 1.10 MPa): close, ideal plasticity "
                           "follows this curve"));
  record.result.misfit_fraction = 0.03;
  EXPECT_TRUE(has(unwrapped(fit_report(record)),
                  "close, ideal plasticity follows this curve within its noise"));
  record.target.characteristics.rm.reset();
  record.result.misfit_word = "fair";
  EXPECT_TRUE(has(fit_report(record),
                  "3.0 % of the largest stress (rms 1.10 MPa): fair, ideal plasticity"));
  EXPECT_FALSE(has(fit_report(record), "fall after the largest stress"));
  record.result.misfit_word = "poor";
  record.result.law = Law::Linear;
  record.result.runs_test_p = 1e-20;
  const std::string text = unwrapped(fit_report(record));
  EXPECT_TRUE(has(text, "runs test p 1e-20: poor, linear hardening does not describe this curve"));
  EXPECT_TRUE(has(text, "- If it is the fall after the largest stress"));
}

TEST(FitReport, SaysHowFarTheModelGoesRightBelowTheIntervals) {
  const std::string text = fit_report(fitted_record());
  const std::size_t misfit = text.find("\n  misfit ");
  ASSERT_NE(misfit, std::string::npos);
  EXPECT_GT(misfit, text.find("95 % interval"));
  EXPECT_FALSE(has(fit_report(failed_record("a", "why")), "misfit"));
}

TEST(FitReport, SaysWhoseTheLargestStressIs) {
  FitRecord record = fitted_record();
  Characteristics& all = record.target.characteristics;
  const auto says = [&](const char* note) { return has(fit_report(record), note); };
  EXPECT_FALSE(says("the record ends while it rises"));
  all.observed_break.reset();
  EXPECT_FALSE(says("the record ends while it rises")) << "it falls from 8 % on";
  all.strain_at_rm = all.largest_strain;
  EXPECT_TRUE(says("  largest stress; the record ends while it rises\n"));
  record.target.measure = Measure::True;
  EXPECT_TRUE(says("  proof stress, of the true stress\n"));
  // Advice on the fall after the largest stress is of curves that have one.
  record.result.misfit_word = "poor";
  EXPECT_FALSE(says("fall after the largest stress"));
  EXPECT_TRUE(says("- The picture shows what the model misses."));
}

/// What a fit began with is no value of a limit that no break shows.
TEST(FitReport, HasNoBreakStrainWhereNothingBroke) {
  FitRecord record = fitted_record();
  const auto line = [&] {
    const std::string text = fit_report(record);
    const std::string rest = text.substr(text.find("  break_strain ", text.find("Parameters")));
    return rest.substr(0, rest.find('\n'));
  };
  EXPECT_TRUE(has(line(), "10.025")) << line();
  FittedParameter& limit = parameter_of(record, "break_strain");
  limit.identified = false;
  limit.standard_error = FittedParameter::kNone;
  limit.judgement = {Verdict::NotIdentified, 0.0};
  EXPECT_FALSE(has(line(), "10.025")) << line();
  EXPECT_TRUE(has(line(), "not identified")) << line();
  limit.at_upper = true;
  limit.judgement = {Verdict::AtBound, 1.0};
  EXPECT_TRUE(has(line(), "10.025")) << "a bound is one: " << line();
}

TEST(FitReport, LeavesOutTheCharacteristicsThatACurveDoesNotHave) {
  FitRecord record = fitted_record();
  record.target.characteristics = {};
  const std::string text = fit_report(record);
  for (const char* absent : {"Characteristics", "ReH", "proof stress", "largest stress\n"}) {
    EXPECT_FALSE(has(text, absent)) << absent;
  }
  EXPECT_TRUE(has(text, "Parameters"));
}

TEST(FitReport, CountsTheSamplesOfARepairOnce) {
  FitRecord record = fitted_record();
  record.target.repairs = {{"strain-reversals", 1, "1 samples dropped where it ran back"}};
  EXPECT_TRUE(fit_has_line(fit_report(record),
                           "  strain-reversals  1 sample      samples dropped where it ran back"));
}

TEST(FitReport, CountsTheEvaluationsOfEachStage) {
  FitRecord record = fitted_record();
  record.result.stages.push_back({"LN_BOBYQA", "xtol-reached", 18, 1.1e12});
  const std::string text = fit_report(record);
  EXPECT_TRUE(fit_has_line(text, "  objective     f = 1.2 MPa²"));
  EXPECT_TRUE(fit_has_line(text, "  evaluations   142, seed 12345"));
  EXPECT_TRUE(fit_has_line(text, "    GN_CRS2_LM  1 start    60    4 MPa²  maxeval-reached"));
  EXPECT_TRUE(fit_has_line(text, "    LN_BOBYQA   2 starts  100  1.1 MPa²  xtol-reached"));
}

TEST(FitReport, OfARejectedSpecimenGivesTheReason) {
  const std::string text = fit_report(rejected_record("bad", "no column 'Stress'"));
  EXPECT_EQ(text.substr(0, text.find('\n')), "bad: rejected");
  EXPECT_TRUE(fit_has_line(text, "  reason        no column 'Stress'"));
  EXPECT_FALSE(has(text, "Parameters"));
  EXPECT_FALSE(has(text, "misfit"));
}

TEST(FitReport, IsNowhereWiderThanAHundredColumns) {
  FitRecord record = fitted_record(std::string(150, 'n'));
  record.target.warnings = {std::string(150, 'w') + " and " + std::string(150, 'v')};
  record.target.repairs[0].text = "a sentence " + std::string(120, 'r');
  record.result.parameters.push_back(
      free_parameter(std::string(90, 'p'), Dimension::Stress, 123.456e6, 0.5e6, 1e8, 1e-3, 1e12));
  std::istringstream in(fit_report(record));
  for (std::string line; std::getline(in, line);) {
    EXPECT_LE(report::width_of(line), 100U) << line;
  }
}

TEST(FitReport, HasColoursOnlyWhenAskedAndPassesNoneOn) {
  const FitRecord record = fitted_record("bar\x1b[31m");
  EXPECT_FALSE(has(fit_report(record), "\x1b"));
  const std::string text = fit_report(record, {.color = true});
  EXPECT_TRUE(has(text, "\x1b[1mParameters\x1b[0m\n"));
  EXPECT_FALSE(has(text, "bar\x1b"));
}

}  // namespace
}  // namespace plastica::calibrate
