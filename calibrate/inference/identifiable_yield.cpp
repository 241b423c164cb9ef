#include "calibrate/inference/identifiable_yield.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "calibrate/search/least_squares.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {
namespace {

constexpr int kFewSamples = 3;

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

}  // namespace

void drop_unidentifiable_yield(Misfit& misfit, const ParameterSet& parameters,
                               std::span<const double> active, const FitOptions& options,
                               Misfit::Details& details) {
  const std::size_t samples = details.residual.size();
  for (std::size_t k = 0; k < active.size(); ++k) {
    if (!is_yield(parameters.all()[parameters.active()[k]])) continue;
    const std::span<double> slopes = std::span(details.jacobian).subspan(k * samples, samples);
    const std::span<const double> weights = misfit.weights();
    int moved = 0;
    for (std::size_t s = 0; s < samples; ++s) moved += slopes[s] != 0.0 && weights[s] > 0.0 ? 1 : 0;
    if (moved == 0 || moved > kFewSamples) continue;
    // What the squares say of the noise, or what is known of it; and the squared threshold over it.
    double squares = 0.0, counted = 0.0, squared_weights = 0.0;
    for (std::size_t s = 0; s < samples; ++s) {
      if (!(weights[s] > 0.0)) continue;
      squares += details.residual[s] * details.residual[s];
      squared_weights += weights[s] * weights[s];
      counted += 1.0;
    }
    double degrees = std::max(1.0, counted - static_cast<double>(active.size()));
    double variance = squares / degrees;
    if (options.objective == Objective::LeastSquares && options.noise) {
      variance = *options.noise * *options.noise;
      degrees = std::numeric_limits<double>::infinity();
    }
    const double t = theory::student_t_quantile(0.5 + 0.5 * options.confidence, degrees);
    const double best = misfit.search_cost(active, {});
    const double without = WithoutYield(misfit, parameters, active, k).min_cost();
    if (without - best < t * t * variance * squared_weights) std::ranges::fill(slopes, 0.0);
  }
}

}  // namespace plastica::calibrate
