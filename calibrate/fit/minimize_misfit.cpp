#include "calibrate/fit/minimize_misfit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "calibrate/fit/optimizer.hpp"

namespace plastica::calibrate {
namespace {

/// ln 5: how far the global stage of `auto` looks around the start.
constexpr double kGlobalReach = 1.6094379124341003746;
constexpr double kEverywhere = 1e300;
/// How far the downhill simplex looks around the end of SLSQP, and how often at most.
constexpr double kPolishReach = 1e-2;
constexpr int kMostPolishes = 3;
/// Misfit, as a share of the largest stress, above which kinks can make several minima; how many
/// restarts look for them, and how high up the cost's parabola they begin.
constexpr double kCloseFit = 0.02;
constexpr int kRestarts = 16;
constexpr double kRestartRise = 0.1;
/// With three or more parameters of the stress (a hardening law's) there are other minima far away
/// too: how many starts look for them, as far around the start as the global stage, unless the
/// misfit is below this share of the largest stress.
constexpr std::size_t kManyParameters = 3;
constexpr double kExactFit = 0.002;
constexpr int kWideRestarts = 12;
/// A decrease of the cost that is not worth a polish, as a share of the cost.
constexpr double kWorthPolishing = 1e-10;

/// The misfit in coordinates of order one, counted and traced.
///
/// z_i = scale_i x_i, x_i the set's coordinates, and the cost over the largest stress squared:
/// algorithms that begin with a unit Hessian (SLSQP) need it to be about right. `rescale` takes
/// the curvatures at the best point for that, of Gauss and Newton: 2 sum w_i (dr_i/dx)^2.
class Search {
 public:
  Search(Misfit& misfit, const ParameterSet& parameters, const FitOptions& options,
         std::uint64_t seed, Solution& solution)
      : misfit_(misfit),
        parameters_(parameters),
        options_(options),
        seed_(seed),
        solution_(solution),
        values_(parameters.active().size()) {
    for (std::size_t k = 0; k < values_.size(); ++k) {
      const std::size_t index = parameters.active()[k];
      const ResolvedParameter& p = parameters.all()[index];
      solution_.trace.active.push_back(static_cast<std::uint32_t>(index));
      if (p.is_break) {
        break_ = k;
      } else {
        searched_.push_back(k);
        best_.push_back(parameters.coordinate(k, p.start));
      }
    }
    n_ = searched_.size();
    scale_.assign(n_, 1.0);
    start_ = best_;
  }

  std::size_t size() const { return n_; }

  /// Takes the start as it is: nothing is left to search but the break limit that goes with it.
  void evaluate_start() {
    best_cost_ = cost_at_best();
    found_ = std::isfinite(best_cost_);
    solution_.usable = found_;
  }

  /// Begins with the yield stress at the largest measured stress if that costs less: right for a
  /// plateau without noise, however short it is beside the elastic part.
  void try_largest_yield() {
    const std::vector<double> kept = best_;
    const double kept_cost = cost_at_best();
    for (std::size_t i = 0; i < n_; ++i) {
      const auto field = parameters_.all()[parameters_.active()[searched_[i]]].field->material;
      const bool yield =
          field == MaterialField::YieldStress || field == MaterialField::ShearYieldStress;
      if (yield) best_[i] = upper(i);
    }
    if (!(cost_at_best() < kept_cost)) best_ = kept;
    start_ = best_;
  }

  void rescale() {
    set_values(best_, false);
    const std::vector<double> curvature = misfit_.curvature(values_);
    for (std::size_t i = 0; i < n_; ++i) {
      const std::size_t k = searched_[i];
      const double slope = parameters_.slope(k, values_[k]);
      const double c = curvature[k] * slope * slope / misfit_.cost_unit();
      // A parameter that does not matter here keeps its scale. A power of two scales without
      // rounding: the same point is not evaluated again because its last bit has changed.
      if (std::isfinite(c) && c > kLeastCurvature) scale_[i] = power_of_two_near(std::sqrt(c));
    }
  }

  /// Runs one algorithm over the box from the best point. @return whether the cost got less
  bool stage(const std::string& algorithm, int evaluations, double reach) {
    MinimizeOptions how;
    how.algorithm = algorithm;
    how.max_evaluations = evaluations;
    how.x_tolerance = options_.stopping.parameter_tolerance;
    how.cost_tolerance = options_.stopping.cost_tolerance;
    how.seed = seed_;
    Problem problem;
    for (std::size_t i = 0; i < n_; ++i) {
      const double low = std::max(lower(i), best_[i] - reach);
      const double high = std::min(upper(i), best_[i] + reach);
      problem.lower.push_back(low * scale_[i]);
      problem.upper.push_back(high * scale_[i]);
      problem.start.push_back(std::clamp(best_[i], low, high) * scale_[i]);
    }
    problem.cost = [this](std::span<const double> z, std::span<double> gradient) {
      return cost(z, gradient);
    };
    const Minimum minimum = minimize(problem, how);
    solution_.stages.push_back(
        {algorithm, minimum.outcome, minimum.evaluations, minimum.cost * misfit_.cost_unit()});
    if (minimum.x.empty()) return false;
    solution_.usable = solution_.usable || minimum.usable;
    if (found_ && minimum.cost >= best_cost_) return false;
    for (std::size_t i = 0; i < n_; ++i) best_[i] = minimum.x[i] / scale_[i];
    best_cost_ = minimum.cost;
    found_ = true;
    return true;
  }

  /// Whether the slope at the best point promises a decrease that is worth looking for: with unit
  /// curvature, half of the squared gradient (at a bound, of its inward part).
  bool worth_polishing() {
    if (!found_) return false;
    std::vector<double> z(n_);
    std::vector<double> gradient(n_);
    for (std::size_t i = 0; i < n_; ++i) z[i] = best_[i] * scale_[i];
    const double f = cost(z, gradient);
    double decrease = 0.0;
    for (std::size_t i = 0; i < n_; ++i) {
      const bool blocked = gradient[i] > 0.0 ? best_[i] <= lower(i) : best_[i] >= upper(i);
      if (!blocked) decrease += 0.5 * gradient[i] * gradient[i];
    }
    return decrease > kWorthPolishing * f + kNoiseFloor;
  }

  /// SLSQP from the best point, and what its end on a kink needs.
  void descend(int evaluations) {
    rescale();
    stage("slsqp", evaluations, kEverywhere);
    for (int i = 0; i < kMostPolishes && worth_polishing(); ++i) {
      const bool better = stage("nelder-mead", evaluations, kPolishReach);
      if (!better || !stage("slsqp", evaluations, kEverywhere)) break;
    }
  }

  /// Whether a minimum was found that leaves nothing to look for elsewhere.
  bool settled() const {
    const bool ended = found_ && solution_.stages.back().outcome != "maxeval-reached";
    return ended && (has_many_parameters() ? fits_exactly() : fits_closely());
  }

  /// Goes back to the start, and puts the best point aside for `finish`.
  void begin_again() {
    if (found_) aside_ = Best{best_, best_cost_};
    best_ = start_;
    found_ = false;
    scale_.assign(n_, 1.0);
  }

  /// Looks for other minima near the best point: SLSQP from seeded points around it, at which the
  /// cost would be up to kRestartRise higher if it were a parabola.
  void restart_around(int evaluations) {
    const std::vector<double> centre = best_;
    const double reach = std::sqrt(2.0 * kRestartRise * best_cost_);
    std::mt19937_64 random(seed_);
    for (int i = 0; i < kRestarts; ++i) {
      const std::vector<double> kept = best_;
      for (std::size_t k = 0; k < n_; ++k) {
        best_[k] = centre[k] + reach * uniform(random) / scale_[k];
      }
      if (!stage("slsqp", evaluations, kEverywhere)) best_ = kept;
    }
  }

  /// Looks for minima far away until one fits closely: SLSQP from seeded points around the start,
  /// each with the scale of its own curvature.
  void restart_widely(int evaluations) {
    std::mt19937_64 random(~seed_);
    for (int i = 0; i < kWideRestarts && !fits_exactly(); ++i) {
      const std::vector<double> kept = best_;
      for (std::size_t k = 0; k < n_; ++k) {
        const double x = start_[k] + kGlobalReach * uniform(random);
        best_[k] = std::clamp(x, lower(k), upper(k));
      }
      rescale();
      if (!stage("slsqp", evaluations, kEverywhere)) best_ = kept;
    }
    rescale();
  }

  bool has_many_parameters() const { return n_ >= kManyParameters; }

  bool fits_exactly() const { return best_cost_ <= kExactFit * kExactFit; }

  bool fits_closely() const { return best_cost_ < kCloseFit * kCloseFit; }

  bool found() const { return found_; }

  void finish() {
    if (aside_ && !(found_ && best_cost_ <= aside_->cost)) {
      best_ = aside_->at;
      best_cost_ = aside_->cost;
      found_ = true;
    }
    if (!found_) {
      solution_.reason = "the model could not be run at any point of the box";
      return;
    }
    if (!solution_.usable) solution_.reason = "optimizer: " + solution_.stages.back().outcome;
    solution_.cost = best_cost_ * misfit_.cost_unit();
    cost_at_best();  // sets the break limit, too
    solution_.active = values_;
  }

 private:
  double cost_at_best() {
    std::vector<double> z(n_);
    for (std::size_t i = 0; i < n_; ++i) z[i] = best_[i] * scale_[i];
    return cost(z, {});
  }

  /// Below this, a curvature is rounding; a cost this small is an exact fit (rms 1e-12 of the
  /// largest stress).
  static constexpr double kLeastCurvature = 1e-20;
  static constexpr double kNoiseFloor = 1e-24;

  static double power_of_two_near(double x) {
    int exponent = 0;
    std::frexp(x, &exponent);
    return std::ldexp(1.0, exponent - 1);
  }

  /// 53 random bits as a number in [-1, 1).
  static double uniform(std::mt19937_64& random) {
    return 0x1p-52 * static_cast<double>(random() >> 11U) - 1.0;
  }

  double lower(std::size_t i) const { return parameters_.lower(searched_[i]); }
  double upper(std::size_t i) const { return parameters_.upper(searched_[i]); }

  void set_values(std::span<const double> x, bool scaled) {
    for (std::size_t i = 0; i < n_; ++i) {
      values_[searched_[i]] = parameters_.value(searched_[i], scaled ? x[i] / scale_[i] : x[i]);
    }
  }

  /// A free break limit is not searched but follows the others; see misfit.hpp.
  double cost(std::span<const double> z, std::span<double> gradient) {
    set_values(z, true);
    by_active_.resize(gradient.empty() ? 0 : values_.size());
    const double f = misfit_.search_cost(values_, by_active_);
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      const std::size_t k = searched_[i];
      gradient[i] =
          by_active_[k] * parameters_.slope(k, values_[k]) / (scale_[i] * misfit_.cost_unit());
    }
    if (break_ && std::isfinite(f)) {
      const ResolvedParameter& p = parameters_.all()[parameters_.active()[*break_]];
      values_[*break_] =
          std::clamp(misfit_.permanent_strain() / misfit_.break_factor(), p.lower, p.upper);
    }
    if (misfit_.was_run()) {
      Trace& trace = solution_.trace;
      trace.values.insert(trace.values.end(), values_.begin(), values_.end());
      trace.costs.push_back(f);
    }
    return f / misfit_.cost_unit();
  }

  Misfit& misfit_;
  const ParameterSet& parameters_;
  const FitOptions& options_;
  std::uint64_t seed_;
  Solution& solution_;
  std::size_t n_ = 0;                  ///< number of coordinates that are searched
  std::vector<std::size_t> searched_;  ///< active index of each
  std::optional<std::size_t> break_;   ///< active index of a free break limit
  std::vector<double> scale_;
  std::vector<double> values_;  ///< SI (n_active)
  std::vector<double> by_active_;
  std::vector<double> start_;  ///< the set's coordinates
  std::vector<double> best_;   ///< the set's coordinates; the start until a stage has run
  double best_cost_ = 0.0;
  bool found_ = false;
  struct Best {
    std::vector<double> at;
    double cost;
  };
  std::optional<Best> aside_;  ///< of the first descent
};

}  // namespace

Solution minimize_misfit(Misfit& misfit, const ParameterSet& parameters, const FitOptions& options,
                         std::uint64_t seed) {
  Solution solution;
  Search search(misfit, parameters, options, seed, solution);
  const StoppingRules& stop = options.stopping;
  if (search.size() == 0) {
    search.evaluate_start();
  } else if (options.algorithm != "auto") {
    const bool global = is_global(options.algorithm);
    search.rescale();
    search.stage(options.algorithm, global ? stop.global_evaluations : stop.local_evaluations,
                 kEverywhere);
  } else {
    search.try_largest_yield();
    if (stop.global_evaluations > 0) {
      search.descend(stop.local_evaluations);
      if (search.settled()) {
        search.finish();
        return solution;
      }
      search.begin_again();
      search.stage("crs", stop.global_evaluations, kGlobalReach);
    }
    search.descend(stop.local_evaluations);
    if (search.found() && search.has_many_parameters()) {
      search.restart_widely(stop.local_evaluations);
    }
    if (search.found() && !search.fits_closely()) search.restart_around(stop.local_evaluations);
  }
  search.finish();
  return solution;
}

}  // namespace plastica::calibrate
