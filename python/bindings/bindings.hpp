#pragma once

#include <pybind11/pybind11.h>

/// What each source of this folder adds to the extension module `_core`.
namespace plastica::python {

void bind_errors(pybind11::module_& core);
void bind_fields(pybind11::module_& core);
void bind_responses(pybind11::module_& core);
void bind_models(pybind11::module_& core);
void bind_fitted_parameters(pybind11::module_& core);
void bind_problems(pybind11::module_& core);
void bind_curve_fits(pybind11::module_& core);
void bind_scene_fits(pybind11::module_& core);
void bind_studies(pybind11::module_& core);

}  // namespace plastica::python
