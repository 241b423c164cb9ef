#pragma once

#include <vector>

#include "plastica/io/hdf5.hpp"
#include "plastica/model/beam.hpp"

/// Regions of a beam in files; not installed.
namespace plastica::io {

/// A row per region: `from` and `to`, the material's name, and each field of `material` and
/// `section` of the field table as a column; an optional one that is not set is NaN.
/// @param regions  with places that are fractions of the length
void write_regions(Hdf5Group& group, const std::vector<Region>& regions);
/// @throws InputError if something is missing or out of a field's range
std::vector<Region> read_regions(const Hdf5Group& group);

}  // namespace plastica::io
