#include "plastica/run/companions.hpp"

#include <algorithm>
#include <memory>

#include "plastica/run/break_watch.hpp"
#include "plastica/run/chain_run.hpp"
#include "plastica/run/guarded_cases.hpp"
#include "plastica/run/lane_pool.hpp"
#include "plastica/run/parameters.hpp"
#include "plastica/run/response_size.hpp"

namespace plastica {
namespace {

std::string_view why_no_companion(const ChainModel& model) {
  const SolverOptions& options = model.options;
  if (options.analysis != Analysis::Statics) return "it is a motion";
  if (options.precision != Precision::Double) return "it runs in single precision";
  if (options.control != PathControl::Auto && options.control != PathControl::Load) {
    return "its path is not followed by the load (solver.control)";
  }
  if (options.buckling > 0 || options.frequencies > 0) return "it is asked for modes";
  // A limit may end the path, or shorten its steps.
  if (has_break_limits(model.scene)) return "it may break";
  return "";
}

/// Whether one can take the steps of the other.
bool may_accompany(const ChainModel& one, const ChainModel& lead) {
  const auto& x = one.scene.supports;
  const auto& y = lead.scene.supports;
  return why_no_companion(one).empty() && one.level == lead.level && one.across == lead.across &&
         one.layout.size() == lead.layout.size() && one.stops == lead.stops &&
         one.recorded == lead.recorded && one.options.translation == lead.options.translation &&
         std::equal(x.begin(), x.end(), y.begin(), y.end(), [](const Support& s, const Support& t) {
           return s.kind == t.kind && s.held() == t.held();
         });
}

void run_alone(const LaneCase& one) {
  make_chain_program(*one.model)->run(*one.material, *one.hooks, *one.response);
}

void run_beside(std::span<const LaneCase> cases) {
  const ChainModel& lead = *cases.front().model;
  std::vector<LaneCase> together{cases.front()};
  std::vector<LaneCase> alone;
  const bool leads = why_no_companion(lead).empty();
  for (const LaneCase& one : cases.subspan(1)) {
    (leads && may_accompany(*one.model, lead) ? together : alone).push_back(one);
  }
  const std::vector<bool> done = make_chain_program(lead)->run_with(together);
  if (cases.front().response->status != Status::Completed) return;
  for (std::size_t i = 0; i < together.size(); ++i) {
    if (!done[i]) alone.push_back(together[i]);
  }
  for (const LaneCase& one : alone) run_alone(one);
}

/// Runs the cases whose models there are. Without the first one none is run.
/// @param models  null: no case (n_cases); @param materials  likewise
std::vector<Response> run_beside(std::span<const Model* const> models,
                                 std::span<const MaterialValues<double>> materials, StopFlag stop) {
  Workspace hooks;
  hooks.stop = stop;
  std::vector<Response> responses(models.size());
  if (models.empty() || models.front() == nullptr) return responses;
  run_guarded(0, std::span(responses), [&](std::size_t first, std::span<Response> out) {
    std::vector<LaneCase> beams;
    for (std::size_t k = 0; k < out.size(); ++k) {
      const Model* model = models[first + k];
      if (model == nullptr) continue;
      out[k] = make_response(*model);
      beams.push_back({model->chain.get(), &materials[first + k], &hooks, &out[k]});
    }
    if (!beams.empty()) run_beside(beams);
  });
  return responses;
}

}  // namespace

std::string_view why_no_companion(const Model& model) {
  return model.chain ? why_no_companion(*model.chain) : "it is a coupon";
}

std::size_t most_companions(const Model& model) {
  if (!why_no_companion(model).empty()) return 0;
  const std::size_t beams = kMaxLaneBytes / response_size(model).needed_bytes();
  return beams > 1 ? beams - 1 : 0;
}

std::vector<Response> run_with_companions(const Model& model, std::span<const double> values,
                                          std::size_t cases, StopFlag stop) {
  const std::size_t width = model.parameters.size();
  if (!model.chain) return run_batch(model, values, cases, {.threads = 1, .stop = stop});
  check_memory(std::vector<std::size_t>(cases, response_size(model).needed_bytes()),
               static_cast<int>(cases));
  std::vector<const Model*> models(cases, &model);
  std::vector<MaterialValues<double>> materials(cases);
  for (std::size_t i = 0; i < cases; ++i) {
    if (!take_parameters(model, values.subspan(i * width, width), materials[i])) {
      models[i] = nullptr;
    }
  }
  std::vector<Response> responses = run_beside(models, materials, stop);
  for (std::size_t i = 0; i < cases; ++i) {
    if (models[i] == nullptr) responses[i].status = Status::InvalidParameter;
  }
  return responses;
}

std::vector<BatchRow> run_with_companions(std::span<const BatchCase> cases, StopFlag stop) {
  std::vector<BatchRow> rows(cases.size());
  std::vector<std::unique_ptr<Model>> prepared(cases.size());
  std::vector<const Model*> models(cases.size());
  std::vector<MaterialValues<double>> materials(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    try {
      check_memory(cases[i].scene, cases[i].options);
      prepared[i] = std::make_unique<Model>(prepare(cases[i].scene, cases[i].options));
    } catch (const InputError& error) {
      rows[i].response.status = Status::Rejected;
      rows[i].reason = error.what();
      continue;
    }
    if (!prepared[i]->chain) return run_batch(cases, {.threads = 1, .stop = stop});
    models[i] = prepared[i].get();
    materials[i] = prepared[i]->material;
  }
  std::vector<Response> responses = run_beside(models, materials, stop);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    rows[i].id = cases[i].id;
    if (models[i] == nullptr) continue;
    rows[i].response = std::move(responses[i]);
    rows[i].level = models[i]->level;
    rows[i].in_motion = is_motion(*models[i]);
  }
  return rows;
}

}  // namespace plastica
