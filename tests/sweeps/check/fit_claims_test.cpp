#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <limits>

#include "calibrate/config/templates.hpp"
#include "calibrate/store/fit_store.hpp"
#include "sweeps/check/judge_fits.hpp"
#include "sweeps/check/report.hpp"
#include "sweeps/check/run_check.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"

/// Claims on fits: of a fit file that is run, and of a result.
namespace plastica::sweeps {
namespace {

/// A curve of E = 200 GPa, a yield stress of 350 MPa and a break at 2 % of permanent strain, with
/// noise of 1 MPa.
class FitClaims : public ::testing::Test {
 protected:
  FitClaims() {
    for (const auto& file : calibrate::template_files("fit")) write(file.name, file.text);
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.file(name)) << text;
  }
  CheckFile read(const std::string& claim, const std::string& of = "fit = 'fit.toml'\n") {
    write("check.toml", "[[claim]]\nname = 'a'\n" + of + claim);
    return read_check_file(folder_.file("check.toml"));
  }
  ClaimVerdict verdict(const std::string& claim, const std::string& of = "fit = 'fit.toml'\n") {
    return run_check(read(claim, of), {}).front();
  }
  std::string message(const std::string& claim) {
    const std::string line = plastica::testing::message_of([&] { read(claim); });
    return line.substr(std::min(line.size(), folder_.file("check.toml").size()));
  }

  io::ScratchFolder folder_;
};

TEST_F(FitClaims, HoldAParameterToLimitsATruthAndItsInterval) {
  const std::string of = "parameter = 'yield_stress'\n";
  const ClaimVerdict held = verdict(of + "value = { at_least = '349 MPa', at_most = '351 MPa' }\n");
  EXPECT_TRUE(held.holds) << held.reason;
  EXPECT_EQ(held.at, "of example-curve");
  EXPECT_FALSE(verdict(of + "value = { at_least = '351 MPa' }\n").holds);
  EXPECT_TRUE(verdict(of + "truth = '350 MPa'\nerror = { at_most = '0.3 %' }\n").holds);
  const ClaimVerdict off = verdict(of + "truth = '360 MPa'\nerror = { at_most = '1 %' }\n");
  EXPECT_FALSE(off.holds);
  EXPECT_NEAR(off.number.value_or(0.0), 10.0 / 360.0, 1e-3);
  EXPECT_EQ(off.beside.substr(0, 16), "yield_stress 350") << off.beside;
  EXPECT_TRUE(verdict(of + "interval = { holds = '350 MPa' }\n").holds);
  const ClaimVerdict outside = verdict(of + "interval = { holds = '360 MPa' }\n");
  EXPECT_FALSE(outside.holds);
  EXPECT_EQ(outside.found.substr(0, 3), "349") << outside.found;
}

TEST_F(FitClaims, SayWhatTheIntervalIsAndWhatItIsToHold) {
  CheckedFile checked{
      read("parameter = 'yield_stress'\ninterval = { holds = '360 MPa' }\n"), {}, 0};
  checked.verdicts = run_check(checked.file, {});
  const std::string text = check_report(checked);
  EXPECT_NE(text.find(" MPa of example-curve; wanted to hold 360 MPa; "), std::string::npos)
      << text;
}

TEST_F(FitClaims, HoldMisfitsAndHowManyFitsAreOfUse) {
  EXPECT_TRUE(verdict("misfit = { at_most = '1 %' }\n").holds);
  EXPECT_FALSE(verdict("misfit = { at_most = '0.01 %' }\n").holds);
  EXPECT_TRUE(verdict("fitted = { at_least = 1 }\n").holds);
  EXPECT_TRUE(verdict("failed = { at_most = 0 }\n").holds);
}

TEST_F(FitClaims, DoNotHoldOfAFitThatFails) {
  write("bad.csv", "Strain (%),Stress (MPa)\n0,0\n0.1,1\n");
  std::string text = io::content_of(folder_.file("fit.toml"));
  const std::size_t at = text.find("\"example-curve.csv\"");
  ASSERT_NE(at, std::string::npos) << text;
  write("fit.toml", text.insert(at, "\"bad.csv\", "));
  const std::string of = "parameter = 'yield_stress'\nvalue = { at_most = '1 GPa' }\n";
  const ClaimVerdict all = verdict(of);
  EXPECT_FALSE(all.holds);
  EXPECT_EQ(all.at, "of bad");
  EXPECT_EQ(all.reason.substr(0, 13), "is rejected: ") << all.reason;
  EXPECT_TRUE(verdict("case = 'example-curve'\n" + of).holds);
  EXPECT_FALSE(verdict("case = 'bad'\n" + of).holds);
  const ClaimVerdict failed = verdict("failed = { at_most = 0 }\n");
  EXPECT_EQ(failed.number, 1.0);
  EXPECT_EQ(failed.beside.substr(0, 16), "bad is rejected:") << failed.beside;
  EXPECT_TRUE(verdict("fitted = { at_least = 1 }\n").holds);
  EXPECT_FALSE(verdict("fitted = { at_least = 2 }\n").holds);
}

TEST_F(FitClaims, AreTheSameOfAResult) {
  const auto records = run_fits(read_fit_subject(folder_.file("fit.toml")), 1, nullptr, {});
  ASSERT_TRUE(records);
  calibrate::FitStoreContents contents;
  contents.records = records->curves;
  contents.options = calibrate::read_fit_file(folder_.file("fit.toml")).options;
  calibrate::write_fit_store(folder_.file("fit.h5"), contents);
  const std::string of = "result = 'fit.h5'\n";
  const std::string claim =
      "parameter = 'youngs_modulus'\nvalue = { at_least = '190 GPa', at_most = ";
  const ClaimVerdict run = verdict(claim + "'210 GPa' }\n");
  const ClaimVerdict stored = verdict(claim + "'210 GPa' }\n", of);
  EXPECT_TRUE(stored.holds);
  EXPECT_EQ(stored.number, run.number);
  EXPECT_FALSE(verdict(claim + "'191 GPa' }\n", of).holds);
}

TEST_F(FitClaims, AreOfFitsThroughScenesToo) {
  for (const auto& file : calibrate::template_files("scene-fit")) {
    std::string text = file.text;
    const std::size_t fit = text.find("[fit]\n");
    if (fit != std::string::npos) {
      text.insert(fit + 6, "starts = 1\nscreen = 0\nsegments_error = false\n");
    }
    write(file.name, text);
  }
  const std::string of = "fit = 'scene-fit.toml'\n";
  // The curve that is shipped was made with 205 GPa, with noise (data/targets/make_bend_test.py).
  const ClaimVerdict modulus =
      verdict("parameter = 'youngs_modulus'\ntruth = '205 GPa'\nerror = { at_most = '1 %' }\n", of);
  EXPECT_TRUE(modulus.holds) << modulus.number.value_or(0.0) << modulus.reason;
  EXPECT_EQ(modulus.at, "of scene-fit");
  EXPECT_TRUE(verdict("misfit = { at_most = '1 %' }\n", of).holds);
  EXPECT_FALSE(verdict("misfit = { at_most = '0.1 %' }\n", of).holds);
  const ClaimVerdict law = verdict("law = 'voce'\nfitted = { at_least = 1 }\n", of);
  EXPECT_FALSE(law.holds);
  EXPECT_EQ(law.reason, "no fit is by the law voce");
}

TEST_F(FitClaims, StopBetweenFits) {
  const std::atomic<bool> stop{true};
  EXPECT_FALSE(run_fits(read_fit_subject(folder_.file("fit.toml")), 1, &stop, {}));
  CheckOptions options;
  options.stop = &stop;
  EXPECT_TRUE(run_check(read("failed = { at_most = 0 }\n"), options).empty());
}

/// Of fits that are made up: what no number may come of.
TEST(JudgedFits, HaveNoNumberOfWhatWasNotFound) {
  FittedRecords fits;
  calibrate::FitRecord record;
  record.target.name = "a";
  record.result.status = calibrate::FitStatus::Fitted;
  calibrate::FittedParameter yield;
  yield.path = "material.yield_stress";
  yield.value = 350e6;
  yield.interval_low = 340e6;
  yield.interval_high = 360e6;
  record.result.parameters = {yield};
  fits.curves = {record};
  Claim claim;
  claim.subject = ClaimSubject::Fit;
  claim.parameter = "material.yield_stress";
  claim.dimension = Dimension::Stress;
  claim.kind = ClaimKind::Value;
  claim.at_most = 400e6;
  EXPECT_TRUE(judge(claim, fits).holds);
  calibrate::FittedParameter& found = fits.curves[0].result.parameters[0];

  found.value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(judge(claim, fits).holds);
  found.value = 350e6;
  found.identified = false;
  EXPECT_EQ(judge(claim, fits).reason, "yield_stress is not identified by the curves");
  found.identified = true;
  found.role = calibrate::ParameterRole::Fixed;
  EXPECT_EQ(judge(claim, fits).reason, "yield_stress is fixed: nothing was fitted");
  found.role = calibrate::ParameterRole::Free;
  found.at_lower = true;
  found.lower = 350e6;
  EXPECT_EQ(judge(claim, fits).reason, "yield_stress ended at its bound, 350 MPa");
  found.lower = 0.0;
  EXPECT_TRUE(judge(claim, fits).holds);
  found.at_lower = false;

  claim.kind = ClaimKind::Interval;
  claim.at_most = 0.0;
  claim.truth = 345e6;
  EXPECT_TRUE(judge(claim, fits).holds);
  claim.truth = 339e6;
  EXPECT_FALSE(judge(claim, fits).holds);
  found.interval_high = std::numeric_limits<double>::quiet_NaN();
  claim.truth = 345e6;
  EXPECT_EQ(judge(claim, fits).reason, "yield_stress has no confidence interval");

  claim.kind = ClaimKind::Value;
  claim.parameter = "material.break_strain";
  EXPECT_EQ(judge(claim, fits).reason, "has no parameter break_strain");
  claim.law = "voce";
  EXPECT_EQ(judge(claim, fits).reason, "no fit is by the law voce");
  claim.law.clear();
  claim.kind = ClaimKind::Misfit;
  fits.curves[0].result.misfit_fraction = 0.6;
  EXPECT_EQ(judge(claim, fits).reason.substr(0, 14), "is of no use: ");
}

TEST_F(FitClaims, AreRefusedInOneLineIfBad) {
  const std::string of = "parameter = 'yield_stress'\n";
  EXPECT_EQ(message("value = { at_most = 1 }\n"), ":1: claim[1].parameter: is missing");
  EXPECT_EQ(message("parameter = 'yield'\nvalue = { at_most = 1 }\n").substr(0, 46),
            ":4: claim[1].parameter = yield: is not a field");
  EXPECT_EQ(message(of + "value = { at_most = '1 mm' }\n").substr(0, 35),
            ":5: claim[1].value.at_most = 1 mm: ");
  EXPECT_EQ(message(of + "error = { at_most = '1 %' }\n"), ":1: claim[1].truth: is missing");
  EXPECT_EQ(message(of + "truth = '0 MPa'\nerror = { at_most = '1 %' }\n"),
            ":5: claim[1].truth = 0 MPa: must not be 0: the error is a fraction of it");
  EXPECT_EQ(message(of + "truth = '1 MPa'\nvalue = { at_most = '1 MPa' }\n"),
            ":5: claim[1].truth = 1 MPa: goes with error");
  EXPECT_EQ(message(of + "misfit = { at_most = '1 %' }\n"),
            ":4: claim[1].parameter = yield_stress: goes with value, error or interval");
  EXPECT_EQ(message(of + "interval = {}\n"), ":5: claim[1].interval.holds: is missing");
  EXPECT_EQ(message("work = { at_most = 1 }\n"),
            ":4: claim[1].work = { at_most = 1 }: is about a sweep or a scene, not about fits");
  EXPECT_EQ(message("case = 'b'\nfailed = { at_most = 0 }\n"),
            ":4: claim[1].case = b: is no fit of " + folder_.file("fit.toml"));
  EXPECT_EQ(message("law = 'best'\nfailed = { at_most = 0 }\n").substr(0, 36),
            ":4: claim[1].law = 'best': must be o");
  EXPECT_EQ(message("failed = { at_most = 1 }\n"),
            ":4: claim[1].failed = { at_most = 1 }: holds whatever happens: there are 1");
  const std::string line = plastica::testing::message_of(
      [&] { read("failed = { at_most = 0 }\n", "result = 'fit.toml'\n"); });
  EXPECT_EQ(line, folder_.file("fit.toml") + ": is not an HDF5 file");
}

}  // namespace
}  // namespace plastica::sweeps
