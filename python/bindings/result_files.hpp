#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "plastica/io/output_file.hpp"
#include "plastica/io/result_file.hpp"
#include "python/bindings/background.hpp"

namespace plastica::python {

/// The texts that a result depends on, by their files' names.
inline pybind11::dict texts_of(const std::vector<io::InputText>& inputs) {
  pybind11::dict texts;
  for (const io::InputText& input : inputs) texts[pybind11::str(input.name)] = input.text;
  return texts;
}

/// Defines how contents of a kind are written and read: `write` of their type, and `read_name`.
template <class Contents, class Type, class Read, class Write>
void bind_files(pybind11::module_& core, Type& type, const char* read_name, const Read& read,
                const Write& write) {
  namespace py = pybind11;
  type.def(
      "write",
      [write](const Contents& contents, const std::string& path, bool overwrite) {
        in_background([&] {
          io::check_output_path(path, overwrite);
          write(path, contents, io::overwrite_if(overwrite));
          return true;
        });
      },
      py::arg("path"), py::arg("overwrite"));
  core.def(
      read_name,
      [read](const std::string& path) {
        return in_background([&] { return std::make_shared<Contents>(read(path)); });
      },
      py::arg("path"));
}

}  // namespace plastica::python
