#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "calibrate/search/least_squares.hpp"

namespace plastica::calibrate {

/// The least cost for one value of what is profiled.
struct ProfilePoint {
  double value = 0.0;     ///< of the coordinate, or of the function
  double cost = 0.0;      ///< sum of the squared residuals there
  std::vector<double> x;  ///< the coordinates that have it (n)
};

/// Why a profile ends.
enum class ProfileEnd {
  Crossed,   ///< the cost rises by the threshold there
  Bound,     ///< it does not, up to the coordinate's bound
  Open,      ///< it does not, as far as the function goes within the bounds, or was followed
  NoCurves,  ///< beyond there are no residuals
};

/// One word for files: "crossed", …
std::string_view name_of(ProfileEnd end);

/// One side of a profile, from the best point outwards.
struct ProfileSide {
  std::vector<ProfilePoint> points;  ///< in the order of their values, without the best one
  double end = 0.0;  ///< where the cost has risen by the threshold, or how far it is known
  ProfileEnd why = ProfileEnd::Open;
};

struct ProfileOptions {
  double rise = 3.8415;     ///< of the cost at the interval's ends, > 0
  double tolerance = 1e-3;  ///< of the root of the rise there, before the last interpolation, > 0
  int points = 24;          ///< at most, of a side, >= 2
  int evaluations = 60;     ///< at most, of the search of a point, those of differences included
};

/// Where a profile begins: the solution.
struct ProfileStart {
  std::vector<double> x;  ///< (n)
  double cost = 0.0;      ///< there
  double value = 0.0;     ///< of the coordinate or function there
  /// How far the end may be, such as the root of the rise times the standard error; > 0.
  double step = 0.01;
  /// d x / d value along the least cost, such as a row of the covariance over its diagonal (n); the
  /// first guess.
  std::vector<double> along;
};

/// Follows the least cost over one coordinate, the others searched anew from where the point before
/// had them, until it has risen by the threshold: an end of the likelihood interval. Exact for a
/// linear model; for others it follows the cost where the covariance follows its parabola, and is
/// the same for every transformation of the coordinate. The root of the rise, which is almost a
/// straight line, is bracketed and cut by secants.
/// Source: Venzon & Moolgavkar, Appl. Stat. 37 (1988) 87; Raue et al., Bioinformatics 25 (2009)
/// 1923.
/// @param up  whether to larger values
ProfileSide profile_coordinate(const LeastSquaresProblem& problem, const ProfileStart& best,
                               std::size_t coordinate, bool up, const ProfileOptions& options);

/// The same over a function of the coordinates: how large, or small, it gets where the cost has
/// risen by no more than the threshold. A point is the least of cost + ((function -
/// wanted)/width)^2 and so has the least cost for the value that it reaches.
/// @param problem  with one residual more, the last: the function's value
ProfileSide profile_function(const LeastSquaresProblem& problem, const ProfileStart& best, bool up,
                             const ProfileOptions& options);

}  // namespace plastica::calibrate
