#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibrate/result/scene_fit_record.hpp"

namespace plastica::calibrate {

/// One parameter over the specimens of a population.
struct PopulationParameter {
  std::string path;
  Dimension dimension = Dimension::None;
  std::size_t n = 0;         ///< fits that determine it
  std::size_t left_out = 0;  ///< fitted, but at a bound or not identified
  /// Whether the values are those that segments lead to (`SegmentsError::extrapolated`), as every
  /// fit has one; else they are those of the beams with their segments.
  bool is_of_material = false;
  double mean = 0.0;  ///< [SI]
  /// Of the extrapolated values, the mean of half their intervals: common to all fits, so in none
  /// of the numbers below [SI]; 0 where they are not extrapolated.
  double segments_error = 0.0;
  /// Of the values, with n - 1: the specimens' scatter and the fits' noise together [SI]; NaN for
  /// n < 2.
  double standard_deviation = 0.0;
  /// What all breaks alike may be off between their samples, part of the mean's interval
  /// (mean_interval.hpp) [SI]; 0 of other parameters, and for n < 2.
  double sampling_error = 0.0;
  double rms_error = 0.0;  ///< root of the mean squared standard error [SI]
  /// Of the specimens alone, the noise taken out [SI], >= 0; NaN for n < 2.
  double specimen_deviation = 0.0;
  double mean_low = 0.0, mean_high = 0.0;  ///< by mean_interval.hpp [SI]; NaN for n < 2
  /// Of the specimens' deviation, chi-squared's of values that scatter normally [SI]; NaN for
  /// n < 2.
  double deviation_low = 0.0, deviation_high = 0.0;
};

/// Of fewer specimens a bootstrap says nothing of how two numbers scatter together, and how many
/// resamples it has.
inline constexpr std::size_t kMinSpecimens = 8;
inline constexpr int kPopulationResamples = 1000;

/// How parameters scatter among specimens that were fitted alike.
///
/// With v_k the value of fit k (of the material, where all fits have such a one), s_k its standard
/// error and rho_k its correlation, over the n fits that determine the parameter or both of a pair:
///   variance     max(0, sum (v_k - mean)^2/(n - 1) - sum s_k^2/n)
///   covariance   sum (a_k - mean a)(b_k - mean b)/(n - 1) - sum rho_k s_a,k s_b,k/n,
///                held within plus and minus the product of both standard deviations.
/// A value scatters about its specimen's truth with variance s_k^2, independently of the scatter
/// among specimens: the expectation of the observed moment is the specimens' plus the mean of that
/// of the noise (method of moments).
///
/// With (n - 1) of the values' variance over that of specimens and noise being chi-squared, the
/// specimens' deviation lies between the roots of what its quantiles leave, less the noise: exact
/// for values that scatter normally with like errors; a bootstrap's percentiles hold it in 77 % of
/// populations of ten for 95 %. Intervals of covariances are percentiles over resamples of the
/// fits, each with the errors that it has, drawn with replacement (seeded; the same bits each
/// time). Of few specimens they are too narrow: of 20 by an eighth.
struct ScenePopulation {
  std::vector<PopulationParameter> parameters;
  std::vector<double> covariance;           ///< of the values [SI] (n_parameters x same)
  std::vector<double> specimen_covariance;  ///< the noise taken out [SI] (n_parameters x same)
  /// Its interval [SI] (n_parameters x same).
  std::vector<double> covariance_low, covariance_high;

  /// Of the specimens, from the covariance without noise [1]; NaN where a deviation is 0.
  double correlation(std::size_t a, std::size_t b) const;
};

/// The value of a parameter as one of the material, where its segments lead to one.
std::optional<double> material_value(const SceneFitResult& result, std::size_t parameter);

/// The population of all fits of the status Fitted; parameters in the order of the first of them.
/// Fits without a parameter, with one at a bound or without a standard error do not count for it.
/// @param confidence  of the intervals, within (0, 1)
ScenePopulation scene_population(std::span<const SceneFitRecord> records, double confidence = 0.95);

}  // namespace plastica::calibrate
