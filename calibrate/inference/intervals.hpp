#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/inference/bootstrap.hpp"
#include "calibrate/inference/profile.hpp"

namespace plastica::calibrate {

/// Intervals that a fit finds beside those of the covariance.
struct IntervalOptions {
  bool profile = false;  ///< likelihood intervals: tens of points of the search for a parameter
  int bootstrap = 0;     ///< resamples of the residuals, a search each; 0: none
  int block = 1;         ///< of neighbouring residuals that are drawn together, >= 1
  /// Resamples of the specimens, 0: none. Of a fit through scenes, of the targets that share its
  /// parameters; of coupons, of the fits of a group, for the mean of their values.
  int specimens = 0;
};

/// The smallest number of resamples that gives useful percentiles, and the largest allowed one.
inline constexpr int kMinResamples = 20, kMaxResamples = 1'000'000;

/// Refuses numbers that no fit can have. @throws InputError
void check_intervals(const IntervalOptions& options);

/// The profile likelihood of a free parameter.
struct LikelihoodProfile {
  double low = 0.0, high = 0.0;  ///< of the confidence of the options [SI]; NaN without a profile
  ProfileEnd low_end = ProfileEnd::Open, high_end = ProfileEnd::Open;
  double threshold = 0.0;  ///< rise of the cost at the ends [1]
  /// The points, and what the cost over the noise has risen there [1] (n_points); the fitted value
  /// among them. A break's are those of the noise alone.
  std::vector<double> value, rise;
  std::vector<double> searched;  ///< values of the searched parameters [SI] (n_points x n)
};

/// What a bootstrap says of the free parameters.
struct BootstrapResult {
  int resamples = 0;  ///< asked for; 0: it was not
  int failed = 0;     ///< of these, whose search found no curve or no break
  int block = 1;
  std::vector<double> values;                ///< of the others [SI] (n_made x n_free), row by row
  std::vector<BootstrapInterval> intervals;  ///< (n_free) [SI]
};

struct FitIntervals {
  std::vector<LikelihoodProfile> profiles;  ///< (n_free); empty: not asked for
  BootstrapResult residuals;
  BootstrapResult specimens;
};

/// What a reader must not overlook: a profile that goes below the cost of the fit, a bootstrap many
/// of whose searches failed.
/// @param names  of the free parameters (n_free)
/// @param search_again  what to do about the first: "search again from more starts"
void add_warnings(const FitIntervals& intervals, std::span<const std::string> names,
                  std::string_view search_again, std::vector<std::string>& warnings);

}  // namespace plastica::calibrate
