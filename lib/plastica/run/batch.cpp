#include "plastica/run/batch.hpp"

#include <algorithm>
#include <ctime>
#include <mutex>
#include <utility>

#include "plastica/base/parallel_for.hpp"

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

/// Time that this thread has computed for so far [s]: what else the machine does is not counted.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double timed_run(const Model& model, Workspace& workspace, Response& response) {
  const double begin = thread_seconds();
  run(model, {}, workspace, response);
  return thread_seconds() - begin;
}

}  // namespace

BatchRow run_case(const BatchCase& one) {
  BatchRow row;
  row.id = one.id;
  try {
    const Model model = prepare(one.scene, one.options);
    row.level = model.level;
    row.response = make_response(model);
    Workspace workspace = make_workspace(model);
    workspace.on_break = one.on_break;
    double seconds = timed_run(model, workspace, row.response);
    for (int i = 0; i < one.timed_runs; ++i) {
      const double again = timed_run(model, workspace, row.response);
      seconds = i == 0 ? again : std::min(seconds, again);  // the first run warms up
    }
    row.response.seconds = seconds;
  } catch (const InputError& error) {
    row.response.status = Status::Rejected;
    row.reason = error.what();
  } catch (const std::exception& error) {
    // Out of memory, or a defect: the other cases go on.
    row.response = {};
    row.reason = error.what();
  }
  return row;
}

std::vector<BatchRow> run_batch(std::span<const BatchCase> cases, const BatchOptions& options) {
  std::vector<BatchRow> rows(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) rows[i].id = cases[i].id;
  Progress progress(options);
  parallel_for(cases.size(), {options.threads, options.stop}, [&](std::size_t i, int) {
    rows[i] = run_case(cases[i]);
    progress.one_more();
  });
  return rows;
}

void run_batch(std::size_t cases, const std::function<BatchCase(std::size_t)>& make,
               const std::function<void(std::size_t, BatchRow&&)>& take,
               const BatchOptions& options) {
  Progress progress(options);
  std::mutex taking;
  parallel_for(cases, {options.threads, options.stop}, [&](std::size_t i, int) {
    BatchRow row;
    try {
      row = run_case(make(i));
    } catch (const InputError& error) {
      row.response.status = Status::Rejected;
      row.reason = error.what();
    }
    {
      const std::lock_guard lock(taking);
      take(i, std::move(row));
    }
    progress.one_more();
  });
}

std::vector<Response> run_batch(const Model& model, std::span<const double> values,
                                std::size_t cases, const BatchOptions& options) {
  const std::size_t width = model.parameters.size();
  if (values.size() != cases * width) {
    throw InputError({}, "values", std::to_string(values.size()),
                     "must hold one value a parameter for each case");
  }
  std::vector<Response> responses(cases);
  Progress progress(options);
  parallel_for(cases, {options.threads, options.stop}, [&](std::size_t i, int) {
    responses[i] = make_response(model);
    Workspace workspace = make_workspace(model);
    run(model, values.subspan(i * width, width), workspace, responses[i]);
    progress.one_more();
  });
  return responses;
}

}  // namespace plastica
