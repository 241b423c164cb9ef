#pragma once

#include <vector>

namespace plastica {

/// A factor over time, piecewise straight; holds its last value after the end. What it multiplies
/// (a load, a prescribed motion) says the unit. In statics time is the path parameter.
struct History {
  std::vector<double> time{0.0, 1.0};    ///< [s], rising (n)
  std::vector<double> factor{0.0, 1.0};  ///< [1] (n)

  /// 0 at time 0, 1 at time 1, on along the same line after that.
  static History ramp() { return {}; }
  /// 1 at all times.
  static History constant() { return {{0.0}, {1.0}}; }
  /// From 0 at time 0 over the turning points, one at each whole time 1, 2, …
  static History turning_points(const std::vector<double>& factors);

  double at(double time) const;        ///< the factor
  double slope_at(double time) const;  ///< d factor / d time, of the piece that begins at `time`
  bool is_ramp() const;                ///< whether it is `ramp()`: it goes on after its last point
  double end() const { return time.back(); }
};

}  // namespace plastica
