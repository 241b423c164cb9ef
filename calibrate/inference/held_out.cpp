#include "calibrate/inference/held_out.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "calibrate/inference/bootstrap.hpp"
#include "calibrate/inference/coupon_problem.hpp"
#include "calibrate/inference/fitted_scenes.hpp"
#include "calibrate/inference/scene_work.hpp"
#include "calibrate/target/curve.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::size_t kBlocks = 2 * kParts;
/// Of the ranges of both axes.
constexpr double kChord = 0.05;

double range_of(std::span<const double> values) {
  const auto [low, high] = std::ranges::minmax_element(values);
  return *high > *low ? *high - *low : 1.0;
}

/// Residuals at the end of a search without those of one part; those, too. Empty without an end.
/// @param part  of each residual; kParts: of none
std::vector<double> searched_without(const LeastSquaresProblem& squares,
                                     std::span<const std::size_t> part, std::size_t without,
                                     const LeastSquaresOptions& how) {
  std::vector<double> factor(squares.residuals, 1.0);
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] == without) factor[i] = 0.0;
  }
  const std::vector<double> shift(factor.size(), 0.0);
  const LeastSquares found = minimize_squares(changed(squares, std::move(factor), shift), how);
  if (found.outcome == LeastSquaresOutcome::NoStart) return {};
  std::vector<double> residual(squares.residuals);
  bool is_there = false;
  squares.evaluate(found.x, residual, {&is_there, 1});
  return is_there ? residual : std::vector<double>();
}

LeastSquaresOptions search_of(int evaluations, double x_tolerance) {
  LeastSquaresOptions how;
  how.max_evaluations = evaluations;
  how.x_tolerance = x_tolerance;
  how.cost_tolerance = 1e-10;  // what is left of the part goes with its root
  return how;
}

}  // namespace

std::vector<std::size_t> parts_along(std::span<const double> x, std::span<const double> y) {
  std::vector<double> length(x.size(), 0.0);
  if (x.empty()) return {};
  const double x_range = range_of(x);
  const double y_range = range_of(y);
  std::size_t from = 0;  // of the chord
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double chord = std::hypot((x[i] - x[from]) / x_range, (y[i] - y[from]) / y_range);
    length[i] = std::max(length[i - 1], length[from] + chord);
    if (chord >= kChord) from = i;
  }
  std::vector<std::size_t> parts;
  parts.reserve(x.size());
  for (const double at : length) {
    // Rounding must not decide about a sample between two blocks.
    const double block = static_cast<double>(kBlocks) * at / std::max(length.back(), 1e-300) + 1e-9;
    parts.push_back(std::min(static_cast<std::size_t>(block), kBlocks - 1) % kParts);
  }
  return parts;
}

std::vector<double> held_out(const Target& target, const FitOptions& options,
                             const FitResult& result) {
  if (result.status != FitStatus::Fitted) return {};
  CouponProblem problem(target, options, result);
  if (!std::isfinite(problem.cost())) return {};
  const Curve& curve = target.corrected;
  const std::vector<std::size_t> part = parts_along(curve.strain, curve.stress);
  const double stress = largest_magnitude(curve.stress);
  // Of squares over the noise: to those of stresses, weighted and over the largest.
  const double unit =
      problem.noise() * problem.noise() / (result.effective_samples * stress * stress);
  const LeastSquaresOptions how =
      search_of(options.stopping.local_evaluations, options.stopping.parameter_tolerance);
  std::vector<double> left(kParts, 0.0);
  for (std::size_t k = 0; k < kParts; ++k) {
    const std::vector<double> residual = searched_without(problem.squares(), part, k, how);
    if (residual.empty()) return {};
    for (std::size_t i = 0; i < part.size(); ++i) {
      if (part[i] == k) {
        left[k] += static_cast<double>(kParts) * unit * residual[i] * residual[i];
      }
    }
  }
  return left;
}

std::vector<double> held_out(const FittedScenes& fitted, SceneWork& work) {
  const SceneProblem& problem = fitted.problem();
  const std::span<const WeightedTarget> targets = problem.targets();
  double weights = 0.0;
  for (const WeightedTarget& each : targets) weights += each.weight;
  std::vector<std::size_t> part;
  std::vector<double> unit;  // from the squares to those of fractions, by sample
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const SceneTarget& target = targets[t].target;
    const std::vector<std::size_t> of_target = parts_along(target.abscissa, target.ordinate);
    part.insert(part.end(), of_target.begin(), of_target.end());
    const double scale = problem.scale(t) / largest_size(target.ordinate);
    unit.insert(unit.end(), of_target.size(),
                scale * scale * static_cast<double>(kParts) /
                    (weights * static_cast<double>(of_target.size())));
  }
  LeastSquaresOptions how = search_of(fitted.options().evaluations, fitted.options().tolerance);
  const auto without = [&](std::size_t k) {
    const auto own = fitted.copy();
    LeastSquaresProblem squares = own->squares();
    squares.start = fitted.best().x;
    TaskRecord made;
    made.rows.push_back(searched_without(squares, part, k, how));
    made.runs = own->counters();
    return made;
  };
  std::vector<double> left(kParts, 0.0);
  const std::vector<TaskRecord> all =
      work.make({"parts held out", kParts, fitted.options().threads}, without);
  for (std::size_t k = 0; k < kParts; ++k) {
    const std::vector<double>& residual = all[k].rows.front();
    if (residual.empty()) return {};
    for (std::size_t i = 0; i < part.size(); ++i) {
      if (part[i] == k) left[k] += unit[i] * residual[i] * residual[i];
    }
  }
  return left;
}

}  // namespace plastica::calibrate
