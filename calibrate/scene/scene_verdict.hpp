#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibrate/scene/scene_problem.hpp"

namespace plastica::calibrate {

/// Sets verdict and number of a parameter that has its value and errors.
/// @param noise_error  standard error from the noise alone [SI]; NaN if not identified
/// @param half  half the interval that a break's sampling leaves [SI]
void judge(double noise_error, double half, SceneParameter& parameter);

/// Probability of as few runs of one sign as these residuals have, or fewer, if they were
/// independent (runs of so many are normal within 1 %); where fewer than 10 have one of the signs,
/// that of so few. NaN for fewer than 20 in all.
/// Source: Wald & Wolfowitz, Ann. Math. Stat. 11 (1940) 147.
double runs_probability(std::span<const double> residual);

/// Below this probability of its runs a part's residuals are no noise.
inline constexpr double kFewRuns = 1e-3;

/// Says what a reader must not overlook.
void add_warning(const SceneParameter& parameter, std::vector<std::string>& warnings);
void add_warning(const ScenePartFit& part, std::vector<std::string>& warnings);

}  // namespace plastica::calibrate
