#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/target/target.hpp"

/// Cross-validation of a fit by parts of its curves; not installed.
namespace plastica::calibrate {

class FittedScenes;
class SceneWork;

/// How many times a fit is repeated, each time without one part of its curves.
inline constexpr std::size_t kParts = 5;

/// Which part each sample of a curve belongs to (n_samples), 0 … kParts - 1.
///
/// The curve is cut into twice as many blocks of neighbours, equally long on the curve as it is
/// drawn, with both axes over their ranges: so the steep elastic part has blocks of its own. Its
/// length is that of chords of a twentieth, so that noise makes it no longer. Blocks
/// are dealt round, so that a part is two blocks, with samples before, between or behind them:
/// mostly a law must interpolate, as where it is used. Neighbours stay together because their
/// residuals are alike: single samples would be foretold by those beside them.
/// Source: Burman, Chow & Nolan, Biometrika 81 (1994) 351.
std::vector<std::size_t> parts_along(std::span<const double> x, std::span<const double> y);

/// What is left of each part by a fit to the others, searched from the fit's values on: sum w r^2
/// over the part times kParts over sum w of all and the largest stress squared [1] (kParts). The
/// mean is the square of a misfit as a fraction.
///
/// A direction in which the others determine nothing stays as it was fitted to all, and so does a
/// prior of E by the elastic slope.
/// @param options  those that it was fitted with
/// @return empty of a result that is not Fitted, and where a search finds nothing
std::vector<double> held_out(const Target& target, const FitOptions& options,
                             const FitResult& result);

/// The same of a fit through scenes: parts of every target at once, each over its largest ordinate,
/// targets by their weights.
std::vector<double> held_out(const FittedScenes& fitted, SceneWork& work);

}  // namespace plastica::calibrate
