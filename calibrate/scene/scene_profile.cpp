#include <algorithm>
#include <cmath>

#include "calibrate/fit/not_a_number.hpp"
#include "calibrate/scene/fitted_scenes.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::span<const double> values_of(const VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

/// The squares and, last, the break limit that the scenes have.
LeastSquaresProblem with_limit(SceneProblem& problem, const std::vector<double>& shares) {
  LeastSquaresProblem both = problem.squares();
  ++both.residuals;
  both.evaluate = [&problem, shares](std::span<const double> points, std::span<double> residuals,
                                     std::span<bool> found) {
    const std::size_t m = problem.squares().residuals;
    std::vector<double> squares(found.size() * m);
    problem.squares().evaluate(points, squares, found);
    const auto curves = problem.curves(points, found.size());  // has just run them
    for (std::size_t i = 0; i < found.size(); ++i) {
      double limit = 0.0;
      for (std::size_t part = 0; part < shares.size(); ++part) {
        if (shares[part] != 0.0) limit += shares[part] * strain_at_break(curves[part][i], 0.5);
      }
      std::copy_n(squares.data() + i * m, m, residuals.data() + i * (m + 1));
      residuals[i * (m + 1) + m] = limit;
    }
  };
  return both;
}

/// The profile of one free parameter: both its sides, then what they say.
class ParameterProfile {
 public:
  ParameterProfile(const FittedScenes& fitted, const FittedScenes::FreeParameter& free)
      : fitted_(fitted), free_(free) {
    factor_ = theory::student_t_quantile(0.5 + 0.5 * fitted.options().confidence,
                                         free.degrees_of_freedom);
    best_.x = fitted.best().x;
    best_.cost = fitted.best().cost;
    best_.value = free.is_break ? free.limit.value : best_.x[free.coordinate];
    set_scale();
  }

  /// Whether there is anything to follow: a limit may not depend on what is searched.
  bool depends() const { return std::isfinite(best_.value) && free_.gradient.squaredNorm() > 0.0; }

  ProfileSide side(SceneProblem& problem, bool up) const {
    ProfileOptions how;
    how.rise = factor_ * factor_ * ratio_;
    if (!free_.is_break) {
      return profile_coordinate(problem.squares(), best_, free_.coordinate, up, how);
    }
    return profile_function(with_limit(problem, free_.limit.shares), best_, up, how);
  }

  SceneProfile profile(const ProfileSide& low, const ProfileSide& high) const {
    SceneProfile profile;
    profile.threshold = factor_ * factor_;
    profile.low = end_of(low.end, -1.0, profile.low_end = low.why);
    profile.high = end_of(high.end, 1.0, profile.high_end = high.why);
    for (const ProfilePoint& point : low.points) add(point, profile);
    add({best_.value, best_.cost, best_.x}, profile);
    for (const ProfilePoint& point : high.points) add(point, profile);
    return profile;
  }

 private:
  /// Of given weights the covariance is not the inverse of the squares' curvature: there the
  /// threshold is stretched as the squared error is.
  void set_scale() {
    const VectorXd& gradient = free_.gradient;
    const double error2 = joint_moment(fitted_.errors().covariance(), gradient, gradient);
    const double inverse2 = joint_moment(fitted_.errors().inverse(), gradient, gradient);
    if (std::isfinite(error2) && error2 > 0.0) {
      ratio_ = error2 / inverse2;
      best_.step = factor_ * std::sqrt(error2);
      VectorXd along(gradient.size());
      for (Index i = 0; i < along.size(); ++i) {
        along[i] = 0.0;
        for (Index j = 0; j < along.size(); ++j) {
          const double term = gradient[j] != 0.0 ? fitted_.errors().inverse()(i, j) : 0.0;
          if (std::isfinite(term)) along[i] += term * gradient[j] / inverse2;
        }
      }
      best_.along.assign(values_of(along).begin(), values_of(along).end());
      return;
    }
    // At a bound, or not identified: without a scale of its own.
    constexpr double kShare = 0.02;
    const LeastSquaresProblem& squares = fitted_.problem().squares();
    const std::size_t k = free_.coordinate;
    best_.step =
        kShare * (free_.is_break ? std::abs(best_.value) : squares.upper[k] - squares.lower[k]);
  }

  double value_of(double at) const {
    if (free_.is_break) return at;
    return fitted_.problem().parameters().value(free_.coordinate, at);
  }

  /// The interval's end [SI]; a break's has its place between two samples in it, too.
  double end_of(double end, double side, ProfileEnd& why) const {
    if (!free_.is_break) return value_of(end);
    const double off = end - best_.value;
    const double reach =
        theory::half_interval(fitted_.options().confidence, std::abs(off) / factor_,
                              free_.degrees_of_freedom, free_.limit.halves);
    const double to = best_.value + side * reach;
    const double held = std::clamp(to, *free_.parameter->lower, *free_.parameter->upper);
    if (held != to) why = ProfileEnd::Bound;
    return held;
  }

  void add(const ProfilePoint& point, SceneProfile& profile) const {
    const SceneParameters& searched = fitted_.problem().parameters();
    profile.value.push_back(value_of(point.value));
    profile.rise.push_back((point.cost - best_.cost) / ratio_);
    for (std::size_t i = 0; i < point.x.size(); ++i) {
      profile.searched.push_back(searched.value(i, point.x[i]));
    }
  }

  const FittedScenes& fitted_;
  const FittedScenes::FreeParameter& free_;
  double factor_ = 1.0;
  double ratio_ = 1.0;
  ProfileStart best_;
};

/// A row for each point, value, cost and coordinates, and one for the end.
PieceRecord record_of(const ProfileSide& side) {
  PieceRecord record;
  for (const ProfilePoint& point : side.points) {
    record.rows.push_back({point.value, point.cost});
    record.rows.back().insert(record.rows.back().end(), point.x.begin(), point.x.end());
  }
  record.rows.push_back({side.end, static_cast<double>(side.why)});
  return record;
}

ProfileSide side_from(const PieceRecord& record) {
  ProfileSide side;
  side.end = record.rows.back()[0];
  side.why = static_cast<ProfileEnd>(static_cast<int>(record.rows.back()[1]));
  for (std::size_t i = 0; i + 1 < record.rows.size(); ++i) {
    const std::vector<double>& row = record.rows[i];
    side.points.push_back({row[0], row[1], {row.begin() + 2, row.end()}});
  }
  return side;
}

/// Of a break that nothing searched moves: its sampling alone.
SceneProfile unmoved(const FittedScenes& fitted, const FittedScenes::FreeParameter& free) {
  SceneProfile profile;
  const double factor =
      theory::student_t_quantile(0.5 + 0.5 * fitted.options().confidence, free.degrees_of_freedom);
  profile.threshold = factor * factor;
  const double reach = theory::half_interval(fitted.options().confidence, 0.0,
                                             free.degrees_of_freedom, free.limit.halves);
  const bool there = free.is_break && std::isfinite(free.limit.value);
  profile.low = there ? std::max(free.limit.value - reach, *free.parameter->lower) : kNan;
  profile.high = there ? std::min(free.limit.value + reach, *free.parameter->upper) : kNan;
  if (there) profile.low_end = profile.high_end = ProfileEnd::Crossed;
  return profile;
}

}  // namespace

std::vector<SceneProfile> profile_scenes(const FittedScenes& fitted, SceneWork& work) {
  std::vector<ParameterProfile> parameters;
  for (const auto& free : fitted.free()) parameters.emplace_back(fitted, free);
  const SceneWork::Stage stage{"profile", 2 * parameters.size(), fitted.options().threads};
  const std::vector<PieceRecord> made = work.make(stage, [&](std::size_t i) {
    const ParameterProfile& parameter = parameters[i / 2];
    if (!parameter.depends()) return PieceRecord();
    const auto problem = fitted.copy();
    PieceRecord side = record_of(parameter.side(*problem, i % 2 == 1));
    side.runs = problem->counters();
    return side;
  });
  std::vector<SceneProfile> profiles;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    profiles.push_back(parameters[i].depends() ? parameters[i].profile(side_from(made[2 * i]),
                                                                       side_from(made[2 * i + 1]))
                                               : unmoved(fitted, fitted.free()[i]));
  }
  return profiles;
}

}  // namespace plastica::calibrate
