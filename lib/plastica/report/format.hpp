#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "plastica/base/quantity.hpp"

/// How numbers, units and texts look in everything that people read.
namespace plastica::report {

/// The unit in which a number is shown: shown = SI value / scale.
struct DisplayUnit {
  std::string_view name;  ///< "MPa"; empty for pure numbers
  double scale = 1.0;
};

/// The engineering unit of a dimension: % for strains; GPa, MPa, kPa or Pa for stresses, by
/// magnitude; SI for all else.
/// @param magnitude  the largest number to be shown, in SI
/// @param modulus    whether the stress is a modulus, which is in GPa from 1 GPa on; a stress is
///                   in MPa up to 10 GPa
DisplayUnit display_unit(Dimension dimension, double magnitude, bool modulus = false);
/// A number with a count of significant digits, without an exponent where that is readable.
std::string significant(double value, int digits = 5);
/// The shortest text of at most 5 digits: "10", "0.1", "2000".
std::string brief(double value);
/// "281.23 ± 0.41": the error has two digits, and the value as many decimals as the error.
std::string with_error(double value, double error);
/// Decimals with which an error shows `digits` digits, and its value at most seven.
int decimals_for(double value, double error, int digits = 2);
/// The distance of labels along an axis: 1, 2 or 5 times a power of ten, at most `most` of which
/// lie within `range`. @param range  > 0 @param most  taken for 2 if below
double round_step(double range, int most);
/// A number and its unit: "281.23 MPa", "0.2 %".
std::string quantity(std::string_view number, std::string_view unit);
/// "1 sample", "3 samples".
std::string counted(std::size_t count, std::string_view noun);

/// A name as a cell of CSV: in quotes where it holds a comma, a quote or a line's end (RFC 4180);
/// with an apostrophe in front where a spreadsheet would take it for a formula ("=2+3", "@sum").
std::string csv_cell(std::string_view name);

/// Text of a user as one printable line: control characters become blanks, bytes that are not
/// UTF-8 become question marks.
std::string printable(std::string_view text);
/// Columns that a UTF-8 text takes: its code points.
std::size_t width_of(std::string_view text);
/// The text in lines of at most `width` columns: the first begins with `first`, all others with
/// blanks of the same width. Ends with a line end. Words longer than a line are broken.
std::string wrapped(std::string_view first, std::string_view text, std::size_t width);
/// At most `width` columns, the end replaced by an ellipsis where it is cut.
std::string cut(std::string_view text, std::size_t width);

}  // namespace plastica::report
