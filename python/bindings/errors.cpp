#include <pybind11/pybind11.h>

#include <exception>
#include <utility>

#include "plastica/base/check.hpp"
#include "plastica/base/machine_error.hpp"
#include "python/bindings/bindings.hpp"

namespace py = pybind11;

namespace plastica::python {
namespace {

/// An empty text, and line 0, mean that there is none.
py::object or_none(const std::string& text) {
  if (text.empty()) return py::none();
  return py::str(text);
}

}  // namespace

void bind_errors(py::module_& core) {
  // The package gives the class: what it derives from, and how it prints, is Python's affair.
  core.def("set_input_error",
           [core](const py::object& type) { py::module_(core).attr("_InputError") = type; });
  static PyObject* const module = core.ptr();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(std::move(thrown));
    } catch (const InputError& error) {
      const auto type = py::handle(module).attr("_InputError");
      const auto& where = error.where();
      const py::object line = where.line > 0 ? py::object(py::int_(where.line)) : py::none();
      const py::object raised = type(or_none(where.file), line, or_none(error.field()),
                                     or_none(error.value()), py::str(error.rule()));
      PyErr_SetObject(type.ptr(), raised.ptr());
    } catch (const MachineError& error) {
      PyErr_SetString(PyExc_OSError, error.what());
    }
  });
}

}  // namespace plastica::python
