#include "calibrate/config/read_csv_options.hpp"

#include <array>
#include <string_view>

namespace plastica::calibrate {

std::string column_name(const io::TomlValue& value) {
  return value.is_number() ? std::to_string(value.integer(1, 1'000'000)) : value.string();
}

void read_csv_options(const io::TomlTable& table, io::CsvOptions& csv) {
  static constexpr std::array<std::string_view, 5> kSeparators{",", ";", "tab", "\t", "blank"};
  static constexpr std::array<std::string_view, 2> kDecimals{".", ","};
  const auto separator = table.find("separator");
  if (separator) csv.separator = std::string_view(",;\t\t ")[separator->word(kSeparators)];
  if (const auto value = table.find("decimal")) {
    csv.decimal = kDecimals[value->word(kDecimals)][0];
    if (csv.separator == csv.decimal) throw value->error("is the separator, too");
  } else if (separator && csv.separator == csv.decimal) {
    throw separator->error("is the decimal mark, too");
  }
  if (const auto value = table.find("sheet")) csv.sheet = value->string();
  if (const auto value = table.find("path")) csv.path = value->string();
  if (const auto value = table.find("header")) {
    csv.header = static_cast<std::size_t>(value->integer(0, 1'000'000));
  }
}

}  // namespace plastica::calibrate
