#include "calibrate/config/fit_file.hpp"

#include <iterator>
#include <sstream>

#include "tests/calibrate/config/config_folder.hpp"

namespace plastica::calibrate {
namespace {

class FitFileErrors : public ConfigFolder {
 protected:
  void SetUp() override {
    ConfigFolder::SetUp();
    write("a.csv");
  }

  std::string error(const std::string& text) const {
    return error_of([&] { parse_fit_file(text, path("f.toml")); });
  }

  /// The error of one more line, line 5, in a valid target.
  std::string with(const std::string& line) const {
    return error("[[target]]\nfiles = 'a.csv'\nstrain = 'e'\nstress = 's'\n" + line + "\n");
  }
};

TEST_F(FitFileErrors, AFileThatIsNotThereIsNamed) {
  EXPECT_EQ(error_of([&] { read_fit_file(path("no.toml")); }),
            "no.toml: cannot be read: No such file or directory");
}

TEST_F(FitFileErrors, BrokenTomlIsNamedWithItsLine) {
  EXPECT_EQ(error("[fit]\nnoise = 2 MPa\n"),
            "f.toml:2: noise = 2 MPa: is not TOML (column 11): key-value pair: expected a comment "
            "or whitespace, saw 'M'; words and quantities stand in quotes, \"355 MPa\"");
}

TEST_F(FitFileErrors, AFitWithoutTargetsIsRefused) {
  EXPECT_EQ(error("[fit]\n"), "f.toml: target: is missing: a fit needs at least one [[target]]");
  EXPECT_EQ(error("[target]\nfiles = 'a.csv'\n"),
            "f.toml:1: target: must be a list of tables, each with the header [[target]]");
  EXPECT_EQ(error("[[targets]]\nfiles = 'a.csv'\n"),
            "f.toml:1: targets: is not a key; did you mean target?");
}

TEST_F(FitFileErrors, FilesThatMatchNothingAreRefused) {
  EXPECT_EQ(error("[[target]]\nfiles = ['a.csv', '*.tsv']\n"),
            "f.toml:2: target[1].files[2] = *.tsv: matches no file in FOLDER");
  std::filesystem::create_directory(folder_ / "deep");
  EXPECT_EQ(error("[[target]]\nfiles = 'deep'\n"),
            "f.toml:2: target[1].files = deep: matches no file in FOLDER: it is a folder");
}

TEST_F(FitFileErrors, BracesThatStandForTooManyPatternsAreRefused) {
  std::string braces;
  for (int i = 0; i < 15; ++i) braces += "{a,b}";
  EXPECT_EQ(error("[[target]]\nfiles = ['a.csv', '" + braces + "']\n"),
            "f.toml:2: target[1].files[2] = " + braces +
                ": stands for more than 10000 patterns by its braces; give a list of patterns");
}

TEST_F(FitFileErrors, ALinkToItselfIsNoTable) {
  std::filesystem::create_symlink("loop.csv", folder_ / "loop.csv");
  EXPECT_EQ(with("table = { file = 'loop.csv', key = 'id' }"),
            "f.toml:5: target[1].table.file = loop.csv: is not a file in FOLDER: Too many levels "
            "of symbolic links");
}

TEST_F(FitFileErrors, AFileThatMatchesTwiceIsRefused) {
  EXPECT_EQ(error("[[target]]\nfiles = ['a.csv',\n'*.csv']\nstrain = 1\nstress = 2\n"),
            "f.toml:3: target[1].files[2] = *.csv: matches a.csv, which line 2 has already");
}

TEST_F(FitFileErrors, ATargetWithoutFilesIsRefused) {
  EXPECT_EQ(error("[[target]]\nstrain = 1\n"), "f.toml:1: target[1].files: is missing");
  EXPECT_EQ(error("[[target]]\nfile = 'a.csv'\n"),
            "f.toml:1: target[1].files: is missing; is it \"file\" on line 2?");
  EXPECT_EQ(error("[[target]]\nfiles = []\n"),
            "f.toml:2: target[1].files = []: must be a text in quotes, or a list of such");
}

TEST_F(FitFileErrors, StrainAndStressMustBeThereOnce) {
  EXPECT_EQ(error("[[target]]\nfiles = 'a.csv'\nstress = 's'\n"),
            "f.toml:1: target[1].strain: is missing: give strain, or elongation and gauge_length");
  EXPECT_EQ(error("[[target]]\nfiles = 'a.csv'\nstrain = 'e'\n"),
            "f.toml:1: target[1].stress: is missing: give stress, or force and area");
  EXPECT_EQ(with("force = 'F'"), "f.toml:5: target[1].force = F: cannot go with stress");
  EXPECT_EQ(with("elongation = 'u'"), "f.toml:5: target[1].elongation = u: cannot go with strain");
}

TEST_F(FitFileErrors, ForceNeedsAnAreaAndElongationAGaugeLength) {
  EXPECT_EQ(error("[[target]]\nfiles = 'a.csv'\nstrain = 'e'\nforce = 'F'\n"),
            "f.toml:1: target[1].area: is missing: force needs it");
  EXPECT_EQ(error("[[target]]\nfiles = 'a.csv'\nelongation = 'u'\nstress = 's'\n"),
            "f.toml:1: target[1].gauge_length: is missing: elongation needs it");
  EXPECT_EQ(with("area = '1 mm^2'"),
            "f.toml:5: target[1].area = 1 mm^2: is of no use without force");
  EXPECT_EQ(with("gauge_length = '1 mm'"),
            "f.toml:5: target[1].gauge_length = 1 mm: is of no use without elongation");
}

TEST_F(FitFileErrors, ForceAndElongationAreOfTensionAlone) {
  EXPECT_EQ(error("[[target]]\nfiles = 'a.csv'\nstrain = 'e'\nforce = 'F'\ntest = 'bending'\n"),
            "f.toml:4: target[1].force = F: goes with test = \"tension\" alone; bending and "
            "torsion take strain and stress of the outermost fibre");
}

TEST_F(FitFileErrors, AColumnOfTheTableNeedsTheTable) {
  EXPECT_EQ(with("group = ['temperature']"),
            "f.toml:5: target[1].group = ['temperature']: needs `table`, the file that has this "
            "column, or HDF5 files with attributes");
  EXPECT_EQ(
      error("[[target]]\nfiles = 'a.csv'\nstrain = 'e'\nforce = 'F'\narea = { from = 'S' }\n"),
      "f.toml:5: target[1].area = { from = 'S' }: needs `table`, the file that has this "
      "column, or HDF5 files with attributes");
}

TEST_F(FitFileErrors, ATableMustBeAFileWithAKey) {
  EXPECT_EQ(with("table = { file = 'no.csv', key = 'id' }"),
            "f.toml:5: target[1].table.file = no.csv: is not a file in FOLDER");
  EXPECT_EQ(with("table = { file = 'a.csv' }"), "f.toml:5: target[1].table.key: is missing");
  EXPECT_EQ(with("table = 'a.csv'"),
            "f.toml:5: target[1].table = 'a.csv': must be a table, { key = value, ... }");
}

TEST_F(FitFileErrors, UnitsMustSuitTheirColumns) {
  const std::string start = "[[target]]\nfiles = 'a.csv'\n";
  EXPECT_EQ(error(start + "strain = 'e'\nstress = { column = 's', unit = 'mm' }\n"),
            "f.toml:4: target[1].stress.unit = mm: is not a unit of stress (examples: Pa, MPa, "
            "ksi)");
  EXPECT_EQ(error(start + "strain = { column = 'e', unit = 'MPa' }\n"),
            "f.toml:3: target[1].strain.unit = MPa: is not a unit of strain (examples: %, 1, "
            "mm/mm, um/m)");
  EXPECT_EQ(error(start + "strain = 'e'\nforce = 'F'\narea = 100\n"),
            "f.toml:5: target[1].area = 100: an area needs a unit (examples: m^2, mm^2, in^2)");
  EXPECT_EQ(error(start + "strain = 'e'\nforce = 'F'\narea = '0 mm^2'\n"),
            "f.toml:5: target[1].area = 0 mm^2: must be above 0 m^2");
}

TEST_F(FitFileErrors, AColumnIsANameOrANumber) {
  const std::string start = "[[target]]\nfiles = 'a.csv'\n";
  EXPECT_EQ(error(start + "strain = true\n"),
            "f.toml:3: target[1].strain = true: must be a column, { column = \"...\", unit = "
            "\"1\" }");
  EXPECT_EQ(error(start + "strain = 0\n"),
            "f.toml:3: target[1].strain = 0: must be an integer from 1 to 1000000");
  EXPECT_EQ(error(start + "strain = { colum = 'e' }\n"),
            "f.toml:3: target[1].strain.column: is missing; is it \"colum\" on line 3?");
}

TEST_F(FitFileErrors, WordsMustBeKnown) {
  EXPECT_EQ(with("test = 'pull'"),
            "f.toml:5: target[1].test = 'pull': must be one of \"tension\", \"bending\", "
            "\"torsion\"");
  EXPECT_EQ(with("measure = 'nominal'"),
            "f.toml:5: target[1].measure = 'nominal': must be one of \"engineering\", \"true\"");
  EXPECT_EQ(with("loading = 'once'"),
            "f.toml:5: target[1].loading = 'once': must be one of \"monotonic\", \"cyclic\", "
            "\"auto\"");
  EXPECT_EQ(with("separator = '|'"),
            "f.toml:5: target[1].separator = '|': must be one of \",\", \";\", \"tab\", \"\t\", "
            "\"blank\"");
}

TEST_F(FitFileErrors, SeparatorAndDecimalMarkMustDiffer) {
  EXPECT_EQ(with("separator = ','\ndecimal = ','"),
            "f.toml:6: target[1].decimal = ,: is the separator, too");
}

TEST_F(FitFileErrors, CorrectionsAreAutomaticOffOrAStrain) {
  EXPECT_EQ(with("corrections = { toe = 'on' }"),
            "f.toml:5: target[1].corrections.toe = on: must be \"auto\", \"off\" or a strain");
  EXPECT_EQ(with("corrections = { toe = false }"),
            "f.toml:5: target[1].corrections.toe = false: must be \"auto\", \"off\" or a strain");
  EXPECT_EQ(with("corrections = { preload = '1 kN' }"),
            "f.toml:5: target[1].corrections.preload = 1 kN: \"kN\" is not a unit of strain "
            "(examples: %, 1, mm/mm, um/m)");
  EXPECT_EQ(with("corrections = { trim = 0 }"),
            "f.toml:5: target[1].corrections.trim = 0: must be above 0");
  EXPECT_EQ(with("corrections = { drop_fraction = '150 %' }"),
            "f.toml:5: target[1].corrections.drop_fraction = 150 %: must be above 0 and below 1");
  EXPECT_EQ(with("corrections = { reversal_tolerance = -0.1 }"),
            "f.toml:5: target[1].corrections.reversal_tolerance = -0.1: must be at least 0");
  EXPECT_EQ(with("corrections = { foot = 'off' }"),
            "f.toml:5: target[1].corrections.foot = 'off': is not a key of target[1].corrections; "
            "its keys are toe, preload, trim, measure, reversal_tolerance, shift_threshold, "
            "drop_fraction, zero_fraction, end_fraction");
}

TEST_F(FitFileErrors, TrueMeasureMustMakeSense) {
  EXPECT_EQ(with("measure = 'true'\ncorrections = { measure = 'true' }"),
            "f.toml:6: target[1].corrections.measure = true: the columns are true strain and "
            "stress already");
  EXPECT_EQ(with("test = 'torsion'\ncorrections = { measure = 'true' }"),
            "f.toml:6: target[1].corrections.measure = true: goes with test = \"tension\" alone");
}

TEST_F(FitFileErrors, CharacteristicsAreChecked) {
  EXPECT_EQ(with("characteristics = { modulus = 'secant' }"),
            "f.toml:5: target[1].characteristics.modulus = secant: must be \"regression\", "
            "\"chord\" or a stress such as \"200 GPa\"");
  EXPECT_EQ(with("characteristics = { modulus = 'chord' }"),
            "f.toml:5: target[1].characteristics.window: must be two stresses where the modulus "
            "is a chord");
  EXPECT_EQ(with("characteristics = { window = ['1 MPa'] }"),
            "f.toml:5: target[1].characteristics.window = ['1 MPa']: must be two stresses or two "
            "fractions, [lower, upper]");
  EXPECT_EQ(with("characteristics = { window = ['2 MPa', '1 MPa'] }"),
            "f.toml:5: target[1].characteristics.window = ['2 MPa', '1 MPa']: must rise, from 0 "
            "or more");
  EXPECT_EQ(with("characteristics = { window = ['2 MPa', 0.5] }"),
            "f.toml:5: target[1].characteristics.window = ['2 MPa', 0.5]: must be two stresses or "
            "two fractions of the proof stress, not one of each");
  EXPECT_EQ(with("characteristics = { window = [0.5, 1.5] }"),
            "f.toml:5: target[1].characteristics.window = [0.5, 1.5]: must not exceed 100 % of "
            "the proof stress");
  EXPECT_EQ(with("characteristics = { modulus = '70 GPa', window = [0.1, 0.5] }"),
            "f.toml:5: target[1].characteristics.window = [0.1, 0.5]: is of no use: the modulus "
            "is given");
  EXPECT_EQ(with("characteristics = { offset = '0 %' }"),
            "f.toml:5: target[1].characteristics.offset = 0 %: must be above 0 % and at most 5 %: "
            "0.2 % or 0.002, not 0.2");
}

TEST_F(FitFileErrors, AKeyThatNobodyKnowsIsRefused) {
  EXPECT_EQ(with("guage_length = '50 mm'"),
            "f.toml:5: target[1].guage_length = '50 mm': is not a key of target[1]; did you mean "
            "gauge_length?");
  EXPECT_EQ(error("[drive]\nstrain = [0]\n[[target]]\nfiles = 'a.csv'\nstrain = 1\nstress = 2\n"),
            "f.toml:1: drive: is not a key; its keys are material, beam, section, rules, solver, "
            "fit, target_defaults, target");
  EXPECT_EQ(error("[target_defaults]\ntests = 'x'\n[[target]]\nfiles = 'a.csv'\nstrain = 1\n"
                  "stress = 2\n"),
            "f.toml:2: target_defaults.tests = 'x': is not a key of target_defaults; did you mean "
            "test?");
}

TEST_F(FitFileErrors, AMaterialMustNotBeLeftToTheLibrarysDefaults) {
  EXPECT_EQ(with("[fit.parameters]\nyield_stress = {}"),
            "f.toml:1: fit.parameters.youngs_modulus: is missing: make it a parameter, or give it "
            "in [material]");
}

TEST_F(FitFileErrors, TheEndMayBeTheBreakWhateverItsLoad) {
  EXPECT_EQ(with("corrections = { end_fraction = '101 %' }"),
            "f.toml:5: target[1].corrections.end_fraction = 101 %: must be above 0 and at most "
            "100 %");
  EXPECT_EQ(with("corrections = { end_fraction = '100 %' }"), "no error");
}

TEST_F(FitFileErrors, BoundsOfPlausibilityRise) {
  EXPECT_EQ(with("plausible = { youngs_modulus = ['2 GPa', '1 GPa'] }"),
            "f.toml:5: target[1].plausible.youngs_modulus = ['2 GPa', '1 GPa']: must rise");
  EXPECT_EQ(with("plausible = { yield_strain = '1 %' }"),
            "f.toml:5: target[1].plausible.yield_strain = '1 %': must be a list in brackets");
  EXPECT_EQ(
      with("plausible = { yield_strain = ['1 %'] }"),
      "f.toml:5: target[1].plausible.yield_strain = ['1 %']: must be two values, [least, most]");
  EXPECT_EQ(with("plausible = { expected_modulus = '-1 GPa' }"),
            "f.toml:5: target[1].plausible.expected_modulus = -1 GPa: must be above 0");
  EXPECT_EQ(with("plausible = { group_factor = 1 }"),
            "f.toml:5: target[1].plausible.group_factor = 1: must be above 1");
  EXPECT_EQ(with("plausible = { accept = 'yes' }"),
            "f.toml:5: target[1].plausible.accept = 'yes': must be true or false");
}

TEST_F(FitFileErrors, AnOverriddenUnitNeedsAnotherOne) {
  EXPECT_EQ(error("[[target]]\nfiles = 'a.csv'\nstrain = { column = 'e', override_unit = true }\n"
                  "stress = 's'\n"),
            "f.toml:3: target[1].strain.override_unit = true: is of no use without unit");
}

TEST_F(FitFileErrors, EveryKeyStandsInItsDocumentation) {
  std::ifstream file(PLASTICA_SOURCE_DIR "/docs/file-formats.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(page.empty());
  const std::string target = "[[target]]\nfiles = 'a.csv'\nstrain = 'e'\nstress = 's'\n";
  const std::string q = "qqqqqqqqqqqqqqqqqqqqqqqqqq = 1\n";
  for (const std::string& text :
       {target + "[fit]\n" + q, target + "[fit.stop]\n" + q, target + q,
        target + "[target.corrections]\n" + q, target + "[target.characteristics]\n" + q,
        target + "[target.plausible]\n" + q,
        target + "[fit.parameters.yield_stress]\n" + q + "[material]\nname = 'S355'\n"}) {
    const std::string message = error(text);
    const auto at = message.find("its keys are ");
    ASSERT_NE(at, std::string::npos) << message;
    std::istringstream keys(message.substr(at + 13));
    for (std::string key; std::getline(keys, key, ',');) {
      key.erase(0, key.find_first_not_of(' '));
      const bool found = page.find('`' + key + '`') != std::string::npos ||
                         page.find("`stop." + key + '`') != std::string::npos ||
                         page.find(key + " = ") != std::string::npos ||
                         page.find("[fit." + key + "]") != std::string::npos;
      EXPECT_TRUE(found || key == "stop") << key;
    }
  }
}

}  // namespace
}  // namespace plastica::calibrate
