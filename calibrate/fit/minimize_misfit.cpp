#include "calibrate/fit/minimize_misfit.hpp"

#include <algorithm>
#include <cmath>

#include "calibrate/fit/optimizer.hpp"

namespace plastica::calibrate {
namespace {

/// ln 5: how far the global stage of `auto` looks around the start.
constexpr double kGlobalReach = 1.6094379124341003746;
/// How far the downhill simplex looks around the end of SLSQP, and how often at most.
constexpr double kPolishReach = 1e-3;
constexpr int kMostPolishes = 3;

/// The misfit in the optimizer's coordinates, counted and traced.
class Search {
 public:
  Search(Misfit& misfit, const ParameterSet& parameters, const FitOptions& options,
         std::uint64_t seed, Solution& solution)
      : misfit_(misfit), parameters_(parameters), options_(options), seed_(seed),
        solution_(solution), n_(parameters.active().size()), values_(n_) {
    solution_.trace.parameters = n_;
  }

  /// Runs one algorithm over the box; keeps the best point of all. @return whether it got better
  bool stage(const std::string& algorithm, int evaluations, const std::vector<double>& start,
             double reach) {
    MinimizeOptions how;
    how.algorithm = algorithm;
    how.max_evaluations = evaluations;
    how.x_tolerance = options_.stopping.parameter_tolerance;
    how.cost_tolerance = options_.stopping.cost_tolerance;
    how.seed = seed_;
    Problem problem;
    problem.start = start;
    for (std::size_t i = 0; i < n_; ++i) {
      const double low = std::max(parameters_.lower(i), start[i] - reach);
      const double high = std::min(parameters_.upper(i), start[i] + reach);
      problem.lower.push_back(low);
      problem.upper.push_back(high);
      problem.start[i] = std::clamp(start[i], low, high);
    }
    problem.cost = [this](std::span<const double> x, std::span<double> gradient) {
      return cost(x, gradient);
    };
    const Minimum minimum = minimize(problem, how);
    solution_.stages.push_back({algorithm, minimum.outcome, minimum.evaluations,
                                minimum.x.empty() ? 0.0 : minimum.cost});
    if (minimum.x.empty()) return false;
    const bool better = best_.empty() || minimum.cost < solution_.cost;
    if (better) {
      best_ = minimum.x;
      solution_.cost = minimum.cost;
    }
    solution_.usable = solution_.usable || minimum.usable;
    return better;
  }

  const std::vector<double>& best() const { return best_; }

  void finish() {
    if (best_.empty()) {
      solution_.reason = "the model could not be run at any point of the box";
      return;
    }
    if (!solution_.usable) solution_.reason = "optimizer: " + solution_.stages.back().outcome;
    for (std::size_t i = 0; i < n_; ++i) {
      solution_.active.push_back(parameters_.value(i, best_[i]));
    }
  }

 private:
  double cost(std::span<const double> x, std::span<double> gradient) {
    for (std::size_t i = 0; i < n_; ++i) values_[i] = parameters_.value(i, x[i]);
    const double f = misfit_.cost(values_, gradient);
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      gradient[i] *= parameters_.slope(i, values_[i]);
    }
    Trace& trace = solution_.trace;
    trace.values.insert(trace.values.end(), values_.begin(), values_.end());
    trace.costs.push_back(f);
    return f;
  }

  Misfit& misfit_;
  const ParameterSet& parameters_;
  const FitOptions& options_;
  std::uint64_t seed_;
  Solution& solution_;
  std::size_t n_;
  std::vector<double> values_;
  std::vector<double> best_;
};

}  // namespace

Solution minimize_misfit(Misfit& misfit, const ParameterSet& parameters, const FitOptions& options,
                         std::uint64_t seed) {
  Solution solution;
  Search search(misfit, parameters, options, seed, solution);
  std::vector<double> start;
  for (std::size_t i = 0; i < parameters.active().size(); ++i) {
    start.push_back(parameters.coordinate(i, parameters.all()[parameters.active()[i]].start));
  }
  constexpr double kEverywhere = 1e300;
  const StoppingRules& stop = options.stopping;
  if (options.algorithm != "auto") {
    const int most = is_global(options.algorithm) ? stop.global_evaluations : stop.local_evaluations;
    search.stage(options.algorithm, most, start, kEverywhere);
  } else {
    if (stop.global_evaluations > 0) {
      search.stage("crs", stop.global_evaluations, start, kGlobalReach);
    }
    search.stage("slsqp", stop.local_evaluations, search.best().empty() ? start : search.best(),
                 kEverywhere);
    for (int i = 0; i < kMostPolishes && !search.best().empty(); ++i) {
      const std::vector<double> from = search.best();
      if (!search.stage("nelder-mead", stop.local_evaluations, from, kPolishReach)) break;
      if (!search.stage("slsqp", stop.local_evaluations, std::vector<double>(search.best()),
                        kEverywhere)) {
        break;
      }
    }
  }
  search.finish();
  return solution;
}

}  // namespace plastica::calibrate
