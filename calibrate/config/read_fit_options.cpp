#include "calibrate/config/read_fit_options.hpp"

#include <algorithm>
#include <limits>

#include "calibrate/config/read_intervals.hpp"
#include "calibrate/config/read_parameters.hpp"
#include "calibrate/result/words.hpp"
#include "calibrate/search/optimizer.hpp"
#include "plastica/io/read_fields.hpp"
#include "plastica/io/scene_file.hpp"

namespace plastica::calibrate {
namespace {

using io::TomlTable;
using io::TomlValue;

constexpr std::string_view kLeastSquaresAlone = "goes with objective = \"least-squares\" alone";

void read_stopping(const TomlTable& fit, StoppingRules& stopping) {
  constexpr std::int64_t kMax = 1'000'000'000;
  const auto stop = fit.find_table("stop");
  if (!stop) return;
  if (const auto value = stop->find("global_evaluations")) {
    stopping.global_evaluations = static_cast<int>(value->integer(0, kMax));
  }
  if (const auto value = stop->find("local_evaluations")) {
    stopping.local_evaluations = static_cast<int>(value->integer(1, kMax));
  }
  if (const auto value = stop->find("parameter_tolerance")) {
    stopping.parameter_tolerance = value->number_within(0.0, 1.0, true);
  }
  if (const auto value = stop->find("cost_tolerance")) {
    stopping.cost_tolerance = value->number_within(0.0, 1.0, true);
  }
}

/// [{ from = "1 %", weight = 0.2 }, ...], of an objective that is known already.
std::vector<WeightStep> read_weights(const TomlValue& value, const FitOptions& options) {
  const std::vector<TomlValue> items = value.array();
  if (items.empty()) throw value.error("must have at least one { from = ..., weight = ... }");
  if (options.objective != Objective::LeastSquares) throw value.error(kLeastSquaresAlone);
  std::vector<WeightStep> steps;
  for (const TomlValue& item : items) {
    const TomlTable table = item.table();
    const TomlValue from = table.at("from");
    const TomlValue weight = table.at("weight");
    WeightStep step;
    step.from = from.quantity(Dimension::Strain);
    if (step.from < 0.0) throw from.error("must be at least 0: it is the size of the strain");
    if (!steps.empty() && step.from <= steps.back().from) {
      throw from.error("must be above that of the step before");
    }
    step.weight = weight.number_within(0.0, std::numeric_limits<double>::infinity(), true);
    steps.push_back(step);
  }
  return steps;
}

void read_objective(const TomlTable& fit, FitOptions& options) {
  if (const auto value = fit.find("objective")) {
    options.objective = static_cast<Objective>(value->word(words_of<Objective>()));
  }
  if (const auto value = fit.find("noise")) {
    options.noise = value->quantity(Dimension::Stress);
    if (*options.noise <= 0.0) throw value->error("must be above 0 Pa");
    if (options.objective != Objective::LeastSquares) {
      throw value->error(kLeastSquaresAlone);
    }
  }
  if (const auto value = fit.find("weights")) options.weights = read_weights(*value, options);
  if (fit.contains("modulus_prior")) options.modulus_prior = fit.is_set("modulus_prior");
  if (const auto value = fit.find("break_weight")) {
    options.break_weight = value->number_within(0.0, std::numeric_limits<double>::infinity(), true);
  }
}

}  // namespace

std::vector<Law> read_laws(const TomlValue& value) {
  std::vector<Law> laws;
  const std::vector<TomlValue> items = value.array();
  if (items.empty()) throw value.error("must name at least one law");
  for (const TomlValue& item : items) {
    const auto law = static_cast<Law>(item.word(law_names()));
    if (std::ranges::find(laws, law) != laws.end()) throw item.error("is named twice");
    laws.push_back(law);
  }
  std::ranges::sort(laws);
  return laws;
}

FitOptions read_fit_options(const TomlTable& root) {
  FitOptions options;
  io::read_setup(root, options.setup);
  if (const auto material = io::part_of_beam(root, "material")) {
    options.stated = io::paths_said(*material, "material");
  }
  const auto fit = root.find_table("fit");
  if (!fit) {
    options.parameters = default_parameters();
    return options;
  }
  read_objective(*fit, options);
  if (const auto value = fit->find("algorithm")) {
    options.algorithm = algorithm_names()[value->word(algorithm_names())];
  }
  if (const auto value = fit->find("seed")) {
    options.seed =
        static_cast<std::uint64_t>(value->integer(0, std::numeric_limits<std::int64_t>::max()));
  }
  if (const auto value = fit->find("confidence")) {
    options.confidence = value->quantity(Dimension::None);
    if (options.confidence <= 0.0 || options.confidence >= 1.0) {
      throw value->error("must be above 0 % and below 100 %");
    }
  }
  read_intervals(*fit, options.intervals);
  if (const auto value = fit->find("laws")) options.laws = read_laws(*value);
  read_stopping(*fit, options.stopping);
  options.parameters = read_parameters(*fit);
  return options;
}

}  // namespace plastica::calibrate
