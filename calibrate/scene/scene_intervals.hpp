#pragma once

#include <cstddef>
#include <vector>

#include "calibrate/fit/bootstrap.hpp"
#include "calibrate/fit/profile.hpp"

namespace plastica::calibrate {

/// Intervals that a fit through scenes finds beside those of the covariance.
struct SceneIntervalOptions {
  bool profile = false;  ///< likelihood intervals: tens of points of the search for a parameter
  int bootstrap = 0;     ///< resamples of the residuals, a search each; 0: none
  int block = 1;         ///< of neighbouring residuals that are drawn together, >= 1
  int specimens = 0;     ///< resamples of the targets that share the parameters; 0: none
};

/// Resamples for which percentiles say something, and those that there may be.
inline constexpr int kFewestResamples = 20, kMostResamples = 1'000'000;

/// The profile likelihood of a free parameter.
struct SceneProfile {
  double low = 0.0, high = 0.0;  ///< of the confidence of the options [SI]; NaN without a profile
  ProfileEnd low_end = ProfileEnd::Open, high_end = ProfileEnd::Open;
  double threshold = 0.0;  ///< rise of the cost at the ends [1]
  /// The points, and what the cost over the noise has risen there [1] (n_points); the fitted value
  /// among them. A break's are those of the noise alone.
  std::vector<double> value, rise;
  std::vector<double> searched;  ///< values of the searched parameters [SI] (n_points x n)
};

/// What a bootstrap says of the free parameters.
struct SceneBootstrap {
  int resamples = 0;  ///< asked for; 0: it was not
  int failed = 0;     ///< of these, whose search found no curve or no break
  int block = 1;
  std::vector<double> values;                ///< of the others [SI] (n_made x n_free), row by row
  std::vector<BootstrapInterval> intervals;  ///< (n_free) [SI]
};

struct SceneIntervals {
  std::vector<SceneProfile> profiles;  ///< (n_free); empty: not asked for
  SceneBootstrap residuals;
  SceneBootstrap specimens;
};

}  // namespace plastica::calibrate
