#include "plastica/io/csv_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "plastica/io/read_input.hpp"
#include "plastica/io/units.hpp"

namespace plastica::io::csv_text {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view without(std::string_view text, char separator) {
  const auto skip = [&](char c) { return is_blank(c) && c != separator; };
  while (!text.empty() && skip(text.front())) text.remove_prefix(1);
  while (!text.empty() && skip(text.back())) text.remove_suffix(1);
  return text;
}

/// `text` in the given brackets, without them; empty if it is not in them.
std::string_view inside(std::string_view text, char open, char close) {
  if (text.size() < 2 || text.front() != open || text.back() != close) return {};
  return without_blanks(text.substr(1, text.size() - 2));
}

}  // namespace

std::vector<char> decoded(std::string_view bytes, const std::string& file) {
  refuse_binary(bytes, file);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (is_utf8(bytes)) return {bytes.begin(), bytes.end()};
  std::vector<char> text;
  text.reserve(bytes.size() + bytes.size() / 16);
  for (const char c : bytes) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x80) {
      text.push_back(c);
    } else {
      text.push_back(static_cast<char>(0xC0U | (code >> 6U)));
      text.push_back(static_cast<char>(0x80U | (code & 0x3FU)));
    }
  }
  return text;
}

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  int number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    if (line.find_first_not_of(" \t;,") != std::string_view::npos) lines.push_back({line, number});
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
  }
  return lines;
}

bool split(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  const char* const end = line.data() + line.size();
  const char* at = line.data();
  while (true) {
    const char* start = at;
    while (start != end && is_blank(*start) && *start != separator) ++start;
    if (start != end && *start == '"') {
      const char* close = start + 1;
      while (close != end && (*close != '"' || (close + 1 != end && close[1] == '"'))) {
        close += *close == '"' ? 2 : 1;
      }
      if (close == end) return false;
      const char* next = close + 1;
      while (next != end && is_blank(*next) && *next != separator) ++next;
      if (next == end || *next == separator) {
        cells.push_back(without({start + 1, static_cast<std::size_t>(close - start - 1)}, '"'));
        if (next == end) return true;
        at = next + 1;
        continue;
      }
    }
    const char* const next = std::find(start, end, separator);
    cells.push_back(without({start, static_cast<std::size_t>(next - start)}, separator));
    if (next == end) return true;
    at = next + 1;
  }
}

Number read_number(std::string_view cell, char decimal) {
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
  std::array<char, 64> copy{};
  if (decimal == ',') {
    if (cell.size() > copy.size()) return {};
    for (std::size_t i = 0; i < cell.size(); ++i) {
      if (cell[i] == '.') return {};
      copy[i] = cell[i] == ',' ? '.' : cell[i];
    }
    cell = {copy.data(), cell.size()};
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (end != cell.data() + cell.size()) return {};
  if (error == std::errc::result_out_of_range) {
    // Too small is zero, as near as a double comes; too large is not a measurement.
    value = std::strtod(std::string(cell).c_str(), nullptr);
    if (!(std::abs(value) < 1.0)) return {CellKind::OutOfRange, 0.0};
  } else if (error != std::errc{}) {
    return {};
  }
  return {CellKind::Number, value};
}

bool says_nan(std::string_view cell) {
  if (!cell.empty() && (cell[0] == '-' || cell[0] == '+')) cell.remove_prefix(1);
  if (cell.size() < 3) return false;
  const std::string lower = lower_case(cell);
  return lower == "nan" || lower == "nan(ind)";
}

std::string_view without_blanks(std::string_view text) { return without(text, '\0'); }

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::pair<std::string, std::string> name_and_unit(std::string_view header) {
  header = without_blanks(header);
  const auto apart = [&](std::size_t at, std::string_view unit) {
    return std::pair(std::string(without_blanks(header.substr(0, at))), std::string(unit));
  };
  if (const std::size_t open = header.rfind('['); open != std::string_view::npos && open > 0) {
    if (header.back() == ']') return apart(open, inside(header.substr(open), '[', ']'));
  }
  if (const std::size_t open = header.rfind('('); open != std::string_view::npos && open > 0) {
    const std::string_view unit = inside(header.substr(open), '(', ')');
    if (unit == "-" || is_unit(unit)) return apart(open, unit);
  }
  for (const std::string_view word : {" / ", " in "}) {
    const std::size_t at = header.rfind(word);
    if (at == std::string_view::npos || at == 0) continue;
    const std::string_view unit = without_blanks(header.substr(at + word.size()));
    if (is_unit(unit)) return apart(at, unit);
  }
  return {std::string(header), std::string()};
}

UnitCell unit_cell(std::string_view cell) {
  cell = without_blanks(cell);
  if (cell.empty() || cell == "-" || cell == "1") return {true, std::string(cell)};
  for (const std::string_view unit : {inside(cell, '(', ')'), inside(cell, '[', ']')}) {
    if (!unit.empty()) return {true, std::string(unit)};
  }
  if (cell == "()" || cell == "[]") return {true, std::string()};
  return {is_unit(cell), std::string(cell)};
}

}  // namespace plastica::io::csv_text
