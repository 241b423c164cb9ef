#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/inference/unlike_targets.hpp"
#include "calibrate/inference/verdict.hpp"
#include "calibrate/problem/scene_problem.hpp"

namespace plastica::calibrate {

/// Sets verdict and number of a parameter that has its value and errors.
/// @param half  half the interval that a break's sampling leaves [SI]
/// @param prior  fraction of the information on it that is its prior's [1]; 0 without one
void judge(double half, const SegmentsError& segments, double prior, FittedParameter& parameter);

/// Says what a reader must not overlook.
void add_warning(const FittedParameter& parameter, const SegmentsError& segments,
                 std::vector<std::string>& warnings);
/// @param try_next  laws, as `laws_to_try` gives them
void add_warning(const TargetFit& of_target, Law law, std::string_view try_next,
                 std::vector<std::string>& warnings);

/// Whether a target differs from others of its kind, and values of its own meet its curve: what the
/// shared ones leave says nothing of the law then.
bool is_met_alone(const SceneProblem& problem, std::span<const TargetsOfOneKind> kinds,
                  std::size_t t);

/// Of a fit that several targets share: that those of a kind differ by more than their noise, or,
/// where there are too few samples to tell, that some are met far less closely than another.
/// @param fits  what the fit made of them (n_targets)
void warn_of_specimens(std::span<const WeightedTarget> targets, std::span<const TargetFit> fits,
                       std::span<const TargetsOfOneKind> kinds, std::vector<std::string>& warnings);

/// Of targets that bore more than a break limit, fitted or held, while they were intact, and of
/// those that broke before one that is held or at its bound.
/// @param parameters  fitted; one of the break counts with three of its standard errors
/// @param curves  of the targets at the solution (n_targets, >= 1)
void warn_of_limits(const SceneProblem& problem, const SceneFitOptions& options,
                    std::span<const FittedParameter> parameters,
                    std::span<const std::vector<SceneCurve>> curves,
                    std::vector<std::string>& warnings);

}  // namespace plastica::calibrate
