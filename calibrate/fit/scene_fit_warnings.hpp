#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "calibrate/inference/lack_of_fit.hpp"
#include "calibrate/problem/scene_problem.hpp"
#include "calibrate/result/scene_fit_result.hpp"

/// What a reader must not overlook of a fit through scenes, each empty where there is nothing to
/// say; not installed.
namespace plastica::calibrate {

/// That a search ended before it had come to its end.
std::string warning_of_end(LeastSquaresOutcome outcome, int evaluations);

/// A stated noise that the residuals contradict.
/// @param left  what they are [SI]
std::string warning_of_noise(const SceneTarget& target, StatedNoise is, double left);

/// A curve that runs against the fitted one: no value of a parameter mends it.
/// @param fitted  ordinates (n_samples)
std::string warning_of_sign(const SceneTarget& target, const std::vector<double>& fitted);

/// A sensor that was set to zero under load: parameters make up for it as far as they can.
/// @param slopes  of all residuals by the coordinates (m x n), row by row
/// @param residual  of the problem at the solution (m)
std::string warning_of_offset(const SceneProblem& problem, std::size_t t,
                              std::span<const double> slopes, std::span<const double> residual);

/// A scene that stops short of what was measured, even with the fitted values.
std::string warning_of_path(const SceneTarget& target, const SceneCurve& fitted);

/// What a run of each target's scene warns of, with the fitted values: what a scene leaves out, the
/// parameters make up for.
/// @param point  the fitted coordinates (n_free)
void warn_of_scenes(const SceneProblem& problem, std::span<const WeightedTarget> targets,
                    std::span<const double> point, std::vector<std::string>& warnings);

/// Segments that move a value by more than was asked for.
/// @param within  0: nothing was asked
std::string warning_of_segments(const SceneFitResult& result, double within);

}  // namespace plastica::calibrate
