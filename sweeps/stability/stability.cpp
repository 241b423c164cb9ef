#include "sweeps/stability/stability.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <numeric>
#include <random>

#include "plastica/base/check.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/run/simulate.hpp"
#include "sweeps/run/limited_run.hpp"
#include "sweeps/stability/scan.hpp"

namespace plastica::sweeps::stability {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

std::vector<StabilityPoint> chosen_points(const StabilityOptions& options) {
  std::vector<StabilityPoint> chosen;
  for (StabilityPoint& point : stability_points()) {
    const auto named = [&](const std::string& part) {
      return point.id.find(part) != std::string::npos;
    };
    if (point.segment_steps > options.max_segment_steps) continue;
    if (!options.only.empty() && std::none_of(options.only.begin(), options.only.end(), named))
      continue;
    chosen.push_back(std::move(point));
  }
  if (options.sample == 0 || options.sample >= chosen.size()) return chosen;
  // Fisher and Yates, with a remainder whose bias is far below that of any sample.
  std::mt19937_64 random(options.seed);
  std::vector<std::size_t> order(chosen.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = 0; i < options.sample; ++i) {
    std::swap(order[i], order[i + random() % (order.size() - i)]);
  }
  order.resize(options.sample);
  std::sort(order.begin(), order.end());
  std::vector<StabilityPoint> sample;
  sample.reserve(order.size());
  for (const std::size_t i : order) sample.push_back(std::move(chosen[i]));
  return sample;
}

StabilityRow row_of(const StabilityPoint& point) {
  StabilityRow row;
  row.id = point.id;
  row.scene = point.scene->name;
  row.level = point.scene->level;
  row.analysis = point.scene->analysis;
  for (const AxisValue& value : point.at) {
    row.at.push_back({std::string(value.axis), std::string(axis_of(value.axis).unit), value.value});
  }
  return row;
}

void run_point(const StabilityPoint& point, const StabilityOptions& options, StabilityRow& row) {
  const auto began = Clock::now();
  row.begun = true;
  const StabilityCase made = point.scene->make(point.knobs);
  try {
    const double most = std::max(4.0 * point.segment_steps, options.min_segment_steps);
    const RunLimit limit{.steps = most / point.knobs.segments, .seconds = options.max_seconds};
    const Response response = run_limited(made.setup, limit, options.stop).row.response;
    if (response.status == Status::Interrupted && is_raised(options.stop)) {
      row.begun = false;
      return;
    }
    row.verdict = judge(made.setup, response, made.expected);
    row.status = response.status;
    row.energy_balance_error = response.energy_balance_error;
    row.segment_steps = response.counters.steps * point.knobs.segments;
  } catch (const InputError& error) {
    row.verdict = {Validity::Failed, error.what()};
    row.status = Status::Rejected;
  }
  row.seconds = seconds_since(began);
}

}  // namespace

std::vector<StabilityRow> run_stability(const StabilityOptions& options) {
  const std::vector<StabilityPoint> points = chosen_points(options);
  std::vector<StabilityRow> rows;
  rows.reserve(points.size());
  for (const StabilityPoint& point : points) rows.push_back(row_of(point));
  // The longest first, so that none is left alone at the end.
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].segment_steps > points[b].segment_steps;
  });
  std::mutex mutex;
  std::size_t finished = 0;
  parallel_for(order.size(), {.threads = options.threads, .stop = options.stop},
               [&](std::size_t i, int /*worker*/) {
                 run_point(points[order[i]], options, rows[order[i]]);
                 const std::lock_guard lock(mutex);
                 if (!rows[order[i]].begun) return;
                 ++finished;
                 if (options.progress) options.progress(rows[order[i]], finished, points.size());
               });
  return rows;
}

}  // namespace plastica::sweeps::stability
