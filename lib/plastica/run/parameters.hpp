#pragma once

#include "plastica/run/model.hpp"

namespace plastica {

/// The material numbers of a model at some values of its parameters.
/// @return whether they can be run: each within its field's range, and those of a law consistent
bool take_parameters(const Model& model, ParameterValues values, MaterialValues<double>& material);

}  // namespace plastica
