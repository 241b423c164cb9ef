#pragma once

#include <string>

#include "plastica/model/field.hpp"
#include "plastica/run/model.hpp"

namespace plastica::cli {

/// What a dry run says of a motion's first three natural frequencies, with the steps that a period
/// of each has; ends with a line end. Chains so long that it would take seconds are told apart.
std::string frequency_line(const Model& model, const Setup& setup);

}  // namespace plastica::cli
