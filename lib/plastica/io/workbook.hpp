#pragma once

#include <optional>
#include <string>

/// Sheets of Excel workbooks (.xlsx: Office Open XML in a zip archive), as the text of a table.
namespace plastica::io {

/// Whether a file begins as a zip archive. Pipes and what cannot be read are none.
bool is_workbook(const std::string& path);

/// A sheet as text: cells between tabs, a line for each row of the sheet, so that lines count as
/// its rows do. Numbers stand as the workbook stores them, a percentage below a text with a "%"
/// times 100, as it is shown; an error such as #N/A is NaN, of a formula its last result counts.
/// Cells that are text are quoted where they need it.
struct SheetText {
  std::string name;
  std::string text;
  /// '.'; or ',' where cells that are text hold numbers with a decimal comma: then all do.
  char decimal = '.';
};

/// @param sheet  its name, as the workbook has it; empty: the only one that holds a table of
///        numbers (three rows with two numbers each and more), of hidden ones none; or the only one
///        with numbers
/// @param decimal  of numbers that are text, where these do not show it
/// @throws InputError if it is no workbook or damaged, if there is no such sheet, or, without a
///         name, none or more than one; if formulas lack their results; if numbers that are text
///         may be read in two ways
SheetText read_sheet(const std::string& path, const std::optional<std::string>& sheet,
                     std::optional<char> decimal);

}  // namespace plastica::io
