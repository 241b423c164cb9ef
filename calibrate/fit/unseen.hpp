#pragma once

#include <span>

#include "calibrate/fit/fit.hpp"
#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Cross-validation of laws by specimens: how well the fits of other specimens of the same group,
/// test and loading foretell each specimen's curve (`FitResult::unseen`).
///
/// For specimen i, which none of these fits has seen, the model runs along its measured strains
/// with the values of each other one j, and sum w r^2/sum w over the largest stress squared is
/// averaged over j. Of large groups those ten j count that follow i by name, round. What specimens
/// differ by is in all laws alike; a law that is too simple leaves its shape besides, and one that
/// is too free what it has taken from j alone.
/// @param results  of the cases; where laws are compared, those of targets to which every law was
///                 fitted get the number
void add_unseen(std::span<const Target> targets, std::span<const FitCase> cases,
                const FitOptions& options, int threads, std::span<FitResult> results);

}  // namespace plastica::calibrate
