#include "sweeps/advise/for_engine/engine_advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "plastica/run/batch.hpp"
#include "sweeps/advise/advice_text.hpp"
#include "sweeps/advise/for_engine/engine_runs.hpp"
#include "sweeps/advise/for_engine/engine_scene.hpp"
#include "sweeps/advise/for_engine/engine_search.hpp"

namespace plastica::sweeps {
namespace {

/// What of the allowed error the reference may be off by itself.
constexpr double kReferenceShare = 0.25;
/// A motion in a plane that leaves it by no more stays in it [1].
constexpr double kInPlane = 1e-6;

EngineAdviceEnd end_of(AdviceEnd end) {
  switch (end) {
    case AdviceEnd::Interrupted: return EngineAdviceEnd::Interrupted;
    case AdviceEnd::TooManyRuns: return EngineAdviceEnd::TooManyRuns;
    case AdviceEnd::TooMuchWork: return EngineAdviceEnd::TooMuchWork;
    default: return EngineAdviceEnd::AtLimit;
  }
}

/// Runs a scene of ours; refuses what yields or breaks. @throws InputError
BatchRow elastic_run(const Setup& setup) {
  BatchRow row = run_case({"reference", setup.scene, setup.solver});
  if (row.response.status == Status::Rejected) throw InputError({}, "", "", row.reason);
  check_elastic(setup, row.response);
  return row;
}

/// The dampings that the exported joints may have.
std::vector<EngineDamping> dampings_of(const Setup& setup) {
  if (setup.solver.damping != Damping::None) return {EngineDamping::Scene};
  return {EngineDamping::None, EngineDamping::Numerical};
}

TriedEngineSetting tried_of(EngineSearch& search, const EngineRuns& runs,
                            const EngineSetting& setting) {
  const Deviation off = search.off(setting);
  return {setting, runs.time_step(setting), off.largest, off.reason, runs.work(setting)};
}

void add_notes(const Setup& setup, EngineAdvice& advice) {
  const Scene& scene = setup.scene;
  if (!scene.loads.empty()) {
    advice.notes.emplace_back(
        "loads are not in the file: set them before each step, at the present pose "
        "(mj_step1, mj_applyFT, mj_step2)");
  }
  const History& gravity = scene.gravity_history;
  const bool is_constant = gravity.factor == std::vector<double>{1.0};
  if (scene.gravity != std::array<double, 3>{} && !is_constant) {
    advice.notes.emplace_back(
        "gravity has a history here, and is constant in the file: set opt.gravity before each "
        "step");
  }
}

/// The dearest of the cheaper settings that were run and do not do.
std::optional<TriedEngineSetting> next_cheaper_of(EngineSearch& search, const EngineRuns& runs,
                                                  const EngineAdvice& advice) {
  std::optional<TriedEngineSetting> found;
  for (const TriedEngineSetting& one : advice.tried) {
    if (one.work >= advice.work || (found && one.work <= found->work)) continue;
    if (runs.end()) continue;
    const EngineVerdict verdict = search.judge(one.setting);
    if (verdict.within) continue;
    found = one;
    found->reason = verdict.reason;
  }
  return found;
}

void fill_found(EngineSearch& search, EngineRuns& runs, EngineAdvice& advice) {
  const EngineVerdict verdict = search.judge(advice.setting);
  advice.error = verdict.off.largest;
  advice.worst = verdict.off.quantity;
  advice.by_segments = verdict.by_segments;
  advice.by_steps = verdict.by_steps;
  advice.promised = advice.error + advice.reference_error;
  advice.time_step = runs.time_step(advice.setting);
  advice.work = runs.work(advice.setting);
  advice.beam = runs.beam(advice.setting);
  for (const auto& [setting, outcome] : runs.outcomes()) {
    advice.tried.push_back(tried_of(search, runs, setting));
  }
}

/// Whether all hinges of a joint, run together, come to what those of the plane come to.
bool stays_in_plane(const Setup& setup, const std::vector<WatchedProbe>& watched,
                    const AdviceOptions& options, EngineRuns& runs, const EngineSetting& setting) {
  const std::array<bool, 3> all{true, true, true};
  if (runs.turns() == all) return true;
  EngineRuns space(setup, watched, options);
  space.set_turns(all);
  return deviation(runs.run(setting), space.run(setting), watched).largest <= kInPlane;
}

}  // namespace

std::span<const std::string_view> advised_engines() {
  static constexpr std::array<std::string_view, 1> kWords{"mujoco"};
  return kWords;
}

EngineAdvice advise_for_mujoco(const Setup& setup, const AdviceOptions& options) {
  check_scene(setup.scene, setup.solver);
  (void)fineness_axes(setup);
  check_for_mujoco(setup);
  const WatchedProbes probes = engine_probes(setup, options.probes);
  (void)elastic_run(setup);
  EngineAdvice advice;
  advice.left_out = probes.left_out;
  AdviceOptions ours = options;
  ours.within = kReferenceShare * options.within;
  ours.budget = 0.0;
  ours.probes.clear();
  for (const WatchedProbe& one : probes.watched) ours.probes.push_back(one.name);
  advice.reference = advise(setup, ours);
  if (advice.reference.end != AdviceEnd::Found) {
    advice.end = advice.reference.end == AdviceEnd::Interrupted ? EngineAdviceEnd::Interrupted
                                                                : EngineAdviceEnd::NoReference;
    return advice;
  }
  const Setup finest = finer_setup(setup, advice.reference, 0.5);
  const Outcome reference = outcome_of(elastic_run(finest), probes.watched);
  advice.reference_error = advice.reference.verified;
  advice.reference_setting =
      setting_text(advice.reference.axes, own_setting(finest, advice.reference.axes));

  EngineRuns runs(setup, probes.watched, options);
  EngineSearch search(runs, reference, probes.watched, options.within - advice.reference_error);
  for (const EngineDamping damping : dampings_of(setup)) (void)search.search(damping);
  advice.setting = search.best().value_or(search.last());
  if (!search.best()) {
    advice.end = runs.end() ? end_of(*runs.end()) : EngineAdviceEnd::AtLimit;
  } else if (runs.end() == AdviceEnd::Interrupted) {
    advice.end = EngineAdviceEnd::Interrupted;
  } else {
    advice.end = EngineAdviceEnd::Found;
  }
  fill_found(search, runs, advice);
  advice.runs = runs.runs();
  advice.total_work = runs.total_work();
  if (advice.end != EngineAdviceEnd::Found) return advice;
  if (!stays_in_plane(setup, probes.watched, options, runs, advice.setting)) {
    throw InputError({}, "solver.level", "", "must be \"spatial\": the beam leaves its plane");
  }
  advice.next_cheaper = next_cheaper_of(search, runs, advice);
  add_notes(setup, advice);
  return advice;
}

}  // namespace plastica::sweeps
