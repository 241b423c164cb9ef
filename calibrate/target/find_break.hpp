#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "calibrate/target/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Where a curve broke: `intact` samples carry load, the rest is cut.
struct BreakFound {
  std::size_t intact = 0;
  BreakObservation observation;
};

/// Finds the break by the rule of TargetOptions::trim.
/// @param goes_on  stress was measured beyond the last strain: its end is no break
std::optional<BreakFound> find_break(const Curve& curve, Loading loading, double modulus,
                                     bool goes_on, const TargetOptions& options);

/// How far a strain, or another path, goes on from one sample to the next at a sample: the last
/// step, or, where that is shorter or goes the other way, the mean of the last four, of which noise
/// decides one. 0 for the first sample.
double step_before(std::span<const double> path, std::size_t last);

/// The end of the interval in which a break lies that left nothing of the load: the next sample.
/// Where that falls back, or goes on by less than a fraction of a step, it does not say how far the
/// specimen went: a step.
/// @param reached  of the last intact sample
/// @param step  of `step_before`
/// @param even  the fraction [1]
double end_of_break(double reached, double next, double step, double even);

/// A curve that carries load up to and with its sample `last`, which another follows.
/// @param rule  by which that was found
BreakFound broken_after(const Curve& curve, std::size_t last, Loading loading, const char* rule);

}  // namespace plastica::calibrate
