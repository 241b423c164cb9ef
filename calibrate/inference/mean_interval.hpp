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
  /// Squares added: deviation (n - 1) over the root of n, and `sampling_error`.
  double standard_error = 0.0;
  /// What all breaks alike may be off between their samples: `sampling_half` over the root of 3.
  double sampling_error = 0.0;
  double low = 0.0, high = 0.0;
};

/// The interval of a mean. With s the standard deviation (n - 1) of the values:
/// - mean ± t s/sqrt(n), t Student's of n - 1 degrees of freedom: exact where values are normal.
///   Percentiles of resampled means cover the mean of four in 75 % of all groups, for 95 %;
/// - of `kFewestToDraw` values and more, if resamples are asked for, bootstrap-t: the quantiles of
///   (mean* - mean)/(s*/sqrt(n)) over the resamples in place of t, which are not symmetric where
///   the values are not. Source: Efron & Tibshirani, An Introduction to the Bootstrap (1993), 12.5.
/// A break is known to lie within ±h of its value, the middle between two samples. What that does
/// to a mean depends on the specimens. Where breaks scatter over many samples their places between
/// two are independent, and part of s: nothing is to be added. Where they scatter little, all lie
/// between the same two samples or, if the border is among them, a fraction p of them one interval
/// of 2 h higher. Then the middles have s_n^2 = 4 h^2 p (1 - p) about their mean m + 2 h p, and the
/// breaks may all be next to the border, m + h: off by h |1 - 2 p| = sqrt(h^2 - s_n^2), and no more
/// than that. All specimens share this distance; more of them do not make it smaller, and s does
/// not show it. So it is evenly likely within
///   h_c = sqrt(max(0, h^2 - s_n^2)),  s_n^2 = sum (v - mean)^2/n, h^2 the mean of h_k^2,
/// independent of Student's t, and the interval is that of both together (`half_interval`).
/// It is h of breaks that all lie between the same samples, and 0 where the values scatter by more
/// than h.
///
/// The order of the values does not change a bit of it.
/// @param values  finite, 2 or more
/// @param half    h, root of the mean of h_k^2, >= 0; 0: no breaks between samples
MeanInterval mean_interval(std::vector<double> values, const SpecimenDraws& how, double half = 0.0);

}  // namespace plastica::calibrate
