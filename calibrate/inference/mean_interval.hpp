#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace plastica::calibrate {

/// How specimens are resampled, for the interval of their mean.
struct SpecimenDraws {
  int resamples = 0;  ///< 0: none
  std::uint64_t seed = 1;
  double confidence = 0.95;  ///< within (0, 1)
};

/// Of fewer specimens resamples say less than Student's t does.
inline constexpr std::size_t kFewestToDraw = 10;

/// Where the mean of what a group was drawn from lies.
struct MeanInterval {
  double standard_error = 0.0;  ///< deviation (n - 1) over the root of n
  double low = 0.0, high = 0.0;
};

/// The interval of a mean. With s the standard deviation (n - 1) of the values:
/// - mean ± t s/sqrt(n), t Student's of n - 1 degrees of freedom: exact where values are normal.
///   Percentiles of resampled means cover the mean of four in 75 % of all groups, for 95 %;
/// - of `kFewestToDraw` values and more, if resamples are asked for, bootstrap-t: the quantiles of
///   (mean* - mean)/(s*/sqrt(n)) over the resamples in place of t, which are not symmetric where
///   the values are not. Source: Efron & Tibshirani, An Introduction to the Bootstrap (1993), 12.5.
/// The order of the values does not change a bit of it.
/// @param values  finite, 2 or more
MeanInterval mean_interval(std::vector<double> values, const SpecimenDraws& how);

}  // namespace plastica::calibrate
