#pragma once

#include <span>
#include <string>
#include <string_view>

#include "calibrate/report/summary.hpp"
#include "calibrate/report/text.hpp"
#include "plastica/report/ink.hpp"

/// The groups of a batch in its report; not installed.
namespace plastica::calibrate::report {

/// "Rp0.2", or "Rp" where the specimens have different offsets.
std::string proof_label(std::span<const FitRecord> records);

/// What the elastic slopes are: "E", of torsion tests "G", of both "E, G".
std::string modulus_label(std::span<const FitRecord> records);

/// "G", "Rp0.2", "Rm": what a characteristic of a group is called; other names as they are.
/// @param records  of all groups
std::string characteristic_label(std::string_view name, const GroupSummary& group,
                                 std::span<const FitRecord> records);
/// The same over all specimens: "E, G" of tests of both kinds.
std::string characteristic_label(std::string_view name, std::span<const FitRecord> records);

/// When a specimen is out of line with its group, in a sentence without a full stop.
std::string out_of_line_rule();

/// Mean and deviation of the characteristics and parameters of each group, the intervals of the
/// parameters' means if specimens are resampled.
std::string groups_text(std::span<const FitRecord> records, const ReportOptions& options,
                        const plastica::report::Ink& ink);

}  // namespace plastica::calibrate::report
