#include "calibrate/fit/explain_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "calibrate/fit/fitted_curve.hpp"
#include "calibrate/inference/identifiable_yield.hpp"
#include "calibrate/inference/lack_of_fit.hpp"
#include "calibrate/inference/material_interval.hpp"
#include "calibrate/inference/modulus_warning.hpp"
#include "calibrate/inference/strain_errors.hpp"
#include "calibrate/inference/uncertainty.hpp"

namespace plastica::calibrate {
namespace {

double largest_stress(const Curve& curve) { return largest_magnitude(curve.stress); }

/// @return the residuals that enter [Pa]
std::vector<double> describe_misfit(const Misfit::Parts& parts, const Target& target,
                                    FitResult& result) {
  const double stress = largest_stress(target.corrected);
  result.misfit_rms = std::sqrt(std::max(0.0, parts.stress_cost));
  result.misfit_fraction = stress > 0.0 ? result.misfit_rms / stress : 0.0;
  std::vector<double> residual;
  residual.reserve(parts.residual.size());
  for (std::size_t i = 0; i < parts.residual.size(); ++i) {
    if (parts.weight[i] > 0.0) residual.push_back(parts.residual[i]);
  }
  result.autocorrelation = autocorrelation(residual);
  result.effective_samples = effective_samples(parts.weight);
  return residual;
}

void judge_misfit(const std::vector<double>& residual, const Target& target,
                  const FitOptions& options, FitResult& result) {
  result.noise = options.noise;
  result.runs_test_p = runs_test_p(residual);
  result.misfit_word =
      misfit_word(result.misfit_fraction, result.runs_test_p, result.autocorrelation);
  std::string lack = lack_of_fit(phrase_of(result.law), result.misfit_fraction, result.runs_test_p,
                                 laws_to_try(result.law, target.loading, options.laws));
  if (!lack.empty()) result.warnings.push_back(std::move(lack));
}

/// The residuals' own noise: their root mean square by their degrees of freedom [Pa].
struct OwnNoise {
  double deviation = 0.0;
  double degrees = 0.0;  ///< of freedom, at least 1

  explicit OwnNoise(const FitResult& result)
      : degrees(
            std::max(1.0, result.effective_samples - static_cast<double>(result.free_count()))) {
    deviation = result.misfit_rms * std::sqrt(result.effective_samples / degrees);
  }
  StatedNoise judge(double stated) const { return judge_stated_noise(deviation / stated, degrees); }
};

/// Errors and interval of a parameter that the curve determines.
void set_errors(const Uncertainty& u, std::size_t k, double confidence, const FitResult& result,
                FittedParameter& p) {
  const double half = std::abs(u.sampling[k]);
  p.noise_error = u.noise_error[k];
  p.sampling_error = half / std::sqrt(3.0);
  p.misfit_error = 0.0;
  p.degrees_of_freedom = u.degrees_of_freedom[k];
  // Of noise as large as the residuals: a stated one may be smaller, or larger.
  const bool is_stated = std::isinf(u.degrees_of_freedom[k]);
  const OwnNoise own(result);
  const double over = is_stated ? own.deviation / u.noise : 1.0;
  const bool is_larger = is_stated && own.judge(u.noise) == StatedNoise::TooSmall;
  const bool in_runs =
      are_in_runs(result.runs_test_p, result.autocorrelation, result.effective_samples);
  if (in_runs || is_larger) {
    const auto parameters = static_cast<int>(u.identified.size());
    const double times =
        in_runs ? variance_inflation(result.autocorrelation, result.effective_samples, parameters)
                : 1.0;
    // A prior's part does not grow with the residuals.
    p.misfit_error = u.residual_error[k] * std::sqrt(std::max(0.0, over * over * times - 1.0));
  }
  set_material_interval(confidence, {&half, 1}, {}, p);
}

void warn_of_prior(const Prior& prior, const Uncertainty& u, std::size_t k,
                   const FittedParameter& p, FitResult& result) {
  const double fraction = u.prior_fraction[k];
  std::string warning = contradicts_prior({.name = p.name(),
                                           .value = p.value,
                                           .mean = prior.mean,
                                           .standard_deviation = prior.standard_deviation,
                                           .fraction = fraction,
                                           .error_alone = u.residual_error[k] / (1.0 - fraction)});
  if (!warning.empty()) result.warnings.push_back(std::move(warning));
}

/// A parameter without error and verdict.
FittedParameter parameter_of(const ResolvedParameter& r, double value) {
  FittedParameter p;
  p.path = r.field->path;
  p.dimension = r.field->dimension;
  p.role = r.role;
  p.value = value;
  p.start = r.start;
  p.lower = r.role == ParameterRole::Free ? r.lower : p.value;
  p.upper = r.role == ParameterRole::Free ? r.upper : p.value;
  p.logarithmic = r.logarithmic;
  return p;
}

void add_parameters(const ParameterSet& set, std::span<const double> active, const Uncertainty& u,
                    const FitOptions& options, FitResult& result) {
  std::vector<double> values(set.size());
  set.expand(active, values);
  std::size_t next = 0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const ResolvedParameter& r = set.all()[i];
    FittedParameter p = parameter_of(r, values[i]);
    if (r.idle) {
      p.identified = false;
      p.judgement = {Verdict::NotIdentified, std::numeric_limits<double>::infinity()};
    } else if (r.role == ParameterRole::Free) {
      const std::size_t k = next++;
      const double bottom = set.coordinate(k, r.lower);
      const double top = set.coordinate(k, r.upper);
      const double span = top - bottom;
      const double at = set.coordinate(k, p.value);
      p.at_lower = at - bottom < 1e-9 * span;
      p.at_upper = top - at < 1e-9 * span;
      p.identified = u.identified[k];
      // What is held by a bound has no scatter about it.
      if (p.identified && !p.at_bound()) {
        set_errors(u, k, options.confidence, result, p);
      }
      const std::optional<Prior>& prior = options.parameters[i].prior;
      if (prior && p.has_error()) warn_of_prior(*prior, u, k, p, result);
      p.judgement = judge({.value = p.value,
                           .lower = p.lower,
                           .upper = p.upper,
                           .at_bound = p.identified && p.at_bound(),
                           .noise_error = p.has_error() ? p.model_error() : u.noise_error[k],
                           .half = u.sampling[k],
                           .standard_error = p.has_error() ? p.standard_error : u.standard_error[k],
                           .prior = u.prior_fraction[k]});
    }
    result.parameters.push_back(std::move(p));
  }
}

void add_tied_errors(const ParameterSet& set, FitResult& result) {
  for (std::size_t i = 0; i < set.size(); ++i) {
    const ResolvedParameter& r = set.all()[i];
    if (r.role != ParameterRole::Tied) continue;
    result.parameters[i].follow(result.parameters[r.base], r.factor);
  }
}

/// The sampling of most curves leaves a break uncertain; up to this fraction there is no warning.
constexpr double kMinor = 0.01;

/// A record that ends near its largest load may have ended with the break, or before it.
std::string why_no_break(const Target& target) {
  const Curve& curve = target.corrected;
  const std::string where = fmt::format("at {:.3g} % strain", 100.0 * curve.strain.back());
  if (target.ends_at_neck) return "true strain is known no further than Rm, " + where;
  const auto is_removal = [](const Repair& one) { return one.kind == "extensometer-removed"; };
  if (std::ranges::any_of(target.repairs, is_removal)) {
    return "the load goes on where the strain ends, " + where;
  }
  if (target.ran_back) return "the strain ran back before, beyond " + where.substr(3);
  const double rm = *std::ranges::max_element(curve.stress);
  const double end = curve.stress.back() / rm;
  if (end < 0.5) return "the specimen did not break; the record ends " + where;
  return fmt::format(
      "the record ends under load {}, at {:.0f} % of the largest stress; if the specimen broke "
      "there, say so by corrections.end_fraction = \"{:.0f} %\"",
      where, 100.0 * end, std::ceil(100.0 * end));
}

/// Where noise is not alike along the curve; which errors it makes stands in uncertainty.hpp.
std::string unequal_noise(const Uncertainty& u) {
  if (u.own_variance.empty()) return {};
  return "the residuals scatter more on some parts of the curve than on others, as by noise of the "
         "strain: errors and intervals are those of unequal noise";
}

void warn_of_noise(double stated, FitResult& result) {
  const OwnNoise own(result);
  const StatedNoise is = own.judge(stated);
  if (is == StatedNoise::Fits) return;
  result.warnings.push_back(
      fmt::format("a noise of {:.3g} MPa is stated, but the residuals are of {:.3g} MPa: {}",
                  stated / 1e6, own.deviation / 1e6,
                  is == StatedNoise::TooSmall
                      ? "the errors count these; profiles and the choice of a law do not"
                      : "the errors are those of the stated noise, too large by as much"));
}

void add_warnings(const Target& target, FitResult& result) {
  for (const FittedParameter& p : result.parameters) {
    const bool no_break =
        p.role == ParameterRole::Free && !target.characteristics.observed_break && p.is_break();
    if (no_break) {
      result.warnings.push_back(p.name() + " is not identified: " + why_no_break(target));
    } else if (p.judgement) {
      const Judgement& judgement = *p.judgement;
      const bool minor =
          judgement.verdict == Verdict::LimitedBySampling && judgement.number < kMinor;
      std::string warning = minor ? std::string() : warning_of(p.name(), judgement, p.lower);
      if (!warning.empty()) result.warnings.push_back(std::move(warning));
    }
  }
  if (result.noise) warn_of_noise(*result.noise, result);
  std::string warning = modulus_warning(target, result.parameters);
  if (!warning.empty()) result.warnings.push_back(std::move(warning));
}

/// Says so where a break limit that is fixed, tied or at a bound is not the specimen's.
void warn_of_held_break(const Target& target, const ParameterSet& set, double factor,
                        double permanent, FitResult& result) {
  const auto& observed = target.characteristics.observed_break;
  const auto& decides = set.break_parameter();
  if (!observed || !decides) return;
  const FittedParameter& p = result.parameters[decides->index];
  if (p.role == ParameterRole::Free && !p.at_lower && !p.at_upper) return;
  const double own = permanent / factor;
  if (std::fabs(p.value - own) <= observed->half_interval() / factor) return;
  result.warnings.push_back(
      fmt::format("{} is held at {:.4g} %, but the specimen broke at {:.4g} % permanent strain",
                  p.name(), 100.0 * p.value, 100.0 * own));
}

/// The limit of one reversal may have been survived in one before; a limit that is held may be
/// below what an intact specimen bore.
void warn_of_early_break(const Target& target, const BreakEvent& event, FitResult& result) {
  const Curve& curve = target.corrected;
  if (event.sample >= curve.size()) return;
  const bool broke = target.characteristics.observed_break.has_value();
  result.warnings.push_back(fmt::format(
      "with this break limit the model breaks at {:.4g} % strain, at sample {} of {}, and the "
      "specimen {}: it bore more than the limit",
      100.0 * event.strain, event.sample + 1, curve.size(),
      broke ? "went on" : "did not break at all"));
}

/// A yield stress above what the specimen bore is reached after its break.
void warn_of_late_break(const Target& target, const BreakEvent& event, FitResult& result) {
  constexpr double kLate = 0.01;  // of the strain at break
  const auto& observed = target.characteristics.observed_break;
  if (!observed || event.sample < target.corrected.size()) return;
  const double late = std::fabs(event.strain) - std::fabs(observed->strain());
  if (late <= observed->half_interval() + kLate * std::fabs(observed->strain())) return;
  result.warnings.push_back(
      fmt::format("the fitted model breaks at {:.4g} % strain in total, and the specimen broke at "
                  "{:.4g} %",
                  100.0 * event.strain, 100.0 * observed->strain()));
}

/// The fitted curve, and the strain where the model breaks.
void add_fitted_curve(const Target& target, const FitOptions& options, FitResult& result) {
  FittedCurve fitted = fitted_curve(target, options, result);
  result.fitted = std::move(fitted.curve);
  if (!fitted.event) return;
  result.break_strain_total = fitted.event->strain;
  warn_of_early_break(target, *fitted.event, result);
  warn_of_late_break(target, *fitted.event, result);
}

/// A result that says nothing of any other solution.
void begin_result(const Misfit::Parts& parts, FitResult& result) {
  result.status = FitStatus::Fitted;
  result.parameters.clear();
  result.warnings.clear();
  result.break_strain_total.reset();
  result.cost = parts.stress_cost + parts.break_cost;
}

}  // namespace

void describe_fit(const Target& target, const ParameterSet& set, Misfit& misfit,
                  std::span<const double> active, FitResult& result) {
  const Misfit::Parts parts = misfit.parts(active);
  begin_result(parts, result);
  describe_misfit(parts, target, result);
  std::vector<double> values(set.size());
  set.expand(active, values);
  for (std::size_t i = 0; i < set.size(); ++i) {
    result.parameters.push_back(parameter_of(set.all()[i], values[i]));
  }
}

void explain_fit(const Target& target, const FitOptions& options, const ParameterSet& set,
                 Misfit& misfit, std::span<const double> active, FitResult& result) {
  Misfit::Details details = misfit.details(active);
  begin_result(details, result);
  drop_unidentifiable_yield(misfit, set, target.corrected, active, options, details);
  add_strain_errors(target, options, set, active, details);
  const Uncertainty u = uncertainty(details, active, set, target, options, misfit.break_factor());
  judge_misfit(describe_misfit(details, target, result), target, options, result);
  add_parameters(set, active, u, options, result);
  add_tied_errors(set, result);
  result.correlation = u.correlation;
  std::string unequal = unequal_noise(u);
  if (!unequal.empty()) result.warnings.push_back(std::move(unequal));
  add_warnings(target, result);
  warn_of_held_break(target, set, misfit.break_factor(), details.permanent, result);
  add_fitted_curve(target, options, result);
}

}  // namespace plastica::calibrate
