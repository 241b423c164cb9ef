#include <algorithm>
#include <cmath>

#include "calibrate/inference/fitted_scenes.hpp"
#include "calibrate/inference/parameter_profile.hpp"

namespace plastica::calibrate {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::span<const double> values_of(const VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

/// The squares and, last, the break limit that the scenes have.
LeastSquaresProblem with_limit(SceneProblem& problem, const std::vector<double>& fractions) {
  LeastSquaresProblem both = problem.squares();
  ++both.residuals;
  both.evaluate = [&problem, fractions](std::span<const double> points, std::span<double> residuals,
                                        std::span<bool> found) {
    const std::size_t m = problem.squares().residuals;
    std::vector<double> squares(found.size() * m);
    problem.squares().evaluate(points, squares, found);
    const auto curves = problem.curves(points, found.size());  // has just run them
    for (std::size_t i = 0; i < found.size(); ++i) {
      double limit = 0.0;
      for (std::size_t t = 0; t < fractions.size(); ++t) {
        if (fractions[t] != 0.0) limit += fractions[t] * strain_at_break(curves[t][i], 0.5);
      }
      std::copy_n(squares.data() + i * m, m, residuals.data() + i * (m + 1));
      residuals[i * (m + 1) + m] = limit;
    }
  };
  return both;
}

ProfiledParameter profiled(const FittedScenes& fitted, const FittedScenes::FreeParameter& free) {
  ProfiledParameter p;
  p.lower = *free.parameter->lower;
  p.upper = *free.parameter->upper;
  p.is_break = free.is_break;
  p.coordinate = free.coordinate;
  p.limit = free.limit.value;
  p.halves = free.limit.halves;
  const VectorXd& gradient = free.gradient;
  p.gradient.assign(values_of(gradient).begin(), values_of(gradient).end());
  p.squared_error = fitted.errors().moment(fitted.errors().covariance(), gradient, gradient);
  p.inverse = fitted.errors().moment(fitted.errors().inverse(), gradient, gradient);
  p.along.assign(p.gradient.size(), 0.0);
  for (Index i = 0; i < gradient.size(); ++i) {
    for (Index j = 0; j < gradient.size(); ++j) {
      const double term = gradient[j] != 0.0 ? fitted.errors().inverse()(i, j) : 0.0;
      if (!std::isfinite(term)) continue;
      p.along[static_cast<std::size_t>(i)] += term * gradient[j] / p.inverse;
    }
  }
  p.degrees_of_freedom = free.degrees_of_freedom;
  p.value_of = [&searched = fitted.problem().parameters()](std::size_t i, double at) {
    return searched.value(i, at);
  };
  return p;
}

/// A row for each point, value, cost and coordinates, and one for the end.
TaskRecord record_of(const ProfileSide& side) {
  TaskRecord record;
  for (const ProfilePoint& point : side.points) {
    record.rows.push_back({point.value, point.cost});
    record.rows.back().insert(record.rows.back().end(), point.x.begin(), point.x.end());
  }
  record.rows.push_back({side.end, static_cast<double>(side.why)});
  return record;
}

ProfileSide side_from(const TaskRecord& record) {
  ProfileSide side;
  side.end = record.rows.back()[0];
  side.why = static_cast<ProfileEnd>(static_cast<int>(record.rows.back()[1]));
  for (std::size_t i = 0; i + 1 < record.rows.size(); ++i) {
    const std::vector<double>& row = record.rows[i];
    side.points.push_back({row[0], row[1], {row.begin() + 2, row.end()}});
  }
  return side;
}

}  // namespace

std::vector<LikelihoodProfile> profile_scenes(const FittedScenes& fitted, SceneWork& work) {
  std::vector<ParameterProfile> parameters;
  for (const auto& free : fitted.free()) {
    parameters.emplace_back(profiled(fitted, free), fitted.problem().squares(), fitted.best().x,
                            fitted.best().cost, fitted.options().confidence);
  }
  const SceneWork::Stage stage{"profile", 2 * parameters.size(), fitted.options().threads};
  const std::vector<TaskRecord> made = work.make(stage, [&](std::size_t i) {
    const ParameterProfile& parameter = parameters[i / 2];
    if (!parameter.depends()) return TaskRecord();
    const auto problem = fitted.copy();
    const LeastSquaresProblem squares =
        parameter.is_break() ? with_limit(*problem, fitted.free()[i / 2].limit.fractions)
                             : problem->squares();
    TaskRecord side = record_of(parameter.side(squares, i % 2 == 1));
    side.runs = problem->counters();
    return side;
  });
  std::vector<LikelihoodProfile> profiles;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const ParameterProfile& parameter = parameters[i];
    profiles.push_back(parameter.depends()
                           ? parameter.profile(side_from(made[2 * i]), side_from(made[2 * i + 1]))
                           : parameter.unmoved());
  }
  return profiles;
}

}  // namespace plastica::calibrate
