#include "tests/cli/bad_input.hpp"

/// Measured curves of beams, and what a fit file says of them, that are refused.
namespace plastica::testing {
namespace {

constexpr const char* kBar = R"([beam]
length = "400 mm"
segments = 4
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
[material]
name = "S355"
[[support]]
at = "start"
kind = "clamp"
[[support]]
at = "end"
kind = "roller"
hold = ["y"]
translation = ["0 mm", "-80 mm", "0 mm"]
[[probe]]
name = "force"
kind = "reaction"
at = "end"
component = "y"
[[probe]]
name = "tip"
kind = "displacement"
at = "end"
component = "y"
)";

// A line number in an error line is one of this text.
constexpr const char* kBentBarFit =
    "[fit]\n"                                                               // 1
    "parameters.youngs_modulus = { bounds = ['50 GPa', '500 GPa'] }\n"      // 2
    "[[target]]\n"                                                          // 3
    "files = 'a.csv'\n"                                                     // 4
    "scene = 'bar.toml'\n"                                                  // 5
    "abscissa = { probe = 'tip', column = 'Displacement', factor = -1 }\n"  // 6
    "ordinate = { probe = 'force', column = 'Force', factor = -1 }\n";      // 7

BadInput refused(std::string name, std::string curve, std::string line,
                 const std::string& fit = kBentBarFit) {
  return {std::move(name),
          {{"fit.toml", fit}, {"bar.toml", kBar}, {"a.csv", std::move(curve)}},
          {"calibrate", "fit.toml", "-o", "fit.h5"},
          std::move(line)};
}

/// A good curve and the fit file with one thing changed.
BadInput scene_fit_change(std::string name, const std::string& from, const std::string& to,
                          std::string line) {
  return refused(std::move(name), "Displacement (mm),Force (N)\n0,0\n1,130\n2,260\n",
                 "fit.toml:" + std::move(line), changed(kBentBarFit, from, to));
}

class BadSceneTarget : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadSceneTarget, IsRefusedInOneLine) { expect_refusal(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Curve, BadSceneTarget,
    ::testing::Values(
        refused("MissingColumn", "Displacement (mm),Load (N)\n0,0\n1,130\n",
                "fit.toml:7: ordinate = Force: is not a column of a.csv, which has 2 columns: "
                "Displacement, "
                "Load"),
        refused("MissingUnit", "Displacement (mm),Force\n0,0\n1,130\n",
                "fit.toml:7: ordinate = Force: needs a unit, as a.csv gives none"),
        refused("UnitThatDoesNotFit", "Displacement (mm),Force (MPa)\n0,0\n1,130\n",
                "a.csv: unit of Force = MPa: is not a unit of force (examples: N, kN, lbf)"),
        refused("Word", "Displacement (mm),Force (N)\n0,0\n1,130\n2,much\n3,390\n",
                "a.csv:4: Force = much: is not a number"),
        refused("NoNumbers", "Displacement (mm),Force (N)\n0,NaN\n1,NaN\n",
                "a.csv: Force: no row has both numbers"),
        refused("TurnsRound", "Displacement (mm),Force (N)\n0,0\n1,NaN\n2,260\n1,130\n",
                "a.csv:5: Displacement = 1: goes back by more than reversal_tolerance: a beam's "
                "curve is "
                "followed one way; a scene that this column drives follows it to and fro")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Fit, BadSceneTarget,
    ::testing::Values(
        scene_fit_change(
            "ColumnNumber", "'Force'", "3",
            "7: ordinate = 3: is not a column of a.csv, which has 2 columns: Displacement, Force"),
        scene_fit_change("Defaults", "[[target]]", "[target_defaults]\ncut = 1\n[[target]]",
                         "3: target_defaults: is for coupons' curves: say it in each [[target]]"),
        scene_fit_change(
            "Unit", "column = 'Force'", "column = 'Force', unit = 'mm'",
            "7: target[1].ordinate.unit = mm: is not a unit of force (examples: N, kN, "
            "lbf)"),
        scene_fit_change(
            "ToleranceWithoutUnit", "scene =", "reversal_tolerance = 1\nscene =",
            "5: target[1].reversal_tolerance = 1: a length needs a unit (examples: m, mm, "
            "in)"),
        scene_fit_change("FieldByItsLastPart", "parameters.youngs",
                         "parameters.density = {}\nparameters.youngs",
                         "2: fit.parameters.density: needs its whole path, in quotes: "
                         "\"material.density\""),
        scene_fit_change("NegativeTolerance", "scene =", "reversal_tolerance = '-1 mm'\nscene =",
                         "5: target[1].reversal_tolerance = -1 mm: must be at least 0")),
    name_of_case);

}  // namespace
}  // namespace plastica::testing
