#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "calibrate/fit/compare_laws.hpp"
#include "calibrate/fit/result.hpp"
#include "calibrate/report/text.hpp"

namespace plastica::calibrate {

/// The records of one target, a law each.
using LawRecords = std::vector<const FitRecord*>;

/// Records by target, in the order in which the targets come up first.
std::vector<LawRecords> by_target(std::span<const FitRecord> records);

/// Whether a target has more than one record: laws are compared.
bool compares_laws(std::span<const FitRecord> records);

/// The laws of one target beside each other.
LawComparison compare_laws(const LawRecords& records);

/// The laws over all targets, as if each target had the law's parameters of its own: sums of the
/// targets that every law was fitted to; where there is none, of the laws that were fitted to every
/// target.
LawComparison compare_laws(std::span<const FitRecord> records);

/// Puts the records of the law that is advised for all targets to the front, in their order; all
/// stay as they are where no laws are compared. @return how many these are
std::size_t advised_first(std::vector<FitRecord>& records);

/// What a record is called in a file that compares laws: "s355:voce", else "s355".
std::string label_of(const FitRecord& record, bool compared);

/// The comparison as text: a table of a few targets each, of many one row each; then which law is
/// advised. Empty where no laws are compared.
std::string laws_report(std::span<const FitRecord> records, const ReportOptions& options = {});

}  // namespace plastica::calibrate
