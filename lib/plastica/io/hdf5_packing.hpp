#pragma once

#include "plastica/io/hdf5_columns.hpp"

/// Packed numbers of HDF5 files that other programs wrote; not installed.
namespace plastica::io::h5 {

/// Makes of the stored numbers of a dataset those that they stand for, by its attributes, if it has
/// any of them: stored * `scale_factor` + `add_offset`, and no number (NaN) where what is stored is
/// `_FillValue` or a `missing_value`. Source: NetCDF Climate and Forecast Metadata
/// Conventions 1.11, 2.5.1 and 8.1.
/// @param column  of its values, as they are stored
/// @throws InputError if such an attribute is no number, or more than one
void unpack(const Hdf5Handle& dataset, const Place& place, Column& column);

/// Whether a dataset has such attributes.
bool is_packed(const Hdf5Handle& dataset);

}  // namespace plastica::io::h5
