#include "plastica/io/read_drive.hpp"

#include <filesystem>

#include "plastica/io/csv_column.hpp"
#include "plastica/io/read_input.hpp"

namespace plastica::io {
namespace {

std::vector<double> listed_strain(const TomlValue& list) {
  std::vector<double> strain;
  for (const TomlValue& item : list.array()) strain.push_back(item.quantity(Dimension::Strain));
  if (strain.empty()) throw list.error("must have at least one sample");
  return strain;
}

std::vector<double> tabled_strain(const TomlTable& table, const std::string& file) {
  const TomlValue name = table.at("table");
  const TomlValue column = table.at("column");
  const auto unit = table.find("unit");
  const auto path = std::filesystem::path(file).parent_path() / name.string();
  if (!is_file(path)) {
    throw name.error("is not a file in the folder of " + file + why_no_file(path));
  }
  const CsvTable csv = CsvTable::read(path.string());
  NamedColumn source;
  source.name = column.is_string() ? column.string() : std::to_string(column.integer(1, 1'000'000));
  source.where = unit ? unit->where() : column.where();
  source.key = column.key();
  if (unit) source.unit = unit->string();
  source.override_unit = table.is_set("override_unit");
  return read_column(csv, source, Dimension::Strain);
}

std::vector<double> programmed_strain(const TomlTable& table) {
  const std::vector<double> turns = listed_strain(table.at("turning_points"));
  const auto given = table.find("points_between");
  const auto between = given ? given->integer(0, 1'000'000) : 50;
  const auto steps = static_cast<double>(between + 1);
  std::vector<double> strain{0.0};
  for (const double turn : turns) {
    const double from = strain.back();
    if (turn == from) continue;
    for (std::int64_t i = 1; i <= between; ++i) {
      strain.push_back(from + (turn - from) * (static_cast<double>(i) / steps));
    }
    strain.push_back(turn);
  }
  return strain;
}

}  // namespace

std::vector<double> read_strain(const TomlTable& drive, const std::string& file) {
  const TomlValue strain = drive.at("strain");
  if (strain.is_array()) return listed_strain(strain);
  if (!strain.is_table()) {
    throw strain.error("must be a list of strains, { table, column } or { turning_points }");
  }
  const TomlTable how = strain.table();
  const bool by_table = how.find("table").has_value();
  const bool by_turning_points = how.find("turning_points").has_value();
  if (by_table == by_turning_points) {
    how.check_unused();
    throw strain.error("must have either table and column, or turning_points");
  }
  if (by_turning_points) return programmed_strain(how);
  return tabled_strain(how, file);
}

}  // namespace plastica::io
