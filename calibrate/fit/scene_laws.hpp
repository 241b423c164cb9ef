#pragma once

#include <span>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/inference/compare_laws.hpp"
#include "calibrate/problem/law.hpp"
#include "calibrate/result/scene_fit_record.hpp"

namespace plastica::calibrate {

/// Cyclic if an ordinate has both signs, each beyond 5 % of its largest size.
Loading loading_of(std::span<const WeightedTarget> targets);

/// A setup whose material hardens by a law; so do the regions of the beam that have the scene's
/// material, number by number.
Setup setup_of(Law law, const Setup& setup);

/// The targets with such setups.
std::vector<WeightedTarget> targets_of(Law law, std::span<const WeightedTarget> targets);

/// What a fit of one law is told: the options with its parameters, those that a fit of a coupon has
/// (fit_law.hpp). Bounds that nobody gave follow, with S the yield stress, E Young's modulus (each
/// at its start) and e = S/E, from:
///   tangent_modulus       0 … E/4, at most 0.9 of the least E; start E/100
///   kinematic_fraction       0 … 1; 1/2
///   saturation_stress     0 … 3 S; 0.3 S
///   saturation_rate       0.1/e over and times 100; 0.1/e: Q is nearly there after 30 e
///   backstress_modulus_1  0.2 E over and times 100; 0.2 E
///   backstress_rate_1     1/e over and times 100; 1/e: full, with S/5, after some 3 e
///   backstress_modulus_2, backstress_rate_2  a tenth of these
///   backstress_modulus_3, backstress_rate_3  a hundredth
/// The scene's own value is the start where it has the law.
SceneFitOptions options_of(Law law, const SceneFitOptions& options,
                           std::span<const WeightedTarget> targets);

/// Lets a law's searches begin also where a simpler law that it contains ended: once with its own
/// parameters at their starts, once where these have the least effect (`min_effect_value`), so that
/// it ends no worse.
/// @param options  of the law
void start_from(const SceneFitResult& simpler, SceneFitOptions& options);

/// Warns where a law ends with a larger misfit than a simpler one that it contains.
void compare_with(const SceneFitResult& simpler, std::span<const WeightedTarget> targets,
                  SceneFitResult& result);

/// What a comparison asks of a fit. A target counts its weight over the mean of all.
LawFit law_fit_of(const SceneFitRecord& record);

}  // namespace plastica::calibrate
