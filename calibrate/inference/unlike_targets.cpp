#include "calibrate/inference/unlike_targets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibrate/fit/check_scene_fit.hpp"
#include "calibrate/inference/lack_of_fit.hpp"
#include "calibrate/inference/material_interval.hpp"
#include "calibrate/inference/score_covariance.hpp"
#include "calibrate/inference/small_matrices.hpp"
#include "calibrate/inference/verdict.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Directions of a target's coordinates that its own curve shows: what a curve hardly shows, its
/// residuals cannot tell from their noise, and the step there is no small one any more.
constexpr double kShown = 1e-6;

/// A target of which no more samples are left tells nothing of its noise.
constexpr Index kFewLeft = 8;

/// A part of the inverse: of the directions that are shown.
struct Shown {
  MatrixXd directions;  ///< (n x rank), so that directions directions^T is the inverse

  explicit Shown(const MatrixXd& a) {
    const auto n = a.rows();
    std::vector<Index> moved;
    for (Index k = 0; k < n; ++k) {
      if (a(k, k) > 0.0) moved.push_back(k);
    }
    directions = MatrixXd::Zero(n, 0);
    if (moved.empty()) return;
    const UnitDirections unit(kept_of(a, moved));
    const Index rank = (unit.values.array() > kShown).count();
    const Index first = unit.values.size() - rank;
    directions = MatrixXd::Zero(n, rank);
    for (Index k = 0; k < rank; ++k) {
      const VectorXd one =
          unit.size.cwiseProduct(unit.vectors.col(first + k)) / std::sqrt(unit.values[first + k]);
      for (std::size_t i = 0; i < moved.size(); ++i) {
        directions(moved[i], k) = one[static_cast<Index>(i)];
      }
    }
  }
  Index rank() const { return directions.cols(); }
  VectorXd solve(const VectorXd& b) const { return directions * (directions.transpose() * b); }
};

/// What a target says of the coordinates that are free.
struct Score {
  MatrixXd slopes;    ///< (n_samples x n_free)
  VectorXd residual;  ///< (n_samples)
  VectorXd score;
  MatrixXd normal;
};

Score score_of(const SceneProblem& problem, std::size_t t, std::span<const double> slopes,
               std::span<const double> residual, const std::vector<Index>& free) {
  const auto n = static_cast<Index>(problem.parameters().size());
  const std::size_t first = problem.first_residual(t);
  const std::size_t count = problem.targets()[t].target.ordinate.size();
  const SlopeRows rows(slopes.data() + first * static_cast<std::size_t>(n),
                       static_cast<Index>(count), n);
  Score one;
  one.slopes = rows(Eigen::all, free);
  one.residual = Eigen::Map<const VectorXd>(residual.data() + first, static_cast<Index>(count));
  one.score = one.slopes.transpose() * one.residual;
  one.normal = gram(one.slopes);
  return one;
}

/// Whether a target's samples count alike and leave independent noise: its variance is one number.
bool is_even_noise(const SceneProblem& problem, std::size_t t, const VectorXd& left) {
  const std::span<const double> weights = problem.weights(t);
  const auto [low, high] = std::ranges::minmax_element(weights);
  const std::span<const double> all(left.data(), static_cast<std::size_t>(left.size()));
  return *low == *high &&
         !are_in_runs(runs_test_p(all), autocorrelation(all), static_cast<double>(all.size()));
}

/// h^T V^-1 h in the directions that are shown, V the covariance of the score by noise.
double squared(const VectorXd& h, const Shown& shown, const Score& one, const VectorXd& left,
               bool is_even) {
  // A curve without any noise has the rounding of its numbers.
  constexpr double kRounding = 1e-20;
  const VectorXd own = shown.directions.transpose() * h;
  const auto samples = static_cast<double>(left.size());
  const double freedom = samples - static_cast<double>(shown.rank());
  if (is_even) {
    // Of an estimated variance the mean of what follows is freedom/(freedom - 2) too large.
    const double variance =
        left.squaredNorm() / freedom + kRounding * one.residual.squaredNorm() / samples;
    return own.squaredNorm() / variance * (freedom - 2.0) / freedom;
  }
  using ByRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const ByRows slopes = product(one.slopes, shown.directions);
  const std::vector<double> noise =
      score_covariance({slopes.data(), static_cast<std::size_t>(slopes.size())},
                       {left.data(), static_cast<std::size_t>(left.size())});
  const MatrixXd covariance = SlopeRows(noise.data(), shown.rank(), shown.rank());
  const MatrixXd floor =
      kRounding * one.residual.squaredNorm() * MatrixXd::Identity(shown.rank(), shown.rank());
  const Shown inverse(covariance + floor);
  return freedom / samples * (inverse.directions.transpose() * own).squaredNorm();
}

TargetsOfOneKind compared(const SceneProblem& problem, std::vector<std::size_t> targets,
                          std::span<const double> slopes, std::span<const double> residual,
                          const std::vector<Index>& free) {
  TargetsOfOneKind kind;
  const auto n = static_cast<Index>(free.size());
  std::vector<Score> scores;
  VectorXd sum = VectorXd::Zero(n);
  MatrixXd normal = MatrixXd::Zero(n, n);
  for (const std::size_t t : targets) {
    scores.push_back(score_of(problem, t, slopes, residual, free));
    sum += scores.back().score;
    normal += scores.back().normal;
  }
  const Shown by_all(normal);
  const VectorXd of_kind = -by_all.solve(sum);
  kind.scores = MatrixXd::Zero(n, n);
  kind.degrees = -static_cast<double>(by_all.rank());
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const Score& one = scores[k];
    const Shown shown(one.normal);
    const VectorXd h = one.score + one.normal * of_kind;
    kind.left.push_back(one.residual - one.slopes * shown.solve(one.score));
    kind.degrees_left.push_back(static_cast<double>(one.residual.size() - shown.rank()));
    kind.scores += h * h.transpose();
    if (one.residual.size() < shown.rank() + kFewLeft) continue;
    if (shown.rank() > 0) {
      const bool is_even = is_even_noise(problem, targets[k], kind.left.back());
      kind.chi_squared += squared(h, shown, one, kind.left.back(), is_even);
    }
    kind.degrees += static_cast<double>(shown.rank());
  }
  const auto count = static_cast<double>(targets.size());
  kind.scores *= count / (count - 1.0);
  kind.targets = std::move(targets);
  return kind;
}

}  // namespace

bool TargetsOfOneKind::differ() const {
  constexpr double kSeldom = 1e-3;
  return degrees > 0.0 && theory::chi_squared_cdf(chi_squared, degrees) > 1.0 - kSeldom;
}

std::vector<TargetsOfOneKind> targets_of_one_kind(const SceneProblem& problem,
                                                  std::span<const double> slopes,
                                                  std::span<const double> residual,
                                                  const std::vector<Index>& free) {
  std::vector<TargetsOfOneKind> kinds;
  std::vector<bool> seen(problem.targets().size(), false);
  for (std::size_t t = 0; t < seen.size(); ++t) {
    if (seen[t]) continue;
    std::vector<std::size_t> alike;
    for (std::size_t other = t; other < seen.size(); ++other) {
      const bool is_alike =
          are_of_one_kind(problem.targets()[t].target, problem.targets()[other].target);
      if (seen[other] || !is_alike) continue;
      alike.push_back(other);
      seen[other] = true;
    }
    if (alike.size() < 2 || free.empty()) continue;
    kinds.push_back(compared(problem, std::move(alike), slopes, residual, free));
  }
  return kinds;
}

std::vector<double> left_alone(const SceneProblem& problem, const TargetsOfOneKind& kind,
                               std::size_t k) {
  const std::size_t t = kind.targets[k];
  std::vector<double> of_all(problem.squares().residuals);
  std::ranges::copy(kind.left[k],
                    of_all.begin() + static_cast<std::ptrdiff_t>(problem.first_residual(t)));
  return problem.unscaled(t, of_all);
}

}  // namespace plastica::calibrate
