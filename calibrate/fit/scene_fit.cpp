#include "calibrate/fit/scene_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "calibrate/fit/check_scene_fit.hpp"
#include "calibrate/fit/scene_fit_warnings.hpp"
#include "calibrate/fit/scene_laws.hpp"
#include "calibrate/inference/fitted_scenes.hpp"
#include "calibrate/inference/held_out.hpp"
#include "calibrate/inference/lack_of_fit.hpp"
#include "calibrate/inference/material_interval.hpp"
#include "calibrate/inference/not_a_number.hpp"
#include "calibrate/inference/scene_errors.hpp"
#include "calibrate/inference/scene_segments.hpp"
#include "calibrate/inference/scene_verdict.hpp"
#include "calibrate/inference/scene_work.hpp"
#include "calibrate/problem/scene_problem.hpp"
#include "calibrate/search/scene_search.hpp"

namespace plastica::calibrate {
namespace {

class SceneFit {
 public:
  SceneFit(std::span<const WeightedTarget> targets, const SceneFitOptions& options)
      : targets_(targets),
        options_(options),
        problem_(targets, options),
        search_(problem_, options),
        work_(problem_, options.hooks) {
    result_.objective = options.objective;
    result_.law = law_of(targets.front().setup.scene.material.hardening, options.parameters);
    check_break_levels(problem_, options);
    if (problem_.samples() <= problem_.parameters().size()) {
      throw InputError({}, "target", targets.front().target.name,
                       "has no more samples than the fit has parameters");
    }
  }

  SceneFitResult run() {
    search_.run();
    result_.search_runs = problem_.counters().runs;
    result_.starts = search_.starts();
    if (search_.found()) {
      explain();
    } else {
      // Bad input where no value of a parameter could help.
      if (search_.start_reverses()) {
        const SceneTarget& target = first_along_a_probe();
        throw InputError(target.abscissa_where, "abscissa.probe", target.abscissa_probe,
                         search_.first_reason());
      }
      result_.reason = "the scene gives no curve from the start values: " + search_.first_reason();
    }
    RunCounters counters = problem_.counters();
    counters.add(work_.counters());
    result_.runs = counters.runs;
    result_.failed_runs = counters.failed;
    result_.segment_iterations = counters.segment_iterations;
    return std::move(result_);
  }

 private:
  const SceneTarget& first_along_a_probe() const {
    const auto found = std::ranges::find_if(targets_, [](const WeightedTarget& each) {
      return each.target.kind == Abscissa::Probe || each.target.kind == Abscissa::Time;
    });
    return found == targets_.end() ? targets_.front().target : found->target;
  }

  void explain() {
    result_.status = FitStatus::Fitted;
    result_.outcome = search_.best().outcome;
    result_.degrees_of_freedom = degrees_of_freedom(problem_.noise());
    for (std::size_t t = 0; t < targets_.size(); ++t) add_target(t);
    const auto curves = problem_.curves(search_.best().x, 1);
    for (std::size_t t = 0; t < targets_.size(); ++t) {
      if (targets_[t].target.broke) result_.targets[t].break_strain = curves[t][0].strain.at;
    }
    SceneErrors errors(problem_, search_.best().x, search_.best().residual, options_.confidence);
    add_parameters(errors);
    for (std::size_t t = 0; t < targets_.size(); ++t) {
      result_.targets[t].fitted_error = errors.fitted_errors(t);
    }
    if (options_.segments_error) add_segments();
    for (std::size_t i = 0; i < result_.parameters.size(); ++i) {
      FittedParameter& p = result_.parameters[i];
      set_material_interval(options_.confidence, halves_[i], segments_of(i), p);
      // As wide as one interval with the same standard error.
      const double half = std::sqrt(3.0) * p.sampling_error;
      judge(half, segments_of(i), prior_fractions_[i], p);
    }
    warn(warning_of_end(search_.best().outcome, options_.evaluations));
    for (std::size_t t = 0; t < targets_.size(); ++t) {
      const SceneTarget& target = targets_[t].target;
      warn(warning_of_noise(target, stated_noise(t), search_.noise_left(t)));
      warn(warning_of_sign(target, result_.targets[t].fitted));
      warn(warning_of_offset(problem_, t, errors.slopes(), search_.best().residual));
      warn(warning_of_path(target, curves[t][0]));
    }
    for (std::size_t i = 0; i < result_.parameters.size(); ++i) {
      const FittedParameter& p = result_.parameters[i];
      add_warning(p, segments_of(i), result_.warnings);
      const auto has = [&](const Parameter& each) { return each.field->path == p.path; };
      const auto& prior = std::ranges::find_if(options_.parameters, has)->prior;
      if (!prior) continue;
      result_.prior_squared += std::pow((p.value - prior->mean) / prior->standard_deviation, 2);
      // x = (1 - f) d + f m, whose variances add up: that of d, what the curves say alone.
      const double f = prior_fractions_[i];
      const double of_prior = f * prior->standard_deviation;
      const double left = p.noise_error * p.noise_error - of_prior * of_prior;
      warn(contradicts_prior({.name = p.name(),
                              .value = p.value,
                              .mean = prior->mean,
                              .standard_deviation = prior->standard_deviation,
                              .fraction = f,
                              .error_alone = std::sqrt(std::max(left, 0.0)) / (1.0 - f)}));
    }
    const std::string next = laws_to_try(result_.law, loading_of(targets_), options_.laws);
    for (std::size_t t = 0; t < targets_.size(); ++t) {
      if (!is_met_alone(problem_, errors.kinds(), t)) {
        add_warning(result_.targets[t], result_.law, next, result_.warnings);
      }
    }
    warn_of_scenes(problem_, targets_, search_.best().x, result_.warnings);
    warn_of_specimens(targets_, result_.targets, errors.kinds(), result_.warnings);
    warn_of_limits(problem_, options_, result_.parameters, curves, result_.warnings);
    const FittedScenes fitted(problem_, options_, search_.best(), errors);
    result_.intervals = find_intervals(fitted, work_, result_.warnings);
    if (options_.laws.size() > 1) result_.held_out = held_out(fitted, work_);
    add_held();
  }

  /// Those that were not searched stand behind the free ones.
  void add_held() {
    for (const Parameter& p : options_.parameters) {
      if (p.role == ParameterRole::Free) continue;
      FittedParameter held;
      held.path = p.field->path;
      held.dimension = p.field->dimension;
      held.role = p.role;
      if (p.role == ParameterRole::Fixed) {
        held.value = *p.value;
      } else {
        const auto is_base = [&](const Parameter& other) { return other.field == p.tied_to; };
        const Parameter& base = *std::ranges::find_if(options_.parameters, is_base);
        const FittedParameter* fitted = result_.find_parameter(base.field->path);
        const bool fixed = base.role == ParameterRole::Fixed;
        held.value = p.factor * (fixed ? *base.value : fitted->value);
        if (!fixed) held.follow(*fitted, p.factor);
        if (!fixed) held.identified = fitted->verdict() != Verdict::NotIdentified;
      }
      held.start = held.lower = held.upper = held.value;
      result_.parameters.push_back(std::move(held));
    }
  }

  void add_segments() {
    result_.segments =
        fit_remeshed({problem_, options_, search_.best().x, result_.parameters, fractions_}, work_);
    if (!result_.segments) return;
    warn(warning_of_segments(result_, options_.segments_within));
    const auto unknown = [](const SegmentsError& e) { return e.trend == SegmentsTrend::Unknown; };
    const SceneSegments& made = *result_.segments;
    if (made.note.empty() || !std::ranges::all_of(made.parameters, unknown)) return;
    result_.warnings.push_back("the error of the segments is not known: " + made.note);
  }

  /// What the segments do to a parameter; of coupons, or if not asked for, nothing that is known.
  const SegmentsError& segments_of(std::size_t i) const {
    static const SegmentsError kUnknown;
    return result_.segments ? result_.segments->parameters[i] : kUnknown;
  }

  /// What the residuals say of a target's stated noise; nothing where none is stated, or they are
  /// too few to tell.
  StatedNoise stated_noise(std::size_t t) const {
    const auto& stated = targets_[t].target.noise;
    const TargetNoise& noise = problem_.noise()[t];
    if (!stated || noise.is_from_elsewhere()) return StatedNoise::Fits;
    return judge_stated_noise(search_.noise_left(t) / *stated, noise.degrees_left);
  }

  void warn(std::string warning) {
    if (!warning.empty()) result_.warnings.push_back(std::move(warning));
  }

  void add_target(std::size_t index) {
    const SceneTarget& target = targets_[index].target;
    TargetFit of_target;
    of_target.name = target.name;
    of_target.law = law_of(targets_[index].setup.scene.material.hardening, options_.parameters);
    of_target.level = problem_.model(index).level();
    of_target.samples = target.ordinate.size();
    of_target.cost = search_.cost_of(index);
    const TargetNoise& noise = problem_.noise()[index];
    of_target.noise =
        noise.pooled ? noise.deviation : target.noise.value_or(search_.noise_left(index));
    of_target.degrees_of_freedom = noise.degrees_of_freedom;
    if (noise.pooled) {
      result_.warnings.push_back(fmt::format(
          "{}: its {} samples leave {:.2g} degrees of freedom, too few to estimate its "
          "noise: the pooled noise of all targets is used for it, {:.3g} (SI); state its noise "
          "if it is known",
          target.name, of_target.samples, noise.degrees_left, of_target.noise));
    }
    const double largest = largest_size(target.ordinate);
    const double rms = std::sqrt(of_target.cost / static_cast<double>(of_target.samples));
    of_target.misfit_fraction = largest > 0.0 ? rms / largest : 0.0;
    const std::vector<double> residual = problem_.unscaled(index, search_.best().residual);
    for (std::size_t i = 0; i < of_target.samples; ++i) {
      of_target.fitted.push_back(target.ordinate[i] + residual[i]);
    }
    of_target.runs_test_p = runs_test_p(residual);
    in_runs_ = in_runs_ || are_in_runs(of_target.runs_test_p, autocorrelation(residual),
                                       static_cast<double>(residual.size()));
    is_doubted_ = is_doubted_ || stated_noise(index) == StatedNoise::TooSmall;
    of_target.break_strain = kNan;
    result_.targets.push_back(std::move(of_target));
  }

  void add_parameters(SceneErrors& errors) {
    const SceneParameters& searched = problem_.parameters();
    const Eigen::MatrixXd& covariance = errors.covariance();
    // By the coordinates: of a searched one its slope, of a limit its gradient.
    std::vector<Eigen::VectorXd> slopes;
    std::size_t next = 0;
    for (const Parameter& p : options_.parameters) {
      if (p.role != ParameterRole::Free) continue;
      FittedParameter fitted;
      fitted.path = p.field->path;
      fitted.dimension = p.field->dimension;
      fitted.lower = *p.lower;
      fitted.upper = *p.upper;
      std::vector<double> halves;
      BreakLimit limit;
      fractions_.emplace_back();
      Eigen::VectorXd slope = Eigen::VectorXd::Zero(covariance.rows());
      if (is_break(p)) {
        limit = errors.break_limit(p);
        fitted.value = fitted.start = std::clamp(limit.value, *p.lower, *p.upper);
        fitted.at_lower = limit.value < *p.lower;
        fitted.at_upper = limit.value > *p.upper;
        halves = limit.halves;
        fractions_.back() = limit.fractions;
        if (limit.disagree) {
          result_.warnings.push_back(fmt::format(
              "{}: the targets disagree, from {:.4g} to {:.4g}; the value is a mean of unlike ones",
              fitted.path, limit.min, limit.max));
        }
        slope = limit.slope;
      } else {
        fitted.value = searched.value(next, search_.best().x[next]);
        fitted.start = searched.value(next, 0.0);
        const Coordinate& coordinate = searched.coordinate(next);
        fitted.logarithmic = coordinate.logarithmic;
        const bool low = std::abs(search_.best().x[next] - coordinate.at(coordinate.lower)) <
                         std::abs(search_.best().x[next] - coordinate.at(coordinate.upper));
        fitted.at_lower = errors.at_bound(next) && low;
        fitted.at_upper = errors.at_bound(next) && !low;
        slope[static_cast<Eigen::Index>(next)] = std::abs(coordinate.slope(fitted.value));
        ++next;
      }
      const double degrees = errors.degrees_of_freedom(slope);
      fitted.degrees_of_freedom =
          errors.has_scatter() ? std::min(degrees, errors.correlated_degrees(slope)) : degrees;
      const auto error = [&](const Eigen::MatrixXd& c) {
        return fitted.at_bound() ? kNan : std::sqrt(errors.moment(c, slope, slope));
      };
      fitted.noise_error = error(errors.covariance());
      // Where the residuals are independent both estimate the same, and either may be larger.
      const double more = error(errors.correlated_covariance());
      fitted.misfit_error = std::isnan(more) ? kNan : 0.0;
      // That of targets that differ stands for both: their scales are not those of noise alone.
      if (errors.has_scatter()) fitted.noise_error = std::min(fitted.noise_error, more);
      if ((in_runs_ || is_doubted_ || errors.has_scatter()) && more > fitted.noise_error) {
        fitted.misfit_error = std::sqrt(more * more - fitted.noise_error * fitted.noise_error);
      }
      if (limit.scatter > 0.0) {
        fitted.misfit_error = std::hypot(fitted.misfit_error, limit.scatter);
        fitted.degrees_of_freedom = std::min(fitted.degrees_of_freedom, limit.scatter_degrees);
      }
      double squares = 0.0;
      for (const double half : halves) squares += half * half / 3.0;
      fitted.sampling_error = std::sqrt(squares);
      // Both count by one over the square of their standard deviations.
      const double of_prior = p.prior
                                  ? errors.moment(errors.inverse(), slope, slope) /
                                        (p.prior->standard_deviation * p.prior->standard_deviation)
                                  : 0.0;
      prior_fractions_.push_back(of_prior);
      halves_.push_back(std::move(halves));
      result_.parameters.push_back(std::move(fitted));
      slopes.push_back(std::move(slope));
    }
    add_correlation(slopes, errors);
  }

  void add_correlation(const std::vector<Eigen::VectorXd>& slopes, const SceneErrors& errors) {
    const std::size_t n = slopes.size();
    result_.correlation.assign(n * n, kNan);
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) {
        const double both =
            result_.parameters[a].scatter_error() * result_.parameters[b].scatter_error();
        result_.correlation[a * n + b] =
            a == b && both > 0.0 ? 1.0
                                 : errors.moment(errors.covariance(), slopes[a], slopes[b]) / both;
      }
    }
  }

  std::span<const WeightedTarget> targets_;
  const SceneFitOptions& options_;
  SceneProblem problem_;
  SceneSearch search_;
  SceneWork work_;           ///< after the search
  bool in_runs_ = false;     ///< whether a target's residuals are no noise
  bool is_doubted_ = false;  ///< whether a target's residuals are far above its stated noise
  std::vector<std::vector<double>> halves_;     ///< of the sampling intervals of parameters [SI]
  std::vector<double> prior_fractions_;         ///< in what is known of the parameters (n_free)
  std::vector<std::vector<double>> fractions_;  ///< of the targets in a break limit, by parameter
  SceneFitResult result_;
};

}  // namespace

SceneFitResult fit(std::span<const WeightedTarget> targets, const SceneFitOptions& options) {
  check_scene_fit(targets, options);
  return SceneFit(targets, options).run();
}

void check_scenes(std::span<const WeightedTarget> targets, const SceneFitOptions& options) {
  check_scene_fit(targets, options);
  (void)SceneFit(targets, options);
}

SceneFitResult fit_scene(const Setup& setup, const SceneTarget& target,
                         const SceneFitOptions& options) {
  const std::vector<WeightedTarget> targets{{setup, target}};
  return fit(targets, options);
}

}  // namespace plastica::calibrate
