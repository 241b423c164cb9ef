#pragma once

#include <functional>
#include <string_view>

#include "calibrate/search/optimizer.hpp"

namespace plastica::calibrate {

/// Is told each stage, in their order.
using StageListener = std::function<void(std::string_view algorithm, const Minimum& end)>;

/// A decrease that is not worth another stage, as a fraction of the cost.
inline constexpr double kWorthwhile = 1e-10;

/// How a search gets past kinks.
struct KinkOptions {
  int rounds = 5;                   ///< of SLSQP at most, >= 0
  double worthwhile = kWorthwhile;  ///< a promise of less, as a fraction of the cost, is none
};

/// Goes on from where "gauss-newton" has stopped, to the bottom of the basin.
///
/// The cost has a kink where, say, a sample goes from elastic to plastic, and the least cost often
/// lies on one, where Gauss and Newton's steps are refused. If the slopes still promise a decrease
/// at their end, SLSQP goes on in whitened coordinates (whitened.hpp): a quasi-Newton search gets
/// along a kink, since its matrix takes the jump of the slope for a large curvature across it. Of
/// few parameters a downhill simplex looks around where SLSQP ends, and both go on from there. Each
/// stage is kept for its cost alone. Source of quasi-Newton on kinks: Lewis & Overton, Math.
/// Program. 141 (2013) 135.
/// @param problem  with cost and squares; its start does not count
/// @param from  where gauss-newton has stopped, and what its model promises there
/// @param how  its algorithm does not count; evaluations are those of each stage
/// @throws whatever the problem's functions threw
Minimum pass_kinks(const Problem& problem, Minimum from, const MinimizeOptions& how,
                   const StageListener& tell, const KinkOptions& kinks = {});

}  // namespace plastica::calibrate
