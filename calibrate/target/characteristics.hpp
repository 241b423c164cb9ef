#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "calibrate/target/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// The elastic line stress = modulus (strain - zero_strain).
struct ElasticLine {
  double modulus = 0.0;             ///< [Pa]
  double modulus_stderr = 0.0;      ///< [Pa]; 0 unless by regression
  double zero_strain = 0.0;         ///< [1] where the line meets zero stress
  double zero_strain_stderr = 0.0;  ///< [1]
  double low = 0.0;                 ///< stress window [Pa]
  double high = 0.0;
  double yield_stress = 0.0;  ///< [Pa] the proof stress that the window refers to, or Rm
  std::size_t samples = 0;    ///< in the window
};

/// Standard deviation of the noise of the stress [Pa]: the median distance of a sample from the
/// straight line between its neighbours, over what unit noise gives (0.6745 for a median, and the
/// root of 1 + a^2 + (1-a)^2 for a sample at the fraction a between its neighbours). 0 on straight
/// stretches however they are sampled, little disturbed by bends.
double noise_of(std::span<const double> strain, std::span<const double> stress);

/// Whether the proof stress can be told from the elastic line: the line shifted by the offset must
/// lie more than 6 standard deviations of the noise beside it.
bool sees_offset(double modulus, double offset, double noise);

/// Finds the elastic line by the rules of TargetOptions, on the first loading, up to the largest
/// stress (a cyclic curve that starts in compression is mirrored).
/// @param noise  of the stress [Pa], a floor of the standard errors
/// @return empty if the window holds too few samples even when widened
/// @throws InputError if a chord is asked for without a window, or a window is empty
std::optional<ElasticLine> find_elastic_line(const Curve& curve, Loading loading, double noise,
                                             const TargetOptions& options);

/// Stress where the curve crosses the line modulus (strain - zero_strain - offset) for the last
/// time, between samples by linear interpolation [Pa]; empty if it never falls below that line.
/// The last crossing, as noise may cross it many times. Source: ISO 6892-1:2019, 13.
std::optional<double> proof_stress(std::span<const double> strain, std::span<const double> stress,
                                   double modulus, double zero_strain, double offset);

/// Upper and lower yield strength [Pa].
struct YieldPoint {
  double upper = 0.0;
  double lower = 0.0;  ///< least stress until it climbs above the upper one; no transient excluded
};

/// The yield point by the rule of TargetOptions::yield_drop. Source: ISO 6892-1:2019, 3.10.2.
std::optional<YieldPoint> find_yield_point(std::span<const double> stress, double noise,
                                           double yield_drop);

}  // namespace plastica::calibrate
