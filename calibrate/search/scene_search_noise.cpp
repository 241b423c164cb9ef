#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/inference/scene_errors.hpp"
#include "calibrate/problem/target_noise.hpp"
#include "calibrate/search/scene_search.hpp"

/// How a search weights its targets by the noise that they turn out to have.
namespace plastica::calibrate {
namespace {

/// Of the fits that set a target's noise by what is left of it.
constexpr int kMaxRounds = 4;
constexpr double kSameNoise = 0.05;

}  // namespace

double SceneSearch::cost_of(std::size_t t) const {
  double sum = 0.0;
  for (const double r : problem_.unscaled(t, best_.residual)) sum += r * r;
  return sum;
}

std::vector<double> SceneSearch::costs() const {
  std::vector<double> all;
  for (std::size_t t = 0; t < problem_.targets().size(); ++t) all.push_back(cost_of(t));
  return all;
}

double SceneSearch::noise_left(std::size_t t) const {
  return std::sqrt(squares_left_[t] / degrees_left_[t]);
}

/// Residuals and cost over another noise. @return largest change of a scale [1]
double SceneSearch::rescale(std::vector<TargetNoise> noise) {
  double change = 0.0;
  for (std::size_t t = 0; t < noise.size(); ++t) {
    const double before = problem_.scale(t);
    // No scene is solved better than this, which keeps an exact curve from all the weight.
    constexpr double kMin = 1e-9;
    double& deviation = noise[t].deviation;
    if (!problem_.targets()[t].target.noise) {
      deviation = std::max(deviation, kMin * size_of(problem_.targets()[t]));
    }
    const double factor = before / deviation;
    if (factor == 1.0) continue;
    change = std::max(change, std::abs(factor - 1.0));
    const std::size_t first = problem_.first_residual(t);
    for (std::size_t i = 0; i < problem_.targets()[t].target.ordinate.size(); ++i) {
      best_.residual[first + i] *= factor;
    }
  }
  problem_.set_noise(std::move(noise));
  best_.cost = 0.0;
  for (const double r : best_.residual) best_.cost += r * r;
  return change;
}

/// Targets of one kind that may differ count alike, and by what they differ: by their noise the
/// quietest would have all the weight, against others and against priors as if it were the
/// material's.
std::vector<TargetNoise> SceneSearch::noise_of(const SceneErrors& errors) const {
  std::vector<TargetNoise> noise =
      noise_of_targets(problem_, costs(), degrees_left_, problem_.noise());
  for (const TargetsOfOneKind& kind : errors.kinds()) {
    if (!kind.may_differ()) continue;
    for (std::size_t k = 0; k < kind.targets.size(); ++k) {
      const std::size_t t = kind.targets[k];
      if (problem_.targets()[t].target.noise) continue;
      noise[t].deviation = problem_.scale(t) * kind.to_count_alike[k];
    }
  }
  return noise;
}

/// What values of its own leave of a target that differs from others of its kind is its noise.
void SceneSearch::set_left(const SceneErrors& errors) {
  degrees_left_ = degrees_left(problem_, errors.identifiable());
  squares_left_ = costs();
  for (const TargetsOfOneKind& kind : errors.kinds()) {
    if (!kind.may_differ()) continue;
    for (std::size_t k = 0; k < kind.targets.size(); ++k) {
      const std::vector<double> left = left_alone(problem_, kind, k);
      squares_left_[kind.targets[k]] =
          std::inner_product(left.begin(), left.end(), left.begin(), 0.0);
      degrees_left_[kind.targets[k]] = std::max(kind.degrees_left[k], 1.0);
    }
  }
}

/// Weights targets by the noise that they turn out to have. The last search is with the weights
/// that stand in the result, so that its values are their minimum.
void SceneSearch::settle_noise() {
  for (int round = 0;; ++round) {
    const SceneErrors errors(problem_, best_.x, best_.residual);
    set_left(errors);
    const double change = rescale(noise_of(errors));
    const bool alone =
        problem_.targets().size() == 1 && problem_.squares().residuals == problem_.samples();
    if (knows_noise_ || alone) return;
    const std::string stage = "weights " + std::to_string(round);
    LeastSquares again = search_from(stage, {best_.x}, options_.evaluations).front().found;
    if (again.outcome != LeastSquaresOutcome::NoStart) {
      best_ = std::move(again);
      pass_kinks("kinks of " + stage);
    }
    if (change < kSameNoise || round == kMaxRounds) break;
  }
  set_left(SceneErrors(problem_, best_.x, best_.residual));
}

}  // namespace plastica::calibrate
