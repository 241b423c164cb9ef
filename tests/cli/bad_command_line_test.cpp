#include "tests/cli/bad_input.hpp"
#include "tests/cli/curves.hpp"

namespace plastica::testing {
namespace {

/// A command line beside a good fit file, and a file "mine" that is in the way of nothing else.
BadInput line(std::string name, std::vector<std::string> arguments, std::string message) {
  return {std::move(name),
          {{"fit.toml", fit_file("'a.csv'")},
           {"other.toml", fit_file("'a.csv'")},
           {"a.csv", broken_curve()},
           {"mine", "my own"}},
          std::move(arguments),
          std::move(message)};
}

class BadCommandLine : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadCommandLine, IsRefusedInOneLine) { expect_refusal(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Words, BadCommandLine,
    ::testing::Values(
        line("UnknownCommand", {"calibrat", "fit.toml"},
             "calibrat: is not a command; did you mean calibrate?"),
        line("HelpOfUnknownCommand", {"calibrat", "--help"},
             "calibrat: is not a command; did you mean calibrate?"),
        line("UnlikelyCommand", {"xyzzy"},
             "xyzzy: is not a command; there are calibrate, inspect, init, simulate, sweep, merge, "
             "check, advise, recommend, stability, diff, show, plot, report, export, fields, "
             "completion, man"),
        line("UnknownOption", {"calibrate", "fit.toml", "--thread", "1"},
             "The following argument was not expected: --thread (see plastica calibrate --help)"),
        line("NoInput", {"calibrate"}, "inputs is required (see plastica calibrate --help)"),
        line("OptionWithoutValue", {"calibrate", "fit.toml", "-o"},
             "--output: 1 required TEXT missing (see plastica calibrate --help)"),
        line("EmptyOutput", {"calibrate", "fit.toml", "-o", ""}, "argument 4, behind -o: is empty"),
        line("EmptySummary", {"calibrate", "fit.toml", "--json="}, "--json: is empty"),
        line("EmptyInput", {"calibrate", ""}, "argument 2, behind calibrate: is empty"),
        line("NegativeThreads", {"calibrate", "fit.toml", "--threads", "-1"},
             "--threads: Value -1 not in range 0 to 4096 (see plastica calibrate --help)"),
        line("ThreadsInWords", {"calibrate", "fit.toml", "--threads", "two"},
             "--threads: Value two not in range 0 to 4096 (see plastica calibrate --help)"),
        line("TwoFitFiles", {"calibrate", "fit.toml", "other.toml"},
             "calibrate = fit.toml: must be the only file: a fit file names its curves"),
        line("FitFileAndCurve", {"calibrate", "a.csv", "fit.toml"},
             "calibrate = fit.toml: must be the only file: a fit file names its curves"),
        line("OptionOfBareCurvesWithFitFile",
             {"calibrate", "fit.toml", "--fix", "youngs_modulus=200 GPa"},
             "--fix: is for curves without a fit file; this is what fit.toml says"),
        line("MultilinearWithoutATable",
             {"calibrate", "fit.toml", "--laws", "ideal,multilinear", "--dry-run"},
             "laws = multilinear: needs a table, and none is made up: "
             "material.hardening.plastic_strain and flow_stress of a fit file say where its fit "
             "begins"),
        line("UnknownKindToInit", {"init", "sweeps"},
             "kind: sweeps not in {fit,scene-fit,scene,coupon,sweep,check} (see plastica init "
             "--help)"),
        line("InitOverAFitFile", {"init", "fit"},
             "init = ./fit.toml: exists already; --force overwrites it"),
        line("InitInMissingFolder", {"init", "scene", "-d", "none"},
             "--directory = none: must be a folder that exists")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Outputs, BadCommandLine,
    ::testing::Values(
        line("OutputExists", {"calibrate", "fit.toml", "-o", "mine"},
             "mine: exists already: use --force to overwrite it"),
        line("OutputInMissingFolder", {"calibrate", "fit.toml", "-o", "none/fit.h5"},
             "none/fit.h5: cannot be written: there is no folder none"),
        line("OutputInAFile", {"calibrate", "fit.toml", "-o", "mine/fit.h5"},
             "mine/fit.h5: cannot be written: mine is no folder"),
        line("OutputIsAFolder", {"calibrate", "fit.toml", "-o", "."},
             ".: cannot be written: it is a folder"),
        line("OutputOverTheCurve", {"calibrate", "fit.toml", "-o", "./a.csv", "--force"},
             "--output = ./a.csv: is a file that this run reads"),
        line("OutputOverTheFitFile", {"calibrate", "fit.toml", "-o", "fit.toml", "--force"},
             "--output = fit.toml: is a file that this run reads"),
        line("OutputOfAnotherFormat", {"calibrate", "fit.toml", "-o", "fit.csv"},
             "--output = fit.csv: is written as HDF5: must end in .h5; plastica export and plot "
             "make other files of it"),
        line("SummaryOverTheCurve", {"calibrate", "fit.toml", "--json", "a.csv"},
             "--json = a.csv: is a file that this run reads"),
        line("SummaryOverTheOutput", {"calibrate", "fit.toml", "-o", "x", "--json", "./x"},
             "--json = ./x: is the output, too"),
        line("SummaryInMissingFolder", {"calibrate", "fit.toml", "--json", "none/fit.json"},
             "none/fit.json: cannot be written: there is no folder none")),
    name_of_case);

TEST(BadCommandLines, MayNotTakeAFileForAJournalThatIsNone) {
  BadInput input = line("", {"calibrate", "fit.toml"},
                        "fit.h5.journal: is in the place of the journal but is none: move it, or "
                        "name another output");
  input.files["fit.h5.journal"] = "my own";
  expect_refusal(input);
}

TEST(BadCommandLines, GetOneLineEvenIfAFileNameHasTwo) {
  expect_refusal(
      line("", {"show", "a\nb.h5"}, "a b.h5: cannot be read: No such file or directory"));
}

}  // namespace
}  // namespace plastica::testing
