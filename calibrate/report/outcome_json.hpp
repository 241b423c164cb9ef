#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "calibrate/report/json_values.hpp"
#include "calibrate/result/fit_outcome.hpp"

namespace plastica::calibrate::report {

/// Rows of a square matrix; empty if it is none.
Json matrix_json(std::span<const double> values, std::size_t n);

/// Adds to a fit of a summary what each has, whatever it was fitted to: its parameters by name, the
/// correlation and, where they were asked for, intervals of the free ones; SI.
/// @param correlated  those that the correlation is of
void add_outcome(Json& fit, const FitOutcome& outcome,
                 const std::vector<const FittedParameter*>& correlated);

}  // namespace plastica::calibrate::report
