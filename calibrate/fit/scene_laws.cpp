#include "calibrate/fit/scene_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <variant>

#include "calibrate/inference/lack_of_fit.hpp"
#include "calibrate/problem/objective.hpp"
#include "calibrate/problem/scene_parameters.hpp"
#include "calibrate/search/ladder.hpp"
#include "plastica/model/region.hpp"

namespace plastica::calibrate {
namespace {

/// A number of the first target's material where the search begins.
double start_of(MaterialField which, const SceneFitOptions& options, const Setup& setup) {
  for (const Parameter& p : options.parameters) {
    if (p.field->material != which || p.role == ParameterRole::Tied) continue;
    const FieldValue scene = p.field->get(setup);
    const double* given = std::get_if<double>(&scene);
    double start = p.value ? *p.value : given != nullptr ? *given : 0.0;
    if (p.lower) start = std::max(start, *p.lower);
    if (p.upper) start = std::min(start, *p.upper);
    return start;
  }
  const Material& material = setup.scene.material;
  return which == MaterialField::YieldStress ? material.yield_stress : material.youngs_modulus;
}

/// The least Young's modulus that a search may try.
double min_modulus(const SceneFitOptions& options, double start) {
  for (const Parameter& p : options.parameters) {
    const bool searched =
        p.field->material == MaterialField::YoungsModulus && p.role == ParameterRole::Free;
    if (searched && p.lower) return *p.lower;
  }
  return start;
}

struct Usual {
  double start = 0.0, lower = 0.0, upper = 0.0;
};

Usual around(double start) { return {start, start / 100.0, start * 100.0}; }

/// Start and bounds of a hardening parameter; empty for others.
std::optional<Usual> usual(const Field& field, const SceneFitOptions& options, const Setup& setup) {
  if (!field.material) return std::nullopt;
  const double S = start_of(MaterialField::YieldStress, options, setup);
  const double E = start_of(MaterialField::YoungsModulus, options, setup);
  switch (*field.material) {
    case MaterialField::TangentModulus: {
      const double most = std::min(0.25 * E, 0.9 * min_modulus(options, E));
      return Usual{std::min(0.01 * E, most), 0.0, most};
    }
    case MaterialField::KinematicFraction: return Usual{0.5, 0.0, 1.0};
    case MaterialField::SaturationStress: return Usual{0.3 * S, 0.0, 3.0 * S};
    case MaterialField::SaturationRate: return around(0.1 * E / S);
    case MaterialField::BackModulus1: return around(0.2 * E);
    case MaterialField::BackModulus2: return around(0.02 * E);
    case MaterialField::BackModulus3: return around(0.002 * E);
    case MaterialField::BackRate1: return around(E / S);
    case MaterialField::BackRate2: return around(0.1 * E / S);
    case MaterialField::BackRate3: return around(0.01 * E / S);
    default: break;
  }
  if (!is_of_table(*field.material)) return std::nullopt;
  const double given = number_of(material_values(setup.scene.material), *field.material);
  return Usual{given, 0.0, 10.0 * given};
}

/// Fills in what a free hardening parameter leaves open.
void complete(const SceneFitOptions& options, const Setup& setup, Parameter& p) {
  const auto found = usual(*p.field, options, setup);
  if (!found || p.role != ParameterRole::Free) return;
  const double lower = p.lower.value_or(found->lower);
  const double upper = p.upper.value_or(found->upper);
  // Given at one end, it may leave the usual ones on the wrong side of that.
  if (!p.lower) p.lower = lower < upper ? lower : 0.01 * upper;
  if (!p.upper) p.upper = lower < upper ? upper : 100.0 * lower;
  if (p.value) return;
  const double scene = std::get<double>(p.field->get(setup));
  p.value = std::clamp(scene != 0.0 ? scene : found->start, *p.lower, *p.upper);
}

/// Mean of the squared residuals of a target, as its samples count [SI^2].
double mean_square(const SceneTarget& target, const TargetFit& fit, Objective objective) {
  const std::vector<double> weights = sample_weights(target.abscissa, objective);
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double residual = fit.fitted[i] - target.ordinate[i];
    sum += weights[i] * residual * residual;
  }
  return sum / std::accumulate(weights.begin(), weights.end(), 0.0);
}

/// Kish's number of the samples by their weights.
double effective_samples(const SceneTarget& target, Objective objective) {
  const std::vector<double> weights = sample_weights(target.abscissa, objective);
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  return sum * sum / std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
}

/// What the residuals of a fit and its priors leave, as in compare_laws.hpp.
double deviance(const SceneFitResult& result, std::span<const WeightedTarget> targets) {
  double sum = result.prior_squared;
  for (std::size_t i = 0; i < result.targets.size(); ++i) {
    const SceneTarget& target = targets[i].target;
    const double square = mean_square(target, result.targets[i], result.objective);
    sum += targets[i].weight * static_cast<double>(target.ordinate.size()) *
           (target.noise ? square / (*target.noise * *target.noise) : std::log(square));
  }
  return sum;
}

}  // namespace

Loading loading_of(std::span<const WeightedTarget> targets) {
  constexpr double kBeyond = 0.05;
  const bool cyclic = std::ranges::any_of(targets, [](const WeightedTarget& weighted) {
    if (weighted.target.ordinate.empty()) return false;
    const auto [low, high] = std::ranges::minmax(weighted.target.ordinate);
    const double beyond = kBeyond * std::max(-low, high);
    return low < -beyond && high > beyond;
  });
  return cyclic ? Loading::Cyclic : Loading::Monotonic;
}

Setup setup_of(Law law, const Setup& setup) {
  Setup changed = setup;
  Hardening& hardening = changed.scene.material.hardening;
  hardening = hardening_of(law, hardening);
  follow_beam(changed.scene);
  return changed;
}

std::vector<WeightedTarget> targets_of(Law law, std::span<const WeightedTarget> targets) {
  std::vector<WeightedTarget> changed(targets.begin(), targets.end());
  for (WeightedTarget& weighted : changed) weighted.setup = setup_of(law, weighted.setup);
  return changed;
}

SceneFitOptions options_of(Law law, const SceneFitOptions& options,
                           std::span<const WeightedTarget> targets) {
  SceneFitOptions own = options;
  const std::vector<Law> laws{law};
  own.parameters = parameters_of(law, loading_of(targets), parameters_of(laws, options.parameters),
                                 options.parameters);
  for (Parameter& p : own.parameters) complete(options, targets.front().setup, p);
  return own;
}

void start_from(const SceneFitResult& simpler, SceneFitOptions& options) {
  std::vector<SearchedParameter> searched;
  for (const Parameter& p : options.parameters) {
    const bool moves = p.role == ParameterRole::Free && !is_break(p);
    if (moves) searched.push_back({&p, *p.lower, *p.upper});
  }
  const auto value_of = [&](std::string_view path) {
    const auto found = std::ranges::find(simpler.parameters, path, &FittedParameter::path);
    return found == simpler.parameters.end() ? std::nullopt : std::optional(found->value);
  };
  for (StartPoint& start : starts_from_simpler(searched, value_of)) {
    options.further_starts.push_back(std::move(start));
  }
}

void compare_with(const SceneFitResult& simpler, std::span<const WeightedTarget> targets,
                  SceneFitResult& result) {
  if (result.status != FitStatus::Fitted || simpler.status != FitStatus::Fitted) return;
  double samples = 0.0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    samples += targets[i].weight * static_cast<double>(targets[i].target.ordinate.size());
  }
  if (!(deviance(result, targets) > deviance(simpler, targets) + kNoBetter * samples)) return;
  result.warnings.push_back(
      fmt::format("{} ends with a larger misfit than {}, which it contains: its search has not "
                  "found its best",
                  name_of(result.law), name_of(simpler.law)));
}

LawFit law_fit_of(const SceneFitRecord& record) {
  const SceneFitResult& result = record.result;
  LawFit fit;
  fit.law = result.law;
  fit.fitted = result.status == FitStatus::Fitted;
  if (!fit.fitted) return fit;
  const double weights = std::accumulate(record.weights.begin(), record.weights.end(), 0.0);
  for (std::size_t i = 0; i < result.targets.size(); ++i) {
    const TargetFit& of_target = result.targets[i];
    const SceneTarget& target = record.targets[i];
    std::vector<double> residual(of_target.fitted.size());
    double largest = 0.0;
    for (std::size_t k = 0; k < residual.size(); ++k) {
      residual[k] = of_target.fitted[k] - target.ordinate[k];
      largest = std::max(largest, std::fabs(target.ordinate[k]));
    }
    const double fraction =
        record.weights[i] * static_cast<double>(result.targets.size()) / weights;
    fit.curves.push_back({.mean_square = mean_square(target, of_target, result.objective),
                          .largest = largest,
                          .samples = fraction * effective_samples(target, result.objective),
                          .autocorrelation = autocorrelation(residual),
                          .noise = target.noise});
    fit.misfit_fraction = std::max(fit.misfit_fraction, of_target.misfit_fraction);
    fit.lacks_fit = fit.lacks_fit || lacks_fit(of_target.misfit_fraction, of_target.runs_test_p);
  }
  // Once for all targets.
  fit.curves.front().prior = result.prior_squared;
  for (const FittedParameter& p : result.parameters) {
    if (p.role != ParameterRole::Free || p.is_break()) continue;
    fit.parameters.push_back(p.name());
    fit.verdicts.push_back(p.verdict());
  }
  for (const SceneStart& start : result.starts) {
    fit.evaluations += static_cast<std::size_t>(start.evaluations);
  }
  fit.runs = static_cast<std::size_t>(result.search_runs);
  fit.seconds = record.seconds;
  fit.parts = result.held_out;
  return fit;
}

}  // namespace plastica::calibrate
