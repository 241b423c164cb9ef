#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "calibrate/report/plot.hpp"
#include "calibrate/report/plot_data.hpp"
#include "plastica/base/check.hpp"
#include "tests/calibrate/report/records.hpp"
#include "tests/support/has.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::has;

using testing::fitted_record;
using testing::parameter_of;
using testing::rejected_record;

std::string message_of(const std::vector<FitRecord>& records, const PlotRequest& request) {
  try {
    plot_script(records, request);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PlotScript, OfOneSpecimenShowsCurveFitYieldAndBreak) {
  const std::string script = plot_script(std::vector{fitted_record()}, {});
  EXPECT_TRUE(has(script, "set title 'bar-01'.\"\\n\".'E 70.00 ± 0.30 GPa"));
  EXPECT_TRUE(has(script, "σ_y 280.00 ± 0.41 MPa"));
  EXPECT_TRUE(has(script, "ε_break 10.025 ± 0.025 % permanent"));
  EXPECT_TRUE(has(script, "set xlabel 'engineering strain [%]'"));
  for (const char* name : {"'measured'", "'fitted'", "'yield, fitted'", "'break, measured'"}) {
    EXPECT_TRUE(has(script, std::string("title ") + name)) << name;
  }
  EXPECT_TRUE(has(script, "\n10.425 280 \n10.425 0 \n") || has(script, "\n10.425 280\n10.425 0\n"))
      << "the fall at the break, in % and MPa";
}

TEST(PlotScript, OfOneSpecimenShowsABreakBeyondItsSamples) {
  FitRecord record = fitted_record();
  record.result.break_strain_total = 0.2;
  const std::string script = plot_script(std::vector{record}, {});
  EXPECT_TRUE(has(script, "set xrange [0:20.6]")) << script;
  record.result.break_strain_total.reset();
  record.target.characteristics.observed_break = BreakObservation{0.3, 280e6, 0.3, "fall-to-zero"};
  EXPECT_TRUE(has(plot_script(std::vector{record}, {}), "set xrange [0:30.9]"));
}

// The record's noise is 1.5 MPa sin(12.9898 i) on top of its fit.
TEST(PlotScript, OfResidualsShowsMeasuredMinusFitted) {
  const std::string script = plot_script(std::vector{fitted_record()}, {.what = "residuals"});
  EXPECT_TRUE(has(script, "stress, measured - fitted [MPa]"));
  EXPECT_TRUE(has(script, "'rms misfit'"));
  EXPECT_TRUE(has(script, "'yield, fitted'"));
  std::istringstream lines(script);
  std::size_t found = 0;
  for (std::string line; std::getline(lines, line);) {
    double strain = 0.0, residual = 0.0;
    std::istringstream row(line);
    if (!(row >> strain >> residual)) continue;
    const double i = std::round(strain / 0.05);
    if (std::fabs(residual - 1.5 * std::sin(12.9898 * i)) < 1e-5) ++found;
  }
  EXPECT_EQ(found, 209U);
  EXPECT_EQ(message_of({rejected_record("a", "x")}, {.what = "residuals"}),
            "--what = residuals: a was not fitted");
}

// Samples at 0.2 and 0.3 %: a line between them would fall before the model breaks at 0.28 %.
TEST(PlotScript, DrawsTheFallWhereTheModelBreaks) {
  FitRecord record = fitted_record();
  record.result.fitted = {{0.0, 0.001, 0.002, 0.003}, {0.0, 70e6, 140e6, 0.0}};
  record.result.break_strain_total = 0.0028;
  const std::string script = plot_script(std::vector{record}, {});
  EXPECT_TRUE(has(script, "\n0.2 140 \n0.28 140 \n0.28 0 \n0.3 0 \n")) << script;
}

TEST(PlotScript, OfManySpecimensHasAPanelPerGroupAndTheMean) {
  const std::vector<FitRecord> records = {fitted_record("a"), fitted_record("b", 290e6),
                                          fitted_record("c", 200e6, "150")};
  const std::string script = plot_script(records, {});
  EXPECT_TRUE(has(script, "set title 'temperature 20, 2 specimens'"));
  EXPECT_TRUE(has(script, "set title 'c'"));
  EXPECT_TRUE(has(script, "title 'mean to first break'"));
  EXPECT_TRUE(has(script, "unset multiplot"));
}

/// A stress that is a thousand times too large counts in no mean, and would leave the others a
/// line.
TEST(PlotScript, OfManySpecimensLeavesOutOneThatIsImplausible) {
  std::vector<FitRecord> records = {fitted_record("a"), fitted_record("b", 290e6),
                                    fitted_record("c")};
  const std::string without = plot_script(std::span(records).first(2), {});
  for (double& stress : records[2].target.corrected.stress) stress *= 1e3;
  records[2].target.status = TargetStatus::Implausible;
  records[2].result = {};
  const std::string with = plot_script(records, {});
  EXPECT_TRUE(has(with, "set title 'temperature 20, 2 of 3'")) << with.substr(0, 2000);
  EXPECT_FALSE(has(with, " 280000"));
  for (const char* line : {"set xrange", "set yrange"}) {
    const auto of = [&](const std::string& script) {
      const std::size_t at = script.find(line);
      return script.substr(at, script.find('\n', at) - at);
    };
    EXPECT_EQ(of(with), of(without));
  }
}

TEST(PlotScript, OfTestsOfTwoKindsHasTheNamesOfEach) {
  std::vector<FitRecord> records = {fitted_record("a"), fitted_record("b")};
  records[1].target.test = plastica::calibrate::Test::Torsion;
  const std::string script = plot_script(records, {});
  EXPECT_TRUE(has(script, "'engineering strain [%]'")) << script.substr(0, 3000);
  EXPECT_TRUE(has(script, "'engineering shear strain [%]'"));
  EXPECT_TRUE(has(script, "'engineering shear stress [MPa]'"));
}

TEST(PlotScript, OfParametersLeavesOutWhatNoCurveDetermines) {
  FitRecord record = fitted_record("a");
  ASSERT_TRUE(has(plot_script(std::vector{record}, {.what = "parameters"}), "break_strain"));
  for (FittedParameter& parameter : record.result.parameters) {
    if (parameter.name() == "break_strain") parameter.identified = false;
  }
  const std::string script = plot_script(std::vector{record}, {.what = "parameters"});
  EXPECT_FALSE(has(script, "break_strain"));
  EXPECT_TRUE(has(script, "yield_stress"));
}

TEST(PlotScript, OfParametersHasAPanelForEachFreeOne) {
  std::vector<FitRecord> records = {fitted_record("a"), fitted_record("b", 290e6)};
  for (FitRecord& record : records) {
    parameter_of(record, "youngs_modulus").role = ParameterRole::Fixed;
  }
  const std::string script = plot_script(records, {.what = "parameters"});
  EXPECT_TRUE(has(script, "set title 'yield_stress [MPa]'"));
  EXPECT_TRUE(has(script, "set title 'break_strain [%]'"));
  EXPECT_FALSE(has(script, "youngs_modulus"));
  EXPECT_TRUE(has(script, "set xtics ('20' 1)"));
}

TEST(PlotScript, LetsNoTextOfAUserLeaveItsQuotes) {
  FitRecord record = fitted_record("it's \"_{x}\\\n`id`\nsystem('id')");
  record.target.group = {{"l'ot", "5%d'\nplot x"}};
  EXPECT_TRUE(has(plot_script(std::vector{record}, {}),
                  "set title 'it''s \"_{x}\\ `id` system(''id'')'.\"\\n\"."));
  const std::string parameters = plot_script(std::vector{record}, {.what = "parameters"});
  EXPECT_TRUE(has(parameters, "('5%%d'' plot x' 1)"));
  EXPECT_TRUE(has(parameters, "set xlabel 'l''ot'"));
}

TEST(PlotScript, LeavesOutOfTheTitleWhatIsNotIdentified) {
  FitRecord record = fitted_record();
  parameter_of(record, "break_strain").identified = false;
  EXPECT_FALSE(has(plot_script(std::vector{record}, {}), "ε_break"));
}

TEST(PlotScript, OfARejectedSpecimenShowsItsSamplesAndTheReason) {
  FitRecord record = rejected_record("bad", "turns back");
  EXPECT_EQ(message_of({record}, {}), "--case = bad: has no curve to draw: turns back");
  record.target.raw = fitted_record().target.raw;
  const std::string script = plot_script(std::vector{record}, {});
  EXPECT_TRUE(has(script, "rejected: turns back"));
  EXPECT_FALSE(has(script, "title 'fitted'"));
}

TEST(PlotScript, OfRejectedSpecimensAloneSaysThatThereIsNothingToDraw) {
  const std::vector<FitRecord> rejected = {rejected_record("a", "has no stress"),
                                           rejected_record("b", "is empty")};
  for (const char* output : {"a.svg", "-"}) {
    EXPECT_EQ(message_of(rejected, {.output = output}),
              "--what = overview: no specimen has a curve to draw; a: has no stress");
    EXPECT_EQ(message_of(rejected, {.what = "parameters", .output = output}),
              "--what = parameters: there is no fitted specimen");
    EXPECT_EQ(message_of(rejected, {.what = "curve", .specimen = "b", .output = output}),
              "--case = b: has no curve to draw: is empty");
  }
}

TEST(PlotScript, ForATerminalLetsNoTextOfAUserLeaveItsQuotes) {
  const std::string hostile = "it's\nsystem('id')\n!id `id` END_OF_DATA";
  std::vector<FitRecord> records = {fitted_record(hostile), fitted_record("b")};
  records[0].target.group = {{hostile, hostile}};
  parameter_of(records[0], "yield_stress").path = hostile;
  for (const char* kind : {"overview", "parameters", "curve"}) {
    std::istringstream script(plot_script(records, {.what = kind, .output = "-"}));
    for (std::string line; std::getline(script, line);) {
      EXPECT_FALSE(line.starts_with("system") || line.starts_with("!")) << line;
      // No string is left open or ended early.
      EXPECT_EQ(std::count(line.begin(), line.end(), '\'') % 2, 0) << line;
    }
  }
}

TEST(PlotScript, SaysWhatThereIsToDraw) {
  const std::vector<FitRecord> records = {fitted_record("a"), fitted_record("b")};
  EXPECT_EQ(message_of(records, {.what = "pie"}),
            "--what = pie: must be curve, residuals, quantiles, overview, parameters, profile, "
            "bootstrap or laws");
  EXPECT_EQ(message_of(records, {.specimen = "c"}),
            "--case = c: is not a specimen of this file; it has a, b");
  EXPECT_EQ(message_of(records, {.what = "overview", .specimen = "a"}),
            "--case = a: does not go with the picture 'overview'");
  EXPECT_EQ(message_of({}, {}), "plot: there is no specimen to draw");
  EXPECT_EQ(message_of({rejected_record("a", "x")}, {.what = "parameters"}),
            "--what = parameters: there is no fitted specimen");
  ASSERT_EQ(plot_kinds().size(), 8U);
  EXPECT_EQ(plot_kinds()[0].name, "curve");
}

TEST(PlotData, IsThinnedToWhatAPictureCanShow) {
  Curve curve;
  for (int i = 0; i <= 100000; ++i) {
    curve.strain.push_back(1e-6 * i);
    curve.stress.push_back(i == 50000 ? 500e6 : 300e6);
  }
  curve.stress[7] = std::numeric_limits<double>::quiet_NaN();
  const Curve thin = report::thinned(curve, 1000);
  EXPECT_LT(thin.size(), 1100U);
  EXPECT_EQ(*std::max_element(thin.stress.begin(), thin.stress.end()), 500e6);
  EXPECT_EQ(thin.strain.back(), curve.strain.back());
}

TEST(MeanCurve, EndsWhereTheFirstCurveEnds) {
  const Curve a = {{0.0, 0.01, 0.02}, {0.0, 100.0, 100.0}};
  const Curve b = {{0.0, 0.01, 0.04}, {0.0, 200.0, 200.0}};
  const Curve mean = report::mean_curve({&a, &b});
  ASSERT_GT(mean.size(), 10U);
  EXPECT_DOUBLE_EQ(mean.strain.back(), 0.02);
  EXPECT_DOUBLE_EQ(mean.stress.back(), 150.0);
  EXPECT_DOUBLE_EQ(mean.stress.front(), 0.0);
}

TEST(MeanCurve, BeginsWhereAllCurvesHaveBegun) {
  const Curve preloaded = {{0.005, 0.01, 0.02}, {50.0, 100.0, 200.0}};
  const Curve whole = {{0.0, 0.01, 0.02}, {0.0, 100.0, 200.0}};
  const Curve mean = report::mean_curve({&whole, &preloaded});
  ASSERT_GT(mean.size(), 10U);
  EXPECT_DOUBLE_EQ(mean.strain.front(), 0.005);
  for (std::size_t i = 0; i < mean.size(); ++i) {
    EXPECT_NEAR(mean.stress[i], 1e4 * mean.strain[i], 1e-9);  // both lie on it
  }
}

TEST(MeanCurve, IsNoneForOneCurveAndForCycles) {
  const Curve a = {{0.0, 0.01, 0.02}, {0.0, 100.0, 100.0}};
  const Curve cycle = {{0.0, 0.01, -0.01}, {0.0, 100.0, -100.0}};
  EXPECT_EQ(report::mean_curve({&a}).size(), 0U);
  EXPECT_EQ(report::mean_curve({&a, &cycle}).size(), 0U);
}

}  // namespace
}  // namespace plastica::calibrate
