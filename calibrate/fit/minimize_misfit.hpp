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
  std::string reason;  ///< if not usable
  std::vector<OptimizerStage> stages;
  Trace trace;
};

/// Minimizes a target's misfit with the algorithm that the options name. A free break limit is not
/// searched but follows the other parameters, see misfit.hpp.
///
/// `auto`:
/// 0. the yield stress begins at the largest measured stress if that costs less than its start;
/// 1. from there SLSQP with exact derivatives. The cost has kinks where a sample goes from elastic
///    to plastic: if SLSQP ended where the slope still promises less cost, a downhill simplex looks
///    around and SLSQP goes on. If the misfit is now below 2 % of the largest stress (with three
///    parameters and more, 0.2 %), this is the end;
/// 2. else a seeded global stage from the start: controlled random search within the bounds and a
///    factor of five around the start;
/// 3. from its best point, or the start if that is better, as in 1;
/// 4. a hardening law's three and more parameters have minima far apart: unless the misfit is below
///    0.2 % of the largest stress, SLSQP starts again from 12 seeded points in the global stage's
///    box (of 40 exact cyclic curves each with 4 to 6 parameters, all are recovered with it, half
///    to 90 % without);
/// 5. where the misfit is above 2 % of the largest stress (the model cannot follow the curve), the
///    kinks are large enough for several minima: SLSQP starts again from 16 seeded points nearby.
/// The best of all is kept.
/// Any other algorithm runs alone from the start.
Solution minimize_misfit(Misfit& misfit, const ParameterSet& parameters, const FitOptions& options,
                         std::uint64_t seed);

}  // namespace plastica::calibrate
