#include "plastica/io/csv_text.hpp"

#include <algorithm>

#include "plastica/io/read_input.hpp"
#include "plastica/io/units.hpp"
#include "plastica/io/utf16.hpp"

namespace plastica::io::csv_text {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view without(std::string_view text, char separator) {
  const auto skip = [&](char c) { return is_blank(c) && c != separator; };
  while (!text.empty() && skip(text.front())) text.remove_prefix(1);
  while (!text.empty() && skip(text.back())) text.remove_suffix(1);
  return text;
}

/// The next cell of a line where blanks separate; moves `at` behind it. @return false if a quote is
/// not closed
bool next_word(std::string_view line, std::size_t& at, std::string_view& word) {
  const std::size_t begin = at;
  const bool quoted = line[at] == '"';
  std::size_t end = quoted ? line.find('"', begin + 1) : line.find_first_of(" \t", begin);
  if (quoted && end == std::string_view::npos) return false;
  end = std::min(end, line.size());
  word = quoted ? line.substr(begin + 1, end - begin - 1) : line.substr(begin, end - begin);
  at = std::min(line.find_first_not_of(" \t", quoted ? end + 1 : end), line.size());
  return true;
}

bool split_at_blanks(std::string_view line, std::vector<std::string_view>& cells) {
  line = without(line, '\0');
  for (std::size_t at = 0; at < line.size();) {
    std::string_view word;
    if (!next_word(line, at, word)) return false;
    cells.push_back(word);
  }
  return true;
}

/// Words that stand further apart than a blank.
void split_at_gaps(std::string_view line, std::vector<std::string_view>& cells) {
  line = without(line, '\0');
  while (!line.empty()) {
    const std::size_t end = std::min({line.find("  "), line.find('\t'), line.size()});
    cells.push_back(line.substr(0, end));
    line = without(line.substr(end), '\0');
  }
}

/// Joins "Stress" and "(MPa)".
void join_units(std::string_view line, std::vector<std::string_view>& cells) {
  std::vector<std::string_view> joined;
  for (const std::string_view cell : cells) {
    const bool is_bracket = cell.starts_with('(') || cell.starts_with('[');
    if (!is_bracket || joined.empty()) {
      joined.push_back(cell);
      continue;
    }
    const auto begin = static_cast<std::size_t>(joined.back().data() - line.data());
    const auto end = static_cast<std::size_t>(cell.data() - line.data()) + cell.size();
    joined.back() = line.substr(begin, end - begin);
  }
  cells = std::move(joined);
}

/// `text` in the given brackets, without them; empty if it is not in them.
std::string_view inside(std::string_view text, char open, char close) {
  if (text.size() < 2 || text.front() != open || text.back() != close) return {};
  return without_blanks(text.substr(1, text.size() - 2));
}

/// Chinese and Japanese programs write wide brackets.
std::string with_narrow_brackets(std::string_view text) {
  std::string narrow(text);
  for (const auto& [wide, bracket] :
       {std::pair<std::string_view, const char*>{"\xEF\xBC\x88", "("}, {"\xEF\xBC\x89", ")"}}) {
    for (std::size_t at = narrow.find(wide); at != std::string::npos; at = narrow.find(wide, at)) {
      narrow.replace(at, wide.size(), bracket);
    }
  }
  return narrow;
}

}  // namespace

std::vector<char> decoded(std::string_view bytes, const std::string& file) {
  if (const auto order = utf16_order(bytes)) {
    const std::string text = utf8_of_utf16(bytes, *order, file);
    return {text.begin(), text.end()};
  }
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
  const auto ends_line = [](char c) { return c == '\n' || c == '\r'; };
  while (!text.empty()) {
    ++number;
    // A loop of its own: find_first_of calls a function for each character.
    const auto end =
        static_cast<std::size_t>(std::find_if(text.begin(), text.end(), ends_line) - text.begin());
    const std::string_view line = text.substr(0, end);
    if (line.find_first_not_of(" \t;,") != std::string_view::npos) lines.push_back({line, number});
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
  }
  return lines;
}

bool split(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  if (separator == ' ') return split_at_blanks(line, cells);
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

bool split_names(std::string_view line, char separator, std::size_t width,
                 std::vector<std::string_view>& cells) {
  if (!split(line, separator, cells)) return false;
  if (separator != ' ' || cells.size() == width) return true;
  const std::vector<std::string_view> words = cells;
  join_units(line, cells);
  if (cells.size() == width) return true;
  cells.clear();
  split_at_gaps(line, cells);
  if (cells.size() != width) join_units(line, cells);
  if (cells.size() != width) cells = words;
  return true;
}

bool is_comment(std::string_view line) {
  line = without_blanks(line);
  return line.starts_with('#') || line.starts_with('%') || line.starts_with("//");
}

std::string_view without_blanks(std::string_view text) { return without(text, '\0'); }
std::string_view without_blanks(std::string_view line, char separator) {
  return without(line, separator);
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::pair<std::string, std::string> name_and_unit(std::string_view text) {
  const std::string narrow = with_narrow_brackets(text);
  const std::string_view header = without_blanks(narrow);
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
  for (const std::string_view word : {" / ", " in ", ", ", "/"}) {
    const std::size_t at = header.rfind(word);
    if (at == std::string_view::npos || at == 0) continue;
    const std::string_view unit = without_blanks(header.substr(at + word.size()));
    // "N/mm2" and "mm/mm" are units, no names with one.
    if (is_unit(unit) && (word.size() > 1 || !is_unit(header))) return apart(at, unit);
  }
  if (header.size() > 1 && header.back() == '%') return apart(header.size() - 1, "%");
  return {std::string(header), std::string()};
}

UnitCell unit_cell(std::string_view text) {
  const std::string narrow = with_narrow_brackets(text);
  const std::string_view cell = without_blanks(narrow);
  if (cell.empty() || cell == "-" || cell == "1") return {true, std::string(cell)};
  for (const std::string_view unit : {inside(cell, '(', ')'), inside(cell, '[', ']')}) {
    if (!unit.empty()) return {true, std::string(unit)};
  }
  if (cell == "()" || cell == "[]") return {true, std::string()};
  return {is_unit(cell), std::string(cell)};
}

std::string on_one_line(std::string_view text) {
  std::string flat(without_blanks(text));
  for (char& c : flat) {
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  }
  return flat;
}

std::string tabbed_cell(std::string_view text) {
  std::string flat = on_one_line(text);
  if (flat.find('"') == std::string::npos) return flat;
  std::string quoted = "\"";
  for (const char c : flat) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace plastica::io::csv_text
