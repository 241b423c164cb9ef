#pragma once

#include <string>
#include <string_view>

#include "plastica/base/check.hpp"

namespace plastica::model_detail {

/// A number with so many significant digits.
std::string rounded(double value, int digits);

/// A number as messages show it: six significant digits.
std::string number_text(double value);

/// A figure as warnings show it: three significant digits.
std::string figure(double value);

/// Throws InputError(where, field, value, rule) unless `holds`.
void require(bool holds, const SourceLocation& where, std::string_view field, double value,
             std::string_view rule);

/// Requires a finite number above zero.
void require_positive(double value, const SourceLocation& where, std::string_view field);

/// Requires a finite number of at least zero.
void require_not_negative(double value, const SourceLocation& where, std::string_view field);

}  // namespace plastica::model_detail
