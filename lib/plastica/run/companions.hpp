#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "plastica/run/batch.hpp"

namespace plastica {

/// Why a model has no companions and is none; empty: it can be. Paths at rest under load control
/// can, by any law and at any level, with double precision.
std::string_view why_no_companion(const Model& model);

/// How many companions of a model run beside it at most: no more than take a quarter of a gigabyte.
std::size_t most_companions(const Model& model);

/// Runs cases that differ in their numbers by little, such as a point and those of its differences:
/// the first one as if it were alone, the others as its *companions*. A companion is in equilibrium
/// at each sample and at each step between, to the tolerance of any run, but takes the steps of the
/// first, and its equilibria are sought next to those of the first. So it costs half a run, and
/// what differs between both is not how they were stepped. What is noted beside the samples (axial
/// forces, bifurcations, stability) is as for the first. Who finds no equilibrium there, or none
/// that is near, is run alone; so are coupons. Where the first is not run, or does not complete its
/// path, the others are not run.
/// @param values  (n_cases x n_parameters), row by row, SI
/// @return the responses (n_cases); empty ones, NotRun, of cases that were not or cannot be run
std::vector<Response> run_with_companions(const Model& model, std::span<const double> values,
                                          std::size_t cases, StopFlag stop = nullptr);

/// The same of scenes of their own.
std::vector<BatchRow> run_with_companions(std::span<const BatchCase> cases,
                                          StopFlag stop = nullptr);

}  // namespace plastica
