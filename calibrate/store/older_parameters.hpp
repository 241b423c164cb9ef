#pragma once

#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/store/tables.hpp"

/// Parameters as files of versions 3 and 4 have them; not installed.
namespace plastica::calibrate::store {

/// Of curves: a table for each parameter of the options, and which fits have theirs.
void read_parameters_4(const io::Hdf5Group& root, int version, std::vector<FitRecord>& records,
                       const FitOptions& options);

/// Through scenes: one table, a row for each parameter of each fit.
void read_scene_parameters_4(const io::Hdf5Group& root, int version,
                             const std::vector<FitOutcome*>& fits);

}  // namespace plastica::calibrate::store
