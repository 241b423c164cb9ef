#include "calibrate/search/scene_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

#include "calibrate/problem/target_noise.hpp"
#include "calibrate/search/least_squares_search.hpp"
#include "calibrate/search/optimizer.hpp"
#include "calibrate/search/screening.hpp"
#include "plastica/theory/sampling.hpp"

namespace plastica::calibrate {
namespace {

/// Gauss-Newton steps that a search may take before the best are chosen, and how many of these go
/// on to the end: see tests/studies/README.md.
constexpr int kShortSteps = 6;
constexpr std::size_t kPolished = 2;
/// Searches side by side: as many points at once as fill lanes and threads.
constexpr std::size_t kTogether = 16;

/// From the least cost on; of ties the first comes first.
std::vector<std::size_t> ranked(const std::vector<SearchRecord>& records) {
  std::vector<std::size_t> order(records.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {},
                           [&](std::size_t k) { return cost_of_search(records[k].found); });
  return order;
}

}  // namespace

SceneSearch::SceneSearch(SceneProblem& problem, const SceneFitOptions& options)
    : problem_(problem), options_(options) {
  const std::span<const WeightedTarget> targets = problem.targets();
  knows_noise_ = std::all_of(targets.begin(), targets.end(),
                             [](const WeightedTarget& weighted) { return weighted.target.noise; });
  std::vector<TargetNoise> noise;
  for (const WeightedTarget& weighted : targets) {
    noise.push_back({.deviation = weighted.target.noise.value_or(size_of(weighted))});
  }
  problem.set_noise(std::move(noise));
}

void SceneSearch::run() {
  search();
  if (found()) settle_noise();
}

void SceneSearch::tell(std::string_view stage, std::size_t done, std::size_t total) const {
  if (!options_.hooks.progress) return;
  options_.hooks.progress(
      {stage, static_cast<int>(done), static_cast<int>(total), problem_.counters().runs});
}

std::vector<double> SceneSearch::searched_values(std::span<const double> x) const {
  std::vector<double> values = problem_.parameters().values(x);
  values.resize(x.size());
  return values;
}

/// Sobol's points within the bounds. The first is a corner; with a seed all are scrambled.
SceneSearch::Points SceneSearch::drawn(int count) const {
  const LeastSquaresProblem& squares = problem_.squares();
  const std::size_t n = squares.start.size();
  Points points(static_cast<std::size_t>(count));
  const std::vector<double> fractions = theory::sobol(points.size(), n, options_.seed);
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      const double width = squares.upper[i] - squares.lower[i];
      points[k].push_back(squares.lower[i] + fractions[k * n + i] * width);
    }
  }
  return points;
}

std::vector<double> SceneSearch::screened_costs(const Points& points) {
  const SceneFitHooks& hooks = options_.hooks;
  const std::vector<std::byte>* kept = hooks.find ? hooks.find("screen") : nullptr;
  if (kept != nullptr) {
    ScreenRecord record = screen_record_from(*kept);
    problem_.count(record.runs);
    return std::move(record.costs);
  }
  tell("screen", 0, points.size());
  const std::size_t m = problem_.squares().residuals;
  std::vector<double> all;
  for (const std::vector<double>& x : points) all.insert(all.end(), x.begin(), x.end());
  std::vector<double> residuals(points.size() * m);
  std::vector<std::size_t> own(points.size());
  std::iota(own.begin(), own.end(), std::size_t{0});
  const std::vector<PointRun> runs = problem_.evaluate(all, points.size(), residuals, own);
  ScreenRecord record;
  for (std::size_t k = 0; k < points.size(); ++k) {
    double cost = runs[k].found ? 0.0 : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < m; ++i) cost += residuals[k * m + i] * residuals[k * m + i];
    record.costs.push_back(cost);
    record.runs.add(runs[k].runs);
  }
  if (hooks.keep) hooks.keep("screen", bytes_of(record));
  tell("screen", points.size(), points.size());
  return std::move(record.costs);
}

/// The best of many points that lie apart.
SceneSearch::Points SceneSearch::screened_starts(int count) {
  const LeastSquaresProblem& squares = problem_.squares();
  const Points points = drawn(options_.screen);
  const std::vector<double> costs = screened_costs(points);
  std::vector<double> fractions;
  for (const std::vector<double>& x : points) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      fractions.push_back((x[i] - squares.lower[i]) / (squares.upper[i] - squares.lower[i]));
    }
  }
  Points chosen;
  for (const std::size_t k : choose_starts(fractions, costs, static_cast<std::size_t>(count))) {
    chosen.push_back(points[k]);
  }
  return chosen;
}

/// Searches from several points, as far as no earlier fit has kept what they found.
std::vector<SearchRecord> SceneSearch::search_from(std::string_view stage, const Points& starts,
                                                   int evaluations) {
  std::vector<SearchRecord> records(starts.size());
  std::vector<std::size_t> missing;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const auto& find = options_.hooks.find;
    const std::vector<std::byte>* kept = find ? find(kept_name(stage, k)) : nullptr;
    if (kept == nullptr) {
      missing.push_back(k);
      continue;
    }
    records[k] = search_record_from(*kept);
    problem_.count(records[k].runs);
  }
  for (std::size_t first = 0; first < missing.size(); first += kTogether) {
    const std::size_t many = std::min(kTogether, missing.size() - first);
    search_together(stage, starts, evaluations,
                    std::span<const std::size_t>(missing).subspan(first, many), records);
  }
  return records;
}

/// Some of the searches side by side: in each round what all of them want is run together.
void SceneSearch::search_together(std::string_view stage, const Points& starts, int evaluations,
                                  std::span<const std::size_t> which,
                                  std::vector<SearchRecord>& records) {
  const LeastSquaresOptions how{.max_evaluations = evaluations, .x_tolerance = options_.tolerance};
  LeastSquaresProblem problem = problem_.squares();
  const std::size_t m = problem.residuals;
  std::vector<LeastSquaresSearch> searches;
  for (const std::size_t k : which) {
    problem.start = starts[k];
    searches.emplace_back(problem, how);
  }
  std::size_t done = which.front();
  tell(stage, done, starts.size());
  for (bool first = true; done < which.front() + which.size(); first = false) {
    std::vector<double> points;
    std::vector<std::size_t> leads;  // of its own search: bits depend on no other one
    for (const LeastSquaresSearch& search : searches) {
      const std::size_t before = leads.size();
      points.insert(points.end(), search.points().begin(), search.points().end());
      for (const std::size_t lead : problem_.leads_of(search.points(), search.count())) {
        leads.push_back(before + lead);
      }
    }
    const std::size_t count = leads.size();
    std::vector<double> residuals(count * m);
    const std::vector<PointRun> runs = problem_.evaluate(points, count, residuals, leads);
    const auto found = std::make_unique<bool[]>(count);
    for (std::size_t i = 0; i < count; ++i) found[i] = runs[i].found;
    std::size_t next = 0;
    for (std::size_t s = 0; s < searches.size(); ++s) {
      const std::size_t many = searches[s].count();
      if (many == 0) continue;
      SearchRecord& record = records[which[s]];
      if (first) record.start = runs[next];
      for (std::size_t i = 0; i < many; ++i) record.runs.add(runs[next + i].runs);
      searches[s].take(std::span<const double>(residuals).subspan(next * m, many * m),
                       {found.get() + next, many});
      next += many;
      if (!searches[s].done()) continue;
      ++done;
      record.found = searches[s].result();
      if (options_.hooks.keep) options_.hooks.keep(kept_name(stage, which[s]), bytes_of(record));
    }
    tell(stage, done, starts.size());
  }
}

/// Goes on to the end with the best of searches that were cut short.
void SceneSearch::polish(std::vector<SearchRecord>& records) {
  std::vector<std::size_t> chosen;
  Points from;
  for (const std::size_t k : ranked(records)) {
    if (chosen.size() == kPolished) break;
    if (records[k].found.outcome == LeastSquaresOutcome::NoStart) break;
    chosen.push_back(k);
    from.push_back(records[k].found.x);
  }
  std::vector<SearchRecord> ends = search_from("polish", from, options_.evaluations);
  for (SearchRecord& record : records) {
    if (record.found.outcome == LeastSquaresOutcome::EvaluationsReached) {
      record.found.outcome = LeastSquaresOutcome::SetAside;
    }
  }
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    ends[i].found.evaluations += records[chosen[i]].found.evaluations;
    records[chosen[i]].found = std::move(ends[i].found);
  }
}

void SceneSearch::search() {
  const std::size_t n = problem_.squares().start.size();
  Points starts{problem_.squares().start};
  for (const StartPoint& further : options_.further_starts) {
    starts.push_back(problem_.parameters().point_at(further));
  }
  const bool alone = options_.algorithm != "auto";
  const bool several = !alone && n > 0 && options_.starts > 1;
  const bool screens = several && options_.screen > 0;
  if (several) {
    const int others = options_.starts - 1;
    Points more = screens ? screened_starts(others) : drawn(others);
    starts.insert(starts.end(), more.begin(), more.end());
  }
  const int few = kShortSteps * static_cast<int>(n + 1) + 1;
  if (alone) starts.resize(1);
  std::vector<SearchRecord> records =
      alone && options_.algorithm != kGaussNewton && n > 0
          ? std::vector<SearchRecord>{search_alone()}
          : search_from("search", starts,
                        screens ? std::min(few, options_.evaluations) : options_.evaluations);
  first_reason_ = records.front().start.reason;
  start_reverses_ = records.front().start.reversed;
  if (screens) polish(records);
  const std::size_t best = ranked(records).front();
  best_ = records[best].found;
  search_around();
  pass_kinks("kinks");
  records[best].found = best_;
  for (std::size_t k = 0; k < records.size(); ++k) {
    const LeastSquares& found = records[k].found;
    const bool any = found.outcome != LeastSquaresOutcome::NoStart;
    SceneStart& start = starts_.emplace_back();
    start.from = searched_values(starts[k]);
    if (any) start.to = searched_values(found.x);
    start.cost = cost_of_search(found);
    start.outcome = found.outcome;
    start.evaluations = found.evaluations;
  }
}

}  // namespace plastica::calibrate
