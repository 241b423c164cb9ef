#include "tests/cli/bad_input.hpp"
#include "tests/cli/curves.hpp"

namespace plastica::testing {
namespace {

/// A lone file of curves, named on the command line.
BadInput curve(std::string name, std::string content, std::string line) {
  return {std::move(name),
          {{"a.csv", std::move(content)}},
          {"calibrate", "a.csv"},
          "a.csv" + std::move(line)};
}

/// A good curve with further options.
BadInput options(std::string name, std::vector<std::string> given, std::string line) {
  given.insert(given.begin(), {"calibrate", "a.csv"});
  return {std::move(name), {{"a.csv", broken_curve()}}, std::move(given), std::move(line)};
}

/// A curve with a text replaced.
std::string changed_curve(const std::string& from, const std::string& to) {
  std::string text = broken_curve();
  return text.replace(text.find(from), from.size(), to);
}

class BadCurve : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadCurve, IsRefusedInOneLine) { expect_refusal(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    File, BadCurve,
    ::testing::Values(
        BadInput{"Missing",
                 {},
                 {"calibrate", "a.csv"},
                 "a.csv: cannot be read: No such file or directory"},
        BadInput{"Folder",
                 {{"a.csv/b.csv", ""}},
                 {"calibrate", "a.csv"},
                 "a.csv: cannot be read: Is a directory"},
        BadInput{"NotInTheTable",
                 {{"a.csv", broken_curve()}, {"info.csv", "id,lot\nb,1\n"}},
                 {"calibrate", "a.csv", "--table", "info.csv:id", "--group", "lot", "-o", "a.h5"},
                 "info.csv: id = a: has no row in the table"},
        curve("Empty", "", ": is empty"),
        curve("Binary",
              std::string("\x7F"
                          "ELF\x02\0\0\0",
                          8),
              ":1: is not text (it has a zero byte)"),
        curve("HeaderOnly", "Strain (%),Stress (MPa)\n", ": holds no data row"),
        curve("UnequalRows", changed_curve("\n0.0400,", "\n0.0400,7,"),
              ":4: has 3 cells, the header on line 1 has 2"),
        curve("NoColumnOfStress", "Strain (%)\n1\n2\n",
              ": --stress: no column is known for the stress; it has Strain: give --stress"),
        curve("NoKnownColumns", "A,B\n1,2\n3,4\n",
              ": --strain: no column is known for the strain; it has A, B: give --strain"),
        curve("StressWithoutUnit", changed_curve(" (MPa)", ""),
              ": --stress = Stress: has no unit in the file: a stress needs a unit (examples: Pa, "
              "MPa, ksi); write --stress \"Stress:MPa\"")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Options, BadCurve,
    ::testing::Values(
        options("UnknownColumn", {"--strain", "Stain"},
                "--strain = Stain: is not a column of a.csv, which has 2 columns: Strain, Stress"),
        options("UnitOfOtherDimension", {"--stress", "Stress:mm"},
                "--stress = Stress:mm: \"mm\" is not a unit of stress (examples: Pa, MPa, ksi)"),
        options("StrainAndElongation", {"--strain", "Strain", "--elongation", "Strain"},
                "--elongation = Strain: cannot go with --strain"),
        options("StrainAndGaugeLength", {"--strain", "Strain", "--gauge-length", "50 mm"},
                "--gauge-length = 50 mm: cannot go with --strain"),
        options("StressAndArea", {"--stress", "Stress", "--area", "12 mm^2"},
                "--area = 12 mm^2: cannot go with --stress"),
        options(
            "SwappedColumns", {"--strain", "Stress:%", "--stress", "Strain:MPa", "--override-unit"},
            "a.csv: strain = Stress: is in MPa in the file, and \"Strain\" for the stress in %: "
            "the columns are swapped"),
        options("LoadWithoutArea", {"--load", "Stress:N"},
                "a.csv: --area: is missing: by it the column \"Stress\", a load, becomes a stress"),
        options("NegativeArea", {"--load", "Stress:N", "--area", "-3 mm^2"},
                "--area = -3 mm^2: must be positive"),
        options(
            "ElongationWithoutGaugeLength", {"--elongation", "Strain:mm"},
            "a.csv: --gauge-length: is missing: by it the column \"Strain\", a length, becomes a "
            "strain"),
        options("UnknownTest", {"--test", "pull"},
                "--test = pull: must be one of tension, bending, torsion"),
        options("TableWithoutKey", {"--table", "info.csv"},
                "--table = info.csv: must be FILE:KEY, the key being a column"),
        options(
            "GroupWithoutTable", {"--group", "lot"},
            "--group = lot: needs --table, which has this column, or HDF5 files with attributes"),
        options("FixWithoutValue", {"--fix", "youngs_modulus"},
                "--fix = youngs_modulus: must be NAME=VALUE, such as youngs_modulus=\"200 GPa\""),
        options(
            "FixOfUnknownName", {"--fix", "young_modulus=200 GPa"},
            "--fix young_modulus: is not the name of a parameter; did you mean youngs_modulus?"),
        options("FixWithoutUnit", {"--fix", "youngs_modulus=200"},
                "--fix youngs_modulus = 200: a stress needs a unit (examples: Pa, MPa, ksi)"),
        options("FixOutOfRange", {"--fix", "youngs_modulus=-1 GPa"},
                "--fix youngs_modulus = -1 GPa: must be above 0 Pa"),
        options("FixTwice",
                {"--fix", "youngs_modulus=1 GPa", "--fix", "material.youngs_modulus=2 GPa"},
                "--fix = material.youngs_modulus=2 GPa: this parameter is fixed twice"),
        options("FixOfAll",
                {"--fix", "youngs_modulus=200 GPa", "--fix", "yield_stress=1 MPa", "--fix",
                 "break_strain=1 %"},
                "--fix = break_strain=1 %: leaves nothing to fit: all parameters are fixed"),
        options("FileTwice", {"a.csv"}, "inputs = a.csv: is named twice")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Inspected, BadCurve,
    ::testing::Values(
        BadInput{"MissingFileToInspect",
                 {},
                 {"inspect", "a.csv"},
                 "a.csv: cannot be read: No such file or directory"},
        BadInput{"EmptyFileToInspect", {{"a.csv", ""}}, {"inspect", "a.csv"}, "a.csv: is empty"}),
    name_of_case);

}  // namespace
}  // namespace plastica::testing
