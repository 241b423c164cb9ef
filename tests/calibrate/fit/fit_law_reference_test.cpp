#include <gtest/gtest.h>

#include <string>

#include "calibrate/fit/fit_law.hpp"
#include "tests/calibrate/fit/hardening_targets.hpp"

/// Laws whose search is long.
namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

TEST(FitLaw, HasNoEffectOfItsOwnWhereAnyWouldBeWorse) {
  const FitOptions options =
      fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  const Target target = softening_target();
  const FitResult ideal = fit_law(target, options, Law::Ideal);
  for (const Law law : {Law::Linear, Law::Voce, Law::Chaboche}) {
    const FitResult result = fit_law(target, options, law);
    EXPECT_LE(result.cost, ideal.cost * (1.0 + 1e-6)) << name_of(law);
    for (const std::string& warning : result.warnings) {
      EXPECT_EQ(warning.find("larger misfit"), std::string::npos) << warning;
    }
  }
}

}  // namespace
}  // namespace plastica::calibrate
