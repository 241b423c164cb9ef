#pragma once

#include "plastica/io/hdf5_columns.hpp"

/// Packed numbers of HDF5 files that other programs wrote; not installed.
namespace plastica::io::h5 {

/// Makes of the stored numbers of a dataset those that they stand for, by its attributes, if it has
/// any of them: stored * `scale_factor` + `add_offset`, and no number (NaN) where what is stored is
/// `_FillValue` or a `missing_value`, or lies outside of `valid_min`, `valid_max` or `valid_range`.
/// `_Unsigned` makes whole numbers with a sign those of as many bits without. All but the first two
/// are compared as the dataset stores them. Sources: NetCDF Climate and Forecast Metadata
/// Conventions 1.11, 2.5.1 and 8.1; NetCDF Users' Guide, attribute conventions.
/// @param column  of its values, as they are stored
/// @throws InputError if such an attribute is no number, or not as many as it must be
void unpack(const Hdf5Handle& dataset, const Place& place, Column& column);

/// Whether a dataset has such attributes.
bool is_packed(const Hdf5Handle& dataset);

}  // namespace plastica::io::h5
