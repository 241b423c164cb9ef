#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "calibrate/target/import.hpp"
#include "plastica/io/csv.hpp"

/// What the names of columns say of the measure and the test, against what the block says; not
/// installed.
namespace plastica::calibrate {

/// Refuses "True strain" and "True stress" of a tension test in a block that does not say which
/// measure they are.
/// @throws InputError
void check_named_measure(const TargetSource& source, const io::CsvTable& table, std::size_t strain,
                         std::size_t stress);

/// Refuses a strain that is the plastic one alone by its name: a curve is one of the total strain.
/// @param way_out  what takes it all the same, for the message
/// @throws InputError
void check_total_strain(const io::CsvTable& table, std::size_t strain, std::string_view way_out);

/// Warns of columns of strain and stress in tension that are of the other measure by their names.
void warn_of_named_measure(const TargetSource& source, const io::CsvTable& table,
                           std::size_t strain, std::size_t stress,
                           std::vector<std::string>& warnings);

/// Warns of columns of strain and stress that are of another test by their names.
void warn_of_named_test(const TargetSource& source, const io::CsvTable& table, std::size_t strain,
                        std::size_t stress, std::vector<std::string>& warnings);

}  // namespace plastica::calibrate
