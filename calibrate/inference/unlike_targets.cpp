#include "calibrate/inference/unlike_targets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibrate/fit/check_scene_fit.hpp"
#include "calibrate/inference/lack_of_fit.hpp"
#include "calibrate/inference/small_matrices.hpp"
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
constexpr double kFewLeft = 12.0;

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

/// The chi-squared that is as seldom as F of so many degrees of freedom over its own estimate's: by
/// the normal deviates of both (Paulson, Ann. Math. Stat. 13 (1942) 233; Wilson & Hilferty, PNAS 17
/// (1931) 684).
double chi_squared_of(double f, double of_mean, double of_variance) {
  const double a = 2.0 / (9.0 * of_mean), b = 2.0 / (9.0 * of_variance);
  const double root = std::cbrt(f);
  const double z = ((1.0 - b) * root - (1.0 - a)) / std::sqrt(b * root * root + a);
  return of_mean * std::pow(std::max(0.0, 1.0 - a + z * std::sqrt(a)), 3);
}

/// What tells how far a target is from what its kind asks for.
struct OwnNoise {
  double variance = 0.0;  ///< of its samples, over the scale
  double alike = 0.0;     ///< correlation of neighbours, >= 0
  double worth = 0.0;     ///< degrees of freedom of the variance

  /// @param weights  of the samples, whose roots are in the residuals
  OwnNoise(const VectorXd& left, std::span<const double> weights, Index rank) {
    const VectorXd own =
        left.cwiseQuotient(Eigen::Map<const VectorXd>(weights.data(), left.size()).cwiseSqrt());
    const auto samples = static_cast<double>(own.size());
    const auto k = static_cast<double>(rank);
    const double seen = autocorrelation({own.data(), static_cast<std::size_t>(own.size())});
    // What a fit takes from it: as in score_covariance.hpp.
    constexpr double kMost = 0.97;
    alike = std::clamp(seen + (k * (1.0 + seen) + 2.0 * seen) / samples, 0.0, kMost);
    worth = samples_worth(samples, alike) - k;
    variance = own.squaredNorm() / (samples - k);
  }
  /// What of it counts in a score whose slopes change slowly.
  double inflated() const { return variance * (1.0 + alike) / (1.0 - alike); }
};

/// h^T V^-1 h in the directions that are shown, V the covariance of the score by noise: as of
/// independent samples, times what neighbours that are alike make of slopes that change slowly.
double squared(const VectorXd& h, const Shown& shown, const Score& one, const OwnNoise& noise,
               std::span<const double> weights) {
  const MatrixXd slopes = product(one.slopes, shown.directions);
  const Eigen::Map<const VectorXd> weight(weights.data(), slopes.rows());
  // A curve without any noise has the rounding of its numbers.
  constexpr double kRounding = 1e-20;
  const double floor = kRounding * one.residual.squaredNorm();
  const MatrixXd covariance = noise.inflated() * gram(slopes, weight) +
                              floor * MatrixXd::Identity(shown.rank(), shown.rank());
  const VectorXd own = Shown(covariance).directions.transpose() * shown.directions.transpose() * h;
  const auto rank = static_cast<double>(shown.rank());
  return chi_squared_of(own.squaredNorm() / rank, rank, noise.worth);
}

/// What several targets ask for together.
struct Together {
  VectorXd sum;
  MatrixXd normal;

  explicit Together(Index n) : sum(VectorXd::Zero(n)), normal(MatrixXd::Zero(n, n)) {}
  void add(const Score& one, double weight = 1.0) {
    sum += weight * one.score;
    normal += weight * one.normal;
  }
};

/// chi^2 and its degrees of freedom, of targets with enough samples.
void compare(const SceneProblem& problem, std::span<const Score> scores, TargetsOfOneKind& kind) {
  Together counted(scores.front().score.size());
  struct One {
    std::size_t k;
    Shown shown;
    OwnNoise noise;
  };
  std::vector<One> ones;
  for (std::size_t k = 0; k < scores.size(); ++k) {
    const Shown shown(scores[k].normal);
    const OwnNoise noise(kind.left[k], problem.weights(kind.targets[k]), shown.rank());
    if (!(noise.worth >= kFewLeft)) continue;
    if (noise.inflated() > 0.0) counted.add(scores[k], 1.0 / noise.inflated());
    ones.push_back({k, shown, noise});
  }
  const Shown by_all(counted.normal);
  const VectorXd of_kind = -by_all.solve(counted.sum);
  kind.degrees = -static_cast<double>(by_all.rank());
  for (const One& one : ones) {
    const Score& score = scores[one.k];
    const VectorXd h = score.score + score.normal * of_kind;
    kind.degrees += static_cast<double>(one.shown.rank());
    if (!(h.squaredNorm() > 0.0) || one.shown.rank() == 0) continue;
    kind.chi_squared +=
        squared(h, one.shown, score, one.noise, problem.weights(kind.targets[one.k]));
  }
}

/// How the scores scatter, and with which scales all would count alike.
void find_scatter(std::span<const Score> scores, TargetsOfOneKind& kind) {
  const Index n = scores.front().score.size();
  Together all(n);
  for (const Score& one : scores) all.add(one);
  const Shown by_all(all.normal);
  const MatrixXd inverse = product(by_all.directions, by_all.directions.transpose());
  const VectorXd of_kind = -by_all.solve(all.sum);
  const auto count = static_cast<double>(scores.size());
  const double part = static_cast<double>(by_all.rank()) / count;  // of one, if all count alike
  kind.scores = MatrixXd::Zero(n, n);
  std::vector<double> leverage;
  Together alike(n);
  for (const Score& one : scores) {
    const VectorXd h = one.score + one.normal * of_kind;
    const MatrixXd own = product(one.normal, inverse);
    leverage.push_back(own.trace());
    const VectorXd k = shortest_solution(MatrixXd::Identity(n, n) - own, h);
    kind.scores += k * k.transpose();
    if (leverage.back() > 0.0) alike.add(one, part / leverage.back());
  }
  kind.scores *= (count - 1.0) / count;
  const VectorXd middle = -Shown(alike.normal).solve(alike.sum);
  double squares = 0.0, degrees = -static_cast<double>(by_all.rank());
  for (std::size_t k = 0; k < scores.size(); ++k) {
    const Shown shown(scores[k].normal);
    degrees += static_cast<double>(shown.rank());
    if (!(leverage[k] > 0.0)) continue;
    const VectorXd h = scores[k].score + scores[k].normal * middle;
    squares += part / leverage[k] * (shown.directions.transpose() * h).squaredNorm();
  }
  for (const double one : leverage) {
    const bool is_known = one > 0.0 && squares > 0.0 && degrees > 0.0;
    kind.to_count_alike.push_back(is_known ? std::sqrt(one / part * squares / degrees) : 1.0);
  }
}

TargetsOfOneKind compared(const SceneProblem& problem, std::vector<std::size_t> targets,
                          std::span<const double> slopes, std::span<const double> residual,
                          const std::vector<Index>& free) {
  TargetsOfOneKind kind;
  kind.targets = std::move(targets);
  std::vector<Score> scores;
  for (const std::size_t t : kind.targets) {
    const Score& one = scores.emplace_back(score_of(problem, t, slopes, residual, free));
    const Shown shown(one.normal);
    kind.left.emplace_back(one.residual - one.slopes * shown.solve(one.score));
    kind.degrees_left.push_back(static_cast<double>(one.residual.size() - shown.rank()));
  }
  compare(problem, scores, kind);
  find_scatter(scores, kind);
  return kind;
}

}  // namespace

double TargetsOfOneKind::probability() const {
  return degrees > 0.0 ? 1.0 - theory::chi_squared_cdf(chi_squared, degrees) : 1.0;
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
  const std::span<const double> weights = problem.weights(t);
  std::vector<double> left(kind.left[k].begin(), kind.left[k].end());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] *= problem.scale(t) / std::sqrt(weights[i]);
  return left;
}

}  // namespace plastica::calibrate
