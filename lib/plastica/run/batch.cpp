#include "plastica/run/batch.hpp"

#include <mutex>

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

}  // namespace

std::vector<BatchRow> run_batch(std::span<const BatchCase> cases, const BatchOptions& options) {
  std::vector<BatchRow> rows(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) rows[i].id = cases[i].id;
  Progress progress(options);
  parallel_for(cases.size(), {options.threads, options.stop}, [&](std::size_t i, int) {
    try {
      rows[i].response = simulate(cases[i].scene, cases[i].options, cases[i].on_break);
    } catch (const InputError& error) {
      rows[i].response.status = Status::Rejected;
      rows[i].reason = error.what();
    }
    progress.one_more();
  });
  return rows;
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
