#include "calibrate/fit/search_target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "calibrate/fit/explain_fit.hpp"
#include "calibrate/inference/lack_of_fit.hpp"
#include "calibrate/problem/given_weights.hpp"
#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/modulus_prior.hpp"
#include "calibrate/problem/parameter_set.hpp"
#include "calibrate/problem/weighed_priors.hpp"
#include "calibrate/search/minimize_misfit.hpp"

namespace plastica::calibrate {
namespace {

/// A seed of the target's own, so that its fit does not depend on its place in a batch (FNV-1a).
std::uint64_t seed_of(const std::string& name, std::uint64_t seed) {
  std::uint64_t hash = 14695981039346656037ULL ^ seed;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

/// Why the samples cannot be fitted, whatever the model; empty if they can.
std::string defect_of(const Curve& curve) {
  if (curve.size() < 2) return "the corrected curve has fewer than two samples";
  if (curve.stress.size() != curve.size()) return "strain and stress differ in length";
  const auto finite = [](double value) { return std::isfinite(value); };
  if (!std::all_of(curve.strain.begin(), curve.strain.end(), finite) ||
      !std::all_of(curve.stress.begin(), curve.stress.end(), finite)) {
    return "the corrected curve holds numbers that are not finite";
  }
  const auto is_first = [&](double strain) { return strain == curve.strain.front(); };
  if (std::all_of(curve.strain.begin(), curve.strain.end(), is_first))
    return "the strain of the corrected curve never changes";
  if (largest_magnitude(curve.stress) == 0.0) return "the corrected curve never carries a stress";
  return "";
}

/// The options with a search's start at the values of a fit.
FitOptions from_values_of(const FitResult& result, FitOptions options) {
  for (Parameter& p : options.parameters) {
    const FittedParameter* fitted = result.find_parameter(p.field->path);
    if (p.role == ParameterRole::Free && fitted != nullptr) {
      p.value = fitted->value;
      p.lower = fitted->lower;
      p.upper = fitted->upper;
    }
  }
  return options;
}

FitOptions without_priors(FitOptions options) {
  for (Parameter& p : options.parameters) p.prior.reset();
  return options;
}

void take_values(const ParameterSet& set, std::span<const double> active, FitOptions& options) {
  for (std::size_t k = 0; k < active.size(); ++k) {
    options.parameters[set.active()[k]].value = active[k];
  }
}

/// @param to  a Solution or a FitResult
void append(const Solution& further, auto& to) {
  const auto add = [](const auto& from, auto& all) {
    all.insert(all.end(), from.begin(), from.end());
  };
  add(further.stages, to.stages);
  add(further.trace.values, to.trace.values);
  add(further.trace.costs, to.trace.costs);
}

/// A kink may part the solution from where stated priors want it, such as a yield stress that no
/// sample reaches: another search begins there.
void look_at_prior_means(const Target& target, FitOptions options, const WeighedPriors& priors,
                         Misfit& misfit, const ParameterSet& set, Solution& solution) {
  constexpr double kLess = 1e-9;
  take_values(set, solution.active, options);
  bool moves = false;
  for (Parameter& p : options.parameters) {
    if (p.role != ParameterRole::Free || !p.prior) continue;
    const double mean = p.prior->mean;
    p.value = std::clamp(mean, p.lower.value_or(mean), p.upper.value_or(mean));
    moves = true;
  }
  if (!moves) return;
  const double cost = misfit.search_cost(solution.active, {});
  const ParameterSet at_means(target, options);
  misfit.set_parameters(at_means);
  misfit.set_priors(priors);
  Solution other = descend_misfit(misfit, at_means, options);
  if (other.usable && misfit.search_cost(other.active, {}) < (1.0 - kLess) * cost) {
    solution.active = other.active;
  }
  append(other, solution);
  misfit.set_parameters(set);
  misfit.set_priors(priors);
}

/// Explains the fit whose values the options start with; its search began where it did.
void explain_from(const Target& target, const FitOptions& options, Misfit& misfit,
                  FitResult& result) {
  const ParameterSet set(target, options);
  misfit.set_parameters(set);
  misfit.end_search();
  std::vector<double> active;
  for (const std::size_t i : set.active()) active.push_back(set.all()[i].start);
  const std::vector<FittedParameter> searched = result.parameters;
  explain_fit(target, options, set, misfit, active, result);
  for (std::size_t i = 0; i < searched.size(); ++i) result.parameters[i].start = searched[i].start;
}

/// How far the solution is from the priors that parameters state.
void add_stated_priors(const FitOptions& options, double variance, FitResult& result) {
  for (std::size_t i = 0; i < options.parameters.size(); ++i) {
    const Parameter& p = options.parameters[i];
    if (p.role != ParameterRole::Free || !p.prior) continue;
    if (!result.stated_priors) result.stated_priors = StatedPriors{variance, 0.0};
    const FittedParameter& fitted = result.parameters[i];
    result.stated_priors->squared +=
        std::pow((fitted.value - p.prior->mean) / p.prior->standard_deviation, 2);
  }
}

}  // namespace

FitResult search_target(const Target& target, const FitOptions& options, Told told,
                        std::span<const StartPoint> further, std::optional<Misfit>* searched) {
  FitResult result;
  result.seed = seed_of(target.name, options.seed);
  result.law = law_of(options.setup.scene.material.hardening, options.parameters);
  if (target.status != TargetStatus::Ready) {
    result.reason = target.reason;
    return result;
  }
  result.reason = defect_of(target.corrected);
  if (result.reason.empty() && !any_weight(options.weights, target.corrected)) {
    result.reason = "the given weight is 0 at every sample";
  }
  if (!result.reason.empty()) return result;
  const FitOptions bare = without_priors(options);
  const ParameterSet set(target, bare);
  std::optional<Misfit> own;
  Misfit& misfit = (searched != nullptr ? *searched : own).emplace(target, bare, set);
  result.samples = misfit.samples();
  if (set.active().empty()) {
    result.reason = "the curve determines none of the free parameters";
    return result;
  }
  Solution solution = minimize_misfit(misfit, set, bare, result.seed, further);
  result.stages = std::move(solution.stages);
  result.trace = std::move(solution.trace);
  if (!solution.usable) {
    result.status = FitStatus::Failed;
    result.reason = solution.reason;
    return result;
  }
  if (told == Told::All) {
    explain_fit(target, bare, set, misfit, solution.active, result);
  } else {
    describe_fit(target, set, misfit, solution.active, result);
  }
  return result;
}

FitPriors::FitPriors(const Target& target, const FitOptions& options) {
  if (target.status != TargetStatus::Ready || !defect_of(target.corrected).empty()) return;
  slope = modulus_prior(target, options);
  all = priors_of(options, slope);
}

void weigh_priors(const Target& target, const FitOptions& options, const FitPriors& found,
                  Misfit& misfit, FitResult& result) {
  constexpr int kRepetitions = 8;
  constexpr double kSettled = 1e-3;
  if (result.status != FitStatus::Fitted) return;
  std::optional<ModulusPrior> slope = found.slope;
  WeighedPriors priors = found.all;
  if (priors.all.empty()) return;
  const double worth =
      std::max(1.0, samples_worth(result.effective_samples, result.autocorrelation));
  const bool is_stated = options.objective == Objective::LeastSquares && options.noise;
  double least = is_stated ? *options.noise * *options.noise : 0.0;
  // A curve without any noise has this much: it must not leave what it cannot tell to no one.
  constexpr double kExact = 1e-6;
  const auto states = [](const WeighedPriors::One& one) { return one.stated; };
  if (std::ranges::any_of(priors.all, states)) {
    least = std::max(least, std::pow(kExact * largest_magnitude(target.corrected.stress), 2));
  }
  double squares = result.misfit_rms * result.misfit_rms;
  FitOptions from = from_values_of(result, options);
  for (int i = 0; i < kRepetitions; ++i) {
    const double before = priors.variance;
    // What a prior pulls the fit away by is no doubt of a noise that is stated.
    if (i == 0 || !is_stated) priors.variance = std::max(squares, least) / worth;
    if (std::abs(priors.variance - before) <= kSettled * before) {
      priors.variance = before;  // what the last search had
      break;
    }
    const ParameterSet set(target, from);
    misfit.set_parameters(set);
    misfit.set_priors(priors);
    Solution solution = descend_misfit(misfit, set, from);
    if (solution.usable) look_at_prior_means(target, from, priors, misfit, set, solution);
    if (!solution.usable) {
      misfit.set_priors({});
      explain_from(target, from_values_of(result, without_priors(options)), misfit, result);
      result.warnings.emplace_back(
          "the fit is not weighed with its priors (a stated one, or the elastic slope): no search "
          "with them has ended");
      return;
    }
    squares = misfit.stress_cost(solution.active);
    take_values(set, solution.active, from);
    append(solution, result);
  }
  if (slope) slope->variance = priors.variance;
  result.modulus_prior = slope;
  misfit.set_priors(priors);
  explain_from(target, from, misfit, result);
  add_stated_priors(options, priors.variance, result);
  constexpr double kHardlyKnown = 0.04;
  if (slope && slope->standard_deviation > kHardlyKnown * slope->mean) {
    result.warnings.push_back(fmt::format(
        "youngs_modulus leans on an elastic slope that is known to {:.2g} % only: its quarters "
        "differ (a slip, or yielding), or the part is short or noisy",
        100.0 * slope->standard_deviation / slope->mean));
  }
}

}  // namespace plastica::calibrate
