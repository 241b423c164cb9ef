#pragma once

#include <span>
#include <string>
#include <string_view>

#include "plastica/report/format.hpp"

/// How the text report of a scene writes numbers and lines; not installed.
namespace plastica::report {

/// A labelled line: "  level           planar: …".
std::string entry(std::string_view label, std::string_view text);

/// The largest size of finite numbers.
double largest_of(std::span<const double> values);

/// The unit in which numbers of a dimension are read best.
DisplayUnit shown_unit(Dimension dimension, double magnitude);

/// A number in the unit in which it is read best: "12.3 mm".
std::string shown(double value, Dimension dimension, int digits = 5);

/// A number among others of the size `largest`: what is round-off beside them is zero.
std::string beside(double value, double largest);

}  // namespace plastica::report
