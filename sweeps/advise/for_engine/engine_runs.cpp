#include "sweeps/advise/for_engine/engine_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "calibrate/engine/engine_world.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/choose_level.hpp"
#include "plastica/run/path_stops.hpp"
#include "sweeps/advise/for_engine/engine_advice.hpp"
#include "sweeps/advise/for_engine/engine_chain.hpp"
#include "sweeps/advise/for_engine/engine_loads.hpp"

namespace plastica::sweeps {
namespace {

constexpr int kFewestSegmentsOfEngine = 2;
/// How often a run looks whether it is to stop [steps].
constexpr int kLooksForStop = 256;

/// Segments end at these places whatever their number; those of loads do not count, since no load
/// is exported.
int needed_segments(Scene scene) {
  scene.loads.clear();
  return static_cast<int>(needed_ends(scene).size()) - 1;
}

std::array<bool, 3> turns_of(const Setup& setup) {
  const LevelChoice choice = choose_level(setup.scene, setup.solver);
  switch (choice.level) {
    case Level::Planar: {
      const bool about_x = choice.bending == BendingAxis::X;
      return {about_x, !about_x, false};
    }
    case Level::Twist: return {false, false, true};
    default: return {true, true, true};
  }
}

/// Joints of a motion in a plane keep the hinges of that plane alone.
void hold_what_rests(const std::array<bool, 3>& turns, calibrate::EngineBeam& beam) {
  if (std::ranges::count(turns, false) == 0) return;
  for (calibrate::EngineJoint& joint : beam.joints) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!turns[k]) joint.rotation[k] = calibrate::JointHold::Rigid;
    }
  }
  const auto axis = std::ranges::find(turns, true) - turns.begin();
  beam.notes.push_back(fmt::format("joints turn about {} alone, as the motion does", "xyz"[axis]));
}

}  // namespace

EngineRuns::EngineRuns(const AdvisedEngine& engine, const Setup& setup,
                       const std::vector<WatchedProbe>& watched, const AdviceOptions& options)
    : engine_(engine),
      setup_(setup),
      watched_(watched),
      options_(options),
      fewest_(std::max(kFewestSegmentsOfEngine, needed_segments(setup.scene))),
      turns_(engine.rule == EngineRule::Hinges ? turns_of(setup) : kAllTurns),
      sample_time_(path_stops(setup.scene, setup.solver).time.back() / setup.solver.steps) {
  not_run_.reason = "it was not run";
}

void EngineRuns::set_turns(const std::array<bool, 3>& turns) {
  if (turns == turns_) return;
  turns_ = turns;
  outcomes_.clear();
}

EngineSetting EngineRuns::with_twice_segments(const EngineSetting& setting) const {
  return {setting.damping, 2 * setting.segments, engine_.steps_of_twice_segments * setting.steps};
}

std::int64_t EngineRuns::work(const EngineSetting& setting) const {
  return std::int64_t{setting.segments} * setting.steps * setup_.solver.steps;
}

calibrate::EngineBeam EngineRuns::beam(const EngineSetting& setting) const {
  Setup at = setup_;
  at.scene.beam.segments = setting.segments;
  at.solver.time_step = time_step(setting);
  calibrate::EngineBeam beam = calibrate::engine_beam(at.scene, at.solver);
  calibrate::EngineWorld world;
  if (setting.damping == EngineDamping::None) world.damping_time = 0.0;
  calibrate::put_into(world, beam);
  beam.time_step_of = "as advised";
  if (engine_.holds_what_rests) hold_what_rests(turns_, beam);
  return beam;
}

bool EngineRuns::is_allowed(const EngineSetting& setting) {
  if (end_) return false;
  if (is_raised(options_.stop)) {
    end_ = AdviceEnd::Interrupted;
  } else if (runs_ >= kRuleRunsPerRun * options_.max_runs) {
    end_ = AdviceEnd::TooManyRuns;
  } else if (static_cast<double>(total_work_ + work(setting)) > options_.max_work) {
    end_ = AdviceEnd::TooMuchWork;
  }
  return !end_;
}

const Outcome& EngineRuns::run(const EngineSetting& setting) {
  const auto known = outcomes_.find(setting);
  if (known != outcomes_.end()) return known->second;
  if (!is_allowed(setting)) return not_run_;
  Outcome outcome = made(setting);
  if (is_raised(options_.stop)) {
    end_ = AdviceEnd::Interrupted;
    return not_run_;
  }
  ++runs_;
  total_work_ += outcome.work;
  if (options_.progress) options_.progress(runs_);
  return outcomes_.emplace(setting, std::move(outcome)).first->second;
}

Outcome EngineRuns::made(const EngineSetting& setting) const {
  const calibrate::EngineBeam numbers = beam(setting);
  const std::unique_ptr<EngineChain> chain = engine_chain(engine_, numbers, turns_);
  const EngineLoads loads(setup_.scene, numbers);
  Outcome outcome;
  outcome.status = Status::Completed;
  outcome.segments = setting.segments;
  outcome.work = work(setting);
  outcome.history.resize(watched_.size());
  const auto record = [&](int sample) {
    outcome.time.push_back(sample_time_ * sample);
    for (std::size_t k = 0; k < watched_.size(); ++k) {
      const Probe& probe = setup_.scene.probes[watched_[k].probe];
      outcome.history[k].push_back(loads.observe(*chain, probe));
    }
  };
  record(0);
  std::vector<SegmentWrench> wrenches;
  for (int sample = 0; sample < setup_.solver.steps; ++sample) {
    for (int step = 0; step < setting.steps; ++step) {
      if (step % kLooksForStop == 0 && is_raised(options_.stop)) return outcome;
      const double time = sample_time_ * sample + chain->time_step() * step;
      const Vec<double, 3> turned = loads.ground_rotation(time);
      for (std::size_t k = 0; k < 3; ++k) chain->set_rest(k, turned[k]);
      loads.gather(*chain, time, wrenches);
      if (chain->step(loads.gravity(time), wrenches)) continue;
      outcome.status = Status::NonFinite;
      outcome.work = std::int64_t{setting.segments} *
                     (std::int64_t{sample} * setting.steps + step + 1);  // it ends here
      outcome.reason = fmt::format("{}'s steps blow up", engine_.word);
      return outcome;
    }
    record(sample + 1);
  }
  return outcome;
}

}  // namespace plastica::sweeps
