#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "calibrate/target/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Standard deviation of the noise of the stress [Pa]: the median distance of a sample from the
/// straight line between its neighbours, over what unit noise gives (0.6745 for a median, and the
/// root of 1 + a^2 + (1-a)^2 for a sample at the fraction a between its neighbours). 0 on straight
/// stretches however they are sampled, little disturbed by bends.
double noise_of(std::span<const double> strain, std::span<const double> stress);

/// The same of values in the order of their rows.
double noise_over_rows(std::span<const double> values);

/// Whether the proof stress can be told from the elastic line: the line shifted by the offset must
/// lie more than 6 standard deviations of the noise beside it.
bool sees_offset(double modulus, double offset, double noise);

/// Stress where the curve crosses the line modulus (strain - zero_strain - offset) for the last
/// time, between samples by linear interpolation [Pa]; empty if it never falls below that line.
/// The last crossing, as noise may cross it many times. Source: ISO 6892-1:2019, 13.
std::optional<double> proof_stress(std::span<const double> strain, std::span<const double> stress,
                                   double modulus, double zero_strain, double offset);

/// Upper and lower yield strength [Pa].
struct YieldPoint {
  double upper = 0.0;
  double lower = 0.0;        ///< least stress until it climbs above the upper one
  std::size_t at = 0;        ///< sample of the upper one
  std::size_t lower_at = 0;  ///< of the lower one
  /// Where the upper one is the largest stress of all, the sample of the largest after the climb
  /// from the lower one: Rm is there (ISO 6892-1:2019, 3.10.1: after the yield point).
  std::optional<std::size_t> later_peak{};
  std::size_t until = 0;  ///< the sample at which it has climbed, or the last one
};

/// The yield point by the rule of TargetOptions::yield_drop. Source: ISO 6892-1:2019, 3.10.2. One
/// that the stress never exceeds again is one if it climbs as much as it fell at the least: else
/// the curve falls from Rm to its end.
std::optional<YieldPoint> find_yield_point(std::span<const double> stress, double noise,
                                           double yield_drop);

/// Leaves the initial transient out of a lower yield strength, as ISO 6892-1:2019, 3.10.2.2 asks
/// for: the undershoot of machine and specimen behind the upper one. The standard says no more of
/// it than that what comes within 0.25 % of strain after it may count (12.1), so it is taken to be
/// - over within a strain l of 0.25 % after the upper one,
/// - deeper than a yield drop (`find_yield_point`) below the least stress from there on,
/// - followed by what stays: from 3 l on the least stress is no higher, but for a twentieth of that
///   depth, or 3 times the noise, and still a yield drop below the upper one. A curve that hardens
///   right behind its minimum has no transient.
void leave_out_transient(std::span<const double> strain, std::span<const double> stress,
                         double noise, double yield_drop, YieldPoint& point);

}  // namespace plastica::calibrate
