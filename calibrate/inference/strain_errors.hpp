#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/parameter_set.hpp"
#include "calibrate/target/target.hpp"

/// What errors of a coupon's strain that many samples have in common do to its residuals; not
/// installed.
namespace plastica::calibrate {

/// Samples at which a strain turns back, rising, by more than a twentieth of its range: shorter
/// ways back are noise, or cycles that count for little.
std::vector<std::size_t> turns_of(std::span<const double> strain);

/// The standard deviation of the noise of a strain that goes to and fro [1], by its fourth
/// differences away from where it turns. Of a smooth course they leave nothing, and the root of 70
/// times the noise; rows that repeat or are unevenly spaced look like noise. 0 where there are
/// fewer than 20 differences.
/// @param turns  of `turns_of`
double noise_of_strain(std::span<const double> strain, std::span<const std::size_t> turns);

/// Fills `by_shift` of what a misfit says at its solution, and `turns`, by differences along its
/// curve and over the noise.
///
/// The noise of the strain where a cyclic test turns back shifts all of the elastic branch that
/// follows: the model goes on from the stress of the strain that was measured. It is taken for that
/// of `noise_of_strain`, but for no more than the residuals of elastic branches leave room for.
/// @param active  solution, SI (n)
void add_strain_errors(const Target& target, const FitOptions& options,
                       const ParameterSet& parameters, std::span<const double> active,
                       Misfit::Details& details);

}  // namespace plastica::calibrate
