#pragma once

#include <optional>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/problem/modulus_prior.hpp"

namespace plastica::calibrate {

/// The priors in the cost of a curve's fit: those that its parameters state, and that of Young's
/// modulus by the elastic slope. With residuals of n samples' worth and mean square f,
///   -2 ln L = n ln f + sum z^2,  z = (value - mean)/standard_deviation of each,
/// is least where f + (f/n) sum z^2 is, f/n held (modulus_prior.hpp): so the cost has variance z^2
/// of each added.
struct WeighedPriors {
  struct One {
    const Field* field = nullptr;
    Prior prior;
    bool stated = true;  ///< by the parameter; else of the slope, which is of the same samples
  };
  std::vector<One> all;
  double variance = 0.0;  ///< f/n; of a stated noise the larger of f and noise^2, over n [Pa^2]
};

/// @param slope  that of Young's modulus, if there is one
WeighedPriors priors_of(const FitOptions& options, const std::optional<ModulusPrior>& slope);

}  // namespace plastica::calibrate
