#include <algorithm>
#include <cmath>
#include <vector>

#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/weighted_squares.hpp"

/// What is asked of a misfit at a solution.
namespace plastica::calibrate {

std::vector<double> Misfit::curvature(std::span<const double> active) {
  const std::size_t n = active.size();
  std::vector<double> curvature(n, 0.0);
  std::vector<double> by_active(n);
  if (!std::isfinite(cost(active, by_active))) return curvature;
  need_samples(true);
  const std::vector<double> map = model_by_active(n);
  std::vector<double> slope(samples_);
  for (std::size_t k = 0; k < n; ++k) {
    stress_slopes(map, k, slope);
    curvature[k] = 2.0 * weighted_product(weight_, slope, slope);
  }
  if (break_scale_ > 0.0) {
    std::fill(by_all_.begin(), by_all_.end(), 0.0);
    by_all_[break_index_] = break_factor_;
    parameters_.contract(by_all_, by_active);
    for (std::size_t k = 0; k < n; ++k) {
      curvature[k] += 2.0 * break_scale_ * by_active[k] * by_active[k];
    }
  }
  return curvature;
}

double Misfit::stress_cost(std::span<const double> active) {
  std::vector<double> gradient(active.size());
  const double total = cost(active, gradient);
  return total - break_cost(limit(), {}, true);
}

Misfit::Parts Misfit::parts(std::span<const double> active) {
  Parts p;
  const double total = cost(active, {});
  need_samples(false);
  p.break_cost = break_cost(limit(), {}, true);
  p.stress_cost = total - p.break_cost;
  p.residual.reserve(samples_);
  const double* stress = response_.probes[0].data();
  for (std::size_t s = 0; s < samples_; ++s) {
    p.residual.push_back(stress[s] - target_.corrected.stress[s]);
  }
  p.weight = raw_weight_;
  return p;
}

Misfit::Details Misfit::details(std::span<const double> active) {
  std::vector<double> gradient(active.size());
  cost(active, gradient);  // runs the model with its slopes
  need_samples(true);
  Details d;
  static_cast<Parts&>(d) = parts(active);
  d.jacobian.resize(samples_ * active.size());
  const std::size_t n = active.size();
  const std::size_t width = model_index_.size();
  const std::vector<double> map = model_by_active(n);
  for (std::size_t k = 0; k < n; ++k) {
    stress_slopes(map, k, std::span(d.jacobian).subspan(k * samples_, samples_));
  }
  d.prior_variance = prior_variance_;
  for (const SetPrior& one : priors_) {
    const auto column = std::ranges::find(parameters_.active(), one.index);
    d.priors.push_back({static_cast<std::size_t>(column - parameters_.active().begin()),
                        one.prior.standard_deviation, one.stated});
  }
  d.permanent = response_.permanent_strain;
  d.permanent_gradient.resize(n);
  for (std::size_t i = 0; i < width; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      d.permanent_gradient[k] += sensitivity_.permanent_strain[i] * map[i * n + k];
    }
  }
  return d;
}

}  // namespace plastica::calibrate
