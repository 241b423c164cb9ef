#include "calibrate/problem/misfit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "calibrate/problem/given_weights.hpp"
#include "calibrate/problem/weighted_squares.hpp"
#include "plastica/model/hardening_kind.hpp"

namespace plastica::calibrate {
namespace {

/// How far a break limit may be from the measured permanent strain at no cost, as a factor.
constexpr double kLikelyReach = 30.0;
/// A permanent strain at break of less than this fraction of the total one may be none: it is what
/// the modulus leaves of that, whose errors are of this size.
constexpr double kPlainlyPermanent = 0.1;

std::vector<double> sample_weights(const std::vector<double>& strain, const FitOptions& options) {
  if (options.objective == Objective::Path) return path_weights(strain);
  const double unit = options.noise ? 1.0 / (*options.noise * *options.noise) : 1.0;
  std::vector<double> weight;
  weight.reserve(strain.size());
  for (const double e : strain) weight.push_back(unit * given_weight(options.weights, e));
  return weight;
}

/// The test as a scene: fixed parameters set, one stress probe, and no limit, since the cost
/// compares breaks itself.
Scene unbroken_scene(const Target& target, const FitOptions& options) {
  Setup setup = options.setup;
  for (const Parameter& p : options.parameters) {
    if (p.role == ParameterRole::Fixed) set_field(setup, *p.field, *p.value, p.where);
  }
  Scene scene = std::move(setup.scene);
  scene.material.break_strain.reset();
  scene.material.break_shear_strain.reset();
  take_test(target, scene);
  if (target.characteristics.observed_break) {
    scene.drive.strain.push_back(target.characteristics.observed_break->strain());
  }
  scene.probes = {{"stress", ProbeQuantity::Stress}};
  return scene;
}

}  // namespace

void take_test(const Target& target, Scene& scene) {
  scene.drive.deformation = target.test;
  scene.drive.strain = target.corrected.strain;
  const auto rate = target.property("strain_rate");
  if (!rate) return;
  if (scene.material.rate.law == RateLaw::None) {
    throw InputError({}, "target.strain_rate", "",
                     "is of no use without a law, material.rate.law: it would move nothing");
  }
  scene.material.rate.strain_rate = rate;
}

Misfit::Misfit(const Target& target, const FitOptions& options, const ParameterSet& parameters)
    : target_(target),
      parameters_(parameters),
      stop_(options.stop),
      samples_(target.corrected.size()) {
  raw_weight_ = sample_weights(target.corrected.strain, options);
  const double sum = std::accumulate(raw_weight_.begin(), raw_weight_.end(), 0.0);
  weight_ = raw_weight_;
  for (double& w : weight_) w /= sum;

  const double stress = largest_magnitude(target.corrected.stress);
  if (stress > 0.0) cost_unit_ = stress * stress;

  std::vector<std::string> paths;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const ResolvedParameter& p = parameters.all()[i];
    if (p.is_break || p.role == ParameterRole::Fixed) continue;
    paths.emplace_back(p.field->path);
    model_index_.push_back(i);
  }
  const auto& observed = target.characteristics.observed_break;
  const auto& decides = parameters.break_parameter();
  const bool free = decides && parameters.all()[decides->index].is_break &&
                    parameters.all()[decides->index].role == ParameterRole::Free;
  if (free && observed && options.break_weight > 0.0) {
    const double permanent = target.characteristics.break_strain_plastic.value_or(0.0);
    const double total = std::fabs(observed->strain());
    const double scale = permanent > 0.0 ? permanent : total;
    break_scale_ = options.break_weight * cost_unit_ / (scale * scale);
    if (permanent > kPlainlyPermanent * total) likely_least_ = permanent / kLikelyReach;
    likely_most_ = kLikelyReach * std::max(permanent, total);
    break_index_ = decides->index;
  }
  if (decides) break_factor_ = decides->factor;

  model_ = prepare(unbroken_scene(target, options), options.setup.solver, paths);
  workspace_ = make_workspace(model_);
  response_ = make_response(model_);
  sensitivity_ = make_sensitivity(model_);
  all_values_.resize(parameters.size());
  by_all_.resize(parameters.size());
  model_values_.resize(paths.size());
  stress_slope_.resize(paths.size());
  closed_normal_.resize(paths.size());
}

void Misfit::set_parameters(const ParameterSet& parameters) {
  parameters_ = parameters;
  run_values_.reset();
}

void Misfit::set_priors(const WeighedPriors& priors) {
  priors_.clear();
  run_values_.reset();
  prior_variance_ = priors.variance;
  for (const std::size_t i : parameters_.active()) {
    for (const WeighedPriors::One& one : priors.all) {
      if (one.field == parameters_.all()[i].field) priors_.push_back({i, one.prior, one.stated});
    }
  }
}

double Misfit::prior_residual(const SetPrior& one) const {
  return prior_size() * (all_values_[one.index] - one.prior.mean) / one.prior.standard_deviation;
}

std::vector<double> Misfit::prior_residuals() const {
  std::vector<double> residuals;
  residuals.reserve(priors_.size());
  for (const SetPrior& one : priors_) residuals.push_back(prior_residual(one));
  return residuals;
}

double Misfit::prior_cost() const {
  double sum = 0.0;
  for (const SetPrior& one : priors_) sum += prior_residual(one) * prior_residual(one);
  return sum;
}

std::size_t Misfit::samples() const {
  const auto counts = [](double weight) { return weight > 0.0; };
  return static_cast<std::size_t>(std::count_if(weight_.begin(), weight_.end(), counts));
}

bool Misfit::set_values(std::span<const double> active) {
  parameters_.expand(active, all_values_);
  MaterialValues<double> material = model_.material;
  for (std::size_t i = 0; i < model_index_.size(); ++i) {
    model_values_[i] = all_values_[model_index_[i]];
    material[static_cast<std::size_t>(*model_.parameters[i]->material)] = model_values_[i];
  }
  // A box cannot say E_t < E.
  return !hardening_kind(model_.coupon.hardening).broken_rule(material);
}

double Misfit::limit() const { return break_factor_ * all_values_[break_index_]; }

double Misfit::likely_limit() const {
  return std::clamp(response_.permanent_strain, likely_least_, likely_most_);
}

double Misfit::break_cost(double limit, std::span<double> by_all, bool limit_moves) const {
  if (break_scale_ == 0.0) return 0.0;
  const double gap = response_.permanent_strain - limit;
  if (!by_all.empty()) {
    const double slope = 2.0 * break_scale_ * gap;
    for (std::size_t i = 0; i < model_index_.size(); ++i) {
      by_all[model_index_[i]] += slope * sensitivity_.permanent_strain[i];
    }
    if (limit_moves) by_all[break_index_] -= slope * break_factor_;
  }
  return break_scale_ * gap * gap;
}

double Misfit::cost(std::span<const double> active, std::span<double> gradient) {
  const double stress = evaluate(active, gradient, true);
  return std::isfinite(stress) ? stress + break_cost(limit(), {}, true) : stress;
}

double Misfit::search_cost(std::span<const double> active, std::span<double> gradient) {
  begin_search();
  const double stress = evaluate(active, gradient, false);
  return std::isfinite(stress) ? stress + break_cost(likely_limit(), {}, false) + prior_cost()
                               : stress;
}

double Misfit::search_squares(std::span<const double> active, std::span<double> gradient,
                              std::span<double> normal) {
  const double cost = search_cost(active, gradient);
  if (!std::isfinite(cost)) return cost;
  for (double& g : gradient) g *= 0.5;
  const std::size_t width = model_index_.size();
  const std::size_t n = active.size();
  model_normal_.resize(width * width);
  if (is_closed_) {
    std::ranges::fill(model_normal_, 0.0);
    for (std::size_t i = 0; i < width; ++i) model_normal_[i * width + i] = closed_normal_[i];
  } else {
    weighted_normal(weight_, sensitivity_.stress, width, model_normal_);
  }
  if (break_scale_ > 0.0 && break_residual() != 0.0) {
    for (std::size_t i = 0; i < width; ++i) {
      for (std::size_t j = 0; j < width; ++j) {
        model_normal_[i * width + j] +=
            break_scale_ * sensitivity_.permanent_strain[i] * sensitivity_.permanent_strain[j];
      }
    }
  }
  for (const SetPrior& one : priors_) {
    const double slope = prior_size() / one.prior.standard_deviation;
    for (std::size_t i = 0; i < width; ++i) {
      if (model_index_[i] == one.index) model_normal_[i * width + i] += slope * slope;
    }
  }
  // J by the active parameters is J by the model's times the map of ties.
  const std::vector<double> map = model_by_active(n);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      double sum = 0.0;
      for (std::size_t i = 0; i < width; ++i) {
        if (map[i * n + a] == 0.0) continue;
        for (std::size_t j = 0; j < width; ++j) {
          sum += map[i * n + a] * model_normal_[i * width + j] * map[j * n + b];
        }
      }
      normal[a * n + b] = sum;
    }
  }
  return cost;
}

bool Misfit::residuals(std::span<const double> active, std::span<double> residual) {
  if (!set_values(active) || !run_model(false)) return false;
  need_samples(false);
  const double* stress = response_.probes[0].data();
  for (std::size_t s = 0; s < samples_; ++s) {
    residual[s] = stress[s] - target_.corrected.stress[s];
  }
  return true;
}

double Misfit::break_residual() const {
  return std::sqrt(break_scale_) * (response_.permanent_strain - likely_limit());
}

double Misfit::evaluate(std::span<const double> active, std::span<double> gradient,
                        bool with_break) {
  const double infinite = std::numeric_limits<double>::infinity();
  was_run_ = true;
  if (!set_values(active) || !run_model(!gradient.empty())) return infinite;
  if (gradient.empty()) return stress_cost_;
  std::fill(by_all_.begin(), by_all_.end(), 0.0);
  for (std::size_t i = 0; i < model_index_.size(); ++i) {
    by_all_[model_index_[i]] += stress_slope_[i];
  }
  break_cost(with_break ? limit() : likely_limit(), by_all_, with_break);
  if (!with_break) {  // the cost itself is without priors
    for (const SetPrior& one : priors_) {
      by_all_[one.index] += 2.0 * prior_residual(one) * prior_size() / one.prior.standard_deviation;
    }
  }
  parameters_.contract(by_all_, gradient);
  return stress_cost_;
}

std::vector<double> Misfit::model_by_active(std::size_t active) {
  const std::size_t width = model_index_.size();
  std::vector<double> map(width * active);
  for (std::size_t i = 0; i < width; ++i) {
    std::fill(by_all_.begin(), by_all_.end(), 0.0);
    by_all_[model_index_[i]] = 1.0;
    parameters_.contract(by_all_, std::span(map).subspan(i * active, active));
  }
  return map;
}

void Misfit::stress_slopes(std::span<const double> map, std::size_t parameter,
                           std::span<double> slopes) const {
  const std::size_t width = model_index_.size();
  const std::size_t n = parameters_.active().size();
  bool first = true;
  for (std::size_t i = 0; i < width; ++i) {
    const double factor = map[i * n + parameter];
    if (factor == 0.0) continue;
    const double* slope = sensitivity_.stress.data() + i;
    if (first) {
      for (std::size_t s = 0; s < slopes.size(); ++s) slopes[s] = factor * slope[s * width];
    } else {
      for (std::size_t s = 0; s < slopes.size(); ++s) slopes[s] += factor * slope[s * width];
    }
    first = false;
  }
  if (first) std::fill(slopes.begin(), slopes.end(), 0.0);
}

}  // namespace plastica::calibrate
