#include "calibrate/config/bare_files.hpp"

#include <utility>

#include "tests/calibrate/config/config_folder.hpp"

namespace plastica::calibrate {
namespace {

class BareFilesTest : public ConfigFolder {
 protected:
  void SetUp() override {
    ConfigFolder::SetUp();
    write("named.csv", "Strain (%),Stress (MPa)\n0,0\n1,100\n2,110\n");
    write("plain.csv", "a,b\n0,0\n1,100\n2,110\n");
    write("machine.csv", "Elongation (mm),Load (kN)\n0,0\n1,100\n2,110\n");
    write("info.csv", "id,S0_mm2,lot\nmachine,100,A\nnamed,90,B\n");
  }

  BareFiles of(const std::vector<std::string>& names) const {
    BareFiles bare;
    for (const std::string& name : names) bare.files.push_back(path(name));
    return bare;
  }
  std::string error(const BareFiles& bare) const {
    return error_of([&] { fit_of_bare_files(bare); });
  }
  /// The error of one option of plain.csv, whose columns are given otherwise.
  template <typename Change>
  std::string error_with(const Change& change) const {
    BareFiles bare = of({"plain.csv"});
    bare.strain = "a:%";
    bare.stress = "b:MPa";
    change(bare);
    return error(bare);
  }
};

TEST_F(BareFilesTest, GuessesColumnsFromTheirNames) {
  const FitFile file = fit_of_bare_files(of({"named.csv"}));
  EXPECT_EQ(file.path, "");
  ASSERT_EQ(file.targets.size(), 1U);
  EXPECT_EQ(file.targets[0].source.strain->column, "Strain");
  EXPECT_EQ(file.targets[0].source.stress->column, "Stress");
  ASSERT_EQ(file.options.parameters.size(), 3U);
  for (const Parameter& parameter : file.options.parameters) {
    EXPECT_EQ(parameter.role, ParameterRole::Free);
  }
}

TEST_F(BareFilesTest, TakesColumnsAndUnitsFromTheOptions) {
  BareFiles bare = of({"plain.csv"});
  bare.strain = "a:%";
  bare.stress = "2:MPa";
  bare.test = "bending";
  bare.measure = "true";
  const TargetSource source = fit_of_bare_files(bare).targets.at(0).source;
  EXPECT_EQ(source.strain->column, "a");
  EXPECT_EQ(source.strain->unit, "%");
  EXPECT_EQ(source.stress->column, "2");
  EXPECT_EQ(source.stress->unit, "MPa");
  EXPECT_EQ(source.test, Deformation::Bending);
  EXPECT_EQ(source.measure, Measure::True);
}

TEST_F(BareFilesTest, TakesANameWithColonsThatEndsWithOne) {
  write("colon.csv", "a,b:c (MPa)\n0,0\n1,100\n2,110\n");
  BareFiles bare = of({"colon.csv"});
  bare.strain = "a";
  bare.stress = "b:c:";
  EXPECT_EQ(fit_of_bare_files(bare).targets.at(0).source.stress->column, "b:c");
}

TEST_F(BareFilesTest, MakesATargetForEachSetOfColumns) {
  write("named2.csv", "Strain (%),Stress (MPa)\n0,0\n1,100\n2,110\n");
  BareFiles bare = of({"named.csv", "machine.csv", "named2.csv"});
  bare.gauge_length = "50 mm";
  bare.area = "S0_mm2:mm^2";
  bare.table = path("info.csv") + ":id";
  bare.group = {"lot"};
  const FitFile file = fit_of_bare_files(bare);
  ASSERT_EQ(file.targets.size(), 2U);
  EXPECT_EQ(file.targets[0].source.files.size(), 2U);
  const TargetSource& machine = file.targets[1].source;
  EXPECT_EQ(machine.elongation->column, "Elongation");
  EXPECT_DOUBLE_EQ(*machine.gauge_length->value, 0.05);
  EXPECT_EQ(machine.area->from, "S0_mm2");
  EXPECT_EQ(machine.area->unit, "mm^2");
  EXPECT_EQ(machine.table->key, "id");
  EXPECT_EQ(machine.group, std::vector<std::string>{"lot"});
}

TEST_F(BareFilesTest, FixesParameters) {
  BareFiles bare = of({"named.csv"});
  bare.fixed = {"youngs_modulus=200 GPa", "poisson_ratio=0.25"};
  const auto parameters = fit_of_bare_files(bare).options.parameters;
  ASSERT_EQ(parameters.size(), 4U);
  EXPECT_EQ(parameters[0].role, ParameterRole::Fixed);
  EXPECT_DOUBLE_EQ(*parameters[0].value, 200e9);
  EXPECT_EQ(*parameters[1].value, 0.25);
  EXPECT_EQ(parameters[2].name(), "yield_stress");
  EXPECT_EQ(parameters[3].role, ParameterRole::Free);
}

TEST_F(BareFilesTest, HasATextThatReadsTheSame) {
  BareFiles bare = of({"plain.csv"});
  bare.strain = "a:%";
  bare.stress = "b:MPa";
  bare.fixed = {"break_strain=2 %"};
  const FitFile file = fit_of_bare_files(bare);
  EXPECT_EQ(local(file.text), R"([fit.parameters]
"material.break_strain" = { value = "2 %", fixed = true }
youngs_modulus = {}
yield_stress = {}

[[target]]
files = ["plain.csv"]
test = "tension"
strain = { column = "a", unit = "%" }
stress = { column = "b", unit = "MPa" }
)");
  EXPECT_EQ(parse_fit_file(file.text, "").targets.at(0).source.files,
            file.targets.at(0).source.files);
}

TEST_F(BareFilesTest, ReadsEachFileOnce) {
  const FitFile file = fit_of_bare_files(of({"named.csv"}));
  // What is there now was never read.
  write("named.csv", "Strain (%),Stress (MPa)\n0,0\n1,999\n2,999\n");
  const std::vector<Target> targets = import_all(file);
  EXPECT_EQ(targets.at(0).raw.stress, (std::vector<double>{0.0, 100e6, 110e6}));
}

TEST_F(BareFilesTest, RefusesNoFileAndFilesThatAreNotThere) {
  EXPECT_EQ(error({}), "FILE: give at least one file");
  EXPECT_EQ(error(of({"no.csv"})), "no.csv: cannot be read: No such file or directory");
  EXPECT_EQ(error(of({"named.csv", "named.csv"})),
            "target[1].files[2] = named.csv: matches named.csv, which line 7 has already");
}

TEST_F(BareFilesTest, RefusesANameThatIsNotUtf8) {
  write("caf\xE9.csv", "Strain (%),Stress (MPa)\n0,0\n1,100\n2,110\n");
  EXPECT_EQ(error(of({"named.csv", "caf\xE9.csv"})),
            "caf\xE9.csv: has a name that is not UTF-8 text; rename it");
  EXPECT_EQ(error_with([](BareFiles& bare) { bare.strain = "\xE9:%"; }),
            "an option is not UTF-8 text");
}

TEST_F(BareFilesTest, RefusesColumnsThatItCannotGuess) {
  EXPECT_EQ(error(of({"plain.csv"})),
            "plain.csv: --strain: no column is known for the strain; it has a, b: give --strain");
  write("half.csv", "Strain,b\n0,0\n1,100\n2,110\n");
  EXPECT_EQ(error(of({"half.csv"})),
            "half.csv: --stress: no column is known for the stress; it has Strain, b: give "
            "--stress");
}

TEST_F(BareFilesTest, RefusesAColumnThatIsNotThere) {
  EXPECT_EQ(error_with([](BareFiles& bare) { bare.stress = "c"; }),
            "--stress = c: is not a column of plain.csv, which has 2 columns: a, b");
  EXPECT_EQ(error_with([](BareFiles& bare) { bare.stress = ":MPa"; }),
            "--stress = :MPa: must be COLUMN or COLUMN:UNIT");
}

TEST_F(BareFilesTest, RefusesAMissingOrWrongUnit) {
  EXPECT_EQ(error_with([](BareFiles& bare) { bare.stress = "b"; }),
            "plain.csv: --stress = b: has no unit in the file: a stress needs a unit (examples: "
            "Pa, MPa, ksi); write --stress \"b:MPa\"");
  EXPECT_EQ(error_with([](BareFiles& bare) { bare.stress = "b:mm"; }),
            "--stress = b:mm: \"mm\" is not a unit of stress (examples: Pa, MPa, ksi)");
  // Nobody is told to call millimetres a strain.
  write("ways.csv", "Way (mm),Load (kN)\n0,0\n1,100\n2,110\n");
  BareFiles machine = of({"ways.csv"});
  machine.strain = "Way";
  machine.stress = "Load";
  EXPECT_TRUE(
      error(machine).ends_with("; a length becomes a strain by --elongation \"Way\" and "
                               "--gauge-length"));
  std::swap(machine.strain, machine.stress);
  EXPECT_TRUE(error(machine).ends_with("; is another column meant?"));
}

TEST_F(BareFilesTest, RefusesForceWithoutAreaAndTheLike) {
  BareFiles bare = of({"machine.csv"});
  EXPECT_EQ(error(bare),
            "machine.csv: --gauge-length: is missing: by it the column \"Elongation\", a length, "
            "becomes a strain");
  bare.gauge_length = "50 mm";
  EXPECT_EQ(error(bare),
            "machine.csv: --area: is missing: by it the column \"Load\", a load, becomes a stress");
  bare.area = "100";
  EXPECT_EQ(error(bare), "--area = 100: an area needs a unit (examples: m^2, mm^2, in^2)");
  bare.area = "0 mm^2";
  EXPECT_EQ(error(bare), "--area = 0 mm^2: must be positive");
}

TEST_F(BareFilesTest, RefusesOptionsThatContradictEachOther) {
  EXPECT_EQ(error_with([](BareFiles& bare) { bare.force = "b"; }),
            "--load = b: cannot go with --stress");
  EXPECT_EQ(error_with([](BareFiles& bare) { bare.group = {"lot"}; }),
            "--group = lot: needs --table, which has this column, or HDF5 files with attributes");
  EXPECT_EQ(error_with([](BareFiles& bare) { bare.table = "info.csv"; }),
            "--table = info.csv: must be FILE:KEY, the key being a column");
}

TEST_F(BareFilesTest, RefusesWordsThatItDoesNotKnow) {
  EXPECT_EQ(error_with([](BareFiles& bare) { bare.test = "pull"; }),
            "--test = pull: must be one of tension, bending, torsion");
  EXPECT_EQ(error_with([](BareFiles& bare) { bare.measure = "nominal"; }),
            "--measure = nominal: must be one of engineering, true");
}

TEST_F(BareFilesTest, RefusesFixesThatMakeNoSense) {
  const auto fix = [&](const std::vector<std::string>& fixed) {
    return error_with([&](BareFiles& bare) { bare.fixed = fixed; });
  };
  EXPECT_EQ(fix({"youngs_modulus"}),
            "--fix = youngs_modulus: must be NAME=VALUE, such as youngs_modulus=\"200 GPa\"");
  EXPECT_EQ(fix({"young_modulus=200 GPa"}),
            "--fix young_modulus: is not the name of a parameter; did you mean youngs_modulus?");
  EXPECT_EQ(fix({"youngs_modulus=200"}),
            "--fix youngs_modulus = 200: a stress needs a unit (examples: Pa, MPa, ksi)");
  EXPECT_EQ(fix({"youngs_modulus=-1 GPa"}), "--fix youngs_modulus = -1 GPa: must be above 0 Pa");
  EXPECT_EQ(fix({"break_strain=1 %", "break_strain=2 %"}),
            "--fix = break_strain=2 %: this parameter is fixed twice");
  EXPECT_EQ(fix({"youngs_modulus=1 GPa", "yield_stress=1 MPa", "break_strain=1 %"}),
            "--fix = break_strain=1 %: leaves nothing to fit: all parameters are fixed");
}

TEST_F(BareFilesTest, KeepAFileThatCannotBeReadForItsRejection) {
  write("empty.csv", "");
  const FitFile file = fit_of_bare_files(of({"empty.csv", "named.csv"}));
  ASSERT_EQ(file.targets.size(), 1U);
  const std::vector<Target> targets = import_all(file);
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_EQ(targets[1].name, "empty");
  EXPECT_EQ(targets[1].status, TargetStatus::Rejected);
  EXPECT_EQ(error(of({"empty.csv"})), "empty.csv: is empty");
}

}  // namespace
}  // namespace plastica::calibrate
