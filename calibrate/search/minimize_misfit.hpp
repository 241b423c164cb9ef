#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/parameter_set.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/search/ladder.hpp"

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
/// 1. from there down by Gauss and Newton with exact slopes, and past kinks of the cost, where a
///    sample goes from elastic to plastic (pass_kinks.hpp). If the misfit is now below 2 % of the
///    largest stress (with three parameters and more, 0.2 %, and none at a bound), this is the end;
/// 2. else a global stage: seeded points of Sobol's within the bounds and a factor of five around
///    the start are screened, and from the best that lie apart, and from the further starts, go
///    short searches, of which the best go on until they come into a basin that is known
///    (multi_start.hpp);
/// 3. where the misfit is still above 2 % (with three parameters and more, above rounding), kinks
///    make several minima near the best point: short searches from 16 seeded points nearby, and
///    those of the global stage that came into its basin, go past kinks, the best ones first. With
///    three parameters and more that ends once four have come to the same least cost within 1e-6,
///    or after twelve.
/// The best of all goes to its end and is kept; of basins whose costs are alike within 1e-6 that
/// which was found first, so that back-stresses keep their numbers. Of 40 exact cyclic curves each
/// with 4 to 6 parameters all are recovered (tests/studies/cyclic_study.cpp).
/// Any other algorithm runs alone from the start.
/// @param further  starts besides that of the parameters, for `auto`
Solution minimize_misfit(Misfit& misfit, const ParameterSet& parameters, const FitOptions& options,
                         std::uint64_t seed, std::span<const StartPoint> further = {});

/// From the start of the parameters down to the end of its basin, and past kinks: step 1 of `auto`.
Solution descend_misfit(Misfit& misfit, const ParameterSet& parameters, const FitOptions& options);

}  // namespace plastica::calibrate
