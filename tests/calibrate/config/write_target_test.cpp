#include "calibrate/config/write_target.hpp"

#include "calibrate/config/fit_file.hpp"
#include "tests/calibrate/config/config_folder.hpp"

namespace plastica::calibrate {
namespace {

class WriteTarget : public ConfigFolder {};

TEST(TomlString, EscapesWhatTomlWantsEscaped) {
  EXPECT_EQ(toml_string("Stress \"true\" \\ MPa\t"), "\"Stress \\\"true\\\" \\\\ MPa\\u0009\"");
  EXPECT_EQ(toml_string("Länge"), "\"Länge\"");
}

TEST_F(WriteTarget, SaysWhatTheReaderUnderstands) {
  write("a [1].csv");
  write("info.csv");
  TargetSource source;
  source.files = {"a [1].csv"};
  source.measure = Measure::True;
  source.loading = Loading::Cyclic;
  source.elongation = ColumnSource{"dL \"x\"", "mm", {}};
  source.gauge_length = SpecimenValue{0.05, "", std::nullopt, {}};
  source.force = ColumnSource{"3", std::nullopt, {}};
  source.area = SpecimenValue{std::nullopt, "S0", "mm^2", {}};
  source.table.emplace();
  source.table->file = "info.csv";
  source.table->key = "id";
  source.group = {"lot", "temperature"};
  source.csv = {'\t', ',', 2};
  const std::string text = target_text(source);
  EXPECT_EQ(text, R"([[target]]
files = ["a \\[1\\].csv"]
test = "tension"
measure = "true"
loading = "cyclic"
elongation = { column = "dL \"x\"", unit = "mm" }
gauge_length = "0.05 m"
force = { column = "3" }
area = { from = "S0", unit = "mm^2" }
table = { file = "info.csv", key = "id" }
group = ["lot", "temperature"]
separator = "tab"
decimal = ","
header = 2
)");
  const TargetSource read = parse_fit_file(text, path("f.toml")).targets.at(0).source;
  EXPECT_EQ(local(read.files.at(0)), "a [1].csv");
  EXPECT_EQ(read.elongation->column, source.elongation->column);
  EXPECT_EQ(read.gauge_length->value, 0.05);
  EXPECT_EQ(read.area->from, "S0");
  EXPECT_EQ(read.csv.separator, '\t');
}

}  // namespace
}  // namespace plastica::calibrate
