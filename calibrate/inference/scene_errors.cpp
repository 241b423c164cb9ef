#include "calibrate/inference/scene_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "calibrate/inference/not_a_number.hpp"
#include "calibrate/inference/score_covariance.hpp"
#include "calibrate/inference/small_matrices.hpp"
#include "calibrate/inference/unbounded_yield.hpp"

namespace plastica::calibrate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// In errors of the noise: a parameter that moves all curves together by less, from one of its
/// bounds to the other, does so by the rounding of their solutions.
constexpr double kMovesNothing = 1e-2;

/// How far a function of the coordinates must lie out of the directions that no curve shows, its
/// gradient over its size, to be one that the curves determine.
constexpr double kTakesPart = 1e-2;

}  // namespace

bool limits(MaterialField limit, const SceneModel& model, const WeightedTarget& weighted) {
  const bool torsion = model.level() == Level::Twist ||
                       (model.level() == Level::Coupon &&
                        weighted.setup.scene.drive.deformation == Deformation::Torsion);
  const bool bends = !torsion && model.level() != Level::Spatial;
  return limit == MaterialField::BreakStrain ? bends : torsion;
}

bool breaks_by(const Parameter& p, const SceneModel& model, const WeightedTarget& weighted) {
  return weighted.target.broke && limits(*p.field->material, model, weighted);
}

double limit_within(const StrainAtBreak& strain, bool ends) {
  return ends ? strain.at : 0.5 * (strain.before + strain.after);
}

double joint_moment(const MatrixXd& c, const VectorXd& a, const VectorXd& b) {
  double sum = 0.0;
  for (Index i = 0; i < a.size(); ++i) {
    for (Index j = 0; j < b.size(); ++j) {
      const double product = a[i] * b[j];
      if (product != 0.0) sum += product * c(i, j);
    }
  }
  return sum;
}

double BreakLimit::half() const { return std::accumulate(halves.begin(), halves.end(), 0.0); }

SceneErrors::SceneErrors(SceneProblem& problem, std::span<const double> x,
                         std::span<const double> residual, std::optional<double> confidence)
    : problem_(problem), x_(x.begin(), x.end()) {
  const LeastSquaresProblem& squares = problem.squares();
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const double reach = 1e-9 * (squares.upper[i] - squares.lower[i]);
    at_bound_.push_back(x_[i] <= squares.lower[i] + reach || x_[i] >= squares.upper[i] - reach);
  }
  set_covariance(residual, confidence);
}

VectorXd SceneErrors::weights() const {
  VectorXd w = VectorXd::Ones(static_cast<Index>(problem_.squares().residuals));
  for (std::size_t t = 0; t < problem_.targets().size(); ++t) {
    const std::span<const double> own = problem_.weights(t);
    w.segment(static_cast<Index>(problem_.first_residual(t)), static_cast<Index>(own.size())) =
        Eigen::Map<const VectorXd>(own.data(), static_cast<Index>(own.size()));
  }
  return w;
}

void SceneErrors::take_out_unbounded_yield(std::span<const double> residual, double confidence) {
  const std::vector<double> without =
      drop_unbounded_yield(problem_, x_, residual, at_bound_, confidence, slopes_);
  if (without.empty()) return;
  std::vector<double> there(residual.size());
  if (!problem_.evaluate(without, 1, there).front().found) return;
  std::vector<double> slopes = residual_slopes(problem_.squares(), without, there, kErrorStep);
  const std::size_t n = x_.size();
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (without[i % n] != x_[i % n]) slopes[i] = 0.0;
  }
  slopes_ = std::move(slopes);
}

void SceneErrors::set_covariance(std::span<const double> residual,
                                 std::optional<double> confidence) {
  const auto n = static_cast<Index>(x_.size());
  covariance_ = inverse_ = correlated_covariance_ = MatrixXd::Constant(n, n, kNan);
  if (n == 0) return;
  slopes_ = residual_slopes(problem_.squares(), x_, residual, kErrorStep);
  if (confidence) {
    take_out_unbounded_yield(residual, *confidence);
  }
  // Rows over the noise, times the root of their weight.
  const MatrixXd j = SlopeRows(slopes_.data(), static_cast<Index>(problem_.squares().residuals), n);
  const MatrixXd normal = gram(j);
  std::vector<Index> kept;
  std::vector<bool> left_out = at_bound_;
  for (Index k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double range = problem_.squares().upper[i] - problem_.squares().lower[i];
    left_out[i] = left_out[i] || !(std::sqrt(normal(k, k)) * range > kMovesNothing);
    if (!left_out[i]) kept.push_back(k);
  }
  identifiable_ = IdentifiableSlopes(slopes_, left_out);
  if (kept.empty()) return;
  const std::vector<Index> free = hold_unseen(normal, kept);
  if (free.empty()) return;
  const VectorXd w = weights();
  const MatrixXd inverse = inverse_of(kept_of(normal, free));
  // What is held has no scatter; what it moves along with is told by `unseen_`.
  const auto of_all = [&](const MatrixXd& own) {
    MatrixXd all = MatrixXd::Constant(n, n, kNan);
    set_kept(all, kept,
             MatrixXd::Zero(static_cast<Index>(kept.size()), static_cast<Index>(kept.size())));
    set_kept(all, free, own);
    return all;
  };
  const auto from_scores = [&](const MatrixXd& scores) {
    return of_all(between(inverse, kept_of(scores, free)));
  };
  covariance_ = from_scores(gram(j, w));
  inverse_ = of_all(inverse);
  for (std::size_t t = 0; t < problem_.targets().size(); ++t) {
    const auto first = static_cast<Index>(problem_.first_residual(t));
    const auto count = static_cast<Index>(problem_.weights(t).size());
    by_target_.push_back(from_scores(gram(j.middleRows(first, count), w.segment(first, count))));
  }
  kinds_ = targets_of_one_kind(problem_, slopes_, residual, free);
  for (const TargetsOfOneKind& kind : kinds_) {
    if (!kind.tell_scatter()) continue;
    scatter_.push_back(
        {of_all(between(inverse, kind.scores)), static_cast<double>(kind.targets.size() - 1)});
  }
  correlated_covariance_ = from_scores(correlated_scores(residual, free));
}

/// Finds the directions that no curve shows, and holds a coordinate for each of them. What the
/// curves determine does not depend on which, and its errors count that the others move.
/// @return  the coordinates that are left
std::vector<Index> SceneErrors::hold_unseen(const MatrixXd& normal,
                                            const std::vector<Index>& kept) {
  const UnitDirections directions(kept_of(normal, kept));
  const Index count = (directions.values.array() <= kNotIdentifiable).count();
  if (count == 0) return kept;
  unit_ = VectorXd::Zero(normal.rows());
  unit_(kept) = directions.size;
  unseen_ = MatrixXd::Zero(normal.rows(), count);
  unseen_(kept, Eigen::all) = directions.vectors.leftCols(count);
  std::vector<Index> free = kept;
  for (const Index held : held_against(directions.vectors.leftCols(count))) {
    std::erase(free, kept[static_cast<std::size_t>(held)]);
  }
  return free;
}

bool SceneErrors::determines(const VectorXd& gradient) const {
  if (unseen_.size() == 0) return true;
  const VectorXd own = unit_.cwiseProduct(gradient);
  return (unseen_.transpose() * own).norm() <= kTakesPart * own.norm();
}

double SceneErrors::moment(const MatrixXd& of, const VectorXd& a, const VectorXd& b) const {
  return determines(a) && determines(b) ? joint_moment(of, a, b) : kNan;
}

/// Of the scores of all targets, each of which may leave residuals in runs, or differ from others
/// of its kind, and of the priors.
MatrixXd SceneErrors::correlated_scores(std::span<const double> residual,
                                        const std::vector<Index>& free) const {
  const auto n = static_cast<Index>(x_.size());
  const std::span<const double> slopes = slopes_;
  const std::size_t samples = problem_.samples();
  MatrixXd sum = gram(MatrixXd(SlopeRows(slopes.data() + samples * x_.size(),
                                         static_cast<Index>(residual.size() - samples), n)));
  std::vector<bool> counted(problem_.targets().size(), false);
  for (const TargetsOfOneKind& kind : kinds_) {
    if (!kind.tell_scatter()) continue;
    MatrixXd own = MatrixXd::Zero(n, n);
    set_kept(own, free, kind.scores);
    sum += own;
    for (const std::size_t t : kind.targets) counted[t] = true;
  }
  for (std::size_t t = 0; t < problem_.targets().size(); ++t) {
    if (counted[t]) continue;
    const std::size_t first = problem_.first_residual(t);
    const std::size_t count = problem_.targets()[t].target.ordinate.size();
    const std::vector<double> scores = score_covariance(
        slopes.subspan(first * x_.size(), count * x_.size()), residual.subspan(first, count));
    sum += SlopeRows(scores.data(), n, n);
  }
  return sum;
}

double SceneErrors::correlated_degrees(const VectorXd& gradient) const {
  double rest = moment(correlated_covariance_, gradient, gradient);
  const double variance = rest;
  const double of_noise = degrees_of_freedom(gradient);
  if (!(variance > 0.0)) return of_noise;
  double squares = 0.0;
  for (const Scatter& one : scatter_) {
    const double own = joint_moment(one.covariance, gradient, gradient);
    squares += own * own / one.degrees;
    rest -= own;
  }
  rest = std::max(rest, 0.0);
  return variance * variance / (squares + rest * rest / of_noise);
}

double SceneErrors::degrees_of_freedom(const VectorXd& gradient) const {
  const double variance = moment(covariance_, gradient, gradient);
  // What no curve determines has the freedom of all.
  if (!(variance > 0.0)) return calibrate::degrees_of_freedom(problem_.noise());
  // Who is pooled has one estimate with the others that are.
  double pooled = 0.0, pooled_degrees = 0.0, squares = 0.0;
  for (std::size_t t = 0; t < by_target_.size(); ++t) {
    const TargetNoise& noise = problem_.noise()[t];
    const double own = joint_moment(by_target_[t], gradient, gradient);
    if (noise.pooled) {
      pooled += own;
      pooled_degrees = noise.degrees_of_freedom;
    } else if (own > 0.0) {
      squares += own * own / noise.degrees_of_freedom;
    }
  }
  if (pooled > 0.0) squares += pooled * pooled / pooled_degrees;
  return variance * variance / squares;
}

std::vector<double> SceneErrors::fitted_errors(std::size_t t) const {
  const std::size_t samples = problem_.targets()[t].target.ordinate.size();
  std::vector<double> errors(samples, 0.0);
  if (identifiable_.slopes().cols() == 0) return errors;
  // A direction that is not identifiable moves none of them: the inverse over the others.
  const MatrixXd& j = identifiable_.slopes();
  const MatrixXd covariance = between(identifiable_.inverse(), gram(j, weights()));
  const auto first = static_cast<Index>(problem_.first_residual(t));
  for (std::size_t i = 0; i < samples; ++i) {
    const VectorXd row = j.row(first + static_cast<Index>(i));
    const double unit = problem_.scale(t) / std::sqrt(problem_.weights(t)[i]);
    errors[i] = unit * std::sqrt(std::max(row.dot(covariance * row), 0.0));
  }
  return errors;
}

void SceneErrors::run_neighbours() {
  const std::size_t n = x_.size();
  std::vector<double> points = x_;
  for (std::size_t k = 0; k < n; ++k) {
    for (const double step : {kErrorStep, -kErrorStep}) {
      points.insert(points.end(), x_.begin(), x_.end());
      points[points.size() - n + k] += at_bound_[k] ? 0.0 : step;
    }
  }
  neighbours_ = problem_.curves(points, 1 + 2 * n);
}

BreakLimit SceneErrors::limit_of(std::size_t t) const {
  const std::vector<SceneCurve>& curves = neighbours_[t];
  const StrainAtBreak& strain = curves[0].strain;
  BreakLimit limit;
  const bool ends = std::isnan(strain.after);
  const auto middle = [&](const StrainAtBreak& s) { return limit_within(s, ends); };
  limit.value = middle(strain);
  limit.halves = {limit.value - strain.before};
  const std::size_t n = x_.size();
  limit.slope = VectorXd::Zero(static_cast<Index>(n));
  for (std::size_t k = 0; k < n; ++k) {
    if (at_bound_[k]) continue;
    // One-sided where the path does not get there on the other side.
    double above = middle(curves[1 + 2 * k].strain), below = middle(curves[2 + 2 * k].strain);
    double distance = 2.0 * kErrorStep;
    for (double* end : {&above, &below}) {
      if (!std::isnan(*end)) continue;
      *end = limit.value;
      distance = kErrorStep;
    }
    const double slope = (above - below) / distance;
    // What is less is rounding of the paths, along which no direction is one.
    constexpr double kNothing = 1e-6;
    limit.slope[static_cast<Index>(k)] =
        std::abs(slope) > kNothing * std::abs(limit.value) ? slope : 0.0;
  }
  return limit;
}

BreakLimit SceneErrors::break_limit(const Parameter& p) {
  if (neighbours_.empty()) run_neighbours();
  std::vector<BreakLimit> limits;
  std::vector<double> certainty;
  std::vector<std::size_t> broken;
  for (std::size_t t = 0; t < problem_.targets().size(); ++t) {
    if (!breaks_by(p, problem_.model(t), problem_.targets()[t])) continue;
    limits.push_back(limit_of(t));
    broken.push_back(t);
    const BreakLimit& limit = limits.back();
    double variance = limit.half() * limit.half() / 3.0;
    variance += moment(covariance_, limit.slope, limit.slope);
    certainty.push_back(1.0 / variance);
  }
  double total = 0.0;
  for (const double c : certainty) total += c;
  BreakLimit mean;
  mean.fractions.assign(problem_.targets().size(), 0.0);
  if (limits.size() == 1) {
    limits.front().fractions = std::move(mean.fractions);
    limits.front().fractions[broken.front()] = 1.0;
    return limits.front();
  }
  mean.slope = VectorXd::Zero(static_cast<Index>(x_.size()));
  for (std::size_t k = 0; k < limits.size(); ++k) {
    // Without noise, or where it is not known, all count alike.
    const double fraction =
        std::isfinite(total) ? certainty[k] / total : 1.0 / static_cast<double>(limits.size());
    mean.fractions[broken[k]] = fraction;
    mean.value += fraction * limits[k].value;
    mean.halves.push_back(fraction * limits[k].half());
    mean.slope += fraction * limits[k].slope;
  }
  mean.min = mean.max = limits.front().value;
  for (std::size_t k = 0; k < limits.size(); ++k) {
    constexpr double kFar = 4.0;
    mean.min = std::min(mean.min, limits[k].value);
    mean.max = std::max(mean.max, limits[k].value);
    const double off = limits[k].value - mean.value;
    mean.disagree = mean.disagree || off * off * certainty[k] > kFar * kFar;
  }
  if (mean.disagree && limits.size() > 2) {
    const auto count = static_cast<double>(limits.size());
    double squares = 0.0;
    for (std::size_t k = 0; k < limits.size(); ++k) {
      const double part = mean.fractions[broken[k]];
      squares += std::pow(part * (limits[k].value - mean.value) / (1.0 - part), 2);
    }
    mean.scatter = std::sqrt(squares * (count - 1.0) / count);
    mean.scatter_degrees = count - 1.0;
  }
  return mean;
}

}  // namespace plastica::calibrate
