#pragma once

#include <vector>

#include "calibrate/result/fit_outcome.hpp"
#include "plastica/io/hdf5.hpp"

/// The table of bootstraps in a file of fits, and whose the profiles of layout.hpp are; not
/// installed.
namespace plastica::calibrate::store {

/// @param fits  in the order of the file
/// @throws std::logic_error if one has profiles, and not one of each free parameter
void write_intervals(io::Hdf5Group& root, const std::vector<const FitOutcome*>& fits);

/// @param fits  of the file, in its order: those to be filled
/// @throws InputError if a table is not complete
void read_intervals(const io::Hdf5Group& root, const std::vector<FitOutcome*>& fits);

/// Whether what was read is of a fit's free parameters. @throws InputError if not
void check_intervals(const io::Hdf5Group& root, const FitOutcome& fit);

}  // namespace plastica::calibrate::store
