#include "calibrate/config/write_target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "calibrate/config/find_files.hpp"
#include "plastica/io/units.hpp"

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

/// Writes a block line by line, each with what is said of its key.
class BlockWriter {
 public:
  explicit BlockWriter(const BlockGuess& block) : block_(block) {}

  void add(std::string_view key, const std::optional<ColumnSource>& column) {
    if (!column) return;
    const bool lacks_unit = is_missing(std::string(key) + ".unit");
    line(key, fmt::format("{{ column = {}{}{}{} }}", toml_string(column->column),
                          lacks_unit ? ", unit = \"?\"" : unit_text(column->unit),
                          column->override_unit ? ", override_unit = true" : "",
                          column->factor != 1.0 ? fmt::format(", factor = {:g}", column->factor)
                                                : std::string()));
  }

  /// @param unit  where the value has none of its own
  void add(std::string_view key, const std::optional<SpecimenValue>& value, Dimension dimension) {
    if (!value) {
      const std::string_view shown = dimension == Dimension::Area ? "mm^2" : "mm";
      if (is_missing(key)) line(key, fmt::format("\"? {}\"", shown));
    } else if (value->value && value->unit) {
      const double scale = io::unit_conversion(*value->unit, dimension).scale;
      line(key, fmt::format("\"{:.10g} {}\"", *value->value / scale, *value->unit));
    } else if (value->value) {
      line(key, fmt::format("\"{} {}\"", *value->value, si_unit(dimension)));
    } else {
      line(key, fmt::format("{{ from = {}{}{} }}", toml_string(value->from), unit_text(value->unit),
                            value->override_unit ? ", override_unit = true" : ""));
    }
  }

  void line(std::string_view key, std::string_view value) {
    constexpr std::size_t kWidth = 80;
    const std::string line = fmt::format("{} = {}", key, value);
    std::string beside;
    for (const auto& [of, words] : block_.comments) {
      if (of != key) continue;
      if (beside.empty() && line.size() + words.size() + 4 <= kWidth) {
        beside = "  # " + words;
      } else {
        text_ += "# " + words + "\n";
      }
    }
    text_ += line + beside + "\n";
  }

  bool is_missing(std::string_view key) const {
    return std::ranges::find(block_.missing, key) != block_.missing.end();
  }

  std::string text() && { return std::move(text_); }

 private:
  const BlockGuess& block_;
  std::string text_ = "[[target]]\n";
};

void add(std::string& text, const io::CsvOptions& csv) {
  if (csv.separator) {
    const std::string separator = *csv.separator == '\t'  ? "tab"
                                  : *csv.separator == ' ' ? "blank"
                                                          : std::string(1, *csv.separator);
    text += fmt::format("separator = {}\n", toml_string(separator));
  }
  if (csv.sheet) text += fmt::format("sheet = {}\n", toml_string(*csv.sheet));
  if (csv.path) text += fmt::format("path = {}\n", toml_string(*csv.path));
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

std::string target_text(const BlockGuess& block) {
  const TargetSource& source = block.source;
  std::vector<std::string> patterns;
  for (const std::string& file : source.files) patterns.push_back(literal_pattern(file));
  constexpr std::string_view kTests[] = {"\"tension\"", "\"bending\"", "\"torsion\""};
  BlockWriter to(block);
  to.line("files", list(patterns));
  to.line("test", kTests[static_cast<int>(source.test)]);
  if (source.measure) {
    to.line("measure", source.measure == Measure::True ? "\"true\"" : "\"engineering\"");
  }
  if (source.loading) {
    to.line("loading", *source.loading == Loading::Cyclic ? "\"cyclic\"" : "\"monotonic\"");
  }
  if (to.is_missing("strain")) to.line("strain", "{ column = \"?\", unit = \"%\" }");
  to.add("strain", source.strain);
  to.add("elongation", source.elongation);
  to.add("gauge_length", source.gauge_length, Dimension::Length);
  if (to.is_missing("stress")) to.line("stress", "{ column = \"?\", unit = \"MPa\" }");
  to.add("stress", source.stress);
  to.add("force", source.force);
  to.add("area", source.area, Dimension::Area);
  to.add("strain_rate", source.strain_rate, Dimension::StrainRate);
  if (source.table) {
    to.line("table", fmt::format("{{ file = {}, key = {} }}", toml_string(source.table->file),
                                 toml_string(source.table->key)));
  }
  if (!source.group.empty()) to.line("group", list(source.group));
  if (!source.split.empty()) to.line("split", list(source.split));
  std::string text = std::move(to).text();
  add(text, source.csv);
  return text;
}

std::string target_text(const TargetSource& source) { return target_text({source, {}, {}}); }

}  // namespace plastica::calibrate
