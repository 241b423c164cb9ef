#include "calibrate/scene/scene_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "calibrate/scene/check_scene_fit.hpp"
#include "calibrate/scene/scene_errors.hpp"
#include "calibrate/scene/scene_problem.hpp"
#include "calibrate/scene/scene_verdict.hpp"
#include "plastica/theory/sampling.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
/// Of the fits that set a part's noise by what is left of it.
constexpr int kMostRounds = 4;
constexpr double kSameNoise = 0.05;

double largest_size(std::span<const double> values) {
  double largest = 0.0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  return largest;
}

class SceneFit {
 public:
  SceneFit(std::span<const ScenePart> parts, const SceneFitOptions& options)
      : parts_(parts), options_(options), problem_(parts, options) {
    check_break_levels(problem_, options);
    if (problem_.samples() <= problem_.parameters().size()) {
      throw InputError({}, "target", parts.front().target.name,
                       "has no more samples than the fit has parameters");
    }
    knows_noise_ = std::all_of(parts.begin(), parts.end(),
                               [](const ScenePart& part) { return part.target.noise; });
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const double range = largest_size(parts[i].target.ordinate);
      problem_.set_scale(i, parts[i].target.noise.value_or(range > 0.0 ? range : 1.0));
    }
  }

  SceneFitResult run() {
    search();
    if (best_.outcome == LeastSquaresOutcome::NoStart) {
      // Bad input where no value of a parameter could help.
      if (start_turns_) {
        throw InputError({}, "abscissa_probe", parts_.front().target.abscissa_probe, first_reason_);
      }
      result_.reason = "the scene gives no curve from the start values: " + first_reason_;
    } else {
      settle_noise();
      explain();
    }
    result_.runs = problem_.counters().runs;
    result_.failed_runs = problem_.counters().failed;
    result_.segment_iterations = problem_.counters().segment_iterations;
    return std::move(result_);
  }

 private:
  LeastSquares search_from(std::span<const double> start) {
    LeastSquaresOptions how;
    how.max_evaluations = options_.evaluations;
    how.x_tolerance = options_.tolerance;
    LeastSquaresProblem problem = problem_.squares();
    problem.start.assign(start.begin(), start.end());
    return minimize_squares(problem, how);
  }

  std::vector<double> searched_values(std::span<const double> x) const {
    std::vector<double> values = problem_.parameters().values(x);
    values.resize(x.size());
    return values;
  }

  void search() {
    const LeastSquaresProblem& squares = problem_.squares();
    const std::size_t n = squares.start.size();
    const auto others = static_cast<std::size_t>(options_.starts - 1);
    // The first of Sobol's points is a corner; with a seed all are scrambled.
    const std::vector<double> drawn =
        n > 0 ? theory::sobol(others, n, options_.seed) : std::vector<double>();
    for (std::size_t k = 0; k <= (n > 0 ? others : 0); ++k) {
      std::vector<double> from = squares.start;
      for (std::size_t i = 0; k > 0 && i < n; ++i) {
        const double share = drawn[(k - 1) * n + i];
        from[i] = squares.lower[i] + share * (squares.upper[i] - squares.lower[i]);
      }
      LeastSquares found = search_from(from);
      SceneStart start;
      start.from = searched_values(from);
      start.outcome = found.outcome;
      start.evaluations = found.evaluations;
      const bool any = found.outcome != LeastSquaresOutcome::NoStart;
      start.cost = any ? found.cost : std::numeric_limits<double>::infinity();
      if (any) start.to = searched_values(found.x);
      result_.starts.push_back(std::move(start));
      if (k == 0) {
        first_reason_ = problem_.reason();
        start_turns_ = !any && problem_.turned();
      }
      if (!any) continue;
      if (best_.outcome == LeastSquaresOutcome::NoStart || found.cost < best_.cost) {
        best_ = std::move(found);
      }
    }
  }

  /// Sum of the squares of a part, without its weight and scale [SI^2].
  double cost_of(std::size_t part) const {
    const std::size_t first = problem_.first_residual(part);
    double sum = 0.0;
    for (std::size_t i = 0; i < parts_[part].target.ordinate.size(); ++i) {
      sum += best_.residual[first + i] * best_.residual[first + i];
    }
    const double scale = problem_.scale(part);
    return sum * scale * scale / parts_[part].weight;
  }

  /// What the residuals of a part say of its noise: each has its share of the parameters.
  double noise_left(std::size_t part) const {
    const auto samples = static_cast<double>(parts_[part].target.ordinate.size());
    const auto taken =
        static_cast<double>(problem_.parameters().size()) / static_cast<double>(problem_.samples());
    return std::sqrt(cost_of(part) / (samples * (1.0 - taken)));
  }

  /// Weights parts by the noise that they turn out to have.
  void settle_noise() {
    for (int round = 0; !knows_noise_; ++round) {
      double change = 0.0;
      for (std::size_t part = 0; part < parts_.size(); ++part) {
        if (parts_[part].target.noise) continue;
        // Without any residual its range goes on to weight it.
        const double noise = noise_left(part);
        if (!(noise > 1e-12 * problem_.scale(part))) continue;
        const double factor = problem_.scale(part) / noise;
        change = std::max(change, std::abs(factor - 1.0));
        const std::size_t first = problem_.first_residual(part);
        for (std::size_t i = 0; i < parts_[part].target.ordinate.size(); ++i) {
          best_.residual[first + i] *= factor;
        }
        problem_.set_scale(part, noise);
      }
      best_.cost = 0.0;
      for (const double r : best_.residual) best_.cost += r * r;
      const bool alone = parts_.size() == 1 && problem_.squares().residuals == problem_.samples();
      if (alone || change < kSameNoise || round == kMostRounds) return;
      LeastSquares again = search_from(best_.x);
      if (again.outcome != LeastSquaresOutcome::NoStart) best_ = std::move(again);
    }
  }

  void explain() {
    result_.status = FitStatus::Fitted;
    result_.outcome = best_.outcome;
    const auto n = static_cast<double>(problem_.parameters().size());
    result_.degrees_of_freedom = knows_noise_ ? std::numeric_limits<double>::infinity()
                                              : static_cast<double>(problem_.samples()) - n;
    for (std::size_t part = 0; part < parts_.size(); ++part) add_part(part);
    const auto curves = problem_.curves(best_.x, 1);
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      if (parts_[part].target.broke) result_.parts[part].break_strain = curves[part][0].strain.at;
    }
    SceneErrors errors(problem_, best_.x, best_.residual);
    add_parameters(errors);
    if (best_.outcome == LeastSquaresOutcome::EvaluationsReached) {
      result_.warnings.push_back(fmt::format(
          "the search ended at its {} evaluations (fit.evaluations): better values may be near",
          options_.evaluations));
    }
    for (std::size_t part = 0; part < parts_.size(); ++part) warn_of_noise(part);
    for (const SceneParameter& p : result_.parameters) add_warning(p, result_.warnings);
    for (const ScenePartFit& part : result_.parts) add_warning(part, result_.warnings);
  }

  /// A stated noise that the residuals contradict.
  void warn_of_noise(std::size_t part) {
    constexpr double kFactor = 2.0;
    const auto& given = parts_[part].target.noise;
    if (!given) return;
    const double left = noise_left(part);
    if (left < kFactor * *given && left > *given / kFactor) return;
    result_.warnings.push_back(
        fmt::format("{}: a noise of {:.3g} is stated, but the residuals are of {:.3g} (SI)",
                    parts_[part].target.name, *given, left));
  }

  void add_part(std::size_t index) {
    const SceneTarget& target = parts_[index].target;
    ScenePartFit part;
    part.name = target.name;
    part.level = problem_.model(index).level();
    part.samples = target.ordinate.size();
    part.cost = cost_of(index);
    part.noise = target.noise.value_or(noise_left(index));
    const double largest = largest_size(target.ordinate);
    const double rms = std::sqrt(part.cost / static_cast<double>(part.samples));
    part.misfit_share = largest > 0.0 ? rms / largest : 0.0;
    const double unit = problem_.scale(index) / std::sqrt(parts_[index].weight);
    std::vector<double> residual;
    for (std::size_t i = 0; i < part.samples; ++i) {
      residual.push_back(unit * best_.residual[problem_.first_residual(index) + i]);
      part.fitted.push_back(target.ordinate[i] + residual.back());
    }
    part.runs_probability = runs_probability(residual);
    part.break_strain = kNan;
    result_.parts.push_back(std::move(part));
  }

  void add_parameters(SceneErrors& errors) {
    const SceneParameters& searched = problem_.parameters();
    const Eigen::MatrixXd& covariance = errors.covariance();
    const double factor =
        theory::student_t_quantile(0.5 + 0.5 * options_.confidence, result_.degrees_of_freedom);
    // By the coordinates: of a searched one its slope, of a limit its gradient.
    std::vector<Eigen::VectorXd> slopes;
    std::size_t next = 0;
    for (const Parameter& p : options_.parameters) {
      if (p.role != ParameterRole::Free) continue;
      SceneParameter fitted;
      fitted.path = p.field->path;
      fitted.dimension = p.field->dimension;
      fitted.lower = *p.lower;
      fitted.upper = *p.upper;
      double half = 0.0;
      Eigen::VectorXd slope = Eigen::VectorXd::Zero(covariance.rows());
      if (is_break(p)) {
        const BreakLimit limit = errors.break_limit(p);
        fitted.value = fitted.start = std::clamp(limit.value, *p.lower, *p.upper);
        fitted.at_bound = !std::isnan(limit.value) && fitted.value != limit.value;
        half = limit.half;
        if (limit.disagree) {
          result_.warnings.push_back(fmt::format(
              "{}: the targets disagree, from {:.4g} to {:.4g}; the value is a mean of unlike ones",
              fitted.path, limit.least, limit.most));
        }
        slope = limit.slope;
      } else {
        fitted.value = searched.value(next, best_.x[next]);
        fitted.start = searched.value(next, 0.0);
        fitted.at_bound = errors.at_bound(next);
        slope[static_cast<Eigen::Index>(next)] = std::abs(searched.slope(next, fitted.value));
        ++next;
      }
      double variance = 0.0;
      for (Eigen::Index i = 0; i < slope.size(); ++i) {
        for (Eigen::Index j = 0; j < slope.size(); ++j) {
          const double product = slope[i] * slope[j];
          if (product != 0.0) variance += product * covariance(i, j);
        }
      }
      const double noise_error = fitted.at_bound ? kNan : std::sqrt(variance);
      fitted.standard_error = std::sqrt(noise_error * noise_error + half * half / 3.0);
      fitted.interval_low = fitted.value - factor * noise_error - half;
      fitted.interval_high = fitted.value + factor * noise_error + half;
      judge(noise_error, half, fitted);
      result_.parameters.push_back(std::move(fitted));
      slopes.push_back(std::move(slope));
    }
    add_correlation(slopes, covariance);
  }

  void add_correlation(const std::vector<Eigen::VectorXd>& slopes,
                       const Eigen::MatrixXd& covariance) {
    const std::size_t n = slopes.size();
    result_.correlation.assign(n * n, kNan);
    const auto joint = [&](std::size_t a, std::size_t b) {
      double sum = 0.0;
      for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
        for (Eigen::Index j = 0; j < covariance.rows(); ++j) {
          const double product = slopes[a][i] * slopes[b][j];
          if (product != 0.0) sum += product * covariance(i, j);
        }
      }
      return sum;
    };
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) {
        const double both =
            result_.parameters[a].standard_error * result_.parameters[b].standard_error;
        result_.correlation[a * n + b] = a == b && both > 0.0 ? 1.0 : joint(a, b) / both;
      }
    }
  }

  std::span<const ScenePart> parts_;
  const SceneFitOptions& options_;
  SceneProblem problem_;
  bool knows_noise_ = false;
  LeastSquares best_;
  std::string first_reason_;
  bool start_turns_ = false;
  SceneFitResult result_;
};

}  // namespace

const SceneParameter& SceneFitResult::parameter(std::string_view name) const {
  for (const SceneParameter& p : parameters) {
    const std::string_view path = p.path;
    if (path == name || path.substr(path.rfind('.') + 1) == name) return p;
  }
  throw std::out_of_range("no fitted parameter " + std::string(name));
}

SceneFitResult fit_scenes(std::span<const ScenePart> parts, const SceneFitOptions& options) {
  check_scene_fit(parts, options);
  return SceneFit(parts, options).run();
}

void check_scenes(std::span<const ScenePart> parts, const SceneFitOptions& options) {
  check_scene_fit(parts, options);
  (void)SceneFit(parts, options);
}

SceneFitResult fit_scene(const Setup& setup, const SceneTarget& target,
                         const SceneFitOptions& options) {
  const std::vector<ScenePart> parts{{setup, target}};
  return fit_scenes(parts, options);
}

}  // namespace plastica::calibrate
