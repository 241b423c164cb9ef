#pragma once

#include <vector>

namespace plastica {

/// A factor over time: straight segments, or with `slope` cubic ones (Hermite's) that go smoothly
/// into each other. What it multiplies (a load, a prescribed motion) says the unit. In statics time
/// is the path parameter.
struct History {
  /// Slopes before and after a time [1/s].
  struct SlopeChange {
    double before = 0.0;
    double after = 0.0;
    bool ends = false;  ///< there a smooth history begins or ends, and has no slope beyond
  };

  std::vector<double> time{0.0, 1.0};    ///< [s], rising (n)
  std::vector<double> factor{0.0, 1.0};  ///< [1] (n)
  /// Whether it goes on along its last line after the end, and along its first one before the
  /// beginning (n >= 2); else it holds its last and first values.
  bool continues = false;
  /// d factor / d time at each time [1/s] (n); empty: straight segments. Then it does not continue.
  std::vector<double> slope{};

  /// 0 at time 0, 1 at time 1, on along the same line beyond both.
  static History ramp() { return {{0.0, 1.0}, {0.0, 1.0}, true}; }
  /// 1 at all times.
  static History constant() { return {{0.0}, {1.0}}; }
  /// From 0 at time 0 over the turning points, one at each whole time 1, 2, …; holds the last one.
  static History turning_points(const std::vector<double>& factors);
  /// 0 up to `from`, then 3 s^2 - 2 s^3 with s from 0 to 1, and 1 from `to` on; `from` < `to` [s].
  static History smooth_step(double from, double to);
  /// offset + sin(2 pi t / period + phase) up to cycles periods, where it holds. Within 2e-8: 128
  /// cubic segments a period, which are off by h^4/384, h = 2 pi/128.
  /// @param period  [s], > 0
  /// @param cycles  > 0, an integer or not
  /// @param phase   [rad]
  static History sine(double period, double cycles, double phase = 0.0, double offset = 0.0);
  /// The cubic spline through points: factor, slope and curvature go smoothly from one segment into
  /// the next, at the first and the last inner point the third derivative, too ("not a knot"), so
  /// that it is within O(h^4) of a smooth function, at its ends as well. Of three points the
  /// parabola, of two the line.
  /// Source: de Boor, A Practical Guide to Splines (1978), ch. IV.
  /// @param time  [s], rising (n >= 2)
  static History spline(std::vector<double> time, std::vector<double> factor);

  double at(double time) const;        ///< the factor
  double slope_at(double time) const;  ///< d factor / d time, of the segment that begins at `time`
  /// Its slopes on both sides of its point that is nearer to a time than `tolerance`; where none
  /// is, twice that at the time.
  SlopeChange slopes_about(double time, double tolerance) const;
  /// d^2 factor / d time^2 of the segment that begins at `time`; 0 of straight ones.
  double curvature_at(double time) const;
  double end() const { return time.back(); }
  /// Times at which its slope may jump [s]: all of straight segments, both ends of smooth ones.
  std::vector<double> corners() const;
  /// Times inside of smooth segments at which the factor turns back [s], rising: between corners
  /// and these it goes one way, which is all that a path of equilibria depends on.
  std::vector<double> reversals() const;
  bool operator==(const History&) const = default;
};

}  // namespace plastica
