#include "calibrate/report/json.hpp"

#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "calibrate/report/format.hpp"
#include "calibrate/report/json_values.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/law_json.hpp"
#include "calibrate/report/parameter_json.hpp"
#include "calibrate/report/shown_intervals.hpp"
#include "calibrate/report/summary.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;
Json pairs(const std::vector<std::pair<std::string, std::string>>& all) {
  Json object = Json::object();
  for (const auto& [key, value] : all) object[key] = value;
  return object;
}

Json characteristics_of(const Characteristics& all) {
  Json object = Json::object();
  for (const CharacteristicEntry& entry : characteristic_entries()) {
    object[std::string(entry.name)] = number(all.*entry.value);
  }
  object["youngs_modulus_standard_error"] = number(all.youngs_modulus_stderr);
  object["modulus_method"] = text_or_null(all.modulus_method);
  object["modulus_window"] = {number(all.modulus_window_low), number(all.modulus_window_high)};
  object["offset"] = number(all.offset);
  object["break"] = nullptr;
  if (all.observed_break) {
    object["break"] = {{"last_whole_strain", number(all.observed_break->last_whole_strain)},
                       {"last_whole_stress", number(all.observed_break->last_whole_stress)},
                       {"first_broken_strain", number(all.observed_break->first_broken_strain)},
                       {"rule", all.observed_break->rule}};
  }
  object["largest_strain"] = number(all.largest_strain);
  return object;
}

Json repairs_of(const Target& target) {
  Json all = Json::array();
  for (const Repair& repair : target.repairs) {
    all.push_back({{"kind", repair.kind}, {"count", repair.count}, {"text", repair.text}});
  }
  return all;
}

Json corrections_of(const Target& target) {
  Json all = Json::array();
  for (const Correction& correction : target.corrections) {
    all.push_back({{"kind", correction.kind},
                   {"applied", correction.applied},
                   {"amount", number(correction.amount)},
                   {"unit", correction.unit},
                   {"text", correction.text}});
  }
  return all;
}

Json stages_of(const FitResult& result) {
  Json all = Json::array();
  for (const OptimizerStage& stage : result.stages) {
    all.push_back({{"algorithm", stage.algorithm},
                   {"outcome", stage.outcome},
                   {"evaluations", stage.evaluations},
                   {"cost", number(stage.cost)}});
  }
  return all;
}

/// Rows of the matrix of the free parameters; empty if the fit gave none.
Json correlation_of(const FitResult& result) {
  std::vector<std::string> names;
  for (const FittedParameter& parameter : result.parameters) {
    if (parameter.role == ParameterRole::Free) names.push_back(parameter.name());
  }
  const std::size_t n = names.size();
  Json rows = Json::array();
  if (result.correlation.size() != n * n) names.clear();
  for (std::size_t i = 0; i < names.size(); ++i) {
    Json row = Json::array();
    for (std::size_t j = 0; j < n; ++j) row.push_back(number(result.correlation[i * n + j]));
    rows.push_back(std::move(row));
  }
  return {{"parameters", std::move(names)}, {"matrix", std::move(rows)}};
}

Json fit_of(const FitRecord& record) {
  const Target& target = record.target;
  const FitResult& result = record.result;
  const bool fitted = result.status == FitStatus::Fitted;
  const auto if_fitted = [&](double value) { return fitted ? number(value) : Json(nullptr); };
  Json parameters = Json::object();
  for (const FittedParameter& parameter : result.parameters) {
    parameters[parameter.name()] = json_of(parameter);
  }
  Json warnings = target.warnings;
  for (const std::string& warning : result.warnings) warnings.push_back(warning);
  Json properties = Json::object();
  for (const auto& [name, value] : target.properties) properties[name] = number(value);
  Json fit = {{"name", target.name},
              {"law", name_of(result.law)},
              {"status", word_of(result.status)},
              {"reason", text_or_null(reason_of(record))},
              {"characteristics", characteristics_of(target.characteristics)},
              {"parameters", std::move(parameters)},
              {"objective", if_fitted(result.cost)},
              {"evaluations", result.evaluations()},
              {"simpler_evaluations", result.simpler_evaluations},
              {"misfit_rms", if_fitted(result.misfit_rms)},
              {"misfit_share", if_fitted(result.misfit_share)},
              {"runs_probability", if_fitted(result.runs_probability)},
              {"autocorrelation", if_fitted(result.autocorrelation)},
              {"effective_samples", if_fitted(result.effective_samples)},
              {"misfit", fitted ? text_or_null(result.misfit_word) : Json(nullptr)},
              {"break_strain_total", number(result.break_strain_total)},
              {"correlation", correlation_of(result)},
              {"stages", stages_of(result)},
              {"noise", number(result.noise)},
              {"seed", result.seed},
              {"samples", result.samples},
              {"file", target.file},
              {"test", word_of(target.test)},
              {"measure", word_of(target.measure)},
              {"loading", word_of(target.loading)},
              {"target_status", word_of(target.status)},
              {"group", pairs(target.group)},
              {"properties", std::move(properties)},
              {"repairs", repairs_of(target)},
              {"corrections", corrections_of(target)},
              {"warnings", std::move(warnings)}};
  const FitIntervals& intervals = result.intervals;
  const bool any = !intervals.profiles.empty() || intervals.residuals.resamples > 0;
  if (any) fit["intervals"] = intervals_json(shown_intervals(record));
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
  Json all = {
      {"fits", std::move(fits)},
      {"groups", std::move(groups)},
      {"counts",
       {{"fitted", counts.fitted}, {"rejected", counts.rejected}, {"failed", counts.failed}}}};
  if (compares_laws(records)) all["laws"] = laws_json(records);
  return all.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace plastica::calibrate
