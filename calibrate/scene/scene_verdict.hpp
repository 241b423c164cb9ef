#pragma once

#include <string>
#include <vector>

#include "calibrate/fit/verdict.hpp"
#include "calibrate/scene/scene_fit.hpp"

namespace plastica::calibrate {

/// Sets verdict and number of a parameter that has its value and errors.
/// @param noise_error  standard error from the noise alone [SI]; NaN if not identified
/// @param half  half the interval that a break's sampling leaves [SI]
void judge(double noise_error, double half, SceneParameter& parameter);

/// Says what a reader must not overlook.
void add_warning(const SceneParameter& parameter, std::vector<std::string>& warnings);
void add_warning(const ScenePartFit& part, std::vector<std::string>& warnings);

}  // namespace plastica::calibrate
