#include "calibrate/scene/scene_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>

#include "calibrate/scene/check_scene_fit.hpp"
#include "calibrate/scene/scene_curve.hpp"

namespace plastica::calibrate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
/// Of the central differences at the solution, in scaled parameters: fibres that yield one after
/// the other, and Newton's tolerance, are smooth over it.
constexpr double kErrorStep = 1e-4;

/// A parameter that is searched, and its coordinate: ln(value/start), or the distance from the
/// start over the width of the bounds.
struct Moved {
  const Parameter* parameter = nullptr;
  double start = 0.0;
  bool logarithmic = false;

  double coordinate(double value) const {
    return logarithmic ? std::log(value / start)
                       : (value - start) / (*parameter->upper - *parameter->lower);
  }
  double value(double x) const {
    const double v =
        logarithmic ? start * std::exp(x) : start + x * (*parameter->upper - *parameter->lower);
    return std::clamp(v, *parameter->lower, *parameter->upper);
  }
  /// d value / d coordinate.
  double slope(double at) const { return logarithmic ? at : *parameter->upper - *parameter->lower; }
};

Moved moved_of(const Parameter& p, const Setup& setup) {
  Moved moved;
  moved.parameter = &p;
  moved.logarithmic =
      p.scale == ParameterScale::Logarithmic || (p.scale == ParameterScale::Auto && *p.lower > 0.0);
  const FieldValue scene = p.field->get(setup);
  const double middle =
      moved.logarithmic ? std::sqrt(*p.lower * *p.upper) : 0.5 * (*p.lower + *p.upper);
  const double* given = std::get_if<double>(&scene);
  const double start = p.value ? *p.value : given != nullptr ? *given : middle;
  moved.start = std::clamp(start, *p.lower, *p.upper);
  return moved;
}

class SceneFit {
 public:
  SceneFit(const Setup& setup, const SceneTarget& target, const SceneFitOptions& options)
      : target_(target), options_(options), setup_(with_fixed(setup, options)) {
    std::vector<const Field*> fields;
    for (const Parameter& p : options.parameters) {
      if (p.role != ParameterRole::Free || is_break(p)) continue;
      moved_.push_back(moved_of(p, setup_));
      fields.push_back(p.field);
    }
    curve_.emplace(setup_, target, std::move(fields));
    check_break();
    problem_.residuals = target.ordinate.size();
    for (const Moved& m : moved_) {
      problem_.lower.push_back(m.coordinate(*m.parameter->lower));
      problem_.upper.push_back(m.coordinate(*m.parameter->upper));
      problem_.start.push_back(0.0);
    }
    if (problem_.residuals <= moved_.size()) {
      throw InputError({}, "target", target.name,
                       "has no more samples than the fit has parameters");
    }
    problem_.residual = [this](std::span<const double> x, std::span<double> r) {
      if (!curve_->run(values_at(x))) return false;
      const std::vector<double>& y = curve_->ordinate();
      for (std::size_t i = 0; i < r.size(); ++i) r[i] = y[i] - target_.ordinate[i];
      return true;
    };
  }

  SceneFitResult run() {
    SceneFitResult result;
    search();
    if (best_.outcome == LeastSquaresOutcome::NoStart) {
      // Bad input where no value of a parameter could help.
      if (start_turns_)
        throw InputError({}, "abscissa_probe", target_.abscissa_probe, first_reason_);
      result.reason = "the scene gives no curve from the start values: " + first_reason_;
    } else {
      explain(result);
    }
    result.runs = curve_->runs();
    result.failed_runs = curve_->failed_runs();
    result.segment_iterations = curve_->segment_iterations();
    return result;
  }

 private:
  static Setup with_fixed(const Setup& setup, const SceneFitOptions& options) {
    Setup fixed = setup;
    for (const Parameter& p : options.parameters) {
      if (p.role == ParameterRole::Fixed) set_field(fixed, *p.field, *p.value, p.where);
    }
    return fixed;
  }

  void check_break() const {
    for (const Parameter& p : options_.parameters) {
      if (p.role != ParameterRole::Free || !is_break(p)) continue;
      const bool bends = p.field->material == MaterialField::BreakStrain;
      if (curve_->level() == (bends ? Level::Planar : Level::Twist)) continue;
      throw InputError(p.where, p.field->path, "",
                       bends ? "is fitted where the beam bends in a plane (solver.level)"
                             : "is fitted where the beam is twisted alone (solver.level)");
    }
  }

  std::vector<double> values_at(std::span<const double> x) const {
    std::vector<double> values(moved_.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = moved_[i].value(x[i]);
    return values;
  }

  void search() {
    LeastSquaresOptions how;
    how.max_evaluations = options_.evaluations;
    how.x_tolerance = options_.tolerance;
    std::mt19937_64 random(options_.seed);
    LeastSquaresProblem problem = problem_;
    for (int start = 0; start < options_.starts; ++start) {
      if (start > 0) {
        for (std::size_t i = 0; i < moved_.size(); ++i) {
          const double share = static_cast<double>(random() >> 11U) * 0x1p-53;
          problem.start[i] = problem.lower[i] + share * (problem.upper[i] - problem.lower[i]);
        }
      }
      LeastSquares found = minimize_squares(problem, how);
      if (start == 0) {
        first_reason_ = curve_->reason();
        start_turns_ = found.outcome == LeastSquaresOutcome::NoStart && curve_->turns();
      }
      if (found.outcome == LeastSquaresOutcome::NoStart) continue;
      if (best_.outcome == LeastSquaresOutcome::NoStart || found.cost < best_.cost) {
        best_ = std::move(found);
      }
    }
  }

  bool at_bound(std::size_t i) const {
    const double reach = 1e-9 * (problem_.upper[i] - problem_.lower[i]);
    return best_.x[i] <= problem_.lower[i] + reach || best_.x[i] >= problem_.upper[i] - reach;
  }

  void explain(SceneFitResult& result) {
    const auto samples = static_cast<double>(problem_.residuals);
    result.status = FitStatus::Fitted;
    result.outcome = best_.outcome;
    result.cost = best_.cost;
    double largest = 0.0;
    for (const double y : target_.ordinate) largest = std::max(largest, std::abs(y));
    const double rms = std::sqrt(best_.cost / samples);
    result.misfit_share = largest > 0.0 ? rms / largest : 0.0;
    for (std::size_t i = 0; i < best_.residual.size(); ++i) {
      result.fitted.push_back(target_.ordinate[i] + best_.residual[i]);
    }
    const double freedom = samples - static_cast<double>(moved_.size());
    result.noise = target_.noise.value_or(std::sqrt(best_.cost / freedom));
    result.degrees_of_freedom = target_.noise ? std::numeric_limits<double>::infinity() : freedom;
    set_covariance(result.noise);
    add_parameters(result);
  }

  /// C above, of the coordinates; NaN in rows of those that are not determined.
  void set_covariance(double noise) {
    const std::size_t n = moved_.size();
    covariance_ = MatrixXd::Constant(static_cast<Index>(n), static_cast<Index>(n), kNan);
    if (n == 0) return;
    const std::vector<double> slopes =
        residual_slopes(problem_, best_.x, best_.residual, kErrorStep);
    if (slopes.empty()) return;
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>
        all(slopes.data(), static_cast<Index>(problem_.residuals), static_cast<Index>(n));
    std::vector<Index> kept;
    for (std::size_t i = 0; i < n; ++i) {
      const auto k = static_cast<Index>(i);
      if (!at_bound(i) && all.col(k).squaredNorm() > 0.0) kept.push_back(k);
    }
    const MatrixXd j = all(Eigen::all, kept);
    const Eigen::FullPivLU<MatrixXd> normal(j.transpose() * j);
    if (!normal.isInvertible()) return;
    const MatrixXd c = noise * noise * normal.inverse();
    for (std::size_t a = 0; a < kept.size(); ++a) {
      for (std::size_t b = 0; b < kept.size(); ++b) {
        covariance_(kept[a], kept[b]) = c(static_cast<Index>(a), static_cast<Index>(b));
      }
    }
  }

  void add_parameters(SceneFitResult& result) {
    std::size_t next = 0;
    for (const Parameter& p : options_.parameters) {
      if (p.role != ParameterRole::Free) continue;
      SceneParameter fitted;
      fitted.path = p.field->path;
      if (is_break(p)) {
        set_break(p, fitted);
      } else {
        const Moved& moved = moved_[next];
        const auto k = static_cast<Index>(next);
        fitted.value = moved.value(best_.x[next]);
        fitted.at_bound = at_bound(next);
        fitted.standard_error = std::abs(moved.slope(fitted.value)) * std::sqrt(covariance_(k, k));
        ++next;
      }
      result.parameters.push_back(std::move(fitted));
    }
  }

  double break_strain_at(std::span<const double> x) {
    return curve_->run(values_at(x)) ? curve_->permanent_strain() : kNan;
  }

  void set_break(const Parameter& p, SceneParameter& fitted) {
    const double strain = break_strain_at(best_.x);
    const SceneBreak& broke = *target_.broke;
    double by_abscissa = 0.0;
    if (broke.half_interval > 0.0) {
      const auto below = curve_->permanent_strain_at(broke.at - broke.half_interval);
      const auto above = curve_->permanent_strain_at(broke.at + broke.half_interval);
      // Beyond the end of the path the slope is that before.
      by_abscissa = above && below ? (*above - *below) / (2.0 * broke.half_interval)
                    : below        ? (strain - *below) / broke.half_interval
                                   : kNan;
    }
    fitted.value = std::clamp(strain, *p.lower, *p.upper);
    fitted.at_bound = fitted.value != strain;
    const auto n = static_cast<Index>(moved_.size());
    VectorXd slope = VectorXd::Zero(n);
    std::vector<double> x = best_.x;
    double variance = by_abscissa * by_abscissa * broke.half_interval * broke.half_interval / 3.0;
    for (Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (at_bound(k)) continue;
      x[k] = best_.x[k] + kErrorStep;
      const double above = break_strain_at(x);
      x[k] = best_.x[k] - kErrorStep;
      slope[i] = (above - break_strain_at(x)) / (2.0 * kErrorStep);
      x[k] = best_.x[k];
    }
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < n; ++j) {
        if (slope[i] != 0.0 && slope[j] != 0.0) variance += slope[i] * covariance_(i, j) * slope[j];
      }
    }
    fitted.standard_error = fitted.at_bound ? kNan : std::sqrt(variance);
  }

  const SceneTarget& target_;
  const SceneFitOptions& options_;
  Setup setup_;
  std::vector<Moved> moved_;
  std::optional<SceneCurve> curve_;
  LeastSquaresProblem problem_;
  LeastSquares best_;
  std::string first_reason_;
  bool start_turns_ = false;
  MatrixXd covariance_;
};

}  // namespace

const SceneParameter& SceneFitResult::parameter(std::string_view name) const {
  for (const SceneParameter& p : parameters) {
    const std::string_view path = p.path;
    if (path == name || path.substr(path.rfind('.') + 1) == name) return p;
  }
  throw std::out_of_range("no fitted parameter " + std::string(name));
}

SceneFitResult fit_scene(const Setup& setup, const SceneTarget& target,
                         const SceneFitOptions& options) {
  check_scene_fit(target, options);
  return SceneFit(setup, target, options).run();
}

}  // namespace plastica::calibrate
