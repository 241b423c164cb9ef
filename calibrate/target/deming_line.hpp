#pragma once

#include <span>

#include "calibrate/target/elastic_line.hpp"

namespace plastica::calibrate {

/// A straight line through samples.
struct DemingLine {
  ElasticLine line;
  /// A sample's foot on the line is where the line has the stress that it has at the sample's
  /// strain, and this fraction of the sample's distance above it more; 0 without noise in the
  /// strain.
  double foot_fraction = 0.0;
};

/// The line through samples with noise in both: Deming, Statistical Adjustment of Data (1943), 178.
/// Without noise in the strain it is the regression of the stress, whose slope that noise would
/// make too small.
/// @param strain, stress  (n >= 3) [1], [Pa]
/// @param noise  of the stress about the curve, a floor of the standard errors [Pa]
/// @return without a window; a modulus of 0 where the strain does not change
DemingLine deming_line(std::span<const double> strain, std::span<const double> stress,
                       double noise);

}  // namespace plastica::calibrate
