#pragma once

#include <vector>

namespace plastica {

/// A factor over time, piecewise straight. What it multiplies (a load, a prescribed motion) says
/// the unit. In statics time is the path parameter.
struct History {
  std::vector<double> time{0.0, 1.0};    ///< [s], rising (n)
  std::vector<double> factor{0.0, 1.0};  ///< [1] (n)
  /// Whether it goes on along its last line after the end, and along its first one before the
  /// beginning (n >= 2); else it holds its last and first values.
  bool continues = false;

  /// 0 at time 0, 1 at time 1, on along the same line beyond both.
  static History ramp() { return {{0.0, 1.0}, {0.0, 1.0}, true}; }
  /// 1 at all times.
  static History constant() { return {{0.0}, {1.0}}; }
  /// From 0 at time 0 over the turning points, one at each whole time 1, 2, …; holds the last one.
  static History turning_points(const std::vector<double>& factors);

  double at(double time) const;        ///< the factor
  double slope_at(double time) const;  ///< d factor / d time, of the piece that begins at `time`
  double end() const { return time.back(); }
  bool operator==(const History&) const = default;
};

}  // namespace plastica
