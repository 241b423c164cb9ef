#pragma once

#include "plastica/model/field.hpp"

namespace plastica::calibrate {

/// Whether a region of the beam has a number of the scene's material, as a copy: one that differs
/// in its section alone has all of them. No break limit at all is shared by the same material only:
/// another one never breaks.
bool has_the_scenes(const Setup& setup, const Field& field, const Region& region);

/// Sets a number of a setup; one of the material also in those regions that had the scene's.
/// @param original  the setup before any number was set
void set_everywhere(const Setup& original, const Field& field, double value, Setup& setup);

/// Whether a number of the material stands in a region, too.
bool stands_in_regions(const Setup& setup, const Field& field);

}  // namespace plastica::calibrate
