#pragma once

#include "calibrate/fit/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// What a curve shows, with stand-ins for what its characteristics lack.
struct CurveSizes {
  double stress = 1.0;   ///< largest |stress| [Pa]
  double strain = 1.0;   ///< largest |strain| [1]
  double modulus = 1.0;  ///< stiffness of the test: E, or G in torsion [Pa]
  double yield = 1.0;    ///< start of the yield stress [Pa]
  double slope = 0.0;    ///< after yield [Pa]
};

CurveSizes curve_sizes(const Target& target, const FitOptions& options);

/// Where a fit begins and how far it may go, from what the curve shows.
struct StartValue {
  double start = 0.0;
  double lower = 0.0;
  double upper = 0.0;
};

/// Start and default bounds of a material field for a target, in SI.
///
/// From the characteristics: Young's modulus as measured; the yield stress as the mean of proof
/// stress and strength (ideal plasticity has to follow both) or as the proof stress (hardening
/// laws); the break strain as the permanent strain at break (of a specimen that broke without any,
/// far below its total strain); the tangent modulus as the slope from
/// proof stress to strength. Where a curve lacks one, its largest stress and strain stand in (95 %
/// of the stress for a yield stress).
/// What saturates hardens, above 0; of a cyclic curve that carries less at the end of a later
/// stroke as long as before it may soften, too, and begins there. Bounds hold the start with at
/// least a factor of ten, and lie within the field's range.
/// @param sizes  the target's `curve_sizes`
StartValue start_value(const Field& field, const CurveSizes& sizes, const Target& target,
                       const FitOptions& options);

/// The value of a yield stress at which the model's would be the largest measured stress (of the
/// samples with a given weight above 0), beyond which it has no effect on a better fit; infinite
/// for all other fields.
double largest_useful_value(const Field& field, const Target& target, const FitOptions& options);

}  // namespace plastica::calibrate
