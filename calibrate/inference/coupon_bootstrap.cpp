#include <algorithm>
#include <cmath>
#include <utility>

#include "calibrate/inference/coupon_intervals.hpp"
#include "calibrate/inference/parameter_profile.hpp"

namespace plastica::calibrate {
namespace {

/// Residuals of unequal noise stay with their samples, at the size of their own variances, and draw
/// their signs, alike within a block: the wild bootstrap (Wu, Ann. Stat. 14 (1986) 1261; signs:
/// Davidson & Flachaire, J. Econometrics 146 (2008) 162).
std::vector<double> drawn_signs(const std::vector<double>& variance, std::size_t block,
                                Draws& draws) {
  std::vector<double> drawn;
  drawn.reserve(variance.size());
  double sign = 1.0;
  for (std::size_t i = 0; i < variance.size(); ++i) {
    if (i % block == 0) sign = draws.below(2) == 0 ? -1.0 : 1.0;
    drawn.push_back(sign * std::sqrt(variance[i]));
  }
  return drawn;
}

/// What is added to the residuals of the squares so that they are those of a drawn curve.
std::vector<double> drawn_shift(const CouponProblem& problem, const std::vector<double>& residual,
                                double inflation, std::size_t block, Draws& draws) {
  const std::vector<double> drawn = problem.own_variance().empty()
                                        ? drawn_residuals(residual, inflation, block, draws)
                                        : drawn_signs(problem.own_variance(), block, draws);
  std::vector<double> shift(problem.squares().residuals, 0.0);
  // A prior's mean is drawn about the fitted value that it stands for.
  const std::span<const double> priors = problem.prior_residuals();
  for (std::size_t k = 0; k < priors.size(); ++k) {
    shift[shift.size() - priors.size() + k] = problem.prior_size() * draws.normal() - priors[k];
  }
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const std::size_t s = problem.entered()[i];
    shift[s] = problem.scale(s) * (drawn[i] - residual[i]);
  }
  return shift;
}

std::vector<double> values_at(CouponProblem& problem, std::span<const double> x, double place) {
  std::vector<double> values;
  for (const CouponProblem::Free& free : problem.free()) {
    const FittedParameter& p = *free.fitted;
    values.push_back(free.coordinate ? problem.value(*free.coordinate, x[*free.coordinate])
                     : free.is_break ? std::clamp(problem.limit_at(x, place), p.lower, p.upper)
                                     : p.value);
  }
  return values;
}

}  // namespace

BootstrapResult bootstrap_coupon(CouponProblem& problem, const FitOptions& options,
                                 std::uint64_t seed) {
  const std::vector<double> residual = problem.residual_of_entered();
  const auto samples = static_cast<double>(residual.size());
  const double left = std::max(1.0, samples - static_cast<double>(problem.rank()));
  const double inflation = std::sqrt(samples / left);
  LeastSquaresOptions how;
  // A ten-thousandth of a standard error, or a thousandth of few samples.
  how.cost_tolerance = 1e-8;
  const auto block = static_cast<std::size_t>(options.intervals.block);
  std::vector<std::vector<double>> rows;
  for (int b = 0; b < options.intervals.bootstrap; ++b) {
    Draws draws(seed, static_cast<std::uint64_t>(b));
    std::vector<double> shift = drawn_shift(problem, residual, inflation, block, draws);
    const double place = draws.uniform();
    std::vector<double> factor(shift.size(), 1.0);
    const LeastSquares found =
        minimize_squares(changed(problem.squares(), std::move(factor), std::move(shift)), how);
    rows.push_back(found.outcome == LeastSquaresOutcome::NoStart
                       ? std::vector<double>()
                       : values_at(problem, found.x, place));
  }
  std::vector<bool> known;
  for (const CouponProblem::Free& free : problem.free()) known.push_back(free.fitted->identified);
  return bootstrap_of(rows, known, options.intervals.block, options.confidence);
}

}  // namespace plastica::calibrate
