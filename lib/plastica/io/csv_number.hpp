#pragma once

#include <string>
#include <string_view>

/// Numbers in the cells of delimited text.
namespace plastica::io::csv_text {

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

/// How a file writes numbers.
struct NumberFormat {
  char decimal = '.';       ///< or ','
  bool is_certain = false;  ///< the other mark can only part thousands
};

/// Reads a cell. Thousands may stand apart: by a blank, an apostrophe, or the mark that is not the
/// decimal one where it can be no other, as in 1,234.5 and 1.234.567, or in any file of that
/// format.
Number read_number(std::string_view cell, NumberFormat format);

/// A number as a cell with a decimal point that reads back bit by bit: "nan" if it is none, whole
/// ones up to 1e15 as they would be typed, which a key or a group is compared with.
std::string number_text(double value);

/// Whether a cell is one of two numbers: "1,234" is 1.234 or 1234.
bool is_ambiguous(std::string_view cell);

/// Whether a cell says NaN in letters: unlike "" and "-", it stands where a number would.
bool says_nan(std::string_view cell);

}  // namespace plastica::io::csv_text
