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

/// Removes a byte order mark; turns UTF-16, and text that is not UTF-8 from Latin-1, into UTF-8.
/// @throws InputError for bytes that no text has
std::vector<char> decoded(std::string_view bytes, const std::string& file);

/// The lines that hold more than blanks and separators; ends are LF, CRLF or CR.
std::vector<Line> lines_of(std::string_view text);

/// Cuts a line into cells without the blanks and quotes around them; a doubled quote inside a
/// quoted cell stays doubled. @return false if a quote is not closed
/// @param separator  ',', ';' or a tab; a blank stands for any number of blanks and tabs
bool split(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// The same for a line of names over `width` columns. Where blanks separate, a name may hold single
/// ones, or a unit in brackets behind one, if the names are as many as the columns then.
bool split_names(std::string_view line, char separator, std::size_t width,
                 std::vector<std::string_view>& cells);

/// Whether a line is a comment where it stands among rows: it begins with #, % or //.
bool is_comment(std::string_view line);

std::string_view without_blanks(std::string_view text);
/// The same of a line of cells: tabs that separate stay, so that no cell is lost at its ends.
std::string_view without_blanks(std::string_view line, char separator);
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

/// A text without blanks around it, tabs and line ends.
std::string on_one_line(std::string_view text);

/// A text as a cell between tabs: no tab, no line end, quoted as CSV does it.
std::string tabbed_cell(std::string_view text);

}  // namespace plastica::io::csv_text
