#pragma once

#include <vector>

#include "calibrate/scene/scene_fit_record.hpp"
#include "plastica/io/hdf5.hpp"

/// The tables of profiles and bootstraps in a file of fits through scenes; not installed.
namespace plastica::calibrate::store {

/// @param records  in the order of the file
void write_intervals(io::Hdf5Group& root, const std::vector<const SceneFitRecord*>& records);

/// @param records  of the file, in its order
/// @throws InputError if a table is not whole
void read_intervals(const io::Hdf5Group& root, std::vector<SceneFitRecord>& records);

}  // namespace plastica::calibrate::store
