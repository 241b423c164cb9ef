#pragma once

#include "plastica/model/field.hpp"

namespace plastica::calibrate {

/// Sets a number of a setup; one of the material also in those regions of the beam that had the
/// scene's: a region that differs in its section alone has a copy of the material.
/// @param original  the setup before any number was set
void set_everywhere(const Setup& original, const Field& field, double value, Setup& setup);

/// Whether a number of the material stands in a region, too.
bool stands_in_regions(const Setup& setup, const Field& field);

}  // namespace plastica::calibrate
