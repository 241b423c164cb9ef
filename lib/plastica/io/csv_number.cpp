#include "plastica/io/csv_number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <string>

#include "plastica/io/csv_text.hpp"

namespace plastica::io::csv_text {
namespace {

/// Marks between thousands; the last two are blanks at which a line must not break.
constexpr std::array<std::string_view, 7> kGroupMarks{",",      ".",      " ",     "'",
                                                      "\u2019", "\u00A0", "\u202F"};

/// A number whose thousands a mark keeps apart.
struct Grouped {
  std::string digits;      ///< without the marks, with a point; empty: it is no such number
  std::string_view mark;   ///< between the groups
  std::size_t groups = 0;  ///< of three digits, behind the first one
  bool has_decimals = false;
};

/// "-1,234.5" as -1234.5: one to three digits, the first no zero, then threes.
Grouped grouped(std::string_view cell, char decimal) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  Grouped number;
  std::string_view rest = cell;
  if (!rest.empty() && (rest[0] == '-' || rest[0] == '+')) {
    if (rest[0] == '-') number.digits = "-";
    rest.remove_prefix(1);
  }
  const auto take_digits = [&](std::size_t most) {
    std::size_t count = 0;
    while (count < std::min(most, rest.size()) && is_digit(rest[count])) ++count;
    number.digits += rest.substr(0, count);
    rest.remove_prefix(count);
    return count;
  };
  if (rest.starts_with('0') || take_digits(3) == 0) return {};
  for (const std::string_view mark : kGroupMarks) {
    if (mark[0] != decimal && rest.starts_with(mark)) number.mark = mark;
  }
  if (number.mark.empty()) return {};
  for (; rest.starts_with(number.mark); ++number.groups) {
    rest.remove_prefix(number.mark.size());
    if (take_digits(3) != 3) return {};
  }
  if (!rest.empty() && rest[0] == decimal) {
    rest.remove_prefix(1);
    number.digits += '.';
    number.has_decimals = true;
    take_digits(rest.size());
  }
  if (!rest.empty()) return {};
  return number;
}

bool can_be_decimal(std::string_view mark) { return mark == "," || mark == "."; }

/// A number with a point.
Number from_text(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return {};
  if (error == std::errc::result_out_of_range) {
    // Too small is zero, as near as a double comes; too large is not a measurement.
    value = std::strtod(std::string(text).c_str(), nullptr);
    if (!(std::abs(value) < 1.0)) return {CellKind::OutOfRange, 0.0};
  } else if (error != std::errc{}) {
    return {};
  }
  return {CellKind::Number, value};
}

Number without_groups(std::string_view cell, char decimal) {
  if (decimal == '.') return from_text(cell);
  std::array<char, 64> copy{};
  if (cell.size() > copy.size() || cell.find('.') != std::string_view::npos) return {};
  std::replace_copy(cell.begin(), cell.end(), copy.begin(), ',', '.');
  return from_text({copy.data(), cell.size()});
}

}  // namespace

Number read_number(std::string_view cell, NumberFormat format) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  if (cell.empty()) return {CellKind::Missing, kNaN};
  const bool sign = cell[0] == '-' || cell[0] == '+';
  const char first = cell.size() > 1 && sign ? cell[1] : cell[0];
  if (!((first >= '0' && first <= '9') || first == '.' || first == ',')) {
    if (says_nan(cell)) return {CellKind::Missing, kNaN};
    const std::string lower = lower_case(cell);
    if (lower == "na" || lower == "n/a" || lower == "-" || lower == "null") {
      return {CellKind::Missing, kNaN};
    }
    return {};
  }
  if (cell[0] == '+') cell.remove_prefix(1);
  const Number number = without_groups(cell, format.decimal);
  if (number.kind != CellKind::Text) return number;
  const Grouped parts = grouped(cell, format.decimal);
  const bool certain = parts.has_decimals || parts.groups > 1 || !can_be_decimal(parts.mark);
  return certain || format.is_certain ? from_text(parts.digits) : Number{};
}

std::string number_text(double value) {
  if (std::isnan(value)) return "nan";
  constexpr double kPlain = 1e15;
  const bool is_whole = value == std::floor(value) && std::fabs(value) < kPlain;
  std::array<char, 32> digits{};
  char* const first = digits.data();
  char* const last = first + digits.size();
  return {first, is_whole ? std::to_chars(first, last, value, std::chars_format::fixed).ptr
                          : std::to_chars(first, last, value).ptr};
}

bool is_ambiguous(std::string_view cell) {
  const Grouped parts = grouped(cell, cell.find(',') == std::string_view::npos ? ',' : '.');
  return parts.groups == 1 && !parts.has_decimals && can_be_decimal(parts.mark);
}

bool says_nan(std::string_view cell) {
  if (!cell.empty() && (cell[0] == '-' || cell[0] == '+')) cell.remove_prefix(1);
  if (cell.size() < 3) return false;
  const std::string lower = lower_case(cell);
  return lower == "nan" || lower == "nan(ind)";
}

}  // namespace plastica::io::csv_text
