#pragma once

#include <cstddef>
#include <optional>

#include "calibrate/target/elastic_line.hpp"
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

/// Cuts the broken samples off target.corrected, records the break; correction "trim-at-break".
void trim_at_break(Target& target, double modulus, bool goes_on, const TargetOptions& options);

/// Shifts the strains so that the elastic line meets the origin; corrections "toe" and
/// "preload-offset", of which at most one is applied automatically.
/// @return the strain taken off every sample [1]
double shift_strain(Target& target, const ElasticLine& line, const TargetOptions& options);

/// Engineering to true up to Rm; correction "true-measure". Recomputes nothing else.
/// @return false if the target was rejected
bool convert_to_true(Target& target, const TargetOptions& options);

}  // namespace plastica::calibrate
