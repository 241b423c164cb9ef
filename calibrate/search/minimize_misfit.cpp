#include "calibrate/search/minimize_misfit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "calibrate/problem/traced_misfit.hpp"
#include "calibrate/search/gauss_newton.hpp"
#include "calibrate/search/minimize_alone.hpp"
#include "calibrate/search/multi_start.hpp"
#include "calibrate/search/screening.hpp"

namespace plastica::calibrate {
namespace {

using Point = std::vector<double>;

/// ln 5: how far the global stage of `auto` looks around the start.
constexpr double kGlobalReach = 1.6094379124341003746;
/// Misfit, as a fraction of the largest stress, above which kinks can make several minima; how many
/// searches look for them, and how high up the cost's parabola they begin.
constexpr double kCloseFit = 0.02;
constexpr int kSearchesAround = 16;
constexpr double kRiseAround = 0.1;
/// With three or more parameters of the stress (a hardening law's) there are other minima far away
/// too, unless the misfit is below this fraction of the largest stress.
constexpr std::size_t kManyParameters = 3;
constexpr double kExactFit = 0.002;
/// A misfit below which nothing is left to look for, rounding of six digits.
constexpr double kNoMisfit = 1e-6;
constexpr std::size_t kSearchesWide = 10;
/// Evaluations of a search before it is compared with others: gauss-newton's patience, within which
/// it tells a kink from a slope.
constexpr int kShort = 8;
/// How many of the wide searches go on, and how far a basin that is known reaches: as far as
/// `search_around` looks.
constexpr MultiStartOptions kWide{.short_evaluations = kShort, .polished = 7, .rise = kRiseAround};
/// A basin found later is kept for a cost that is lower by more than this fraction: back-stresses
/// may be numbered the other way round there.
constexpr double kLower = 1e-6;
/// Tolerances of searches that are compared with each other, before the best goes to its end.
constexpr double kCompared = 1e-6;
constexpr double kComparedCost = 1e-9;

/// 53 random bits as a number in [-1, 1).
double uniform(std::mt19937_64& random) {
  return 0x1p-52 * static_cast<double>(random() >> 11U) - 1.0;
}

bool is_yield(const ResolvedParameter& p) {
  return p.field->material == MaterialField::YieldStress ||
         p.field->material == MaterialField::ShearYieldStress;
}

/// The sequence of stages, and the best point of all so far.
class Search {
 public:
  Search(Misfit& misfit, const ParameterSet& parameters, const FitOptions& options,
         std::uint64_t seed, Solution& solution)
      : misfit_(misfit, parameters, solution.trace),
        parameters_(parameters),
        options_(options),
        solution_(solution),
        problem_(misfit_.problem()) {
    how_.max_evaluations = options.stopping.local_evaluations;
    how_.x_tolerance = options.stopping.parameter_tolerance;
    how_.cost_tolerance = options.stopping.cost_tolerance;
    how_.seed = seed;
    best_.x = problem_.start;
    best_.cost = std::numeric_limits<double>::infinity();
  }

  std::size_t size() const { return misfit_.size(); }

  /// Takes the start as it is: nothing is left to search but the break limit that goes with it.
  void evaluate_start() {
    best_.cost = misfit_.cost(best_.x, {});
    solution_.usable = found();
  }

  /// Begins with the yield stress at the largest measured stress if that costs less: right for a
  /// plateau without noise, however short it is beside the elastic part.
  void try_largest_yield() {
    Point raised = problem_.start;
    for (std::size_t i = 0; i < raised.size(); ++i) {
      if (is_yield(parameters_.all()[misfit_.parameter(i)])) raised[i] = problem_.upper[i];
    }
    const double as_given = misfit_.cost(problem_.start, {});
    if (misfit_.cost(raised, {}) < as_given) problem_.start = raised;
  }

  /// One algorithm alone, from the start.
  void run_alone(const std::string& algorithm) {
    MinimizeOptions how = how_;
    how.algorithm = algorithm;
    if (is_global(algorithm)) how.max_evaluations = options_.stopping.global_evaluations;
    Minimum end = minimize_alone(problem_, how);
    listener()(algorithm, end);
    keep(std::move(end));
  }

  /// From the start to the bottom of its basin.
  void descend() {
    GaussNewton search(problem_, problem_.start, how_);
    Minimum end = search.advance(how_.max_evaluations);
    listener()(kGaussNewton, end);
    if (end.x.empty()) return;
    known_.push_back({search.x(), search.model()});
    keep(pass_kinks(problem_, std::move(end), how_, listener()));
    descended_ = best_.cost;
  }

  /// The best point to its end, unless that is where `descend` has ended and no step leads on.
  void descend_again() {
    Problem from = problem_;
    from.start = best_.x;
    MinimizeOptions smooth = how_;
    smooth.algorithm = kGaussNewton;
    Minimum end = minimize(from, smooth);
    listener()(kGaussNewton, end);
    if (end.cost < descended_ * (1.0 - kWorthwhile)) {
      keep(pass_kinks(problem_, std::move(end), how_, listener()));
    }
  }

  /// Whether a minimum was found that leaves nothing to look for elsewhere. One of many parameters
  /// that has gone to a bound is a sign of a minimum that is not the least.
  bool settled() const {
    const bool ended = found() && solution_.stages.back().outcome != "maxeval-reached";
    if (!ended || size() < kManyParameters) return ended && fits_closely();
    bool at_bound = false;
    for (std::size_t i = 0; i < size(); ++i) {
      at_bound = at_bound || best_.x[i] <= problem_.lower[i] || best_.x[i] >= problem_.upper[i];
    }
    return fits_exactly() && !at_bound;
  }

  /// Looks for minima far away: from the best of Sobol's points within the box and kGlobalReach
  /// around the start, and from further starts.
  void search_widely(std::span<const StartPoint> further) {
    std::vector<Point> starts = screened();
    for (const StartPoint& values : further) starts.push_back(point_at(values));
    MultiStartOptions options = kWide;
    options.known = best_.cost;
    Ends ends = search_from(problem_, starts, options, compared(), listener(), known_);
    for (Minimum& end : ends.apart) {
      if (end.cost < best_.cost * (1.0 - kLower)) keep(std::move(end));
    }
    alike_ = std::move(ends.alike);
    for (const Minimum& end : alike_) keep(end);
  }

  /// Looks for the least of the minima that kinks make near the best point: from where wide
  /// searches came near, and from seeded points around it, at which the cost would be up to
  /// kRiseAround higher if it were a parabola.
  void search_around() {
    const std::vector<double> curvature = curvatures(best_.x);
    const double reach = std::sqrt(2.0 * kRiseAround * best_.cost);
    std::mt19937_64 random(how_.seed);
    const bool few = size() < kManyParameters;
    const int evaluations = few ? how_.max_evaluations : std::min(kShort, how_.max_evaluations);
    std::vector<Minimum> points = std::move(alike_);
    for (int i = 0; i < kSearchesAround; ++i) {
      Point start = best_.x;
      for (std::size_t k = 0; k < size(); ++k) {
        const double x = start[k] + reach * uniform(random) / std::sqrt(curvature[k]);
        start[k] = std::clamp(x, problem_.lower[k], problem_.upper[k]);
      }
      Minimum end = GaussNewton(problem_, start, compared()).advance(evaluations);
      listener()(kGaussNewton, end);
      if (!end.x.empty()) points.push_back(std::move(end));
    }
    AgreementOptions options;
    // Searches in a plane are short.
    if (few) options.enough = options.max = points.size() + 1;
    best_ = least_of_basin(problem_, std::move(points), std::move(best_), options, compared(),
                           listener());
  }

  /// Whether the misfit is too small for minima by kinks that matter.
  bool fits() const {
    return size() < kManyParameters ? fits_closely() : best_.cost < kNoMisfit * kNoMisfit;
  }
  bool found() const { return std::isfinite(best_.cost); }

  void finish() {
    if (!found()) {
      solution_.reason = "the model could not be run at any point of the box";
      return;
    }
    if (!solution_.usable) solution_.reason = "optimizer: " + solution_.stages.back().outcome;
    solution_.cost = best_.cost * misfit_.unit();
    misfit_.cost(best_.x, {});  // sets the break limit, too
    solution_.active = misfit_.values();
  }

 private:
  bool fits_closely() const { return best_.cost < kCloseFit * kCloseFit; }
  bool fits_exactly() const { return best_.cost <= kExactFit * kExactFit; }

  /// How searches go that are compared with each other.
  MinimizeOptions compared() const {
    MinimizeOptions how = how_;
    how.x_tolerance = std::max(how.x_tolerance, kCompared);
    how.cost_tolerance = std::max(how.cost_tolerance, kComparedCost);
    return how;
  }

  std::vector<Point> screened() {
    if (options_.stopping.global_evaluations == 0) return {};
    Box box{problem_.lower, problem_.upper};
    for (std::size_t i = 0; i < size(); ++i) {
      box.lower[i] = std::max(box.lower[i], problem_.start[i] - kGlobalReach);
      box.upper[i] = std::min(box.upper[i], problem_.start[i] + kGlobalReach);
    }
    Minimum screened;
    screened.evaluations = options_.stopping.global_evaluations;
    screened.outcome = "maxeval-reached";
    const std::vector<Point> points =
        sobol_points(box, static_cast<std::size_t>(screened.evaluations), how_.seed);
    std::vector<double> costs;
    costs.reserve(points.size());
    for (const Point& point : points) costs.push_back(misfit_.cost(point, {}));
    screened.cost = *std::ranges::min_element(costs);
    listener()("sobol", screened);
    return starts_among(points, costs, box, kSearchesWide);
  }

  Point point_at(const StartPoint& values) const {
    Point x = problem_.start;
    for (std::size_t i = 0; i < size(); ++i) {
      const Field* field = parameters_.all()[misfit_.parameter(i)].field;
      for (const auto& [moved, value] : values) {
        if (moved != field) continue;
        x[i] = std::clamp(misfit_.coordinate(i, value), problem_.lower[i], problem_.upper[i]);
      }
    }
    return x;
  }

  StageListener listener() {
    return [this](std::string_view algorithm, const Minimum& end) {
      solution_.stages.push_back(
          {std::string(algorithm), end.outcome, end.evaluations, end.cost * misfit_.unit()});
      solution_.usable = solution_.usable || end.usable;
    };
  }

  void keep(Minimum end) {
    if (!end.x.empty() && end.cost < best_.cost) best_ = std::move(end);
  }

  /// Second derivatives of the cost by the coordinates after Gauss and Newton; 1 of those that do
  /// not matter (n).
  std::vector<double> curvatures(const Point& x) {
    const std::size_t n = size();
    std::vector<double> gradient(n), normal(n * n), curvature(n, 1.0);
    if (!std::isfinite(misfit_.squares(x, gradient, normal))) return curvature;
    for (std::size_t i = 0; i < n; ++i) {
      const double c = 2.0 * normal[i * n + i];
      if (std::isfinite(c) && c > kMinCurvature) curvature[i] = c;
    }
    return curvature;
  }

  TracedMisfit misfit_;
  const ParameterSet& parameters_;
  const FitOptions& options_;
  Solution& solution_;
  Problem problem_;
  MinimizeOptions how_;
  Minimum best_;
  std::vector<Basin> known_;    ///< where smooth searches ended
  std::vector<Minimum> alike_;  ///< wide searches that came near one of these
  double descended_ = std::numeric_limits<double>::infinity();  ///< where `descend` ended
};

}  // namespace

Solution minimize_misfit(Misfit& misfit, const ParameterSet& parameters, const FitOptions& options,
                         std::uint64_t seed, std::span<const StartPoint> further) {
  Solution solution;
  Search search(misfit, parameters, options, seed, solution);
  if (search.size() == 0) {
    search.evaluate_start();
  } else if (options.algorithm != "auto") {
    search.run_alone(options.algorithm);
  } else {
    search.try_largest_yield();
    search.descend();
    if (!search.settled()) {
      search.search_widely(further);
      if (search.found() && !search.fits()) search.search_around();
      if (search.found()) search.descend_again();
    }
  }
  search.finish();
  return solution;
}

Solution descend_misfit(Misfit& misfit, const ParameterSet& parameters, const FitOptions& options) {
  Solution solution;
  Search search(misfit, parameters, options, options.seed, solution);
  if (search.size() == 0) {
    search.evaluate_start();
  } else {
    search.descend();
  }
  search.finish();
  return solution;
}

}  // namespace plastica::calibrate
