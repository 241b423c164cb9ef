#pragma once

#include <cstdint>
#include <vector>

#include "calibrate/fit/misfit.hpp"
#include "calibrate/fit/options.hpp"
#include "calibrate/fit/parameter_set.hpp"
#include "calibrate/fit/result.hpp"

namespace plastica::calibrate {

/// What the optimizer found for one target.
struct Solution {
  std::vector<double> active;  ///< SI (n_active)
  double cost = 0.0;           ///< [Pa^2]
  bool usable = false;
  std::string reason;          ///< if not usable
  std::vector<OptimizerStage> stages;
  Trace trace;
};

/// Minimizes a target's misfit with the algorithm that the options name.
///
/// `auto`: a seeded global stage (controlled random search within the bounds and a factor of five
/// around the start), then from its best point, or the start if that is better, SLSQP with exact
/// derivatives. The cost is smooth but for small kinks where a sample goes from elastic to
/// plastic; SLSQP can end on one, so a downhill simplex over a small box looks around its end and
/// SLSQP goes on from there while that finds less cost.
/// Any other algorithm runs alone from the start.
Solution minimize_misfit(Misfit& misfit, const ParameterSet& parameters, const FitOptions& options,
                         std::uint64_t seed);

}  // namespace plastica::calibrate
