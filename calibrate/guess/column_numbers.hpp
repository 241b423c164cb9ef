#pragma once

#include <cstddef>
#include <vector>

#include "plastica/io/csv.hpp"

namespace plastica::calibrate {

/// The numbers of a column, NaN where a cell has none; all NaN where one is a word.
std::vector<double> numbers_in(const io::CsvTable& table, std::size_t column);

/// How the numbers of a column run.
struct ColumnNumbers {
  double first = 0.0;
  double low = 0.0, high = 0.0;  ///< least and largest, 0 included
  bool is_constant = true;       ///< or has no number
  bool is_negative = false;      ///< most of those beyond a thousandth of the largest are
  bool is_clock = false;         ///< rise by equal steps, as time does

  double largest() const { return -low > high ? -low : high; }
};

ColumnNumbers column_numbers(const std::vector<double>& values);

}  // namespace plastica::calibrate
