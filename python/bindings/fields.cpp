#include "plastica/model/field.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <stdexcept>
#include <string>

#include "plastica/base/renamed.hpp"
#include "plastica/io/units.hpp"
#include "plastica/model/item_field.hpp"
#include "plastica/model/support_kind.hpp"
#include "python/bindings/bindings.hpp"

namespace py = pybind11;

namespace plastica::python {
namespace {

constexpr const char* kKinds[] = {"number", "integer", "choice"};

py::dict describe(const Field& field) {
  py::dict said;
  said["path"] = field.path;
  said["kind"] = kKinds[static_cast<std::size_t>(field.kind)];
  said["unit"] = field.kind == FieldKind::Number ? si_unit(field.dimension) : std::string_view();
  said["default"] = default_text(field);
  py::list choices;
  for (const std::string_view word : field.choices) choices.append(word);
  said["choices"] = choices;
  said["rule"] = field.kind == FieldKind::Choice ? std::string() : field.range.rule();
  said["doc"] = field.doc;
  return said;
}

/// Units of the numbers of an item, by their keys: of a single place, and of one that reaches on.
template <class Fields>
py::dict units_of(const Fields& fields) {
  py::dict units;
  for (const auto& field : fields) {
    const Dimension along = field.per_length.value_or(field.dimension);
    units[py::str(std::string(field.key))] =
        py::make_tuple(si_unit(field.dimension), si_unit(along));
  }
  return units;
}

}  // namespace

void bind_fields(py::module_& core) {
  core.def("fields", [] {
    py::list all;
    for (const Field& field : fields()) all.append(describe(field));
    return all;
  });
  core.def(
      "quantity",
      [](const std::string& text, const std::string& of, const std::string& field) {
        for (int k = 0; k <= static_cast<int>(kLastDimension); ++k) {
          const auto dimension = static_cast<Dimension>(k);
          if (name_of(dimension) == of) return io::parse_quantity(text, dimension, {}, field);
        }
        throw std::logic_error("no dimension is called " + of);
      },
      py::arg("text"), py::arg("dimension"), py::arg("field"));
  core.def(
      "unit_conversion",
      [](const std::string& unit, const std::string& of, const std::string& field) {
        const Dimension dimension = of == "stress" ? Dimension::Stress : Dimension::Strain;
        const io::UnitConversion conversion = io::unit_conversion(unit, dimension, {}, field);
        return py::make_tuple(conversion.scale, conversion.offset);
      },
      py::arg("unit"), py::arg("dimension"), py::arg("field"));
  core.def("renamed_keys", [] {
    py::dict now;
    for (const Renamed& one : kRenamedWords) now[py::str(std::string(one.before))] = one.now;
    return now;
  });
  core.def("item_units", [] {
    py::dict units;
    units["support"] = units_of(support_fields());
    units["load"] = units_of(load_fields());
    units["mass"] = units_of(mass_fields());
    units["initial_motion"] = units_of(initial_motion_fields());
    return units;
  });
}

}  // namespace plastica::python
