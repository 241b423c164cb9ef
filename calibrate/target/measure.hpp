#pragma once

#include "calibrate/target/elastic_line.hpp"
#include "calibrate/target/options.hpp"
#include "calibrate/target/repair.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Measures the characteristics of a corrected curve, after ISO 6892-1:2019, and warns of what
/// makes them doubtful: a load cell at its limit, an elastic part that bends, a given modulus that
/// is not the curve's. What cannot be is left out, with a warning.
/// @param line   the elastic line before the shift of strains: its slope and window
/// @param noise  of the stress [Pa]
void measure_characteristics(Target& target, const ElasticLine& line, const RawFacts& facts,
                             double noise, const TargetOptions& options);

/// Whether a curve ends on its elastic line, within its noise.
bool elastic_to_the_end(const Curve& curve, double modulus, double noise, double yield);

}  // namespace plastica::calibrate
