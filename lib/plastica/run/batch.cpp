#include "plastica/run/batch.hpp"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <optional>
#include <utility>

#include "plastica/base/parallel_for.hpp"
#include "plastica/base/thread_seconds.hpp"
#include "plastica/run/guarded_cases.hpp"
#include "plastica/run/lane_pool.hpp"
#include "plastica/run/parameters.hpp"
#include "plastica/run/response_size.hpp"

namespace plastica {
namespace {

class Progress {
 public:
  explicit Progress(const BatchOptions& options) : options_(options) {}
  void one_more() {
    if (!options_.progress) return;
    const std::lock_guard lock(mutex_);
    options_.progress(++finished_);
  }

 private:
  const BatchOptions& options_;
  std::mutex mutex_;
  std::size_t finished_ = 0;
};

double timed_run(const Model& model, Workspace& workspace, Response& response) {
  const double begin = thread_seconds();
  run(model, {}, workspace, response);
  return thread_seconds() - begin;
}

/// Fills a row, or leaves in it why there is no response.
template <class Work>
void guarded(BatchRow& row, const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    row.response.status = Status::Rejected;
    row.reason = error.what();
  } catch (const std::exception& error) {
    // Out of memory, or a defect: the other cases go on.
    row.response = {};
    row.reason = error.what();
  }
}

void run_alone(const BatchCase& one, const Model& model, StopFlag stop, BatchRow& row) {
  Workspace workspace = make_workspace(model);
  workspace.on_break = one.on_break;
  workspace.stop = stop;
  double seconds = timed_run(model, workspace, row.response);
  for (int i = 0; i < one.timed_runs && row.response.status != Status::Interrupted; ++i) {
    const double again = timed_run(model, workspace, row.response);
    seconds = i == 0 ? again : std::min(seconds, again);  // the first run warms up
  }
  row.response.seconds = seconds;
}

using Take = std::function<void(std::size_t index, BatchRow&& row)>;

/// Lays out a case, and runs it or lets it wait in the pool for others of its shape.
void run_or_wait(std::size_t index, const BatchCase& one, StopFlag stop, LanePool& pool,
                 const Take& take) {
  WaitingCase waiting;
  waiting.index = index;
  BatchRow& row = waiting.row;
  row.id = one.id;
  waiting.hooks.on_break = one.on_break;
  waiting.hooks.stop = stop;
  bool waits = false;
  guarded(row, [&] {
    check_memory(one.scene, one.options);
    waiting.model = std::make_unique<Model>(prepare(one.scene, one.options));
    row.level = waiting.model->level;
    row.in_motion = is_motion(*waiting.model);
    row.response = make_response(*waiting.model);
    waits = waiting.model->chain && has_lanes(*waiting.model->chain) && one.timed_runs == 0;
    if (!waits) run_alone(one, *waiting.model, stop, row);
  });
  if (!waits) {
    take(index, std::move(row));
    return;
  }
  if (std::optional<LaneCases> ready = pool.add(std::move(waiting))) {
    run_lane_cases(std::move(*ready), take);
  }
}

/// Halves the largest groups until there is a group for each thread; but articulated motions are
/// stepped in registers, full or not.
void spread(std::size_t threads, std::vector<LaneCases>& groups) {
  const auto parts_of = [](const LaneCases& group) {
    return steps_in_lanes(*group.front().model->chain) ? 0 : group.size();
  };
  const auto fewer = [&](const LaneCases& a, const LaneCases& b) {
    return parts_of(a) < parts_of(b);
  };
  while (!groups.empty() && groups.size() < threads) {
    const auto largest = std::max_element(groups.begin(), groups.end(), fewer);
    const std::size_t parts = parts_of(*largest);
    if (parts < 2) return;
    const auto middle = largest->begin() + static_cast<std::ptrdiff_t>(parts / 2);
    LaneCases half(std::make_move_iterator(middle), std::make_move_iterator(largest->end()));
    largest->erase(middle, largest->end());
    groups.push_back(std::move(half));
  }
}

/// What still waits in the pools of all threads: those of one shape come together once more.
std::vector<LaneCases> left_over(std::vector<LanePool>& pools) {
  LanePool all;
  std::vector<LaneCases> left;
  for (LanePool& pool : pools) {
    for (LaneCases& cases : pool.release()) {
      for (WaitingCase& one : cases) {
        if (std::optional<LaneCases> ready = all.add(std::move(one))) {
          left.push_back(std::move(*ready));
        }
      }
    }
  }
  for (LaneCases& cases : all.release()) left.push_back(std::move(cases));
  spread(pools.size(), left);
  return left;
}

}  // namespace

std::string riding_of(const Model& model) {
  if (!model.chain) return "one by one: it is a coupon";
  const std::string_view why = why_alone(*model.chain);
  if (!why.empty()) return "one by one: " + std::string(why);
  return "side by side with up to " + std::to_string(lane_width(*model.chain) - 1) +
         " others of its shape";
}

BatchRow run_case(const BatchCase& one) {
  BatchRow row;
  row.id = one.id;
  guarded(row, [&] {
    check_memory(one.scene, one.options);
    const Model model = prepare(one.scene, one.options);
    row.level = model.level;
    row.in_motion = is_motion(model);
    row.response = make_response(model);
    run_alone(one, model, nullptr, row);
  });
  return row;
}

std::vector<BatchRow> run_batch(std::span<const BatchCase> cases, const BatchOptions& options) {
  std::vector<BatchRow> rows(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) rows[i].id = cases[i].id;
  run_batch(
      cases.size(), [&](std::size_t i) { return cases[i]; },
      [&](std::size_t i, BatchRow&& row) { rows[i] = std::move(row); }, options);
  return rows;
}

void run_batch(std::size_t cases, const std::function<BatchCase(std::size_t)>& make,
               const std::function<void(std::size_t, BatchRow&&)>& take,
               const BatchOptions& options) {
  Progress progress(options);
  std::mutex taking;
  const Take hand_over = [&](std::size_t i, BatchRow&& row) {
    // Nothing but the batch's own flag interrupts a case.
    if (row.response.status == Status::Interrupted) return;
    {
      const std::lock_guard lock(taking);
      take(i, std::move(row));
    }
    progress.one_more();
  };
  const ParallelOptions how{options.threads, options.stop};
  std::vector<LanePool> pools(static_cast<std::size_t>(resolved_threads(options.threads)));
  ParallelOptions dealt = how;
  dealt.next = options.next;
  parallel_for(cases, dealt, [&](std::size_t i, int worker) {
    std::optional<BatchCase> one;
    BatchRow rejected;
    try {
      one = make(i);
    } catch (const InputError& error) {
      rejected.response.status = Status::Rejected;
      rejected.reason = error.what();
    }
    if (one) {
      run_or_wait(i, *one, options.stop, pools[static_cast<std::size_t>(worker)], hand_over);
    } else {
      hand_over(i, std::move(rejected));
    }
  });
  if (is_raised(options.stop)) return;
  std::vector<LaneCases> left = left_over(pools);
  parallel_for(left.size(), how,
               [&](std::size_t k, int) { run_lane_cases(std::move(left[k]), hand_over); });
}

void run_batch(const Model& model, std::span<const double> values, std::size_t cases,
               const std::function<void(std::size_t, Response&&)>& take,
               const BatchOptions& options) {
  const std::size_t width = model.parameters.size();
  if (values.size() != cases * width) {
    throw InputError({}, "values", std::to_string(values.size()),
                     "must hold one value a parameter for each case");
  }
  const int threads = resolved_threads(options.threads);
  const std::size_t bytes = response_size(model).needed_bytes();
  check_memory(std::vector<std::size_t>(cases, bytes), threads);
  Progress progress(options);
  std::mutex taking;
  Workspace hooks;
  hooks.stop = options.stop;
  const auto finished = [&](std::size_t i, Response&& response) {
    if (response.status == Status::Interrupted) return;
    {
      const std::lock_guard lock(taking);
      take(i, std::move(response));
    }
    progress.one_more();
  };
  const auto values_of = [&](std::size_t i) { return values.subspan(i * width, width); };
  if (model.chain && has_lanes(*model.chain)) {
    const std::size_t together = std::min(lane_width(*model.chain, cases, threads),
                                          std::max(std::size_t{1}, kMaxLaneBytes / bytes));
    std::vector<std::unique_ptr<LaneProgram>> programs(static_cast<std::size_t>(threads));
    parallel_for((cases + together - 1) / together, {options.threads, options.stop},
                 [&](std::size_t group, int worker) {
                   const std::size_t first = group * together;
                   std::vector<Response> responses(std::min(cases - first, together));
                   auto& program = programs[static_cast<std::size_t>(worker)];
                   const auto run_lanes = [&](std::size_t from, std::span<Response> out) {
                     const std::size_t count = out.size();
                     std::vector<MaterialValues<double>> materials(count);
                     std::vector<LaneCase> lanes;
                     for (std::size_t k = 0; k < count; ++k) {
                       out[k] = make_response(model);
                       if (!take_parameters(model, values_of(from + k), materials[k])) {
                         out[k].status = Status::InvalidParameter;
                         continue;
                       }
                       lanes.push_back({model.chain.get(), &materials[k], &hooks, &out[k]});
                     }
                     if (lanes.empty()) return;
                     // What an exception has left behind serves no other case.
                     auto used = program ? std::move(program) : make_lane_program(*model.chain);
                     used->run(lanes);
                     program = std::move(used);
                   };
                   run_guarded(first, std::span(responses), run_lanes);
                   for (std::size_t k = 0; k < responses.size(); ++k) {
                     finished(first + k, std::move(responses[k]));
                   }
                 });
    return;
  }
  parallel_for(cases, {options.threads, options.stop}, [&](std::size_t i, int) {
    Response response;
    run_guarded(i, std::span(&response, 1), [&](std::size_t from, std::span<Response> out) {
      out[0] = make_response(model);
      Workspace workspace = make_workspace(model);
      workspace.stop = options.stop;
      run(model, values_of(from), workspace, out[0]);
    });
    finished(i, std::move(response));
  });
}

std::vector<Response> run_batch(const Model& model, std::span<const double> values,
                                std::size_t cases, const BatchOptions& options) {
  std::vector<Response> responses(cases);
  run_batch(
      model, values, cases,
      [&](std::size_t i, Response&& response) { responses[i] = std::move(response); }, options);
  return responses;
}

}  // namespace plastica
