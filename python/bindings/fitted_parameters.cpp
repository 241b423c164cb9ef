#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

#include "calibrate/result/fitted_parameter.hpp"
#include "calibrate/result/words.hpp"
#include "plastica/base/quantity.hpp"
#include "python/bindings/bindings.hpp"

namespace py = pybind11;

namespace plastica::python {

using calibrate::FittedParameter;

void bind_fitted_parameters(py::module_& core) {
  py::class_<FittedParameter>(core, "FittedParameter")
      .def_readonly("path", &FittedParameter::path)
      .def_property_readonly("name", &FittedParameter::name)
      .def_property_readonly("unit",
                             [](const FittedParameter& one) { return si_unit(one.dimension); })
      .def_property_readonly("role",
                             [](const FittedParameter& one) {
                               const auto words = calibrate::words_of<calibrate::ParameterRole>();
                               return words[static_cast<std::size_t>(one.role)];
                             })
      .def_readonly("value", &FittedParameter::value)
      .def_readonly("start", &FittedParameter::start)
      .def_property_readonly(
          "bounds", [](const FittedParameter& one) { return py::make_tuple(one.lower, one.upper); })
      .def_readonly("error", &FittedParameter::standard_error)
      .def_readonly("noise_error", &FittedParameter::noise_error)
      .def_readonly("sampling_error", &FittedParameter::sampling_error)
      .def_readonly("misfit_error", &FittedParameter::misfit_error)
      .def_property_readonly("interval",
                             [](const FittedParameter& one) {
                               return py::make_tuple(one.interval_low, one.interval_high);
                             })
      .def_readonly("degrees_of_freedom", &FittedParameter::degrees_of_freedom)
      .def_readonly("identified", &FittedParameter::identified)
      .def_property_readonly("at_bound", &FittedParameter::at_bound)
      .def_property_readonly("verdict",
                             [](const FittedParameter& one) -> py::object {
                               if (!one.judgement) return py::none();
                               return py::cast(name_of(one.judgement->verdict));
                             })
      .def_property_readonly("verdict_number", &FittedParameter::verdict_number);
}

}  // namespace plastica::python
