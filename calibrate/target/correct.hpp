#pragma once

#include "calibrate/target/elastic_line.hpp"
#include "calibrate/target/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

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
