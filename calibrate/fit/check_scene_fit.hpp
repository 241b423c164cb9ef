#pragma once

#include <span>

#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/problem/scene_problem.hpp"

namespace plastica::calibrate {

/// @throws InputError for what a fit of no scenes can have
void check_scene_fit(std::span<const WeightedTarget> targets, const SceneFitOptions& options);

/// Whether targets measure the same over the same, as specimens of one test do.
bool are_of_one_kind(const SceneTarget& a, const SceneTarget& b);

/// @throws InputError for a free break limit that none of the scenes meets at its level
void check_break_levels(const SceneProblem& problem, const SceneFitOptions& options);

}  // namespace plastica::calibrate
