#include <pybind11/pybind11.h>

#include "plastica/base/instruction_set.hpp"
#include "plastica/base/version.hpp"
#include "python/bindings/bindings.hpp"

PYBIND11_MODULE(_core, core) {
  core.doc() = "The engine of Plastica; use the package `plastica`, which says what things mean.";
  core.attr("__version__") = std::string(plastica::version());
  plastica::python::bind_errors(core);
  plastica::python::bind_fields(core);
  plastica::python::bind_responses(core);
  plastica::python::bind_models(core);
  plastica::python::bind_fitted_parameters(core);
  plastica::python::bind_problems(core);
  plastica::python::bind_curve_fits(core);
  plastica::python::bind_scene_fits(core);
  plastica::python::bind_studies(core);
}
