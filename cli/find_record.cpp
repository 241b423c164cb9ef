#include "cli/find_record.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "calibrate/report/law_choice.hpp"
#include "plastica/base/check.hpp"

namespace plastica::cli {
namespace {

template <typename Record, typename NameOf>
const Record& find(std::span<const Record> records, const NameOf& name_of, std::string_view what,
                   const std::string& wanted, const std::string& file) {
  constexpr std::size_t kMaxNames = 8;
  std::string names;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (name_of(records[i]) == wanted) return records[i];
    if (i < kMaxNames) names += (i == 0 ? "" : ", ") + name_of(records[i]);
  }
  if (records.size() > kMaxNames) names += fmt::format(", … ({} in all)", records.size());
  throw InputError({file, 0}, "--case", wanted,
                   fmt::format("must be a {} of the file: {}", what, names));
}

/// By its label, or by its name: the law that is advised for it.
template <typename Record>
const Record& find_law(std::span<const Record> records, std::string_view what,
                       const std::string& wanted, const std::string& file) {
  const bool compared = calibrate::compares_laws(records);
  for (const auto& target : calibrate::by_target(records)) {
    if (!compared || name_of(*target.front()) != wanted) continue;
    const calibrate::LawComparison laws = calibrate::compare_laws(target);
    const calibrate::Law best = laws.laws[laws.advised.value_or(0)].fit.law;
    return **std::ranges::find_if(target,
                                  [&](const auto* record) { return record->result.law == best; });
  }
  const auto name = [&](const Record& record) { return calibrate::label_of(record, compared); };
  return find(records, name, what, wanted, file);
}

}  // namespace

const calibrate::FitRecord& find_record(std::span<const calibrate::FitRecord> records,
                                        const std::string& specimen, const std::string& file) {
  return find_law(records, "specimen", specimen, file);
}

const calibrate::SceneFitRecord& find_record(std::span<const calibrate::SceneFitRecord> records,
                                             const std::string& fit, const std::string& file) {
  return find_law(records, "fit", fit, file);
}

}  // namespace plastica::cli
