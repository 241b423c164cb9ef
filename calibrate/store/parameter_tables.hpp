#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "calibrate/result/fit_outcome.hpp"
#include "calibrate/store/tables.hpp"

/// What a file holds of all fits, whatever they were fitted to: their parameters, a table each,
/// /parameters/NAME, with a row for each fit; not installed.
namespace plastica::calibrate::store {

/// What the fits of records gave, for the functions below.
/// @param records  pointers to them
template <typename Record>
auto outcomes_of(const std::vector<Record*>& records) {
  using Outcome = std::conditional_t<std::is_const_v<Record>, const FitOutcome, FitOutcome>;
  std::vector<Outcome*> fits;
  fits.reserve(records.size());
  for (Record* record : records) fits.push_back(&record->result);
  return fits;
}

/// Whose table it is.
struct StoredParameter {
  std::string path;
  Dimension dimension = Dimension::None;
};

/// Those that any fit has, in the order in which they come up first.
std::vector<StoredParameter> parameters_of(std::span<const FitOutcome* const> fits);

/// Writes /parameters/path, in the order of `all`, and a table each under the last part of its
/// path. Its column `row` says which of a fit's parameters it is, -1: the fit does not have it;
/// `role` what it is there: one law may search what another ties.
/// @throws std::logic_error if a fit has one that is not among `all`, or otherwise than there
void write_parameters(io::Hdf5Group& root, std::span<const FitOutcome* const> fits,
                      const std::vector<StoredParameter>& all);

/// Fills the parameters of fits that have none yet.
/// @param version  of the file, 5 or later
/// @param role_of_each  since which version a parameter has its role by fit; before, one in all
/// @throws InputError
void read_parameters(const io::Hdf5Group& root, int version, int role_of_each,
                     std::span<FitOutcome* const> fits);

/// Whether matrix, held out parts and intervals that were read are those of a fit.
/// @param moved  how many parameters the matrix is of
/// @throws InputError if not
void check_outcome(const io::Hdf5Group& root, const FitOutcome& fit, std::size_t moved);

}  // namespace plastica::calibrate::store
