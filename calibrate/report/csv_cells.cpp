#include "calibrate/report/csv_cells.hpp"

#include <fmt/format.h>

#include <cmath>

#include "plastica/report/format.hpp"

namespace plastica::calibrate::report {

std::string cell_of(std::optional<double> value) {
  return value && std::isfinite(*value) ? fmt::format("{}", *value) : std::string();
}

void add_titles(std::vector<std::string>& header, const std::vector<Entry>& entries,
                const std::string& prefix, std::string_view own_units) {
  for (const Entry& entry : entries) {
    std::string& title = header.emplace_back(prefix.empty() ? entry.name : prefix);
    if (!prefix.empty() && entry.name != "value") title += "." + entry.name;
    const std::string_view units = entry.units == kOwnUnits ? own_units : entry.units;
    if (!units.empty()) title += fmt::format(" [{}]", units);
  }
}

void add_cells(std::vector<std::string>& cells, const std::vector<Entry>& entries) {
  for (const Entry& entry : entries) {
    const Json& value = entry.value;
    if (value.is_null()) {
      cells.emplace_back();
    } else if (value.is_string()) {
      cells.push_back(value.get<std::string>());
    } else if (value.is_boolean()) {
      cells.emplace_back(value.get<bool>() ? "1" : "0");
    } else if (value.is_number_float()) {
      cells.push_back(cell_of(value.get<double>()));
    } else {
      cells.push_back(value.dump());
    }
  }
}

void put_row(std::ostream& out, const std::vector<std::string>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) out << ',';
    out << plastica::report::csv_cell(cells[i]);
  }
  out << '\n';
}

}  // namespace plastica::calibrate::report
