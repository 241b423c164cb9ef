#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "plastica/run/response.hpp"

namespace plastica::python {

/// A response and what holds it: its arrays live as long as one of them is looked at.
struct ResponseView {
  std::shared_ptr<const Response> response;
  std::vector<std::string> probe_names;
  std::vector<double> drive;  ///< of a coupon: strain at each sample [1] (n_samples)
};

}  // namespace plastica::python
