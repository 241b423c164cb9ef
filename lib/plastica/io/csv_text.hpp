#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The parts of the reader of delimited text that know nothing of rows and columns.
namespace plastica::io::csv_text {

/// A line without its end; `number` counts from 1.
struct Line {
  std::string_view text;
  int number = 0;
};

/// What a cell holds.
enum class CellKind {
  Number,      ///< a finite number
  Missing,     ///< empty, NaN, NA, n/a, -, null
  OutOfRange,  ///< a number that a double cannot hold
  Text,
};

struct Number {
  CellKind kind = CellKind::Text;
  double value = 0.0;  ///< NaN if missing
};

/// Removes a byte order mark; turns text that is not UTF-8 from Latin-1 into UTF-8.
/// @throws InputError for UTF-16 and for bytes that no text has
std::vector<char> decoded(std::string_view bytes, const std::string& file);

/// The lines that hold more than blanks and separators; ends are LF, CRLF or CR.
std::vector<Line> lines_of(std::string_view text);

/// Cuts a line into cells without the blanks and quotes around them; a doubled quote inside a
/// quoted cell stays doubled. @return false if a quote is not closed
bool split(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// Reads a cell. `decimal` is '.' or ','.
Number read_number(std::string_view cell, char decimal);

/// Whether a cell says NaN in letters: unlike "" and "-", it stands where a number would.
bool says_nan(std::string_view cell);

std::string_view without_blanks(std::string_view text);
std::string lower_case(std::string_view text);

/// Takes "Stress (MPa)", "Strain [%]", "Force / kN" or "Force in kN" apart: name and unit. What is
/// in parentheses or behind a slash has to be a unit, or belongs to the name.
std::pair<std::string, std::string> name_and_unit(std::string_view header);

/// Unit in a cell of a unit row, "(kN)", "[kN]", "kN" or "-"; `is_unit` is false if it is none.
struct UnitCell {
  bool is_unit = false;
  std::string unit;
};
UnitCell unit_cell(std::string_view cell);

}  // namespace plastica::io::csv_text
