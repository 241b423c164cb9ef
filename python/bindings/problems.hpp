#pragma once

#include <pybind11/pybind11.h>

#include "calibrate/fit/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::python {

/// The cost of a fit as a function: a `CurveProblem`, see problems.cpp.
/// @throws InputError for a target that cannot be fitted, and for priors
pybind11::object make_problem(calibrate::Target target, calibrate::FitOptions options);

}  // namespace plastica::python
