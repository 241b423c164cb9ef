#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "plastica/run/break_policy.hpp"
#include "plastica/run/chain_body.hpp"
#include "plastica/run/chain_motion.hpp"
#include "plastica/run/motion_begin.hpp"
#include "plastica/run/step_size.hpp"
#include "plastica/solve/motion_step.hpp"

namespace plastica {

/// The program of one level in dynamics.
template <class L, bool kElastic>
class ChainMotionRunner final : public ChainProgram {
 public:
  using Work = solve::NewtonWork<L, kElastic>;
  using Step = solve::MotionStep<L, kElastic>;

  ChainMotionRunner(const ChainModel& model, const chain::View<L>& view)
      : body_(model, view), options_(motion_options(body_)) {}

  void run(const MaterialValues<double>& material, const Workspace& hooks,
           Response& response) override;

 private:
  Status take_steps(Step& step, const Workspace& hooks, Response& response);
  /// Takes steps up to a time. @return Completed if it got there
  Status go_to(double stop, StepSize& size, Step& step, const Workspace& hooks, Response& response);
  void break_joints(Step& step, const BreakListener& listener, Response& response);
  void cut_joints(double time, Step& step, Response& response);
  void let_go(ChainBreak event, Step& step, Response& response);
  std::vector<Fragment> fragments() const;
  void record(const Step& step, Response& response);

  ChainBody<L, kElastic> body_;
  solve::MotionOptions options_;
  std::unique_ptr<Step> step_;  ///< of the joints below, which a material change renews
  const void* joints_of_step_ = nullptr;
  std::vector<solve::SegmentMotion<L>> initial_motion_;  ///< (N)
  std::vector<bool> cut_;                                ///< joints that are cut (nodes)
  std::vector<bool> reported_;      ///< joints whose break was reported (nodes)
  std::vector<JointFlow> watched_;  ///< angles of the joints that are left (nodes)
  std::size_t next_cut_ = 0;
};

template <class L, bool kElastic>
void ChainMotionRunner<L, kElastic>::run(const MaterialValues<double>& material,
                                         const Workspace& hooks, Response& response) {
  const auto began = std::chrono::steady_clock::now();
  begin_motion(material, body_, response);
  const std::size_t nodes = body_.model.layout.size() + 1;
  cut_.assign(nodes, false);
  reported_.assign(nodes, false);
  watched_.assign(nodes, {});
  next_cut_ = 0;
  if (!step_ || joints_of_step_ != body_.joints.get()) {
    step_ = std::make_unique<Step>(body_.build.chain, *body_.joints, body_.view.section_axes(),
                                   options_, body_.work);
    joints_of_step_ = body_.joints.get();
  }
  step_->stop_by(hooks.stop);
  set_initial_motion(body_, initial_motion_);
  response.status =
      step_->start(initial_motion_) ? take_steps(*step_, hooks, response) : Status::HeldTwice;
  end_motion(step_->momentum_error(), body_, response);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  response.seconds = took.count();
}

template <class L, bool kElastic>
Status ChainMotionRunner<L, kElastic>::take_steps(Step& step, const Workspace& hooks,
                                                  Response& response) {
  body_.record.begin_motion(body_.work, *body_.joints, step.motions(), step.kinetic());
  record(step, response);
  StepSize size(options_);
  for (std::size_t k = 0; k < options_.stops.size(); ++k) {
    cut_joints(step.time(), step, response);
    const Status status = go_to(options_.stops[k], size, step, hooks, response);
    if (status != Status::Completed) return status;
    if (options_.recorded[k]) record(step, response);
  }
  return response.chain.events.empty() ? Status::Completed : Status::Broken;
}

template <class L, bool kElastic>
Status ChainMotionRunner<L, kElastic>::go_to(double stop, StepSize& size, Step& step,
                                             const Workspace& hooks, Response& response) {
  size.begin(step.time(), stop);
  while (!size.done(step.time())) {
    const double h = size.next(step.time());
    bool taken = step.attempt(h);
    response.counters.iterations += step.iterations();
    if (taken && options_.step_error > 0.0) {
      taken = size.judge(step.error() / body_.model.scene.beam.length);
    }
    if (is_raised(hooks.stop)) {
      step.restore();
      return Status::Interrupted;
    }
    if (!taken) {
      ++response.counters.cutbacks;
      if (size.cut()) continue;
      step.restore();
      return Status::NotConverged;
    }
    const bool flowed = body_.flows();
    if (flowed) body_.set_trial_strains();
    const double begin = step.time();
    step.accept();
    note_step(step.time() - begin, response);
    size.accepted();
    ++response.counters.steps;
    if (flowed) body_.accept_strains();
    body_.note_axial(true, response);
    break_joints(step, hooks.on_break, response);
    if (hooks.on_progress && !hooks.on_progress(step.time())) return Status::Interrupted;
  }
  return Status::Completed;
}

template <class L, bool kElastic>
void ChainMotionRunner<L, kElastic>::break_joints(Step& step, const BreakListener& listener,
                                                  Response& response) {
  if (!body_.watch.active()) return;
  const auto& angles = body_.watch.measured(body_.strains);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    watched_[i] = cut_[i] ? JointFlow{} : angles[i];
  }
  if (body_.watch.excess(watched_, reported_) <= 0.0) return;
  ChainBreak event;
  for (const BrokenJoint& joint : body_.watch.broken(watched_)) {
    const auto node = static_cast<std::size_t>(joint.joint);
    if (reported_[node] || cut_[node]) continue;
    event.joints.push_back(joint);
    body_.describe(event.joints.back());
  }
  if (event.joints.empty()) return;
  event.time = step.time();
  mark_cuts(body_.model.scene.on_break, event);
  const std::vector<BrokenJoint> told = event.joints;
  if (listener) {
    event.factor = body_.record.factor_at(event.time);
    event.fragments = fragments();
    listener(event);
    if (!std::ranges::equal(told, event.joints, {}, &BrokenJoint::joint, &BrokenJoint::joint)) {
      throw std::invalid_argument(
          "plastica: a listener may set `cut` of the joints that it is told of, and no others");
    }
  }
  // A joint that is spared for another is asked about again; one that a listener spares, or that
  // the scene only records, is not.
  const bool once = body_.model.scene.on_break == BreakPolicy::RecordOnly;
  for (std::size_t k = 0; k < told.size(); ++k) {
    const bool is_spared = told[k].cut && !event.joints[k].cut;
    if (once || is_spared) reported_[static_cast<std::size_t>(told[k].joint)] = true;
  }
  let_go(std::move(event), step, response);
}

template <class L, bool kElastic>
void ChainMotionRunner<L, kElastic>::cut_joints(double time, Step& step, Response& response) {
  const auto& cuts = body_.model.cuts;
  ChainBreak event;
  event.time = time;
  for (; next_cut_ < cuts.size() && cuts[next_cut_].time <= time; ++next_cut_) {
    const std::size_t node = cuts[next_cut_].node;
    if (cut_[node]) continue;
    BrokenJoint joint;
    joint.joint = static_cast<int>(node);
    joint.cause = BreakCause::Cut;
    joint.cut = true;
    joint.strain = body_.watch.strains(body_.strains)[node];
    body_.describe(joint);
    event.joints.push_back(joint);
  }
  if (!event.joints.empty()) let_go(std::move(event), step, response);
}

template <class L, bool kElastic>
void ChainMotionRunner<L, kElastic>::let_go(ChainBreak event, Step& step, Response& response) {
  event.factor = body_.record.factor_at(event.time);
  bool any_cut = false;
  for (const BrokenJoint& joint : event.joints) {
    if (!joint.cut) continue;
    any_cut = true;
    cut_[static_cast<std::size_t>(joint.joint)] = true;
    step.open(static_cast<std::size_t>(joint.joint));
  }
  if (any_cut) step.opened();
  event.fragments = fragments();
  response.chain.events.push_back(std::move(event));
}

template <class L, bool kElastic>
std::vector<Fragment> ChainMotionRunner<L, kElastic>::fragments() const {
  std::vector<Fragment> fragments{{0, 0}};
  const int n = static_cast<int>(body_.build.chain.size());
  for (int i = 1; i < n; ++i) {
    if (!body_.work.q.open[static_cast<std::size_t>(i)]) continue;
    fragments.back().last = i - 1;
    fragments.push_back({i, i});
  }
  fragments.back().last = n - 1;
  return fragments;
}

template <class L, bool kElastic>
void ChainMotionRunner<L, kElastic>::record(const Step& step, Response& response) {
  record_motion(step.motions(), step.kinetic(), step.flows(), body_, response);
}

template <class L, bool kElastic>
std::unique_ptr<ChainProgram> make_motion_runner(const ChainModel& model,
                                                 const chain::View<L>& view) {
  return std::make_unique<ChainMotionRunner<L, kElastic>>(model, view);
}

}  // namespace plastica
