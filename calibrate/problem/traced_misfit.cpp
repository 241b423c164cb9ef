#include "calibrate/problem/traced_misfit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace plastica::calibrate {

TracedMisfit::TracedMisfit(Misfit& misfit, const ParameterSet& parameters, Trace& trace)
    : misfit_(misfit), parameters_(parameters), trace_(trace), values_(parameters.active().size()) {
  for (std::size_t k = 0; k < values_.size(); ++k) {
    const std::size_t index = parameters.active()[k];
    const ResolvedParameter& p = parameters.all()[index];
    trace_.active.push_back(static_cast<std::uint32_t>(index));
    if (p.is_break) {
      break_ = k;
      continue;
    }
    searched_.push_back(k);
    problem_.lower.push_back(parameters.lower(k));
    problem_.upper.push_back(parameters.upper(k));
    problem_.start.push_back(
        std::clamp(parameters.coordinate(k, p.start), parameters.lower(k), parameters.upper(k)));
  }
  problem_.cost = [this](std::span<const double> x, std::span<double> gradient) {
    return cost(x, gradient);
  };
  problem_.squares = [this](std::span<const double> x, std::span<double> gradient,
                            std::span<double> normal) { return squares(x, gradient, normal); };
}

void TracedMisfit::set_values(std::span<const double> x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    values_[searched_[i]] = parameters_.value(searched_[i], x[i]);
  }
}

double TracedMisfit::slope(std::size_t i) const {
  return parameters_.slope(searched_[i], values_[searched_[i]]);
}

double TracedMisfit::cost(std::span<const double> x, std::span<double> gradient) {
  set_values(x);
  by_active_.resize(gradient.empty() ? 0 : values_.size());
  const double cost = misfit_.search_cost(values_, by_active_);
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    gradient[i] = by_active_[searched_[i]] * slope(i) / unit();
  }
  return traced(cost);
}

double TracedMisfit::squares(std::span<const double> x, std::span<double> gradient,
                             std::span<double> normal) {
  set_values(x);
  const std::size_t n = x.size();
  const std::size_t all = values_.size();
  by_active_.resize(all);
  normal_by_active_.resize(all * all);
  const double cost = misfit_.search_squares(values_, by_active_, normal_by_active_);
  for (std::size_t i = 0; i < n; ++i) {
    const double by = slope(i) / unit();
    gradient[i] = by_active_[searched_[i]] * by;
    for (std::size_t j = 0; j < n; ++j) {
      normal[i * n + j] = normal_by_active_[searched_[i] * all + searched_[j]] * by * slope(j);
    }
  }
  return traced(cost);
}

double TracedMisfit::traced(double cost) {
  if (break_ && std::isfinite(cost)) {
    const ResolvedParameter& p = parameters_.all()[parameters_.active()[*break_]];
    values_[*break_] =
        std::clamp(misfit_.permanent_strain() / misfit_.break_factor(), p.lower, p.upper);
  }
  if (misfit_.was_run()) {
    trace_.values.insert(trace_.values.end(), values_.begin(), values_.end());
    trace_.costs.push_back(cost);
  }
  return cost / unit();
}

}  // namespace plastica::calibrate
