#include "sweeps/plan/fit_plan.hpp"

#include <gtest/gtest.h>

#include "sweeps/run/sweep_run.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/has.hpp"
#include "tests/support/message.hpp"
#include "tests/sweeps/sweep_text.hpp"

namespace plastica::sweeps {
namespace {

const std::string kFolder = std::string(PLASTICA_SOURCE_DIR) + "/data/sweeps/";

Sweep bend(const std::string& error, const std::string& fit,
           const std::string& yield_model = "interaction") {
  return parse_sweep(
      "scene = '../scenes/bend_test.toml'\n[set]\nsolver.steps = 40\n"
      "rules.yield_model = '" +
          yield_model + "'\nmaterial.hardening.law = 'ideal'\n" + segments_axis("[4, 5]") +
          "[error]\n" + error + fit,
      kFolder + "test.toml");
}

const std::string kError = "quantity = 'fit'\nparameter = 'material.yield_stress'\n";
const std::string kFit =
    "[fit]\ntarget = '../targets/bend_test.csv'\n"
    "abscissa = { probe = 'displacement', column = 'Displacement', factor = -1 }\n"
    "ordinate = { probe = 'force', column = 'Force', factor = -1 }\nnoise = '5 N'\n"
    "[fit.parameters]\nyield_stress = { bounds = ['100 MPa', '900 MPa'] }\n";

TEST(FitPlan, IsReadAndFitsEachCase) {
  const Sweep sweep = bend(kError, kFit);
  ASSERT_TRUE(sweep.fit.has_value());
  EXPECT_EQ(sweep.fit->target.noise, 5.0);
  EXPECT_EQ(sweep.fit->target.abscissa_factor, -1.0);
  EXPECT_EQ(sweep.inputs.back().name, "bend_test.csv");
  const auto results = SweepRun(sweep, {}).run();
  for (const CaseResult& result : results) {
    EXPECT_EQ(result.status, Status::Completed) << result.reason;
    EXPECT_GT(result.value.value_or(0.0), 300e6);
    EXPECT_LT(result.value.value_or(0.0), 900e6);
    EXPECT_GT(result.standard_error, 0.0);
    EXPECT_GT(result.segment_iterations(), 100);
  }
}

/// A value that a check of the same fit would not let hold is no result to choose a setting by.
TEST(FitPlan, GivesNoValueThatIsNoAnswer) {
  const auto reasons = [](const std::string& bounds, const std::string& yield_model) {
    std::string fit = kFit;
    fit.replace(fit.find("['100 MPa', '900 MPa']"), 22, bounds);
    const Sweep sweep = bend(kError, fit, yield_model);
    std::vector<std::string> all;
    for (const CaseResult& result : SweepRun(sweep, {}).run()) {
      EXPECT_FALSE(result.value);
      all.push_back(result.reason);
    }
    return all;
  };
  for (const std::string& reason : reasons("['100 MPa', '300 MPa']", "interaction")) {
    EXPECT_EQ(reason, "yield_stress ended at its bound");
  }
  for (const std::string& reason : reasons("['100 MPa', '900 MPa']", "elastic")) {
    EXPECT_TRUE(plastica::testing::has(reason, "is not identified") ||
                plastica::testing::has(reason, "the fit is of no use: the misfit is"))
        << reason;
  }
}

TEST(FitPlan, TellsOfRepairsOfItsCurve) {
  EXPECT_TRUE(bend(kError, kFit).notes.empty());
  const io::ScratchFolder folder;
  const std::string file =
      folder.write("a.csv", "Displacement (mm),Force (N)\n0,0\n1,NaN\n2,260\n");
  std::string fit = kFit;
  const std::string shipped = "../targets/bend_test.csv";
  fit.replace(fit.find(shipped), shipped.size(), file);
  EXPECT_EQ(bend(kError, fit).notes,
            (std::vector<std::string>{file + ": 1 rows dropped that lack one of the two numbers"}));
}

TEST(FitPlan, DecidesTheIdsOfItsCases) {
  const auto id = [](const std::string& fit) { return CaseTable(bend(kError, fit)).id(0); };
  std::string other = kFit;
  other.replace(other.find("900"), 3, "800");
  EXPECT_EQ(id(kFit), id(kFit));
  EXPECT_NE(id(kFit), id(other));
}

TEST(FitPlan, GoesWithTheQuantityOfAFit) {
  const auto message = [](const std::string& error, const std::string& fit) {
    return plastica::testing::message_of([&] { bend(error, fit); });
  };
  EXPECT_EQ(message(kError, ""),
            kFolder + "test.toml: fit: is missing: error.quantity is one of a fit");
  EXPECT_EQ(message("probe = 'force'\n", kFit),
            kFolder + "test.toml:11: fit: goes with error.quantity = \"fit\"");
  EXPECT_EQ(message("quantity = 'fit'\nparameter = 'material.density'\n", kFit),
            kFolder +
                "test.toml:12: error.parameter = material.density: is not a free parameter "
                "of [fit]");
}

}  // namespace
}  // namespace plastica::sweeps
