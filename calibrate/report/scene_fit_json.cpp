#include "calibrate/report/scene_fit_json.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "calibrate/report/json_values.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/law_json.hpp"
#include "calibrate/report/parameter_json.hpp"
#include "calibrate/report/scene_fit_words.hpp"
#include "calibrate/report/scene_population.hpp"
#include "calibrate/report/shown_intervals.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;
/// Rows of a square matrix; empty if it is none.
Json matrix(std::span<const double> values, std::size_t n) {
  Json rows = Json::array();
  if (values.size() != n * n) return rows;
  for (std::size_t i = 0; i < n; ++i) rows.push_back(numbers(values.subspan(i * n, n)));
  return rows;
}

/// @param part  null: the fit has none
Json target_of(const SceneTarget& target, double weight, const ScenePartFit* part) {
  const auto of_part = [&](auto member) {
    return part == nullptr ? Json(nullptr) : number(part->*member);
  };
  Json broke = nullptr;
  if (target.broke) {
    broke = {{"at", number(target.broke->at)},
             {"half_interval", number(target.broke->half_interval)}};
  }
  return {{"name", target.name},
          {"abscissa", abscissa_text(target)},
          {"abscissa_unit", si_unit(target.abscissa_is)},
          {"ordinate", target.ordinate_probe},
          {"ordinate_unit", si_unit(target.ordinate_is)},
          {"samples", target.abscissa.size()},
          {"weight", number(weight)},
          {"given_noise", number(target.noise)},
          {"broke", std::move(broke)},
          {"level", part == nullptr ? Json(nullptr) : Json(word_of(part->level))},
          {"cost", of_part(&ScenePartFit::cost)},
          {"noise", of_part(&ScenePartFit::noise)},
          {"degrees_of_freedom", of_part(&ScenePartFit::degrees_of_freedom)},
          {"misfit_share", of_part(&ScenePartFit::misfit_share)},
          {"runs_probability", of_part(&ScenePartFit::runs_probability)},
          {"break_strain", of_part(&ScenePartFit::break_strain)}};
}

/// Null if the fit was not repeated with other segments.
Json segments_of(const SceneFitResult& result) {
  if (!result.segments) return nullptr;
  const SceneSegments& segments = *result.segments;
  Json parameters = Json::object();
  for (std::size_t i = 0; i < segments.parameters.size(); ++i) {
    const SegmentsError& e = segments.parameters[i];
    parameters[short_name(result.parameters[i].path)] = {
        {"at_half", number(e.at_half)},
        {"at_own", number(e.at_own)},
        {"at_twice", number(e.at_twice)},
        {"trend", name_of(e.trend)},
        {"observed_order", number(e.observed_order)},
        {"order", number(e.order)},
        {"safety_factor", number(e.safety_factor)},
        {"extrapolated", number(e.extrapolated)},
        {"extrapolated_error", number(e.extrapolated_error)},
        {"error", number(e.error)},
        {"unit", si_unit(result.parameters[i].dimension)}};
  }
  return {{"segments", segments.segments},
          {"note", text_or_null(segments.note)},
          {"parameters", std::move(parameters)}};
}

Json fit_of(const SceneFitRecord& record) {
  const SceneFitResult& result = record.result;
  Json parameters = Json::object();
  for (const FittedParameter& p : result.parameters) parameters[p.name()] = json_of(p);
  Json targets = Json::array();
  for (std::size_t i = 0; i < record.targets.size(); ++i) {
    const bool there = result.parts.size() == record.targets.size();
    targets.push_back(
        target_of(record.targets[i], record.weights[i], there ? &result.parts[i] : nullptr));
  }
  Json starts = Json::array();
  for (const SceneStart& start : result.starts) {
    starts.push_back({{"from", numbers(start.from)},
                      {"to", numbers(start.to)},
                      {"cost", number(start.cost)},
                      {"outcome", name_of(start.outcome)},
                      {"evaluations", start.evaluations}});
  }
  int evaluations = 0;
  for (const SceneStart& start : result.starts) evaluations += start.evaluations;
  return {{"name", record.name},
          {"law", name_of(result.law)},
          {"status", word_of(result.status)},
          {"reason", text_or_null(result.reason)},
          {"parameters", std::move(parameters)},
          {"intervals", intervals_json(shown_intervals(record))},
          {"correlation", matrix(result.correlation, result.parameters.size())},
          {"degrees_of_freedom", number(result.degrees_of_freedom)},
          {"segments", segments_of(result)},
          {"targets", std::move(targets)},
          {"starts", std::move(starts)},
          {"outcome", name_of(result.outcome)},
          {"evaluations", evaluations},
          {"runs", result.runs},
          {"search_runs", result.search_runs},
          {"failed_runs", result.failed_runs},
          {"segment_iterations", result.segment_iterations},
          {"warnings", result.warnings}};
}

Json population_of(std::span<const SceneFitRecord> records, double confidence) {
  const ScenePopulation population = scene_population(records, confidence);
  Json parameters = Json::object();
  for (const PopulationParameter& p : population.parameters) {
    parameters[short_name(p.path)] = {
        {"n", p.n},
        {"left_out", p.left_out},
        {"mean", number(p.mean)},
        {"standard_deviation", number(p.standard_deviation)},
        {"rms_error", number(p.rms_error)},
        {"specimen_deviation", number(p.specimen_deviation)},
        {"mean_interval", {number(p.mean_low), number(p.mean_high)}},
        {"specimen_deviation_interval", {number(p.deviation_low), number(p.deviation_high)}},
        {"unit", si_unit(p.dimension)}};
  }
  const std::size_t n = population.parameters.size();
  return {{"parameters", std::move(parameters)},
          {"covariance", matrix(population.covariance, n)},
          {"specimen_covariance", matrix(population.specimen_covariance, n)},
          {"specimen_covariance_low", matrix(population.covariance_low, n)},
          {"specimen_covariance_high", matrix(population.covariance_high, n)},
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
              {"counts", {{"fitted", fitted}, {"failed", std::ssize(shown) - fitted}}}};
  if (compares_laws(records)) all["laws"] = laws_json(records);
  return all.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace plastica::calibrate
