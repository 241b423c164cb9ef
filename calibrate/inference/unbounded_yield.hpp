#pragma once

#include <span>
#include <vector>

#include "calibrate/problem/scene_problem.hpp"

/// Whether tests of beams bound a yield stress from above; not installed.
namespace plastica::calibrate {

/// Takes yield stresses that the targets do not bound from above out of the slopes of a solution.
///
/// Of a beam that stays elastic the best yield stress is often one at which it yields by as little
/// as the noise of its last samples has it: the slopes say that these determine it. So the squares
/// with it at its upper bound, the others fitted anew, must be more by what the confidence asks
/// for, the squared quantile of Student's t. The others are fitted by a step of Gauss and Newton
/// with the slopes at the solution: from where the beam hardly yields to where it does not, they
/// hardly change; where that step says that the squares would hardly rise, they are run there.
/// @param x  coordinates of the solution (n)
/// @param residual  there, over the scales, which are the noise (m)
/// @param at_bound  coordinates that are held there (n)
/// @param confidence  within (0, 1)
/// @param slopes  d residual / d coordinate (m x n), row by row
/// @return  the solution with these yield stresses at their upper bounds: at it the slopes by the
///          others have nothing of a yield that is hardly there, by which they would be told apart;
///          empty if all are bounded
std::vector<double> drop_unbounded_yield(SceneProblem& problem, std::span<const double> x,
                                         std::span<const double> residual,
                                         const std::vector<bool>& at_bound, double confidence,
                                         std::span<double> slopes);

}  // namespace plastica::calibrate
