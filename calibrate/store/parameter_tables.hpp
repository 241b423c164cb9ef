#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibrate/result/fit_outcome.hpp"
#include "calibrate/store/tables.hpp"

/// Parameters of fits, a table each: /parameters/NAME has a row for each fit of the file, whatever
/// it was fitted to; not installed.
namespace plastica::calibrate::store {

/// Whose table it is.
struct StoredParameter {
  std::string path;
  Dimension dimension = Dimension::None;
  ParameterRole role = ParameterRole::Free;
};

/// Those that any fit has, in the order in which they come up first.
std::vector<StoredParameter> parameters_of(std::span<const FitOutcome* const> fits);

/// Writes /parameters/path, in the order of `all`, and a table each under the last part of its
/// path. Its column `row` says which of a fit's parameters it is, -1: the fit does not have it.
/// @throws std::logic_error if a fit has one that is not among `all`, or otherwise than there
void write_parameters(io::Hdf5Group& root, std::span<const FitOutcome* const> fits,
                      const std::vector<StoredParameter>& all);

/// Fills the parameters of fits that have none yet.
/// @param version  of the file, 5 or later
/// @throws InputError
void read_parameters(const io::Hdf5Group& root, int version, std::span<FitOutcome* const> fits);

}  // namespace plastica::calibrate::store
