#pragma once

#include "calibrate/search/optimizer.hpp"

namespace plastica::calibrate {

/// The stage "gauss-newton" of `minimize`: Levenberg and Marquardt's steps (least_squares.hpp) with
/// the problem's exact slopes. A point and its slopes are one evaluation.
/// @throws whatever `problem.squares` threw
Minimum minimize_exact_squares(const Problem& problem, const MinimizeOptions& options);

}  // namespace plastica::calibrate
