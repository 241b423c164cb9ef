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

/// How far a strain, or another path, went on from one sample to the next on the way to a sample:
/// the last step, or the mean of the last four, if that is larger. Steps of nothing do not count,
/// nor what came before a turn. 0 if it has stood still so far.
double step_before(std::span<const double> path, std::size_t last);

/// The end of the interval in which a break lies: the next sample. Where that falls back, or goes
/// on by less than a part of the step before, it does not say how far the specimen went: a step.
/// @param reached  of the last intact sample
/// @param step  of `step_before`
/// @param even  that part [1]
double end_of_break(double reached, double next, double step, double even);

/// A curve that carries load up to and with its sample `last`, which another follows.
/// @param rule  by which that was found
BreakFound broken_after(const Curve& curve, std::size_t last, Loading loading, const char* rule);

}  // namespace plastica::calibrate
