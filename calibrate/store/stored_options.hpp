#pragma once

#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"
#include "plastica/io/hdf5.hpp"

/// The group /options of a result file; not installed.
namespace plastica::calibrate::store {

/// Writes all that the fits were told: single values, a table of parameters, and under setup/ a
/// value for each field of the scene and the solver, with its unit.
void write_options(io::Hdf5Group& group, const FitOptions& options);

/// The parameters that a record's fit was told: of its law, where laws are compared.
std::vector<Parameter> parameters_of(const FitRecord& record, const FitOptions& options);

/// @param version  of the file
/// @throws InputError if something is missing or out of a field's range
FitOptions read_options(const io::Hdf5Group& group, int version);

}  // namespace plastica::calibrate::store
