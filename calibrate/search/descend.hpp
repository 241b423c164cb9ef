#pragma once

#include <functional>
#include <limits>
#include <string_view>

#include "calibrate/search/optimizer.hpp"

namespace plastica::calibrate {

/// Is told each stage, in their order.
using StageListener = std::function<void(std::string_view algorithm, const Minimum& end)>;

/// How a descent gets past kinks.
struct KinkOptions {
  int rounds = 5;  ///< of SLSQP at most, >= 0
  /// SLSQP goes on from costs up to this alone.
  double highest_cost = std::numeric_limits<double>::infinity();
};

/// Follows a sum of squares from the problem's start to the bottom of its basin.
///
/// "gauss-newton" first. The cost has a kink where, say, a sample goes from elastic to plastic, and
/// the least cost often lies on one, where Gauss and Newton's steps are refused. If the slopes
/// still promise a decrease at its end, SLSQP goes on in whitened coordinates (whitened.hpp): a
/// quasi-Newton search gets along a kink, since its matrix takes the jump of the slope for a large
/// curvature across it. Of few parameters a downhill simplex looks around where SLSQP ends, and
/// both go on from there. Each stage is kept for its cost alone. Source of quasi-Newton on kinks:
/// Lewis & Overton, Math. Program. 141 (2013) 135.
/// @param problem  with cost and squares
/// @param how  its algorithm does not count; evaluations are those of each stage
/// @throws whatever the problem's functions threw
Minimum descend(const Problem& problem, const MinimizeOptions& how, const StageListener& tell,
                const KinkOptions& kinks = {});

}  // namespace plastica::calibrate
