#include "calibrate/config/write_target.hpp"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "calibrate/config/find_files.hpp"

namespace plastica::calibrate {
namespace {

std::string list(const std::vector<std::string>& texts) {
  std::string text = "[";
  for (const std::string& item : texts) text += (text.size() > 1 ? ", " : "") + toml_string(item);
  return text + "]";
}

std::string unit_text(const std::optional<std::string>& unit) {
  return unit ? ", unit = " + toml_string(*unit) : "";
}

void add(std::string& text, std::string_view key, const std::optional<ColumnSource>& column) {
  if (!column) return;
  text += fmt::format("{} = {{ column = {}{} }}\n", key, toml_string(column->column),
                      unit_text(column->unit));
}

void add(std::string& text, std::string_view key, const std::optional<SpecimenValue>& value,
         std::string_view si_unit) {
  if (!value) return;
  if (value->value) {
    text += fmt::format("{} = \"{} {}\"\n", key, *value->value, si_unit);
    return;
  }
  text += fmt::format("{} = {{ from = {}{} }}\n", key, toml_string(value->from),
                      unit_text(value->unit));
}

void add(std::string& text, const io::CsvOptions& csv) {
  if (csv.separator) {
    const std::string separator = *csv.separator == '\t'  ? "tab"
                                  : *csv.separator == ' ' ? "blank"
                                                          : std::string(1, *csv.separator);
    text += fmt::format("separator = {}\n", toml_string(separator));
  }
  if (csv.decimal) text += fmt::format("decimal = \"{}\"\n", *csv.decimal);
  if (csv.header) text += fmt::format("header = {}\n", *csv.header);
}

}  // namespace

std::string toml_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') quoted += '\\';
    if (code < ' ' || code == 0x7F) {
      quoted += fmt::format("\\u{:04X}", static_cast<unsigned>(code));
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string target_text(const TargetSource& source) {
  std::vector<std::string> patterns;
  for (const std::string& file : source.files) patterns.push_back(literal_pattern(file));
  std::string text = "[[target]]\nfiles = " + list(patterns) + "\n";
  constexpr std::string_view kTests[] = {"tension", "bending", "torsion"};
  text += fmt::format("test = \"{}\"\n", kTests[static_cast<int>(source.test)]);
  if (source.measure == Measure::True) text += "measure = \"true\"\n";
  if (source.loading) {
    text += fmt::format("loading = \"{}\"\n",
                        *source.loading == Loading::Cyclic ? "cyclic" : "monotonic");
  }
  add(text, "strain", source.strain);
  add(text, "elongation", source.elongation);
  add(text, "gauge_length", source.gauge_length, "m");
  add(text, "stress", source.stress);
  add(text, "force", source.force);
  add(text, "area", source.area, "m^2");
  add(text, "strain_rate", source.strain_rate, "1/s");
  if (source.table) {
    text += fmt::format("table = {{ file = {}, key = {} }}\n", toml_string(source.table->file),
                        toml_string(source.table->key));
  }
  if (!source.group.empty()) text += "group = " + list(source.group) + "\n";
  add(text, source.csv);
  return text;
}

}  // namespace plastica::calibrate
