#include <algorithm>
#include <cmath>
#include <utility>

#include "calibrate/fit/coupon_intervals.hpp"
#include "calibrate/fit/not_a_number.hpp"

namespace plastica::calibrate {
namespace {

/// What is added to the residuals of the squares so that they are those of a drawn curve.
std::vector<double> drawn_shift(const CouponProblem& problem, const std::vector<double>& residual,
                                double inflation, std::size_t block, Draws& draws) {
  const std::vector<double> drawn = drawn_residuals(residual, inflation, block, draws);
  std::vector<double> shift(problem.squares().residuals, 0.0);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const std::size_t s = problem.entered()[i];
    shift[s] = problem.scale(s) * (drawn[i] - residual[i]);
  }
  return shift;
}

/// The free parameters' values at coordinates. @return whether all are numbers
bool values_at(CouponProblem& problem, std::span<const double> x, double place,
               std::vector<double>& values) {
  for (const CouponProblem::Free& free : problem.free()) {
    const FittedParameter& p = *free.fitted;
    values.push_back(free.coordinate ? problem.value(*free.coordinate, x[*free.coordinate])
                     : free.is_break ? std::clamp(problem.limit_at(x, place), p.lower, p.upper)
                                     : p.value);
  }
  return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
}

}  // namespace

BootstrapResult bootstrap_coupon(CouponProblem& problem, const FitOptions& options,
                                 std::uint64_t seed) {
  const std::vector<double> residual = problem.residual_of_entered();
  const auto samples = static_cast<double>(residual.size());
  const double left = std::max(1.0, samples - static_cast<double>(problem.determined()));
  const double inflation = std::sqrt(samples / left);
  BootstrapResult result;
  result.resamples = options.intervals.bootstrap;
  result.block = options.intervals.block;
  LeastSquaresOptions how;
  // A ten-thousandth of a standard error, or a thousandth of few samples.
  how.cost_tolerance = 1e-8;
  std::vector<std::vector<double>> columns(problem.free().size());
  for (int b = 0; b < result.resamples; ++b) {
    Draws draws(seed, static_cast<std::uint64_t>(b));
    std::vector<double> shift =
        drawn_shift(problem, residual, inflation, static_cast<std::size_t>(result.block), draws);
    const double place = draws.even();
    std::vector<double> factor(shift.size(), 1.0);
    const LeastSquares found =
        minimize_squares(changed(problem.squares(), std::move(factor), std::move(shift)), how);
    std::vector<double> values;
    if (found.outcome == LeastSquaresOutcome::NoStart ||
        !values_at(problem, found.x, place, values)) {
      ++result.failed;
      continue;
    }
    result.values.insert(result.values.end(), values.begin(), values.end());
    for (std::size_t i = 0; i < values.size(); ++i) columns[i].push_back(values[i]);
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool seen = problem.free()[i].fitted->identified;
    result.intervals.push_back(seen ? bootstrap_interval(std::move(columns[i]), options.confidence)
                                    : BootstrapInterval{kNan, kNan, kNan});
  }
  return result;
}

}  // namespace plastica::calibrate
