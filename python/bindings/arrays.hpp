#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <vector>

/// Numbers of ours as arrays of NumPy, without a copy.
namespace plastica::python {

/// A view of numbers that `owner` holds, which may not be written to.
/// @param shape  its product is at most the number of values
template <class T>
pybind11::array view_of(const T* data, const std::vector<pybind11::ssize_t>& shape,
                        const std::vector<pybind11::ssize_t>& strides, pybind11::handle owner) {
  pybind11::array view(pybind11::dtype::of<T>(), shape, strides, data, owner);
  view.attr("setflags")(pybind11::arg("write") = false);
  return view;
}

/// The same of numbers in a row.
template <class T>
pybind11::array view_of(const std::vector<T>& values, const std::vector<pybind11::ssize_t>& shape,
                        pybind11::handle owner) {
  std::vector<pybind11::ssize_t> strides(shape.size(), sizeof(T));
  for (std::size_t k = shape.size(); k-- > 1;) strides[k - 1] = strides[k] * shape[k];
  return view_of(values.data(), shape, strides, owner);
}

template <class T>
pybind11::array view_of(const std::vector<T>& values, pybind11::handle owner) {
  return view_of(values, {static_cast<pybind11::ssize_t>(values.size())}, owner);
}

}  // namespace plastica::python
