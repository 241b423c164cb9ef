#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "calibrate/report/law_choice.hpp"
#include "calibrate/result/fit_outcome.hpp"
#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "python/bindings/arrays.hpp"

/// What fits of curves and fits through scenes have in common for Python.
namespace plastica::python {

/// One record of a file's contents, which it keeps alive.
template <class Contents>
struct RecordView {
  std::shared_ptr<const Contents> contents;
  std::size_t index = 0;

  const auto& record() const { return contents->records[index]; }
  const calibrate::FitOutcome& outcome() const { return record().result; }
};

using CurveFitView = RecordView<calibrate::FitStoreContents>;
using SceneFitView = RecordView<calibrate::SceneFitContents>;

/// A matrix of numbers by row.
inline pybind11::array matrix(const std::vector<double>& values, std::size_t columns,
                              pybind11::handle owner) {
  const auto n = static_cast<pybind11::ssize_t>(columns);
  const auto rows = columns == 0 ? 0 : static_cast<pybind11::ssize_t>(values.size()) / n;
  return view_of(values, {rows, n}, owner);
}

/// Profiles of the free parameters, by name: interval and points.
pybind11::dict profiles_of(const calibrate::FitOutcome& outcome, pybind11::handle owner);
/// A bootstrap: the values of each free parameter by name, and how many resamples failed; None
/// where there is none.
pybind11::object bootstrap_of(const calibrate::FitOutcome& outcome,
                              const calibrate::BootstrapResult& bootstrap, pybind11::handle owner);
/// Adds intervals to those that a file asks for. @throws InputError for numbers that no fit can
/// have
void set_intervals(bool profile, int bootstrap, int block, int specimens,
                   calibrate::IntervalOptions& intervals);

/// The law that is advised over all records; None where none is, or none are compared.
template <class Contents>
pybind11::object advised_law(const Contents& contents) {
  const auto records = std::span(contents.records);
  if (!calibrate::compares_laws(records)) return pybind11::none();
  const calibrate::LawComparison laws = calibrate::compare_laws(records);
  if (!laws.advised) return pybind11::none();
  return pybind11::cast(name_of(laws.laws[*laws.advised].fit.law));
}

/// Defines what all records have.
template <class View>
pybind11::class_<View> bind_record(pybind11::module_& core, const char* name) {
  namespace py = pybind11;
  return py::class_<View>(core, name)
      .def_property_readonly("name", [](const View& view) { return name_of(view.record()); })
      .def_property_readonly("status",
                             [](const View& view) { return name_of(view.outcome().status); })
      .def_property_readonly("reason", [](const View& view) { return view.outcome().reason; })
      .def_property_readonly("law", [](const View& view) { return name_of(view.outcome().law); })
      .def_property_readonly("parameters",
                             [](const View& view) { return view.outcome().parameters; })
      .def_property_readonly("warnings", [](const View& view) { return view.outcome().warnings; })
      .def_property_readonly("held_out",
                             [](const View& view) { return view.outcome().held_out_misfit(); })
      .def_property_readonly("correlation",
                             [](const py::object& self) {
                               const auto& view = self.cast<const View&>();
                               const auto& result = view.record().result;
                               return matrix(result.correlation,
                                             result.correlated_parameters().size(), self);
                             })
      .def_property_readonly(
          "correlated",
          [](const View& view) {
            std::vector<std::string> names;
            for (const auto* one : view.record().result.correlated_parameters()) {
              names.push_back(one->name());
            }
            return names;
          })
      .def_property_readonly("profiles",
                             [](const py::object& self) {
                               return profiles_of(self.cast<const View&>().outcome(), self);
                             })
      .def_property_readonly("bootstrap",
                             [](const py::object& self) {
                               const auto& outcome = self.cast<const View&>().outcome();
                               return bootstrap_of(outcome, outcome.intervals.residuals, self);
                             })
      .def_property_readonly("bootstrap_specimens", [](const py::object& self) {
        const auto& outcome = self.cast<const View&>().outcome();
        return bootstrap_of(outcome, outcome.intervals.specimens, self);
      });
}

}  // namespace plastica::python
