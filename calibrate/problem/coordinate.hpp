#pragma once

#include <algorithm>
#include <cmath>

#include "plastica/base/scalar.hpp"

namespace plastica::calibrate {

/// The coordinate in which a search moves a parameter: ln(value/start), or the distance from the
/// start over a size. All else in SI.
struct Coordinate {
  double start = 0.0;               ///< at 0
  double lower = 0.0, upper = 0.0;  ///< bounds
  bool logarithmic = false;
  double size = 1.0;  ///< of a linear one, > 0

  double at(double value) const {
    using plastica::log;
    return logarithmic ? log(value / start) : (value - start) / size;
  }
  /// Within the bounds.
  double value(double x) const {
    using plastica::exp;
    return std::clamp(logarithmic ? start * exp(x) : start + size * x, lower, upper);
  }
  /// d value / d coordinate.
  double slope(double value) const { return logarithmic ? value : size; }
};

}  // namespace plastica::calibrate
