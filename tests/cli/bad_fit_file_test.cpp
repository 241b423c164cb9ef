#include <stdexcept>

#include "tests/cli/bad_input.hpp"
#include "tests/cli/curves.hpp"

namespace plastica::testing {
namespace {

// A line number in an error line is one of this text.
constexpr const char* kFit =
    "[fit]\n"                                            // 1
    "objective = 'path'\n"                               // 2
    "[fit.parameters]\n"                                 // 3
    "youngs_modulus = {}\n"                              // 4
    "yield_stress = { bounds = ['10 MPa', '2 GPa'] }\n"  // 5
    "break_strain = { bounds = ['0.1 %', '100 %'] }\n"   // 6
    "[[target]]\n"                                       // 7
    "files = 'a.csv'\n"                                  // 8
    "strain = { column = 'Strain', unit = '%' }\n"       // 9
    "stress = { column = 'Stress', unit = 'MPa' }\n";    // 10
constexpr const char* kObjective = "objective = 'path'";
constexpr const char* kModulus = "youngs_modulus = {}";
constexpr const char* kBreak = "break_strain = { bounds = ['0.1 %', '100 %'] }";
constexpr const char* kStrain = "strain = { column = 'Strain', unit = '%' }";
constexpr const char* kStress = "stress = { column = 'Stress', unit = 'MPa' }";
constexpr const char* kForce = "force = { column = 'Stress', unit = 'kN' }";
constexpr const char* kTable = "table = { file = 'info.csv', key = 'id' }\n";

/// The fit file with one thing changed, beside a good curve and a good table.
BadInput fit_change(std::string name, const std::string& from, const std::string& to,
                    std::string line) {
  std::string text = kFit;
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error(from + " is not in the fit file");
  text.replace(at, from.size(), to);
  return {
      std::move(name),
      {{"fit.toml", text}, {"a.csv", broken_curve()}, {"info.csv", "id,S0,temperature\na,20,20\n"}},
      {"calibrate", "fit.toml", "-o", "fit.h5"},
      "fit.toml:" + std::move(line)};
}

/// A key is put before the other keys of the target, on line 8.
BadInput target_key(std::string name, const std::string& keys, std::string line) {
  return fit_change(std::move(name), "files =", keys + "\nfiles =", std::move(line));
}

/// Parameters are put behind the others, from line 7 on.
BadInput parameter(std::string name, const std::string& lines, std::string line) {
  return fit_change(std::move(name), kBreak, std::string(kBreak) + "\n" + lines, std::move(line));
}

class BadFitFile : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadFitFile, IsRefusedInOneLine) { expect_refusal(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Text, BadFitFile,
    ::testing::Values(
        fit_change("TomlSyntaxError", "[[target]]", "[[target]",
                   "7: [[target]: is not TOML (column 10): …"),
        fit_change("UnclosedText", kObjective, "objective = 'strain",
                   "2: objective = 'strain: is not TOML (column …"),
        fit_change("KeyTwice", kObjective, std::string(kObjective) + "\n" + kObjective,
                   "3: objective = 'path': is not TOML (column 13): …"),
        fit_change("BinaryFitFile", "[fit]", "\x01\x80\xFF", "1: is not TOML (column …"),
        fit_change("UnknownKey", "objective", "objektive",
                   "2: fit.objektive = 'path': is not a key of fit; did you mean objective?"),
        target_key("UnknownKeyOfTarget", "grupo = 'x'",
                   "8: target[1].grupo = 'x': is not a key of target[1]; did you mean group?"),
        fit_change(
            "UnknownTable", "[[target]]", "[extra]\nx = 1\n[[target]]",
            "7: extra: is not a key; its keys are material, beam, section, rules, solver, fit, "
            "target_defaults, target"),
        fit_change("WrongType", "'path'", "3",
                   "2: fit.objective = 3: must be one of \"path\", \"least-squares\""),
        fit_change("WrongTypeOfTruth", "{}", "{ value = '200 GPa', fixed = 'yes' }",
                   "4: fit.parameters.youngs_modulus.fixed = 'yes': must be true or false"),
        fit_change("UnknownObjective", "'path'", "'chi'",
                   "2: fit.objective = 'chi': must be one of \"path\", \"least-squares\""),
        fit_change(
            "UnknownAlgorithm", kObjective, "algorithm = 'simplex'",
            "2: fit.algorithm = 'simplex': must be one of \"auto\", \"gauss-newton\", \"crs\", …"),
        fit_change("NoiseWithoutLeastSquares", kObjective, "noise = '1 MPa'",
                   "2: fit.noise = 1 MPa: goes with objective = \"least-squares\" alone"),
        fit_change("NegativeSeed", kObjective, "seed = -1",
                   "2: fit.seed = -1: must be an integer from 0 to 9223372036854775807"),
        fit_change("ConfidenceBeyondAll", kObjective, "confidence = '120 %'",
                   "2: fit.confidence = 120 %: must be above 0 % and below 100 %"),
        fit_change("InfiniteWeight", kObjective, "break_weight = inf",
                   "2: fit.break_weight = inf: must be a finite number"),
        fit_change("NegativeEvaluations", kObjective, "stop = { local_evaluations = -5 }",
                   "2: fit.stop.local_evaluations = -5: must be an integer from 1 to 1000000000"),
        fit_change("HingeOfAChain", "[fit]", "rules.hinge_length = '1 m'\n[fit]",
                   "1: rules.hinge_length = 1 m: is of chains: a coupon has no hinge"),
        fit_change("UnknownMaterial", "[fit]", "material = 'S356'\n[fit]",
                   "1: material = S356: must be one of S235, S275, S355, …")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Parameters, BadFitFile,
    ::testing::Values(
        fit_change(
            "UnitMissing", "'10 MPa'", "10",
            "5: fit.parameters.yield_stress.bounds[1] = 10: a stress needs a unit (examples: Pa, "
            "MPa, ksi)"),
        fit_change(
            "UnknownUnit", "'10 MPa'", "'10 MegaP'",
            "5: fit.parameters.yield_stress.bounds[1] = 10 MegaP: \"MegaP\" is not a unit of "
            "stress (examples: Pa, MPa, ksi)"),
        fit_change(
            "BoundsReversed", "['10 MPa', '2 GPa']", "['2 GPa', '10 MPa']",
            "5: fit.parameters.yield_stress.bounds = ['2 GPa', '10 MPa']: the lower bound must be "
            "below the upper one"),
        fit_change("OneBound", "['10 MPa', '2 GPa']", "['2 GPa']",
                   "5: fit.parameters.yield_stress.bounds = ['2 GPa']: must be two values, [lower, "
                   "upper]"),
        fit_change("BoundOutOfRange", "'10 MPa'", "'-10 MPa'",
                   "5: fit.parameters.yield_stress.bounds[1] = -10 MPa: must be above 0 Pa"),
        fit_change("InfiniteBound", "'2 GPa'", "'inf GPa'",
                   "5: fit.parameters.yield_stress.bounds[2] = inf GPa: is not a finite number"),
        fit_change("ValueOutOfRange", "{}", "'-200 GPa'",
                   "4: fit.parameters.youngs_modulus = -200 GPa: must be above 0 Pa"),
        fit_change("ValueNotANumber", "{}", "{ value = nan, fixed = true }",
                   "4: fit.parameters.youngs_modulus.value = nan: must be a finite number"),
        fit_change(
            "ValueNotFixed", "{}", "{ value = '200 GPa' }",
            "4: fit.parameters.youngs_modulus.value = 200 GPa: needs fixed = true beside it; a "
            "free parameter's first value is its start"),
        fit_change("FixedWithoutValue", "{}", "{ fixed = true }",
                   "4: fit.parameters.youngs_modulus.value: is missing"),
        fit_change("StartOutsideBounds", "'2 GPa'] }", "'2 GPa'], start = '3 GPa' }",
                   "5: fit.parameters.yield_stress.start = 3 GPa: must be within the bounds"),
        fit_change("UnknownScale", "{}", "{ scale = 'log' }",
                   "4: fit.parameters.youngs_modulus.scale = 'log': must be one of \"auto\", "
                   "\"linear\", \"logarithmic\""),
        fit_change("UnknownParameter", "yield_stress", "yeild_stress",
                   "5: fit.parameters.yeild_stress: is not the name of a parameter; did you mean "
                   "yield_stress?"),
        parameter("FieldThatIsNoParameter", "'section.width' = {}",
                  "7: fit.parameters.section.width: is not a field that a fit can move"),
        parameter("ParameterTwice", "material.yield_stress = {}",
                  "7: fit.parameters.material.yield_stress: is the parameter of line 5, too"),
        parameter("TieToItself", "shear_modulus = { tie = 'shear_modulus' }",
                  "7: fit.parameters.shear_modulus.tie = shear_modulus: a parameter cannot be tied "
                  "to itself"),
        parameter("TieToUnknown", "shear_modulus = { tie = 'nothing' }",
                  "7: fit.parameters.shear_modulus.tie = nothing: is not the name of a parameter"),
        parameter("TieToAbsent", "shear_modulus = { tie = 'tangent_modulus' }",
                  "7: fit.parameters.shear_modulus.tie = tangent_modulus: is not one of the fit's "
                  "parameters"),
        parameter("TieToTied",
                  "shear_yield_stress = { tie = 'yield_stress' }\n"
                  "shear_modulus = { tie = 'shear_yield_stress' }",
                  "8: fit.parameters.shear_modulus.tie = shear_yield_stress: is tied itself"),
        parameter(
            "TieOfOtherDimension", "shear_modulus = { tie = 'break_strain' }",
            "7: fit.parameters.shear_modulus.tie = break_strain: is a strain, shear_modulus a "
            "stress"),
        fit_change("AllFixed",
                   "youngs_modulus = {}\nyield_stress = { bounds = ['10 MPa', '2 GPa'] }\n"
                   "break_strain = { bounds = ['0.1 %', '100 %'] }",
                   "yield_stress = '300 MPa'",
                   "3: fit.parameters: needs at least one that is free"),
        fit_change(
            "ModulusNowhere", kModulus, "",
            "1: fit.parameters.youngs_modulus: is missing: make it a parameter, or give it in "
            "[material]")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Targets, BadFitFile,
    ::testing::Values(
        fit_change("NoFilesMatch", "'a.csv'", "['a.csv', 'b*.csv']",
                   "8: target[1].files[2] = b*.csv: matches no file"),
        fit_change("FileTwice", "'a.csv'", "['a.csv', '*a.csv']",
                   "8: target[1].files[2] = *a.csv: matches a.csv, which line 8 has already"),
        fit_change("FilesMissing", "files = 'a.csv'", "", "7: target[1].files: is missing"),
        fit_change(
            "UnknownColumnOfStrain", "'Strain'", "'Strian'",
            "9: strain = Strian: is not a column of a.csv, which has 2 columns: Strain, Stress"),
        fit_change("UnknownColumnOfStress", "'Stress'", "3",
                   "10: stress = 3: is not a column of a.csv, which has 2 columns: Strain, Stress"),
        fit_change(
            "UnknownUnitOfColumn", "'MPa' }", "'MegaP' }",
            "10: target[1].stress.unit = MegaP: is not a unit of stress (examples: Pa, MPa, ksi)"),
        fit_change(
            "UnitOfOtherDimension", "'MPa' }", "'mm' }",
            "10: target[1].stress.unit = mm: is not a unit of stress (examples: Pa, MPa, ksi)"),
        target_key("UnknownTest", "test = 'pull'",
                   "8: target[1].test = 'pull': must be one of \"tension\", \"bending\", "
                   "\"torsion\""),
        target_key("UnknownMeasure", "measure = 'nominal'",
                   "8: target[1].measure = 'nominal': must be one of \"engineering\", \"true\""),
        target_key("UnknownGroupColumn", std::string(kTable) + "group = ['speed']",
                   "7: group = speed: is not a column of info.csv, which has 3 columns: id, S0, "
                   "temperature"),
        target_key("GroupWithoutTable", "group = ['temperature']",
                   "8: target[1].group = ['temperature']: needs `table`, the file that has this "
                   "column, or HDF5 files with attributes"),
        target_key("MissingTable", "table = { file = 'none.csv', key = 'id' }",
                   "8: target[1].table.file = none.csv: is not a file"),
        target_key("TableWithoutKey", "table = { file = 'info.csv' }",
                   "8: target[1].table.key: is missing"),
        target_key("RateWithoutALaw", "strain_rate = '0.01 1/s'",
                   "8: target[1].strain_rate: is of no use without a law, material.rate.law: it "
                   "would move nothing"),
        target_key("MissingKeyColumn", "table = { file = 'info.csv', key = 'name' }",
                   "8: key = name: is not a column of info.csv, which has 3 columns: id, S0, "
                   "temperature"),
        fit_change("NegativeArea", kStress, std::string(kForce) + "\narea = '-1 mm^2'",
                   "11: target[1].area = -1 mm^2: must be above 0 m^2"),
        fit_change("ForceWithoutArea", kStress, kForce,
                   "7: target[1].area: is missing: force needs it"),
        fit_change("ElongationWithoutGaugeLength", kStrain, "elongation = 'Strain'",
                   "7: target[1].gauge_length: is missing: elongation needs it"),
        fit_change("StrainAndElongation", kStrain, std::string(kStrain) + "\nelongation = 'Strain'",
                   "10: target[1].elongation = Strain: cannot go with strain"),
        fit_change(
            "StressAndForce", kStress, std::string(kStress) + "\n" + kForce,
            "11: target[1].force = { column = 'Stress', unit = 'kN' }: cannot go with stress"),
        fit_change("NeitherStressNorForce", kStress, "",
                   "7: target[1].stress: is missing: give stress, or force and area"),
        fit_change("ForceInBending", kStress,
                   "test = 'bending'\n" + std::string(kForce) + "\narea = '1 mm^2'",
                   "11: target[1].force = { column = 'Stress', unit = 'kN' }: goes with test = "
                   "\"tension\" alone; bending and torsion take strain and stress of the outermost "
                   "fibre")),
    name_of_case);

TEST(BadFitFiles, NeedATarget) {
  expect_refusal({"",
                  {{"fit.toml", "[fit]\n"}},
                  {"calibrate", "fit.toml"},
                  "fit.toml: target: is missing: a fit needs at least one [[target]]"});
}

TEST(BadFitFiles, ThatAreMissingAreNamed) {
  expect_refusal(
      {"", {}, {"calibrate", "fit.toml"}, "fit.toml: cannot be read: No such file or directory"});
}

TEST(BadFitFiles, MustGiveAStressAUnitIfTheCurveDoesNot) {
  std::string curve = broken_curve();
  curve.erase(curve.find(" (MPa)"), 6);
  const std::string text = "[[target]]\nfiles = 'a.csv'\nstrain = 'Strain'\nstress = 'Stress'\n";
  expect_refusal({"",
                  {{"fit.toml", text}, {"a.csv", curve}},
                  {"calibrate", "fit.toml"},
                  "fit.toml:4: stress = Stress: needs a unit, as a.csv gives none"});
}

}  // namespace
}  // namespace plastica::testing
