#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "calibrate/inference/compare_laws.hpp"
#include "calibrate/report/text.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"

namespace plastica::calibrate {

/// The records of one target, or of one fit through scenes, a law each.
using LawRecords = std::vector<const FitRecord*>;
using SceneLawRecords = std::vector<const SceneFitRecord*>;

/// Records by target or name, in the order in which these come up first.
std::vector<LawRecords> by_target(std::span<const FitRecord> records);
std::vector<SceneLawRecords> by_target(std::span<const SceneFitRecord> records);

/// Whether a target has more than one record: laws are compared.
bool compares_laws(std::span<const FitRecord> records);
bool compares_laws(std::span<const SceneFitRecord> records);

/// The laws of one target beside each other.
LawComparison compare_laws(const LawRecords& records);
LawComparison compare_laws(const SceneLawRecords& records);

/// The laws over all targets, see `compare_laws_over`.
LawComparison compare_laws(std::span<const FitRecord> records);
LawComparison compare_laws(std::span<const SceneFitRecord> records);

/// Puts the records of the law that is advised for all targets to the front, in their order; all
/// stay as they are where no laws are compared. @return how many these are
std::size_t advised_first(std::vector<FitRecord>& records);
std::size_t advised_first(std::vector<SceneFitRecord>& records);

/// The records of one law, or, where none is named, of that which is advised for all targets; all
/// of them where no laws are compared.
/// @param law  its name; may be empty
/// @throws InputError for a law that the records do not have
std::vector<FitRecord> of_law(std::span<const FitRecord> records, const std::string& law);
std::vector<SceneFitRecord> of_law(std::span<const SceneFitRecord> records, const std::string& law);

/// Splits a case "s355:voce" of a file that compares laws into name and law; leaves others as they
/// are.
void split_label(std::span<const FitRecord> records, std::string& name, std::string& law);
void split_label(std::span<const SceneFitRecord> records, std::string& name, std::string& law);

/// What a record is called in a file that compares laws: "s355:voce", else "s355".
std::string label_of(const FitRecord& record, bool compared);
std::string label_of(const SceneFitRecord& record, bool compared);

/// The comparison as text: a table of a few targets each, of many one row each; then which law is
/// advised. Empty where no laws are compared.
std::string laws_report(std::span<const FitRecord> records, const ReportOptions& options = {});
std::string laws_report(std::span<const SceneFitRecord> records, const ReportOptions& options = {});

}  // namespace plastica::calibrate
