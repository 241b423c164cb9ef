#pragma once

#include <algorithm>
#include <chrono>

#include "plastica/run/motion_begin.hpp"
#include "plastica/run/motion_lanes.hpp"
#include "plastica/run/step_size.hpp"

/// Defines `MotionLanes`.
namespace plastica {

template <class L>
void MotionLanes<L>::run(std::span<const LaneCase> cases) {
  const auto began = std::chrono::steady_clock::now();
  begin(cases);
  // Two take as long as one by one, with the same bits.
  if (riders() > 2) {
    start();
    StepSize size(options_);
    for (std::size_t k = 0; k < options_.stops.size() && riders() > 0; ++k) {
      go_to(options_.stops[k], size);
      if (options_.recorded[k]) record();
    }
    finish();
  } else {
    for (Lane& lane : lanes()) lane.rides = false;
  }
  for (Lane& lane : lanes()) {
    if (lane.rides) continue;
    make_chain_program(*lane.one.model)
        ->run(*lane.one.material, *lane.one.hooks, *lane.one.response);
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  share_seconds(took.count(), cases);
}

template <class L>
std::size_t MotionLanes<L>::riders() const {
  const auto of_cases = std::span(lanes_).first(count_);
  return static_cast<std::size_t>(
      std::count_if(of_cases.begin(), of_cases.end(), [](const Lane& lane) { return lane.rides; }));
}

/// Lays out all cases; those of another shape than the first one's do not ride.
template <class L>
void MotionLanes<L>::begin(std::span<const LaneCase> cases) {
  count_ = cases.size();
  shape_.clear();
  const History* first = nullptr;
  for (std::size_t i = 0; i < count_; ++i) {
    lanes_[i].one = cases[i];
    lanes_[i].rides = lay_out(lanes_[i]);
    if (!lanes_[i].rides) continue;
    const auto& histories = lanes_[i].body->build.chain.histories;
    if (first == nullptr) {
      first = histories.data();
      shape_ = new_shape_;
      steps_->take_shape(shape_.data());
    }
    lanes_[i].rides = shape_ == new_shape_ && std::equal(histories.begin(), histories.end(), first);
    if (lanes_[i].rides) take_numbers(static_cast<int>(i), lanes_[i]);
  }
  if (first == nullptr) return;
  // What no case fills is like one that is there.
  const auto rides =
      std::find_if(lanes().begin(), lanes().end(), [](const Lane& lane) { return lane.rides; });
  lay_out(*rides);
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    if (i >= count_ || !lanes_[i].rides) take_numbers(static_cast<int>(i), *rides);
  }
}

/// Writes down shape and numbers. @return whether it can ride at all
template <class L>
bool MotionLanes<L>::lay_out(Lane& lane) {
  const LaneCase& one = lane.one;
  if (one.hooks->on_progress) return false;
  if (lane.model != one.model) {
    lane.body = std::make_unique<Body>(*one.model, view_of<L>(*one.model));
    lane.model = one.model;
  }
  // It rides to its end, where its last shape is kept.
  lane.body->record.shapes_on_demand();
  begin_motion(*one.material, *lane.body, *one.response);
  set_initial_motion(*lane.body, lane.motion);
  new_shape_.clear();
  numbers_.clear();
  chain::FieldWriter writer{new_shape_, numbers_};
  const auto& chain = lane.body->build.chain;
  chain::visit_chain(writer, chain);
  with_joints<L>(law_, *lane.body->joints, [&](auto& joints) {
    joints.visit(writer, [](auto& v, auto& law) { chain::visit_law(v, law); });
  });
  chain::visit_inertias(writer, chain);
  with_joints<L>(law_, *lane.body->joints, [&](auto& joints) { joints.visit_stiffness(writer); });
  writer.flag(starts_free(*lane.body));
  // Velocities are fitted anew where what moves a support has a corner, and in all lanes then.
  for (const auto& constraint : chain.constraints) writer.flag(constraint.motion != 0.0);
  writer.flag(dot(chain.root.motion, chain.root.motion) > 0.0);
  writer.flag(dot(chain.root.rotation, chain.root.rotation) > 0.0);
  return true;
}

/// Of the case that was laid out last.
template <class L>
void MotionLanes<L>::take_numbers(int number, Lane& lane) {
  steps_->take_chain(number, numbers_.data());
  std::vector<double> velocities;
  chain::FieldWriter writer{new_shape_, velocities};
  chain::visit_velocities(writer, lane.motion);
  steps_->take_velocities(number, velocities.data());
}

template <class L>
void MotionLanes<L>::start() {
  const auto rides =
      std::find_if(lanes().begin(), lanes().end(), [](const Lane& lane) { return lane.rides; });
  const auto& chain = rides->body->build.chain;
  options_ = motion_options(*rides->body);
  options_.newton.stop = rides->one.hooks->stop;
  time_ = 0.0;
  constexpr std::size_t kOfJoint = 4 * (L::kTranslations + L::kRotations);
  found_.resize(kOfJoint * (chain.joints() + 2) + chain.constraints.size());
  std::vector<const History*> histories;
  for (const History& history : chain.histories) histories.push_back(&history);
  OfEach holds{};
  steps_->start(options_, histories.data(), starts_free(*rides->body), holds.data());
  for (std::size_t i = 0; i < count_; ++i) {
    Lane& lane = lanes_[i];
    lane.rides = lane.rides && holds[i] > 0.0;
    if (!lane.rides) continue;
    read_all(static_cast<int>(i), lane);
    lane.body->record.begin_motion(lane.body->work, *lane.body->joints, lane.motion, lane.kinetic);
  }
  record();
}

template <class L>
void MotionLanes<L>::go_to(double stop, StepSize& size) {
  size.begin(time_, stop);
  while (!size.done(time_) && riders() > 0) {
    take_step(size.next(time_));
    size.accepted();
  }
}

template <class L>
void MotionLanes<L>::take_step(double h) {
  OfEach rides{}, solved{}, solves{}, flows{};
  for (std::size_t i = 0; i < count_; ++i) rides[i] = lanes_[i].rides ? 1.0 : 0.0;
  steps_->attempt(h, rides.data(), solved.data(), solves.data(), flows.data());
  for (std::size_t i = 0; i < count_; ++i) {
    Lane& lane = lanes_[i];
    // Who is stopped runs alone, and ends there at once.
    lane.rides = lane.rides && solved[i] > 0.0 && !is_raised(lane.one.hooks->stop);
    if (!lane.rides) continue;
    lane.one.response->counters.iterations += static_cast<int>(solves[i]);
    lane.body->work.time = time_ + h;
    if (flows[i] == 0.0) continue;
    read_joints(static_cast<int>(i), lane);
    lane.body->set_trial_strains();
  }
  if (riders() == 0) return;
  const bool restarted = steps_->accept();
  const double begin = time_;
  time_ += h;
  for (std::size_t i = 0; i < count_; ++i) {
    Lane& lane = lanes_[i];
    if (!lane.rides) continue;
    note_step(time_ - begin, *lane.one.response);
    ++lane.one.response->counters.steps;
    const bool flowed = flows[i] > 0.0;
    if (flowed) lane.body->accept_strains();
    if (flowed || restarted) lane.rides = goes_on(static_cast<int>(i), lane, restarted);
  }
}

/// After a step in which joints have flowed, or at whose end they were asked again. @return whether
/// none breaks
template <class L>
bool MotionLanes<L>::goes_on(int number, Lane& lane, bool restarted) {
  if (law_ == solve::LaneLaw::Elastic) return true;
  if (restarted) read_joints(number, lane);
  Body& body = *lane.body;
  axial_.resize(body.build.chain.joints());
  steps_->read_axial(number, axial_.data());
  body.note_axial(true, *lane.one.response, &axial_);
  return !body.watch.active() || body.watch.excess(body.watch.measured(body.strains)) <= 0.0;
}

template <class L>
void MotionLanes<L>::read_joints(int number, Lane& lane) {
  Body& body = *lane.body;
  steps_->read_joints(number, found_.data());
  chain::FieldReader reader{found_.data()};
  chain::visit_each(reader, body.work.angles);
  body.joints->visit_found(reader, body.view.section_axes());
}

template <class L>
void MotionLanes<L>::read_motion(int number, Lane& lane) {
  auto& work = lane.body->work;
  steps_->read_motion(number, found_.data());
  chain::FieldReader reader{found_.data()};
  chain::visit_held(reader, work.q);
  chain::visit_pose(reader, work.q.pose[0]);
  chain::visit_wrenches(reader, work.transmitted.outer);
  chain::visit_each(reader, work.joints.force);
  chain::visit_velocities(reader, lane.motion);
  reader.number(lane.kinetic);
  reader.number(lane.flows.external);
  reader.number(lane.flows.damping);
  reader.number(lane.flows.numerical_dissipation);
  reader.number(lane.momentum_error);
}

template <class L>
void MotionLanes<L>::read_all(int number, Lane& lane) {
  read_joints(number, lane);
  read_motion(number, lane);
  auto& work = lane.body->work;
  std::copy_n(work.angles.begin(), work.q.angle.size(), work.q.angle.begin());
  chain::place<false>(lane.body->build.chain, work.q, work.time, work.placement);
}

template <class L>
void MotionLanes<L>::record() {
  for (std::size_t i = 0; i < count_; ++i) {
    Lane& lane = lanes_[i];
    if (!lane.rides) continue;
    read_all(static_cast<int>(i), lane);
    record_motion(lane.motion, lane.kinetic, lane.flows, *lane.body, *lane.one.response);
  }
}

template <class L>
void MotionLanes<L>::finish() {
  for (std::size_t i = 0; i < count_; ++i) {
    Lane& lane = lanes_[i];
    if (!lane.rides) continue;
    read_motion(static_cast<int>(i), lane);
    lane.one.response->status = Status::Completed;
    end_motion(lane.momentum_error, *lane.body, *lane.one.response);
  }
}

}  // namespace plastica
