#include "plastica/run/companions.hpp"

#include <algorithm>
#include <exception>
#include <memory>

#include "plastica/run/chain_run.hpp"
#include "plastica/run/guarded_cases.hpp"
#include "plastica/run/lane_pool.hpp"
#include "plastica/run/parameters.hpp"
#include "plastica/run/response_size.hpp"

namespace plastica {
namespace {

bool has_limit(const Material& material) {
  return material.break_strain || material.break_shear_strain;
}

/// Whether a limit on strains may end the path, or shorten its steps.
bool may_break(const Scene& scene) {
  return has_limit(scene.material) || scene.break_limit_x || scene.break_limit_y ||
         scene.break_limit_z || std::ranges::any_of(scene.regions, [](const Region& region) {
           return has_limit(region.material);
         });
}

std::string_view why_no_companion(const ChainModel& model) {
  const SolverOptions& options = model.options;
  if (options.analysis != Analysis::Statics) return "it is a motion";
  if (options.precision != Precision::Double) return "it runs in single precision";
  if (options.control != PathControl::Auto && options.control != PathControl::Load) {
    return "its path is not followed by the load (solver.control)";
  }
  if (options.buckling > 0 || options.frequencies > 0) return "it is asked for modes";
  if (may_break(model.scene)) return "it may break";
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
  check_memory(std::vector<std::size_t>(cases, response_size(model).needed_bytes()),
               static_cast<int>(cases));
  Workspace hooks;
  hooks.stop = stop;
  std::vector<Response> responses(cases);
  run_guarded(0, std::span(responses), [&](std::size_t first, std::span<Response> out) {
    std::vector<MaterialValues<double>> materials(out.size());
    std::vector<LaneCase> beams;
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k] = make_response(model);
      const ParameterValues at = values.subspan((first + k) * width, width);
      if (take_parameters(model, at, materials[k])) {
        beams.push_back({model.chain.get(), &materials[k], &hooks, &out[k]});
      } else {
        out[k].status = Status::InvalidParameter;
      }
    }
    if (!beams.empty()) run_beside(beams);
  });
  return responses;
}

std::vector<BatchRow> run_with_companions(std::span<const BatchCase> cases, StopFlag stop) {
  Workspace hooks;
  hooks.stop = stop;
  std::vector<BatchRow> rows(cases.size());
  std::vector<std::unique_ptr<Model>> models(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    rows[i].id = cases[i].id;
    try {
      check_memory(cases[i].scene, cases[i].options);
      models[i] = std::make_unique<Model>(prepare(cases[i].scene, cases[i].options));
    } catch (const InputError& error) {
      rows[i].response.status = Status::Rejected;
      rows[i].reason = error.what();
    }
  }
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (models[i]) which.push_back(i);
  }
  std::vector<Response> responses(which.size());
  run_guarded(0, std::span(responses), [&](std::size_t first, std::span<Response> out) {
    std::vector<LaneCase> beams;
    for (std::size_t k = 0; k < out.size(); ++k) {
      const Model& model = *models[which[first + k]];
      out[k] = make_response(model);
      beams.push_back({model.chain.get(), &model.material, &hooks, &out[k]});
    }
    run_beside(beams);
  });
  for (std::size_t k = 0; k < which.size(); ++k) {
    BatchRow& row = rows[which[k]];
    row.response = std::move(responses[k]);
    row.level = models[which[k]]->level;
    row.in_motion = is_motion(*models[which[k]]);
  }
  return rows;
}

}  // namespace plastica
