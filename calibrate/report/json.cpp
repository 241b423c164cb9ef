#include "calibrate/report/json.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "calibrate/report/described.hpp"
#include "calibrate/report/fit_entries.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/law_json.hpp"
#include "calibrate/report/outcome_json.hpp"
#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/scene_population.hpp"
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

/// Adds the lists of a fit.
void add_lists(Json& fit, const FitRecord& record) {
  const Target& target = record.target;
  Json warnings = target.warnings;
  for (const std::string& warning : record.result.warnings) warnings.push_back(warning);
  Json properties = Json::object();
  for (const auto& [name, value] : target.properties) properties[name] = number(value);
  fit["characteristics"] = json_of(described(&target.characteristics, kDescribeCharacteristics));
  fit["stages"] = described_list(record.result.stages, kDescribeStage);
  fit["group"] = pairs(target.group);
  fit["properties"] = std::move(properties);
  fit["repairs"] = described_list(target.repairs, kDescribeRepair);
  fit["corrections"] = described_list(target.corrections, kDescribeCorrection);
  fit["warnings"] = std::move(warnings);
}

/// Null if the fit was not repeated with other segments.
Json segments_of(const SceneFitResult& result) {
  if (!result.segments) return nullptr;
  const SceneSegments& segments = *result.segments;
  Json parameters = Json::object();
  for (std::size_t i = 0; i < segments.parameters.size(); ++i) {
    Json& object = parameters[result.parameters[i].name()];
    object = json_of(described(&segments.parameters[i], kDescribeSegments));
    object["unit"] = si_unit(result.parameters[i].dimension);
  }
  return {{"segments", segments.segments},
          {"note", text_or_null(segments.note)},
          {"parameters", std::move(parameters)}};
}

void add_lists(Json& fit, const SceneFitRecord& record) {
  const SceneFitResult& result = record.result;
  fit["segments"] = segments_of(result);
  Json targets = Json::array();
  for (std::size_t t = 0; t < record.targets.size(); ++t) {
    targets.push_back(json_of(target_entries(&record, t)));
    targets.back()["repairs"] = described_list(record.targets[t].repairs, kDescribeRepair);
  }
  fit["targets"] = std::move(targets);
  Json starts = described_list(result.starts, kDescribeStart);
  for (std::size_t i = 0; i < result.starts.size(); ++i) {
    starts[i]["from"] = numbers(result.starts[i].from);
    starts[i]["to"] = numbers(result.starts[i].to);
  }
  fit["starts"] = std::move(starts);
  fit["warnings"] = result.warnings;
}

Json out_of_line(const GroupStatistic& entry, std::span<const FitRecord> records) {
  Json list = Json::array();
  for (const OutOfLine& one : entry.out_of_line) {
    list.push_back({{"target", records[one.record].target.name},
                    {"value", number(one.value)},
                    {"median", number(one.median)},
                    {"score", number(one.score)}});
  }
  return list;
}

/// @param records  that the statistics are of
Json statistics_of(const std::vector<GroupStatistic>& all, std::span<const FitRecord> records) {
  Json object = Json::object();
  for (const GroupStatistic& entry : all) {
    object[entry.name] = {{"n", entry.statistic.n},
                          {"mean", number(entry.statistic.mean)},
                          {"standard_deviation", number(entry.statistic.standard_deviation)},
                          {"out_of_line", out_of_line(entry, records)}};
    if (!entry.mean_interval) continue;
    object[entry.name]["mean_standard_error"] = number(entry.mean_interval->standard_error);
    object[entry.name]["mean_sampling_error"] = number(entry.mean_interval->sampling_error);
    object[entry.name]["mean_interval"] = {number(entry.mean_interval->low),
                                           number(entry.mean_interval->high)};
  }
  return object;
}

Json population_of(std::span<const SceneFitRecord> records, double confidence) {
  const ScenePopulation population = scene_population(records, confidence);
  Json parameters = Json::object();
  for (const PopulationParameter& p : population.parameters) {
    parameters[short_name(p.path)] = {
        {"n", p.n},
        {"left_out", p.left_out},
        {"of_material", p.is_of_material},
        {"segments_error", number(p.segments_error)},
        {"mean", number(p.mean)},
        {"standard_deviation", number(p.standard_deviation)},
        {"rms_error", number(p.rms_error)},
        {"specimen_deviation", number(p.specimen_deviation)},
        {"mean_sampling_error", number(p.sampling_error)},
        {"mean_interval", {number(p.mean_low), number(p.mean_high)}},
        {"specimen_deviation_interval", {number(p.deviation_low), number(p.deviation_high)}},
        {"unit", si_unit(p.dimension)}};
  }
  const std::size_t n = population.parameters.size();
  return {{"parameters", std::move(parameters)},
          {"covariance", matrix_json(population.covariance, n)},
          {"specimen_covariance", matrix_json(population.specimen_covariance, n)},
          {"specimen_covariance_low", matrix_json(population.covariance_low, n)},
          {"specimen_covariance_high", matrix_json(population.covariance_high, n)},
          {"confidence", confidence}};
}

std::string dumped(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// An object's text with the fits in front of what it has, an object each: as a whole those of ten
/// thousand would take half a gigabyte.
/// @param all  an object that is not empty
template <typename Record>
std::string text_with_fits(std::span<const Record> records, const Json& all, int indent) {
  const bool has_lines = indent >= 0;
  const auto line = [&](int depth) {
    const int blanks = has_lines ? depth * indent : 0;
    return (has_lines ? "\n" : "") + std::string(static_cast<std::size_t>(blanks), ' ');
  };
  std::string text = "{" + line(1) + (has_lines ? "\"fits\": [" : "\"fits\":[");
  for (const Record& record : records) {
    Json fit = json_of(fit_entries(&record));
    add_outcome(fit, record.result, record.result.correlated_parameters());
    add_lists(fit, record);
    text += &record == records.data() ? line(2) : "," + line(2);
    // Texts have no line ends of their own: JSON writes them as "\n".
    for (const char c : dumped(fit, indent)) {
      if (c == '\n') {
        text += line(2);
      } else {
        text += c;
      }
    }
    // Growing by doubles, a long text would stand in memory three times.
    if (&record == records.data()) text.reserve(text.size() * (records.size() + 1));
  }
  if (!records.empty()) text += line(1);
  text += "],";
  text += std::string_view(dumped(all, indent)).substr(1);
  text += '\n';
  return text;
}

}  // namespace

// Groups, population and counts are those of the law that is advised.

std::string json_summary(std::span<const FitRecord> records, int indent,
                         const SpecimenDraws& draws) {
  std::vector<FitRecord> advised;
  std::span<const FitRecord> shown = records;
  if (compares_laws(records)) {
    advised.assign(records.begin(), records.end());
    shown = std::span(advised).first(advised_first(advised));
  }
  Json groups = Json::array();
  for (const GroupSummary& group : summarize_groups(shown, draws)) {
    groups.push_back({{"group", pairs(group.group)},
                      {"fitted", group.fitted},
                      {"rejected", group.rejected},
                      {"failed", group.failed},
                      {"characteristics", statistics_of(group.characteristics, shown)},
                      {"parameters", statistics_of(group.parameters, shown)}});
  }
  const Counts counts = count_statuses(shown);
  Json all = {{"groups", std::move(groups)},
              {"counts",
               {{"fitted", counts.fitted},
                {"rejected", counts.rejected},
                {"failed", counts.failed},
                {"unusable", counts.unusable}}}};
  if (compares_laws(records)) all["laws"] = laws_json(records);
  return text_with_fits(records, all, indent);
}

std::string json_summary(std::span<const SceneFitRecord> records, double confidence, int indent) {
  const std::vector<SceneFitRecord> shown = of_law(records, "");
  const auto fitted = std::ranges::count(shown, FitStatus::Fitted,
                                         [](const SceneFitRecord& r) { return r.result.status; });
  Json all = {{"population", population_of(shown, confidence)},
              {"counts",
               {{"fitted", fitted},
                {"failed", std::ssize(shown) - fitted},
                {"unusable", std::ranges::count_if(shown, [](const SceneFitRecord& r) {
                   return !why_unusable(r.result).empty();
                 })}}}};
  if (compares_laws(records)) all["laws"] = laws_json(records);
  return text_with_fits(records, all, indent);
}

}  // namespace plastica::calibrate
