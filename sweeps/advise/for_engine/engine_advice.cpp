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
Outcome elastic_run(const AdvisedEngine& engine, const Setup& setup,
                    const std::vector<WatchedProbe>& watched, const AdviceOptions& options) {
  const std::vector<BatchCase> cases{{"reference", setup.scene, setup.solver}};
  const BatchRow row = run_batch(cases, {.threads = 1, .stop = options.stop}).front();
  check_elastic(engine, setup, row.response);
  return outcome_of(row, watched);
}

/// The dampings that the exported joints may have.
std::vector<EngineDamping> dampings_of(const AdvisedEngine& engine, const Setup& setup) {
  if (setup.solver.damping != Damping::None) return {EngineDamping::Scene};
  if (!engine.damps_numerically) return {EngineDamping::None};
  return {EngineDamping::None, EngineDamping::Numerical};
}

TriedEngineSetting tried_of(EngineSearch& search, const EngineRuns& runs,
                            const EngineSetting& setting) {
  const Deviation off = search.off(setting);
  return {setting, runs.time_step(setting), off.largest, off.reason, runs.work(setting)};
}

void add_notes(const Setup& setup, EngineAdvice& advice) {
  const Scene& scene = setup.scene;
  if (!advice.engine->rule_note.empty()) advice.notes.emplace_back(advice.engine->rule_note);
  if (!scene.loads.empty()) {
    advice.notes.emplace_back(advice.engine->load_note);
  }
  const bool is_constant = scene.gravity_history.factor == std::vector<double>{1.0};
  if (scene.gravity != std::array<double, 3>{} && !is_constant) {
    advice.notes.emplace_back(advice.engine->gravity_note);
  }
  const bool moves = std::ranges::any_of(scene.supports, &Support::moves);
  if (moves) {
    advice.notes.emplace_back(advice.engine->clamp_note);
  }
}

/// The dearest of the cheaper settings that were run and do not do.
std::optional<TriedEngineSetting> next_cheaper_of(EngineSearch& search, const EngineRuns& runs,
                                                  const EngineAdvice& advice) {
  std::optional<TriedEngineSetting> found;
  for (const TriedEngineSetting& one : advice.tried) {
    if (one.work >= advice.work || (found && one.work <= found->work)) continue;
    if (runs.end() && one.error <= search.allowed()) continue;
    const EngineVerdict verdict = search.judge(one.setting);
    if (verdict.within) continue;
    found = one;
    found->reason = verdict.reason;
  }
  return found;
}

void fill_setting(EngineSearch& search, EngineRuns& runs, EngineAdvice& advice) {
  const EngineVerdict verdict = search.judge(advice.setting);
  advice.error = verdict.off.largest;
  advice.worst = verdict.off.quantity;
  advice.by_segments = verdict.by_segments;
  advice.by_steps = verdict.by_steps;
  advice.promised = advice.error + advice.reference_error;
  advice.time_step = runs.time_step(advice.setting);
  advice.work = runs.work(advice.setting);
  advice.beam = runs.beam(advice.setting);
  advice.tried.clear();
  for (const auto& [setting, outcome] : runs.outcomes()) {
    advice.tried.push_back(tried_of(search, runs, setting));
  }
}

/// Whether all hinges of a joint, run together, come to what those of the plane come to, if the
/// beam has them.
bool stays_in_plane(const AdvisedEngine& engine, const Setup& setup,
                    const std::vector<WatchedProbe>& watched, const AdviceOptions& options,
                    EngineRuns& runs, const EngineSetting& setting) {
  if (runs.turns() == kAllTurns || engine.holds_what_rests) return true;
  EngineRuns space(engine, setup, watched, options);
  space.set_turns(kAllTurns);
  return deviation(runs.run(setting), space.run(setting), watched).largest <= kInPlane;
}

/// Our own advice, and the run that the engine's are compared with; not usable: there is none, and
/// `advice` says why.
Outcome reference_for(const Setup& setup, const std::vector<WatchedProbe>& watched,
                      const AdviceOptions& options, EngineAdvice& advice) {
  AdviceOptions ours = options;
  ours.within = kReferenceShare * options.within;
  ours.budget = 0.0;
  ours.probes.clear();
  for (const WatchedProbe& one : watched) ours.probes.push_back(one.name);
  // What yields would take long to advise on.
  (void)elastic_run(*advice.engine, setup, watched, options);
  advice.end = EngineAdviceEnd::NoReference;
  advice.reference = advise(setup, ours);
  if (advice.reference.end != AdviceEnd::Found) {
    if (advice.reference.end == AdviceEnd::Interrupted) advice.end = EngineAdviceEnd::Interrupted;
    return {};
  }
  const Setup finest = finer_setup(setup, advice.reference, 0.5);
  Outcome reference = elastic_run(*advice.engine, finest, watched, options);
  if (is_raised(options.stop)) advice.end = EngineAdviceEnd::Interrupted;
  advice.reason = reference.reason;
  // Twice as fine as what was promised for, of order 1 at least; no less than what the two differ
  // by, which may be little where errors cancel.
  advice.reference_error = std::max(advice.reference.verified, 0.5 * advice.reference.promised);
  advice.reference_setting =
      setting_text(advice.reference.axes, own_setting(finest, advice.reference.axes));
  return reference;
}

/// Searches by the rule, and fills in what it finds.
void advise_by_rule(const Setup& setup, const std::vector<WatchedProbe>& watched,
                    const AdviceOptions& options, const Outcome& reference, EngineRuns& runs,
                    EngineAdvice& advice) {
  EngineSearch search(runs, reference, watched, options.within - advice.reference_error);
  for (const EngineDamping damping : dampings_of(*advice.engine, setup)) search.search(damping);
  advice.cut_short = runs.end().has_value();
  advice.setting = search.best().value_or(search.last());
  if (search.best() && runs.end() != AdviceEnd::Interrupted) {
    advice.end = EngineAdviceEnd::Found;
  } else {
    advice.end = runs.end() ? end_of(*runs.end()) : EngineAdviceEnd::AtLimit;
  }
  fill_setting(search, runs, advice);
  if (advice.end == EngineAdviceEnd::Found) {
    advice.next_cheaper = next_cheaper_of(search, runs, advice);
  }
}

}  // namespace

EngineAdvice advise_for_engine(const AdvisedEngine& engine, const Setup& setup,
                               const AdviceOptions& options) {
  check_scene(setup.scene, setup.solver);
  (void)fineness_axes(setup);
  check_for_engine(engine, setup);
  const WatchedProbes probes = engine_probes(setup, options.probes);
  EngineAdvice advice;
  advice.engine = &engine;
  advice.left_out = probes.left_out;
  const Outcome reference = reference_for(setup, probes.watched, options, advice);
  if (!usable(reference.status)) return advice;
  EngineRuns runs(engine, setup, probes.watched, options);
  advise_by_rule(setup, probes.watched, options, reference, runs, advice);
  if (advice.end == EngineAdviceEnd::Found &&
      !stays_in_plane(engine, setup, probes.watched, options, runs, advice.setting)) {
    runs.set_turns(kAllTurns);
    advise_by_rule(setup, probes.watched, options, reference, runs, advice);
  }
  advice.runs = runs.runs();
  advice.total_work = runs.total_work();
  add_notes(setup, advice);
  return advice;
}

}  // namespace plastica::sweeps
