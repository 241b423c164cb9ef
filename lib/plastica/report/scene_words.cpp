#include "plastica/report/scene_words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "plastica/report/ink.hpp"

namespace plastica::report {

std::string entry(std::string_view label, std::string_view text) {
  return wrapped(fmt::format("  {:<16}", label), text, kWidth);
}

double largest_of(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) largest = std::max(largest, std::fabs(value));
  }
  return largest;
}

DisplayUnit shown_unit(Dimension dimension, double magnitude) {
  if (dimension == Dimension::Length && magnitude < 1.0) return {"mm", 1e-3};
  if (dimension == Dimension::Force && magnitude >= 1e4) return {"kN", 1e3};
  if (dimension == Dimension::Moment && magnitude >= 1e4) return {"kN m", 1e3};
  return display_unit(dimension, magnitude);
}

std::string shown(double value, Dimension dimension, int digits) {
  const DisplayUnit unit = shown_unit(dimension, value);
  return quantity(significant(value / unit.scale, digits), unit.name);
}

std::string beside(double value, double largest) {
  return std::fabs(value) <= 1e-9 * largest ? "0" : significant(value);
}

}  // namespace plastica::report
