#pragma once

#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/target/curve.hpp"

namespace plastica::calibrate {

/// The weight given to a sample: that of the last step whose `from` is not above |strain|, 1 before
/// the first.
/// @param strain  corrected strain of the sample [1]
double given_weight(const std::vector<WeightStep>& steps, double strain);

/// Whether any sample of a curve has a given weight above 0.
bool any_weight(const std::vector<WeightStep>& steps, const Curve& curve);

/// Checks the given weights against the rules that `FitOptions` states.
/// @throws InputError naming "fit.weights[2].weight" (counted from 1)
void check_weights(const FitOptions& options);

}  // namespace plastica::calibrate
