#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "calibrate/inference/intervals.hpp"
#include "plastica/io/hdf5.hpp"

/// The tables of profiles and bootstraps in a file of fits, of coupons or through scenes; not
/// installed.
namespace plastica::calibrate::store {

/// What one fit has.
struct StoredIntervals {
  std::vector<std::string> paths;  ///< of its free parameters, in their order
  const FitIntervals* intervals = nullptr;
};

/// @param fits  in the order of the file
void write_intervals(io::Hdf5Group& root, const std::vector<StoredIntervals>& fits);

/// @param fits  of the file, in its order: those to be filled
/// @throws InputError if a table is not complete
void read_intervals(const io::Hdf5Group& root, const std::vector<FitIntervals*>& fits);

/// Whether what was read is of a fit's free parameters.
/// @param free  how many the fit has
/// @throws InputError if not
void check_intervals(const io::Hdf5Group& root, const FitIntervals& intervals, std::size_t free);

}  // namespace plastica::calibrate::store
