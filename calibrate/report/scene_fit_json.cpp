#include "calibrate/report/scene_fit_json.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "calibrate/report/described.hpp"
#include "calibrate/report/json_values.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/law_json.hpp"
#include "calibrate/report/outcome_json.hpp"
#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/scene_fit_words.hpp"
#include "calibrate/report/scene_population.hpp"
#include "calibrate/result/describe_fit.hpp"
#include "calibrate/result/describe_target.hpp"
#include "calibrate/result/usable.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;
/// @param of_target  null: the fit has none
Json target_of(const SceneTarget& target, double weight, const TargetFit* of_target) {
  Json object = described_json(&target, kDescribeSceneTarget);
  object["abscissa"] = abscissa_text(target);
  object["abscissa_unit"] = si_unit(target.abscissa_is);
  object["ordinate_unit"] = si_unit(target.ordinate_is);
  object["samples_measured"] = target.abscissa.size();
  object["weight"] = number(weight);
  object["repairs"] = described_list(target.repairs, kDescribeRepair);
  JsonDescriber<TargetFit> made(object, of_target);
  kDescribeTargetFit(made);
  return object;
}

/// Null if the fit was not repeated with other segments.
Json segments_of(const SceneFitResult& result) {
  if (!result.segments) return nullptr;
  const SceneSegments& segments = *result.segments;
  Json parameters = Json::object();
  for (std::size_t i = 0; i < segments.parameters.size(); ++i) {
    Json& object = parameters[result.parameters[i].name()];
    object = described_json(&segments.parameters[i], kDescribeSegments);
    object["unit"] = si_unit(result.parameters[i].dimension);
  }
  return {{"segments", segments.segments},
          {"note", text_or_null(segments.note)},
          {"parameters", std::move(parameters)}};
}

Json fit_of(const SceneFitRecord& record) {
  const SceneFitResult& result = record.result;
  Json targets = Json::array();
  for (std::size_t i = 0; i < record.targets.size(); ++i) {
    const bool there = result.targets.size() == record.targets.size();
    targets.push_back(
        target_of(record.targets[i], record.weights[i], there ? &result.targets[i] : nullptr));
  }
  Json starts = described_list(result.starts, kDescribeStart);
  for (std::size_t i = 0; i < result.starts.size(); ++i) {
    starts[i]["from"] = numbers(result.starts[i].from);
    starts[i]["to"] = numbers(result.starts[i].to);
  }
  Json fit = described_json(&record, kDescribeSceneFit);
  fit["law"] = laws_text(result);
  fit["usable"] = is_usable(result);
  fit["why_unusable"] = text_or_null(why_unusable(result));
  fit["evaluations"] = result.evaluations();
  add_outcome(fit, result);
  fit["segments"] = segments_of(result);
  fit["targets"] = std::move(targets);
  fit["starts"] = std::move(starts);
  fit["warnings"] = result.warnings;
  return fit;
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

}  // namespace

std::string scene_fits_json(std::span<const SceneFitRecord> records, double confidence,
                            int indent) {
  Json fits = Json::array();
  for (const SceneFitRecord& record : records) fits.push_back(fit_of(record));
  // Population and counts are those of the law that is advised.
  const std::vector<SceneFitRecord> shown = of_law(records, "");
  const auto fitted = std::ranges::count(shown, FitStatus::Fitted,
                                         [](const SceneFitRecord& r) { return r.result.status; });
  Json all = {{"fits", std::move(fits)},
              {"population", population_of(shown, confidence)},
              {"counts",
               {{"fitted", fitted},
                {"failed", std::ssize(shown) - fitted},
                {"unusable", std::ranges::count_if(shown, [](const SceneFitRecord& r) {
                   return !why_unusable(r.result).empty();
                 })}}}};
  if (compares_laws(records)) all["laws"] = laws_json(records);
  return all.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace plastica::calibrate
