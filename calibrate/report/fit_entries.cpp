#include "calibrate/report/fit_entries.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "calibrate/report/format.hpp"
#include "calibrate/report/scene_fit_words.hpp"
#include "calibrate/result/describe_fit.hpp"
#include "calibrate/result/describe_target.hpp"
#include "calibrate/result/usable.hpp"

namespace plastica::calibrate::report {
namespace {

/// Replaces what a description says.
void replace(std::vector<Entry>& entries, std::string_view name, Json value) {
  std::ranges::find(entries, name, &Entry::name)->value = std::move(value);
}

/// @param add_own  what only one kind of fits has
template <typename Record, typename AddOwn>
std::vector<Entry> entries_of(const Record* record, const AddOwn& add_own) {
  using Result = decltype(Record::result);
  const Result* result = record == nullptr ? nullptr : &record->result;
  std::vector<Entry> entries{
      {"name", "", result == nullptr ? Json() : text_or_null(name_of(*record))}};
  append(entries, described<FitOutcome>(result, kDescribeOutcome));
  add_own(entries, result);
  append(entries, described(result, [](auto& d) {
           d.derived("usable", "", [](const auto& row) { return is_usable(row); });
           d.derived("why_unusable", "", [](const auto& row) { return why_unusable(row); });
           d.derived("evaluations", "", [](const auto& row) { return row.evaluations(); });
           d.derived("held_out", "1", [](const auto& row) { return row.held_out_misfit(); });
         }));
  return entries;
}

}  // namespace

std::vector<Entry> fit_entries(const FitRecord* record) {
  const Target* target = record == nullptr ? nullptr : &record->target;
  std::vector<Entry> entries = entries_of(record, [&](auto& own, const FitResult* result) {
    append(own, described(target, kDescribeSpecimen));
    append(own, described(result, kDescribeFit));
  });
  // Of a rejected target the fit has none of its own.
  if (record != nullptr) replace(entries, "reason", text_or_null(reason_of(*record)));
  return entries;
}

std::vector<Entry> fit_entries(const SceneFitRecord* record) {
  std::vector<Entry> entries = entries_of(record, [&](auto& own, const SceneFitResult* result) {
    append(own, described(result, kDescribeSceneFit));
  });
  if (record != nullptr) replace(entries, "law", laws_text(record->result));
  return entries;
}

std::vector<Entry> target_entries(const SceneFitRecord* record, std::size_t of) {
  const SceneTarget* target = record == nullptr ? nullptr : &record->targets[of];
  std::vector<Entry> entries = described(target, kDescribeSceneTarget);
  append(entries, described(target, [](auto& d) {
           d.derived("abscissa", "", [](const auto& row) { return abscissa_text(row); });
           d.derived("abscissa_unit", "",
                     [](const auto& row) { return std::string(si_unit(row.abscissa_is)); });
           d.derived("ordinate_unit", "",
                     [](const auto& row) { return std::string(si_unit(row.ordinate_is)); });
           d.derived("samples_measured", "1", [](const auto& row) { return row.abscissa.size(); });
         }));
  entries.push_back({"weight", "1", record == nullptr ? Json() : number(record->weights[of])});
  const bool made = record != nullptr && record->result.targets.size() == record->targets.size();
  append(entries, described(made ? &record->result.targets[of] : nullptr, kDescribeTargetFit));
  return entries;
}

}  // namespace plastica::calibrate::report
