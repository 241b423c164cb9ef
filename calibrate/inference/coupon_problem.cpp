#include "calibrate/inference/coupon_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "calibrate/inference/identifiable_yield.hpp"
#include "calibrate/inference/strain_errors.hpp"
#include "calibrate/problem/weighed_priors.hpp"

namespace plastica::calibrate {
namespace {

/// Fraction of the largest stress below which a noise is rounding.
constexpr double kMinNoise = 1e-12;

}  // namespace

CouponProblem::CouponProblem(const Target& target, const FitOptions& options,
                             const FitResult& result)
    : set_(target, options), misfit_(target, options, set_) {
  const std::size_t n_active = set_.active().size();
  std::vector<std::optional<std::size_t>> active_index;  // of each of free_
  std::size_t k = 0;
  for (std::size_t i = 0; i < set_.size(); ++i) {
    const ResolvedParameter& p = set_.all()[i];
    if (p.role != ParameterRole::Free) continue;
    Free free;
    free.fitted = &result.parameters[i];
    if (!p.idle) {
      active_.push_back(free.fitted->value);
      free.is_break = p.is_break;
      if (!p.is_break) {
        free.coordinate = searched_.size();
        searched_.push_back(k);
        squares_.lower.push_back(set_.lower(k));
        squares_.upper.push_back(set_.coordinate(k, p.upper));
        const double at = set_.coordinate(k, free.fitted->value);
        squares_.start.push_back(std::clamp(at, squares_.lower.back(), squares_.upper.back()));
      }
    }
    active_index.push_back(p.idle ? std::nullopt : std::optional(k++));
    free_.push_back(free);
  }
  WeighedPriors priors = priors_of(options, result.modulus_prior);
  if (result.modulus_prior) priors.variance = result.modulus_prior->variance;
  if (result.stated_priors) priors.variance = result.stated_priors->variance;
  misfit_.set_priors(priors);
  details_ = misfit_.details(active_);
  drop_unidentifiable_yield(misfit_, set_, target.corrected, active_, options, details_);
  misfit_.end_search();
  add_strain_errors(target, options, set_, active_, details_);
  uncertainty_ = uncertainty(details_, active_, set_, target, options, misfit_.break_factor());
  spread_ = spread_of(details_, active_, set_, target, options);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const std::size_t of = active_index[i].value_or(0);
    if (of < n_active) free_[i].degrees_of_freedom = uncertainty_.degrees_of_freedom[of];
  }
  noise_ = std::max(uncertainty_.noise, kMinNoise * std::sqrt(misfit_.cost_unit()));
  for (std::size_t i = 0; i < n_active; ++i) {
    if (set_.all()[set_.active()[i]].is_break) limit_half_ = uncertainty_.sampling[i];
  }
  const std::span<const double> weights = misfit_.weights();
  const double squared = std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
  const double unit = 1.0 / (noise_ * noise_ * squared);
  weight_unit_ = unit / std::accumulate(details_.weight.begin(), details_.weight.end(), 0.0);
  break_scale_ = std::sqrt(unit);
  for (std::size_t s = 0; s < weights.size(); ++s) {
    scale_.push_back(std::sqrt(unit * weights[s]));
    if (weights[s] > 0.0) entered_.push_back(s);
  }
  squares_.residuals = weights.size() + 1 + misfit_.priors();
  squares_.evaluate = one_by_one([this](std::span<const double> x, std::span<double> residual) {
    return residuals(x, residual);
  });
  std::vector<double> residual(squares_.residuals);
  if (!residuals(squares_.start, residual)) {
    cost_ = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  prior_residuals_.assign(residual.end() - static_cast<std::ptrdiff_t>(misfit_.priors()),
                          residual.end());
  cost_ = std::inner_product(residual.begin(), residual.end(), residual.begin(), 0.0);
}

std::span<const double> CouponProblem::active_of(std::span<const double> x) {
  for (std::size_t i = 0; i < searched_.size(); ++i) active_[searched_[i]] = value(i, x[i]);
  return active_;
}

bool CouponProblem::residuals(std::span<const double> x, std::span<double> residual) {
  const std::size_t samples = scale_.size();
  if (!misfit_.residuals(active_of(x), residual.first(samples))) return false;
  for (std::size_t s = 0; s < samples; ++s) residual[s] *= scale_[s];
  residual[samples] = break_scale_ * misfit_.break_residual();
  std::size_t next = samples + 1;
  for (const double prior : misfit_.prior_residuals()) residual[next++] = break_scale_ * prior;
  return true;
}

LeastSquaresProblem CouponProblem::with_limit() {
  LeastSquaresProblem both = squares_;
  ++both.residuals;
  both.evaluate = one_by_one([this](std::span<const double> x, std::span<double> residual) {
    const std::size_t m = squares_.residuals;
    if (!residuals(x, residual.first(m))) return false;
    residual[m] = misfit_.permanent_strain() / misfit_.break_factor();
    return true;
  });
  return both;
}

std::vector<double> CouponProblem::residual_of_entered() const {
  std::vector<double> residual;
  for (const std::size_t s : entered_) residual.push_back(details_.residual[s]);
  return residual;
}

std::optional<CouponProblem::Moments> CouponProblem::moments(
    std::span<const double> gradient) const {
  const std::size_t n = searched_.size();
  const std::size_t n_active = active_.size();
  // The matrices are in SI: d value/d coordinate turns them.
  std::vector<double> slope(n);
  for (std::size_t i = 0; i < n; ++i) slope[i] = set_.slope(searched_[i], value(i, solution()[i]));
  const auto inverse = [&](std::size_t i, std::size_t j) {
    return spread_.inverse[searched_[i] * n_active + searched_[j]] /
           (slope[i] * slope[j] * weight_unit_);
  };
  Moments all;
  double of_residuals = 0.0, of_prior = 0.0, of_stated = 0.0;
  all.along.assign(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    if (!uncertainty_.identified[searched_[i]]) {
      // A parameter that is not identifiable does not matter to what does not depend on it.
      if (gradient[i] != 0.0) return std::nullopt;
      continue;
    }
    for (std::size_t j = 0; j < n; ++j) {
      if (!uncertainty_.identified[searched_[j]]) continue;
      const std::size_t entry = searched_[i] * n_active + searched_[j];
      const double both = gradient[i] * gradient[j] / (slope[i] * slope[j]);
      of_residuals += both * noise_ * noise_ * spread_.spread[entry];
      of_prior += both * spread_.prior[entry];
      of_stated += both * spread_.stated[entry];
      all.inverse += gradient[i] * gradient[j] * inverse(i, j);
      all.along[i] += inverse(i, j) * gradient[j];
    }
  }
  // The errors of residuals and slope add up, see uncertainty.hpp.
  all.squared_error =
      std::pow(std::sqrt(std::max(0.0, of_residuals)) + std::sqrt(std::max(0.0, of_prior)), 2) +
      std::max(0.0, of_stated);
  if (!(all.squared_error > 0.0) || !(all.inverse > 0.0)) return std::nullopt;
  for (double& a : all.along) a /= all.inverse;
  return all;
}

std::vector<double> CouponProblem::limit_slope() const {
  std::vector<double> by_coordinate;
  for (std::size_t i = 0; i < searched_.size(); ++i) {
    const std::size_t k = searched_[i];
    by_coordinate.push_back(details_.permanent_gradient[k] *
                            set_.slope(k, value(i, solution()[i])) / misfit_.break_factor());
  }
  return by_coordinate;
}

double CouponProblem::limit_at(std::span<const double> x, double place) {
  std::vector<double> residual(scale_.size());
  if (!misfit_.residuals(active_of(x), residual)) return std::numeric_limits<double>::quiet_NaN();
  return misfit_.permanent_strain() / misfit_.break_factor() + (2.0 * place - 1.0) * limit_half_;
}

double CouponProblem::value(std::size_t coordinate, double x) const {
  return set_.value(searched_[coordinate], x);
}

}  // namespace plastica::calibrate
