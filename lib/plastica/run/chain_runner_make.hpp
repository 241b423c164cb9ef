#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

#include "plastica/model/beam_axis.hpp"
#include "plastica/run/break_policy.hpp"
#include "plastica/run/chain_modes.hpp"
#include "plastica/run/chain_motion.hpp"
#include "plastica/run/chain_runner.hpp"
#include "plastica/run/check_plane.hpp"
#include "plastica/run/lane_program.hpp"

/// Defines `ChainRunner`, and which program a scene of one level has.
namespace plastica {

template <class L, bool kElastic>
ChainRunner<L, kElastic>::ChainRunner(const ChainModel& model, const chain::View<L>& view)
    : body_(model, view) {
  set_path_options();
}

template <class L, bool kElastic>
void ChainRunner<L, kElastic>::set_path_options() {
  const SolverOptions& solver = body_.model.options;
  options_.newton.max_iterations = std::min(solver.max_iterations, solve::kMaxIterations);
  options_.newton.tolerance = solver.tolerance;
  options_.stops = body_.model.stops;
  options_.recorded = body_.model.recorded;
  options_.control = solver.control;
  options_.finds_control = !solver.control_at && solver.control != PathControl::Displacement;
  options_.steps = solver.steps;
  options_.largest_rotation = solver.largest_rotation;
  options_.smallest_step = solver.smallest_step;
  options_.control_motion = solver.control_motion;
  const Scene& scene = body_.model.scene;
  Place at = Place::end();
  if (!scene.loads.empty()) at = scene.loads.front().at;
  if (solver.control_at) at = *solver.control_at;
  const chain::SegmentPoint point =
      chain::segment_point(body_.model.layout, fraction_of(at, body_.model.layout.ends));
  control_.segment = point.segment;
  control_.arm = body_.view.point(point.arm);
  if constexpr (L::kTranslations > 0) {
    // The level's own axes.
    const auto motion = body_.view.point(
        {{solver.control_motion[0], solver.control_motion[1], solver.control_motion[2]}});
    for (std::size_t k = 0; k < L::kTranslations; ++k) options_.control_motion[k] = motion[k];
  } else {
    options_.control_motion[0] = solver.control_motion[2];
  }
}

template <class L, bool kElastic>
void ChainRunner<L, kElastic>::run(const MaterialValues<double>& material, const Workspace& hooks,
                                   Response& response) {
  const auto began = std::chrono::steady_clock::now();
  if (begin(material, hooks, response)) proceed();
  finish();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  response.seconds = took.count();
}

template <class L, bool kElastic>
std::vector<bool> ChainRunner<L, kElastic>::run_with(std::span<const LaneCase> cases) {
  const auto began = std::chrono::steady_clock::now();
  const LaneCase& lead = cases.front();
  for (const LaneCase& one : cases.subspan(1)) {
    companions_.push_back(std::make_unique<ChainCompanion<L, kElastic>>(one, body_.view));
  }
  if (begin(*lead.material, *lead.hooks, *lead.response)) proceed();
  finish();
  std::vector<bool> done{true};
  for (const auto& companion : companions_) {
    done.push_back(companion->finish(*lead.response));
  }
  companions_.clear();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  share_seconds(took.count(), cases);
  return done;
}

template <class L, bool kElastic>
bool ChainRunner<L, kElastic>::begin(const MaterialValues<double>& material, const Workspace& hooks,
                                     Response& response) {
  material_ = material;
  response_ = &response;
  hooks_ = &hooks;
  options_.newton.stop = hooks.stop;
  // Who is told of each step is told of it once.
  asks_beside_ = static_cast<bool>(hooks.on_progress);
  body_.record.shapes_on_demand(!hooks.on_progress);
  return begin_path();
}

template <class L, bool kElastic>
bool ChainRunner<L, kElastic>::begin_path() {
  body_.reset(material_);
  committed_ = body_.work.q;
  previous_ = body_.work.q;
  response_->samples = 0;
  clear_motion(*response_);
  response_->axial.reset();
  response_->unheld_thrust = false;
  response_->chain.events.clear();
  response_->critical.reset();
  response_->buckling.reset();
  response_->vibration.reset();
  has_stable_ = false;
  reported_.assign(body_.build.chain.size() + 1, false);
  has_yielded_ = leaves_plane_ = false;
  unstable_beside_ = 0;
  checked_at_ = -1.0;
  checked_moment_ = 0.0;
  body_.record.begin_frames(*response_);
  for (const auto& companion : companions_) companion->begin();
  solve::PathObserver<L, kElastic>& observer = *this;
  continuation_.emplace(body_.build.chain, *body_.joints, options_, control_, body_.work,
                        committed_, previous_, elastic_, observer);
  return continuation_->begin();
}

template <class L, bool kElastic>
void ChainRunner<L, kElastic>::proceed() {
  continuation_->proceed();
}

template <class L, bool kElastic>
void ChainRunner<L, kElastic>::finish() {
  Response& response = *response_;
  bool cut_short = false;
  if (response.samples > 0) {
    // Where the path ends without an equilibrium, the joints hold a trial, which may yield first.
    const Sections last{last_forces_, last_aside_};
    check_plane(committed_, last_time_, has_yielded_ ? &last : nullptr);
  }
  if (leaves_plane_ && !is_raised(hooks_->stop)) {
    // The path once more, with an eye on where that begins.
    asks_beside_ = true;
    if (begin_path()) proceed();
  }
  if (body_.record.lacks_last_shape(response)) {
    // It has ended early. That is rare, and the path is the same once more.
    cut_short = is_raised(hooks_->stop);
    body_.record.shapes_on_demand(false);
    if (!cut_short && begin_path()) proceed();
  }
  if (!cut_short && !find_modes()) {
    cut_short = true;
    response.buckling.reset();
    response.vibration.reset();
  }
  asks_beside_ = false;
  // Without its last shape a path is not handed over as one that has come to its end.
  response.status = cut_short ? Status::Interrupted : continuation_->status();
  if (!body_.record.lacks_last_shape(response)) body_.record.end_frames(response);
  response.counters = continuation_->counters();
  response.limit = continuation_->limit();
  response.plateau = response.status == Status::LimitLoad ? std::nullopt : continuation_->plateau();
  if (response.plateau) {
    for (double* time : {&response.plateau->from, &response.plateau->to}) {
      *time = body_.record.growing_factor_at(*time);
    }
  }
  body_.finish_axial(response);
  if (response.limit) {
    const History& grows = body_.record.growing_history(response.limit->below);
    response.limit->below = grows.at(response.limit->below);
    response.limit->above = grows.at(response.limit->above);
    note_limit_mode(*response.limit);
  }
  if (!continuation_->critical().empty()) {
    response.critical = continuation_->critical();
    for (auto* times :
         {&response.critical->factor, &response.critical->below, &response.critical->above}) {
      for (double& time : *times) time = body_.record.growing_factor_at(time);
    }
  }
  set_energy_balance(body_.model.scene.beam.length, response);
  response.permanent_strain = body_.watch.largest_strain(body_.strains);
}

/// At a limit point the path goes along its mode.
template <class L, bool kElastic>
void ChainRunner<L, kElastic>::note_limit_mode(LimitLoad& limit) {
  if constexpr (L::kTranslations > 0) {
    const auto& chain = body_.build.chain;
    const std::size_t n = chain.size();
    std::vector<typename L::Point> displacement(n + 1);
    for (const auto& [q, fraction] : {std::pair{&committed_, 1.0}, std::pair{&previous_, -1.0}}) {
      chain::place<kElastic>(chain, *q, last_time_, body_.work.placement);
      const auto& placement = body_.work.placement;
      for (std::size_t i = 0; i <= n; ++i) {
        const auto at =
            i < n ? placement.position[i] : placement.point(n - 1, chain.segments[n - 1].arm);
        displacement[i] += constant<typename L::Scalar>(fraction) * at;
      }
    }
    solve::make_largest_one(displacement, constant<typename L::Scalar>(0));
    for (const auto& point : displacement) {
      const auto in_space = detail::doubles(body_.view.point_in_space(point));
      limit.mode.insert(limit.mode.end(), in_space.begin(), in_space.end());
    }
  }
}

/// What is asked for about the loaded state. Uses up the work, and the laws' history.
/// @return whether it was not stopped
template <class L, bool kElastic>
bool ChainRunner<L, kElastic>::find_modes() {
  if constexpr (kIsDouble<typename L::Scalar>) {
    const SolverOptions& solver = body_.model.options;
    const StopFlag stop = hooks_->stop;
    const Status status = continuation_->status();
    if (status == Status::Interrupted) return true;
    const bool stands =
        status == Status::Completed || status == Status::LimitLoad || status == Status::Unstable;
    if (solver.frequencies > 0 && stands) {
      ChainModes<L, kElastic> modes(body_, committed_, last_time_, has_yielded_);
      response_->vibration = modes.vibration(std::min(solver.frequencies, modes.freedoms()), stop);
    }
    if (solver.buckling == 0) return !is_raised(stop);
    const bool by_arcs = solver.control == PathControl::ArcLength;
    if ((!has_stable_ || by_arcs) && stands && !has_yielded_) {
      // Arcs do not count on their way.
      stable_ = committed_;
      stable_time_ = last_time_;
      has_stable_ = true;
    }
    if (!has_stable_) return !is_raised(stop);
    body_.joints->reset();
    ChainModes<L, kElastic> modes(body_, stable_, stable_time_, false);
    OutOfPlane* beside = nullptr;
    if (has_space_beside() && beside_->has_potential()) {
      const double reach = stable_time_ > 0.0 ? stable_time_ : options_.stops.back();
      see(stable_, stable_time_, nullptr);
      beside_->let_forces_grow(seen_, reach);
      beside = beside_.get();
    }
    response_->buckling = modes.buckling(solver.buckling, beside, stop);
    return !is_raised(stop);
  }
  return true;
}

template <class L, bool kElastic>
bool ChainRunner<L, kElastic>::needs_all() const {
  const auto& supports = body_.model.scene.supports;
  return !body_.build.chain.ground_joints.empty() || body_.watch.active() ||
         std::any_of(supports.begin(), supports.end(),
                     [](const Support& s) { return s.moves(); }) ||
         (continuation_->records_next() &&
          body_.record.needs_chain(response_->samples, *response_));
}

template <class L, bool kElastic>
bool ChainRunner<L, kElastic>::yields() const {
  const auto& work = body_.joints->work_increment();
  return std::any_of(work.begin(), work.end(), [](double w) { return w > 0.0; });
}

template <class L, bool kElastic>
solve::Verdict ChainRunner<L, kElastic>::judge(const Work& /*w*/, bool shortest) {
  // Up to the first equilibrium there may have been several steps.
  const bool first = response_->samples == 0;
  flowed_ = first || body_.flows();
  if (!flowed_) return solve::Verdict::Accept;
  body_.set_trial_strains(first);
  if (!body_.watch.active()) return solve::Verdict::Accept;
  const double excess = body_.watch.excess(body_.watch.measured(body_.trial), reported_);
  if (excess <= 0.0) return solve::Verdict::Accept;
  if (excess > kBreakTolerance && !shortest) return solve::Verdict::TooFar;
  const bool goes_on = body_.model.scene.on_break == BreakPolicy::RecordOnly;
  return goes_on ? solve::Verdict::Accept : solve::Verdict::End;
}

template <class L, bool kElastic>
bool ChainRunner<L, kElastic>::accept(const Work& w) {
  if (flowed_) body_.accept_strains();
  body_.note_axial(false, *response_);
  body_.record.add_work(w, *body_.joints);
  has_yielded_ = has_yielded_ || yields();
  last_time_ = w.time;
  const bool unseen = continuation_->loaded_gradually();
  for (const auto& companion : companions_) {
    if (unseen) companion->leave();
    companion->take(w, previous_);
  }
  if (L::kTranslations == 2) {
    check_plane_while_moments_grow(w);
    check_plane_where_loads_turn(w);
  }
  if (body_.model.options.buckling > 0 && continuation_->known_unstable_modes() == 0 &&
      !has_yielded_) {
    stable_ = w.q;
    stable_time_ = w.time;
    has_stable_ = true;
  }
  if (body_.watch.active() &&
      body_.watch.excess(body_.watch.measured(body_.strains), reported_) > 0.0) {
    note_break(w);
  }
  return !hooks_->on_progress || hooks_->on_progress(w.time);
}

template <class L, bool kElastic>
void ChainRunner<L, kElastic>::note_break(const Work& w) {
  ChainBreak event;
  event.time = w.time;
  event.factor = body_.record.growing_factor_at(w.time);
  event.joints = body_.broken();
  std::erase_if(event.joints, [&](const BrokenJoint& joint) {
    return reported_[static_cast<std::size_t>(joint.joint)];
  });
  for (const BrokenJoint& joint : event.joints) {
    reported_[static_cast<std::size_t>(joint.joint)] = true;
  }
  mark_cuts(body_.model.scene.on_break, event);
  response_->chain.events.push_back(std::move(event));
}

template <class L, bool kElastic>
bool ChainRunner<L, kElastic>::record(const Work& w) {
  // The last sample is the end, of arcs that are more than the samples, too.
  if (response_->samples == body_.model.samples) --response_->samples;
  body_.record.write(w, *body_.joints, body_.strains, response_->samples, *response_);
  response_->chain.iterations[response_->samples] = continuation_->counters().iterations;
  ++response_->samples;
  for (const auto& companion : companions_) companion->record();
  if (!response_->unheld_thrust) response_->unheld_thrust = is_pushed(w) && !has_space_beside();
  return response_->samples < body_.model.samples;
}

template <class L, bool kElastic>
std::unique_ptr<ChainProgram> make_program(const ChainModel& model, const chain::View<L>& view) {
  if (model.options.analysis == Analysis::Dynamics) {
    return make_motion_runner<L, kElastic>(model, view);
  }
  return std::make_unique<ChainRunner<L, kElastic>>(model, view);
}

}  // namespace plastica
