#include "calibrate/config/fit_file.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "calibrate/config/templates.hpp"
#include "calibrate/fit/fit.hpp"
#include "tests/calibrate/config/config_folder.hpp"

namespace plastica::calibrate {
namespace {

class FitFileTest : public ConfigFolder {
 protected:
  FitFile parse(const std::string& text) const { return parse_fit_file(text, path("f.toml")); }

  /// A file whose only target has `files`, strain and stress, and what is given.
  FitFile with(const std::string& more) const { return parse(kTarget + more); }

  std::vector<std::string> files(const FitFile& file) const {
    std::vector<std::string> found;
    for (const TargetBlock& block : file.targets) {
      for (const std::string& name : block.source.files) found.push_back(local(name));
    }
    return found;
  }

  const std::string kTarget =
      "[[target]]\nfiles = '*.csv'\nstrain = 'Strain'\nstress = { column = 'Stress', unit = 'MPa' "
      "}\n";
};

using Names = std::vector<std::string>;

TEST_F(FitFileTest, ReadsTheFileOfTheReadme) {
  for (const char* name : {"targets/al6061-a.csv", "targets/al6061-b.csv", "targets/s355.csv"}) {
    write(name);
  }
  write("info.csv", "test_id,temperature\nal6061-a,20\n");
  const std::string text = R"([fit]
objective = "path"
[fit.parameters]
youngs_modulus = { bounds = ["20 GPa", "400 GPa"] }
yield_stress   = { bounds = ["10 MPa", "2 GPa"] }
break_strain   = { bounds = ["0.1 %", "100 %"] }
[[target]]
files  = ["targets/al6061-*.csv"]
test   = "tension"
strain = { column = "Strain" }
stress = { column = "Stress_MPa", unit = "MPa" }
table  = { file = "info.csv", key = "test_id" }
group  = ["temperature"]
)";
  write("fit.toml", text);
  const FitFile file = read_fit_file(path("fit.toml"));
  EXPECT_EQ(file.path, path("fit.toml"));
  EXPECT_EQ(file.text, text);
  EXPECT_EQ(file.options.parameters.size(), 3U);
  EXPECT_EQ(files(file), (Names{"targets/al6061-a.csv", "targets/al6061-b.csv"}));
  const TargetSource& source = file.targets.at(0).source;
  EXPECT_EQ(source.strain->column, "Strain");
  EXPECT_FALSE(source.strain->unit);
  EXPECT_EQ(source.stress->column, "Stress_MPa");
  EXPECT_EQ(source.stress->unit, "MPa");
  EXPECT_EQ(local(source.table->file), "info.csv");
  EXPECT_EQ(source.table->key, "test_id");
  EXPECT_EQ(source.group, Names{"temperature"});
  EXPECT_EQ(source.where.line, 7);
}

TEST_F(FitFileTest, ReadsForceAndElongationOfAMachine) {
  write("Zx1.csv");
  write("info.csv");
  const FitFile file = parse(R"([[target]]
files = "Zx1.csv"
elongation = { column = 4, unit = "mm" }
gauge_length = "50 mm"
force = { column = "Load", unit = "kN" }
area = { from = "S0_mm2", unit = "mm^2" }
table = { file = "info.csv", key = "specimen" }
separator = ";"
decimal = ","
header = 2
)");
  const TargetSource& source = file.targets.at(0).source;
  EXPECT_FALSE(source.strain || source.stress);
  EXPECT_EQ(source.elongation->column, "4");
  EXPECT_DOUBLE_EQ(*source.gauge_length->value, 0.05);
  EXPECT_EQ(source.force->unit, "kN");
  EXPECT_FALSE(source.area->value);
  EXPECT_EQ(source.area->from, "S0_mm2");
  EXPECT_EQ(source.area->unit, "mm^2");
  EXPECT_EQ(source.csv.separator, ';');
  EXPECT_EQ(source.csv.decimal, ',');
  EXPECT_EQ(source.csv.header, 2U);
}

TEST_F(FitFileTest, SetsEveryCorrectionAndCharacteristic) {
  write("a.csv");
  const FitFile file = with(R"(loading = "monotonic"
[target.corrections]
toe = "0.05 %"
preload = "off"
trim = "4 %"
measure = "true-forced"
reversal_tolerance = "0.01 %"
shift_threshold = "2 %"
drop_fraction = 0.3
zero_fraction = 0
end_fraction = "80 %"
[target.characteristics]
modulus = "chord"
window = ["10 MPa", "100 MPa"]
offset = "0.1 %"
yield_drop = "1 %"
min_samples = 4
)");
  using enum CorrectionChoice::Mode;
  const TargetOptions& options = file.targets.at(0).options;
  EXPECT_EQ(options.loading, Loading::Monotonic);
  EXPECT_EQ(file.targets.at(0).source.loading, Loading::Monotonic);
  EXPECT_EQ(options.toe.mode, Set);
  EXPECT_DOUBLE_EQ(options.toe.amount, 0.0005);
  EXPECT_EQ(options.preload.mode, Off);
  EXPECT_EQ(options.trim.mode, Set);
  EXPECT_DOUBLE_EQ(options.trim.amount, 0.04);
  EXPECT_TRUE(options.convert_to_true);
  EXPECT_TRUE(options.force_true);
  EXPECT_DOUBLE_EQ(options.reversal_tolerance, 1e-4);
  EXPECT_DOUBLE_EQ(options.shift_threshold, 0.02);
  EXPECT_EQ(options.drop_fraction, 0.3);
  EXPECT_EQ(options.zero_fraction, 0.0);
  EXPECT_DOUBLE_EQ(options.end_fraction, 0.8);
  EXPECT_EQ(options.modulus_method, ModulusMethod::Chord);
  EXPECT_EQ(options.modulus_window, std::pair(10e6, 100e6));
  EXPECT_DOUBLE_EQ(options.offset, 0.001);
  EXPECT_DOUBLE_EQ(options.yield_drop, 0.01);
  EXPECT_EQ(options.min_samples, 4U);
}

TEST_F(FitFileTest, TakesAWindowInFractionsAndAGivenModulus) {
  write("a.csv");
  const auto fractions = with("characteristics = { window = ['10 %', 0.4] }").targets.at(0).options;
  EXPECT_FALSE(fractions.modulus_window);
  EXPECT_DOUBLE_EQ(fractions.modulus_low, 0.1);
  EXPECT_EQ(fractions.modulus_high, 0.4);
  const auto given = with("characteristics = { modulus = '10000 ksi' }").targets.at(0).options;
  EXPECT_NEAR(*given.youngs_modulus, 68.9476e9, 1e6);
}

TEST_F(FitFileTest, LeavesAllToTheRulesIfNothingIsSet) {
  write("a.csv");
  const TargetOptions options = with("").targets.at(0).options;
  const TargetOptions defaults;
  EXPECT_EQ(options.test, Deformation::Tension);
  EXPECT_FALSE(options.loading);
  EXPECT_EQ(options.toe.mode, CorrectionChoice::Mode::Automatic);
  EXPECT_EQ(options.trim.mode, CorrectionChoice::Mode::Automatic);
  EXPECT_EQ(options.offset, defaults.offset);
  EXPECT_FALSE(options.convert_to_true || options.youngs_modulus || options.modulus_window);
}

TEST_F(FitFileTest, LetsATargetChangeTheDefaultsOfAll) {
  write("a.csv");
  write("b.csv");
  const FitFile file = parse(R"([target_defaults]
strain = "e"
stress = { column = "s", unit = "ksi" }
measure = "true"
corrections = { toe = "off", trim = "off" }
[[target]]
files = "a.csv"
[[target]]
files = "b.csv"
elongation = { column = "u", unit = "mm" }
gauge_length = "50 mm"
corrections = { toe = "auto" }
)");
  EXPECT_EQ(file.targets[0].source.strain->column, "e");
  EXPECT_EQ(file.targets[0].options.toe.mode, CorrectionChoice::Mode::Off);
  EXPECT_FALSE(file.targets[1].source.strain);
  EXPECT_EQ(file.targets[1].source.elongation->column, "u");
  EXPECT_EQ(file.targets[1].source.stress->column, "s");
  EXPECT_EQ(file.targets[1].options.measure, Measure::True);
  EXPECT_EQ(file.targets[1].options.toe.mode, CorrectionChoice::Mode::Automatic);
  EXPECT_EQ(file.targets[1].options.trim.mode, CorrectionChoice::Mode::Off);
}

TEST_F(FitFileTest, ReadsThePatternsOfATargetInTheirOrder) {
  for (const char* name : {"two/b.csv", "two/a.csv", "one/a.csv", "c.csv"}) write(name);
  const FitFile file =
      parse("[[target]]\nfiles = ['two/*', '{one,three}/*', 'c.*']\nstrain = 1\nstress = 2\n");
  EXPECT_EQ(files(file), (Names{"two/a.csv", "two/b.csv", "one/a.csv", "c.csv"}));
}

TEST_F(FitFileTest, RunsTheTemplateOfInit) {
  const auto written = template_files("fit");
  for (const TemplateFile& file : written) write(file.name, file.text);
  const FitFile file = read_fit_file(path(written[0].name));
  EXPECT_EQ(file.options.parameters.size(), 3U);
  const auto targets = import_all(file);
  ASSERT_EQ(targets.size(), 1U);
  EXPECT_EQ(targets[0].status, TargetStatus::Ready) << targets[0].reason;
  const FitResult result = fit_target(targets[0], file.options);
  ASSERT_EQ(result.status, FitStatus::Fitted) << result.reason;
  EXPECT_NEAR(result.parameter("youngs_modulus").value, 200e9, 1e9);
  EXPECT_NEAR(result.parameter("yield_stress").value, 350e6, 0.5e6);
  EXPECT_NEAR(result.parameter("break_strain").value, 0.02, 1e-4);
}

TEST_F(FitFileTest, SaysThatTwoBlocksReadOneCurve) {
  const auto written = template_files("fit");
  for (const TemplateFile& file : written) write(file.name, file.text);
  const std::string own = written[0].text;
  const std::string block = own.substr(own.find("\n[[target]]"));
  const auto once = import_all(parse(own));
  const auto twice = import_all(parse(own + "\n" + block));
  ASSERT_EQ(twice.size(), 2U);
  EXPECT_EQ(twice[0].warnings, once[0].warnings);
  ASSERT_EQ(twice[1].warnings.size(), once[0].warnings.size() + 1);
  EXPECT_EQ(twice[1].warnings.back(), "its curve is that of " + twice[0].name +
                                          ", too: two [[target]] blocks read it, and it counts "
                                          "twice");
}

/// A copy in another file, and one file by two paths.
TEST_F(FitFileTest, SaysThatACurveIsACopy) {
  const auto warnings_of = [&](const std::vector<std::string>& blocks) {
    std::string text;
    for (const std::string& files : blocks) {
      text +=
          "[[target]]\nstrain = 1\nstress = { column = 2, unit = 'MPa' }\nfiles = " + files + "\n";
    }
    const auto targets = import_all(parse(text));
    Names warnings;
    for (const Target& target : targets) {
      for (const std::string& warning : target.warnings) {
        if (warning.starts_with("its curve is")) warnings.push_back(target.name + ": " + warning);
      }
    }
    return warnings;
  };
  std::string curve = "e,s\n", other = "e,s\n";
  for (int i = 0; i < 60; ++i) {
    const std::string strain = std::to_string(1e-4 * i) + ',';
    curve += strain + std::to_string(std::min(20.0 * i, 400.0)) + '\n';
    other += strain + std::to_string(std::min(20.0 * i, 401.0)) + '\n';
  }
  write("x/a.csv", curve);
  write("x/b.csv", other);
  write("x/c.csv", curve);
  EXPECT_EQ(warnings_of({"['x/*.csv']"}),
            Names{"c: its curve is that of a, too, in another file: a copy counts twice"});
  const Names again = warnings_of({"['x/a.csv', 'x/b.csv']", "'x/../x/a.csv'"});
  ASSERT_EQ(again.size(), 1U);
  EXPECT_TRUE(again[0].ends_with("too: two [[target]] blocks read it, and it counts twice"));
  EXPECT_EQ(warnings_of({"['x/a.csv', 'x/b.csv']"}), Names{});
}

TEST_F(FitFileTest, GroupsSpecimensOfBlocksByTheSameNumber) {
  for (const char* name : {"one/a.csv", "one/b.csv", "two/c.csv", "two/d.csv"}) write(name);
  write("one.csv", "id,temperature\na,20\nb,20.0\n");
  write("two.csv", "id,temperature\nc,2e1\nd,room\n");
  const FitFile file = parse(
      "[target_defaults]\nstrain = 1\nstress = { column = 2, unit = 'MPa' }\n"
      "group = ['temperature']\n"
      "[[target]]\nfiles = 'one/*'\ntable = { file = 'one.csv', key = 'id' }\n"
      "[[target]]\nfiles = 'two/*'\ntable = { file = 'two.csv', key = 'id' }\n");
  Names groups;
  for (const Target& target : import_all(file)) groups.push_back(target.group.at(0).second);
  EXPECT_EQ(groups, (Names{"20", "20", "20", "room"}));
}

TEST_F(FitFileTest, GivesSpecimensOfOneNameNumbers) {
  for (const char* name : {"one/a.csv", "two/a.csv"}) write(name);
  const FitFile file = parse(
      "[target_defaults]\nstrain = 1\nstress = { column = 2, unit = 'MPa' }\n"
      "[[target]]\nfiles = 'one/*'\n[[target]]\nfiles = 'two/*'\n");
  const auto targets = import_all(file);
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_EQ(targets[0].name, "a");
  EXPECT_EQ(targets[1].name, "a#2");
}

}  // namespace
}  // namespace plastica::calibrate
