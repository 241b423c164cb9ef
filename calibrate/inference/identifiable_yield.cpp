#include "calibrate/inference/identifiable_yield.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "calibrate/search/least_squares.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {
namespace {

bool is_elastic(const ResolvedParameter& p) {
  return p.field->material == MaterialField::YoungsModulus ||
         p.field->material == MaterialField::ShearModulus ||
         p.field->material == MaterialField::PoissonRatio;
}

bool is_yield(const ResolvedParameter& p) {
  return p.field->material == MaterialField::YieldStress ||
         p.field->material == MaterialField::ShearYieldStress;
}

/// The least squares of the search with one parameter at its upper bound.
class WithoutYield {
 public:
  WithoutYield(Misfit& misfit, const ParameterSet& parameters, std::span<const double> active,
               std::size_t held)
      : misfit_(misfit), parameters_(parameters), active_(active.begin(), active.end()) {
    for (std::size_t i = 0; i < active.size(); ++i) {
      const ResolvedParameter& p = parameters.all()[parameters.active()[i]];
      if (i == held) active_[i] = p.upper;
      if (i == held || p.is_break) continue;
      searched_.push_back(i);
      problem_.lower.push_back(parameters.lower(i));
      problem_.upper.push_back(parameters.upper(i));
      problem_.start.push_back(std::clamp(parameters.coordinate(i, active[i]),
                                          problem_.lower.back(), problem_.upper.back()));
    }
    problem_.residuals = misfit.weights().size() + 1 + misfit.priors();
    problem_.evaluate = one_by_one([this](std::span<const double> x, std::span<double> residual) {
      return residuals(x, residual);
    });
  }

  /// [Pa^2]; infinite where the model cannot be run.
  double min_cost() const {
    LeastSquaresOptions how;
    how.cost_tolerance = 1e-8;
    const LeastSquares found = minimize_squares(problem_, how);
    const bool none = found.outcome == LeastSquaresOutcome::NoStart;
    return none ? std::numeric_limits<double>::infinity() : found.cost;
  }

 private:
  bool residuals(std::span<const double> x, std::span<double> residual) {
    for (std::size_t i = 0; i < searched_.size(); ++i) {
      active_[searched_[i]] = parameters_.value(searched_[i], x[i]);
    }
    const std::span<const double> weights = misfit_.weights();
    if (!misfit_.residuals(active_, residual.first(weights.size()))) return false;
    for (std::size_t s = 0; s < weights.size(); ++s) residual[s] *= std::sqrt(weights[s]);
    residual[weights.size()] = misfit_.break_residual();
    std::ranges::copy(misfit_.prior_residuals(),
                      residual.begin() + static_cast<std::ptrdiff_t>(weights.size()) + 1);
    return true;
  }

  Misfit& misfit_;
  const ParameterSet& parameters_;
  std::vector<double> active_;         ///< SI (n_active)
  std::vector<std::size_t> searched_;  ///< active index of each coordinate
  LeastSquaresProblem problem_;
};

/// What a curve tells of its noise, for sums of weighted squares.
struct NoiseOfCost {
  double variance = 0.0;         ///< of the stress [Pa^2]
  double degrees = 1.0;          ///< of freedom
  double squared_weights = 0.0;  ///< sum w^2 over the samples that count
  double samples = 0.0;          ///< that count

  NoiseOfCost(const Misfit::Details& details, std::span<const double> weights,
              std::size_t parameters, const FitOptions& options) {
    double squares = 0.0;
    for (std::size_t s = 0; s < weights.size(); ++s) {
      if (!(weights[s] > 0.0)) continue;
      squares += details.residual[s] * details.residual[s];
      squared_weights += weights[s] * weights[s];
      samples += 1.0;
    }
    degrees = std::max(1.0, samples - static_cast<double>(parameters));
    variance = squares / degrees;
    if (options.objective == Objective::LeastSquares && options.noise) {
      variance = *options.noise * *options.noise;
      degrees = std::numeric_limits<double>::infinity();
    }
  }

  /// What a cost must rise by where so many parameters are taken out that say something. The search
  /// chose where the curve leaves its elastic line, so the risk is shared, as by Bonferroni,
  /// between the places that differ: taken as log2(samples), each half as near to the end as the
  /// one before. It leaves 1 of 40 elastic curves of 100 and 1000 samples with a yield stress.
  double rise(double confidence, int parameters) const {
    const double risk = (1.0 - confidence) / std::max(1.0, std::log2(samples));
    const double t = theory::student_t_quantile(1.0 - 0.5 * risk, degrees);
    const double more = theory::chi_squared_quantile(1.0 - risk, parameters) /
                        theory::chi_squared_quantile(1.0 - risk, 1.0);
    return t * t * more * variance * squared_weights;
  }
};

/// The model where it hardly yields.
struct ElasticModel {
  bool is_one = false;  ///< but for some samples at its end: no bound makes it yield
  /// A bound below what the stress costs [Pa^2]: that is linear in a modulus.
  double least_cost = 0.0;

  ElasticModel(Misfit& misfit, const Curve& curve, std::span<const double> active) {
    const std::span<const double> weights = misfit.weights();
    std::vector<double> residual(weights.size());
    if (!misfit.residuals(active, residual)) return;
    double xx = 0.0, xy = 0.0, yy = 0.0, most = 0.0;
    double slope = 0.0;
    std::vector<double> model(weights.size());
    for (std::size_t s = 0; s < weights.size(); ++s) {
      const double measured = curve.stress[s];
      model[s] = measured + residual[s];
      xx += weights[s] * model[s] * model[s];
      xy += weights[s] * model[s] * measured;
      yy += weights[s] * measured * measured;
      most = std::max(most, std::fabs(model[s]));
      if (curve.strain[s] != 0.0) slope = std::max(slope, model[s] / curve.strain[s]);
    }
    constexpr double kFewest = 3.0, kSome = 0.05, kStraight = 1e-6;
    double yield = 0.0;
    for (std::size_t s = 0; s < model.size(); ++s) {
      yield += std::fabs(slope * curve.strain[s] - model[s]) > kStraight * most ? 1.0 : 0.0;
    }
    is_one = yield <= std::max(kFewest, kSome * static_cast<double>(model.size()));
    least_cost = xx > 0.0 ? std::max(0.0, yy - xy * xy / xx) : 0.0;
  }
};

}  // namespace

void drop_unidentifiable_yield(Misfit& misfit, const ParameterSet& parameters, const Curve& curve,
                               std::span<const double> active, const FitOptions& options,
                               Misfit::Details& details) {
  // No elastic line comes near a curve that is followed closely, half of it as permanent strain.
  constexpr double kPlain = 0.5, kClose = 0.1;
  const bool is_close = details.stress_cost < kClose * kClose * misfit.cost_unit();
  if (is_close && std::fabs(details.permanent) > kPlain * largest_magnitude(curve.strain)) return;
  const std::size_t samples = details.residual.size();
  const std::span<const double> weights = misfit.weights();
  const auto of = [&](std::size_t k) -> const ResolvedParameter& {
    return parameters.all()[parameters.active()[k]];
  };
  const auto slopes_of = [&](std::size_t k) {
    return std::span(details.jacobian).subspan(k * samples, samples);
  };
  const auto is_seen = [&](std::size_t k) {
    const std::span<const double> slopes = slopes_of(k);
    for (std::size_t s = 0; s < samples; ++s) {
      if (slopes[s] != 0.0 && weights[s] > 0.0) return true;
    }
    return false;
  };
  std::vector<std::size_t> plastic;
  for (std::size_t k = 0; k < active.size(); ++k) {
    if (!of(k).is_break && !is_elastic(of(k)) && is_seen(k)) plastic.push_back(k);
  }
  const auto yield = std::ranges::find_if(plastic, [&](std::size_t k) { return is_yield(of(k)); });
  if (yield == plastic.end()) return;
  const NoiseOfCost noise(details, weights, active.size(), options);
  const double best = misfit.search_cost(active, {});
  const double enough = best + noise.rise(options.confidence, static_cast<int>(plastic.size()));
  // Mostly it is plain, and no search is needed.
  std::vector<double> elastic(active.begin(), active.end());
  elastic[*yield] = of(*yield).upper;
  const ElasticModel without(misfit, curve, elastic);
  if (!without.is_one || without.least_cost >= enough) return;
  if (WithoutYield(misfit, parameters, active, *yield).min_cost() >= enough) return;
  for (const std::size_t k : plastic) std::ranges::fill(slopes_of(k), 0.0);
}

}  // namespace plastica::calibrate
