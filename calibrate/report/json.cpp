#include "calibrate/report/json.hpp"

#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "calibrate/report/described.hpp"
#include "calibrate/report/format.hpp"
#include "calibrate/report/json_values.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/law_json.hpp"
#include "calibrate/report/outcome_json.hpp"
#include "calibrate/report/summary.hpp"
#include "calibrate/result/describe_fit.hpp"
#include "calibrate/result/describe_target.hpp"
#include "calibrate/result/usable.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;
Json pairs(const std::vector<std::pair<std::string, std::string>>& all) {
  Json object = Json::object();
  for (const auto& [key, value] : all) object[key] = value;
  return object;
}

Json fit_of(const FitRecord& record) {
  const Target& target = record.target;
  const FitResult& result = record.result;
  Json warnings = target.warnings;
  for (const std::string& warning : result.warnings) warnings.push_back(warning);
  Json properties = Json::object();
  for (const auto& [name, value] : target.properties) properties[name] = number(value);
  Json fit = described_json(&record, kDescribeFit);
  fit["reason"] = text_or_null(reason_of(record));
  fit["usable"] = is_usable(result);
  fit["why_unusable"] = text_or_null(why_unusable(result));
  fit["evaluations"] = result.evaluations();
  fit["characteristics"] = described_json(&target.characteristics, kDescribeCharacteristics);
  add_outcome(fit, result);
  fit["stages"] = described_list(result.stages, kDescribeStage);
  fit["group"] = pairs(target.group);
  fit["properties"] = std::move(properties);
  fit["repairs"] = described_list(target.repairs, kDescribeRepair);
  fit["corrections"] = described_list(target.corrections, kDescribeCorrection);
  fit["warnings"] = std::move(warnings);
  return fit;
}

Json statistics_of(const std::vector<GroupStatistic>& all) {
  Json object = Json::object();
  for (const GroupStatistic& entry : all) {
    object[entry.name] = {{"n", entry.statistic.n},
                          {"mean", number(entry.statistic.mean)},
                          {"standard_deviation", number(entry.statistic.standard_deviation)}};
    if (!entry.mean_interval) continue;
    object[entry.name]["mean_standard_error"] = number(entry.mean_interval->standard_error);
    object[entry.name]["mean_sampling_error"] = number(entry.mean_interval->sampling_error);
    object[entry.name]["mean_interval"] = {number(entry.mean_interval->low),
                                           number(entry.mean_interval->high)};
  }
  return object;
}

}  // namespace

std::string json_summary(std::span<const FitRecord> records, int indent,
                         const SpecimenDraws& draws) {
  Json fits = Json::array();
  for (const FitRecord& record : records) fits.push_back(fit_of(record));
  // Groups and counts are those of the law that is advised.
  std::vector<FitRecord> advised(records.begin(), records.end());
  const std::span<const FitRecord> shown = std::span(advised).first(advised_first(advised));
  Json groups = Json::array();
  for (const GroupSummary& group : summarize_groups(shown, draws)) {
    groups.push_back({{"group", pairs(group.group)},
                      {"fitted", group.fitted},
                      {"rejected", group.rejected},
                      {"failed", group.failed},
                      {"characteristics", statistics_of(group.characteristics)},
                      {"parameters", statistics_of(group.parameters)}});
  }
  const Counts counts = count_statuses(shown);
  Json all = {{"fits", std::move(fits)},
              {"groups", std::move(groups)},
              {"counts",
               {{"fitted", counts.fitted},
                {"rejected", counts.rejected},
                {"failed", counts.failed},
                {"unusable", counts.unusable}}}};
  if (compares_laws(records)) all["laws"] = laws_json(records);
  return all.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace plastica::calibrate
