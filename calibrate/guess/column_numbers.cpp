#include "calibrate/guess/column_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plastica::calibrate {
namespace {

bool rises_evenly(const std::vector<double>& values) {
  if (values.size() < 5) return false;
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (!(std::abs(values[i] - values[i - 1] - step) <= 1e-3 * std::abs(step))) return false;
  }
  return step > 0.0;
}

}  // namespace

std::vector<double> numbers_in(const io::CsvTable& table, std::size_t column) {
  try {
    return table.numbers(column);
  } catch (const InputError&) {
    return std::vector<double>(table.rows(), std::numeric_limits<double>::quiet_NaN());
  }
}

ColumnNumbers column_numbers(const std::vector<double>& values) {
  ColumnNumbers numbers;
  bool any = false;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (!any) numbers.first = value;
    any = true;
    numbers.is_constant = numbers.is_constant && value == numbers.first;
    numbers.low = std::min(numbers.low, value);
    numbers.high = std::max(numbers.high, value);
  }
  const double far = 1e-3 * numbers.largest();
  const auto below = std::ranges::count_if(values, [&](double v) { return v < -far; });
  const auto above = std::ranges::count_if(values, [&](double v) { return v > far; });
  numbers.is_negative = below > 2 * above;
  numbers.is_clock = rises_evenly(values);
  return numbers;
}

}  // namespace plastica::calibrate
