#include "calibrate/report/csv_cells.hpp"

#include <fmt/format.h>

#include <cmath>

#include "plastica/report/format.hpp"

namespace plastica::calibrate::report {

std::string cell_of(std::optional<double> value) {
  return value && std::isfinite(*value) ? fmt::format("{}", *value) : std::string();
}

void put_row(std::ostream& out, const std::vector<std::string>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) out << ',';
    out << plastica::report::csv_cell(cells[i]);
  }
  out << '\n';
}

}  // namespace plastica::calibrate::report
