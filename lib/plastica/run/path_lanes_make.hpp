#pragma once

#include <algorithm>
#include <chrono>
#include <utility>

#include "plastica/run/chain_runner.hpp"
#include "plastica/run/path_lanes.hpp"

/// Defines `PathLanes`.
namespace plastica {

inline constexpr auto kVisitState = [](auto& v, auto& state, std::size_t first, std::size_t count) {
  chain::visit_state(v, state, first, count);
};

template <class L>
void PathLanes<L>::run(std::span<const LaneCase> cases) {
  const auto began = std::chrono::steady_clock::now();
  waiting_ = cases;
  for (Lane& lane : lanes_) lane.seeks = false;
  for (int lane = 0; lane < solve::kPathLanes; ++lane) fill(lane);
  while (any_seeks()) {
    std::array<double, solve::kPathLanes> imbalance{};
    newton_->evaluate(imbalance.data());
    bool all_found = true;
    for (int lane = 0; lane < solve::kPathLanes; ++lane) {
      Lane& one = lanes_[static_cast<std::size_t>(lane)];
      if (!one.seeks) continue;
      judge(lane, imbalance[static_cast<std::size_t>(lane)]);
      all_found = all_found && one.found;
    }
    count_unstable_modes();
    if (!all_found) newton_->step();
    for (int lane = 0; lane < solve::kPathLanes; ++lane) {
      if (lanes_[static_cast<std::size_t>(lane)].found) take_found(lane);
    }
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  share_seconds(took.count(), cases);
}

/// Begins a beam that waits; those that need nothing from a lane are run meanwhile.
template <class L>
void PathLanes<L>::fill(int lane) {
  Lane& one = lanes_[static_cast<std::size_t>(lane)];
  one.seeks = one.found = false;
  while (!one.seeks && !waiting_.empty()) {
    const LaneCase& next = waiting_.front();
    waiting_ = waiting_.subspan(1);
    if (is_raised(next.hooks->stop)) {
      next.response->samples = 0;
      next.response->status = Status::Interrupted;
      continue;
    }
    one.seeks = begin(lane, next);
  }
  if (one.seeks) begin_seeking(lane);
}

/// @return whether the beam is in the lane, and has not ended
template <class L>
bool PathLanes<L>::begin(int lane, const LaneCase& next) {
  Lane& one = lanes_[static_cast<std::size_t>(lane)];
  if (one.model != next.model) {
    one.runner = std::make_unique<Runner>(*next.model, view_of<L>(*next.model));
    one.model = next.model;
  }
  Runner& runner = *one.runner;
  if (runner.begin(*next.material, *next.hooks, *next.response)) {
    new_shape_.clear();
    numbers_.clear();
    chain::FieldWriter writer{new_shape_, numbers_};
    const auto& chain = runner.body().build.chain;
    chain::visit_chain(writer, chain);
    with_joints(runner, [&](auto& joints) {
      joints.visit(writer, [](auto& v, auto& law) { chain::visit_law(v, law); });
    });
    const auto one_sided = [](const auto& constraint) { return constraint.one_sided; };
    const bool fits =
        !are_few(1) && std::none_of(chain.constraints.begin(), chain.constraints.end(), one_sided);
    if (fits && shape_ != new_shape_ && !any_seeks()) {
      shape_ = new_shape_;
      newton_->take_shape(shape_.data());
      constexpr std::size_t kOfJoint = 28;  // more than its trial in space, with back stresses
      found_.resize(kOfJoint * (chain.joints() + 1) + chain.constraints.size());
    }
    if (fits && shape_ == new_shape_) {
      newton_->take_chain(lane, numbers_.data());
      return true;
    }
    runner.proceed();
  }
  runner.finish();
  return false;
}

template <class L>
void PathLanes<L>::begin_seeking(int lane) {
  Lane& one = lanes_[static_cast<std::size_t>(lane)];
  auto& work = one.runner->body().work;
  numbers_.clear();
  chain::FieldWriter writer{new_shape_, numbers_};
  chain::visit_unknowns(writer, work.q);
  writer.number(work.moment_scale);
  writer.number(work.force_scale);
  writer.number(0.0);  // no step is taken yet
  for (const History& history : one.runner->body().build.chain.histories) {
    writer.number(history.at(work.time));
  }
  with_joints(*one.runner, [&](auto& joints) { joints.visit_states(writer, kVisitState); });
  newton_->take_start(lane, numbers_.data());
  one.iteration = 0;
  one.found = false;
}

/// As `equilibrate` decides; what is found is read before the others step on.
template <class L>
void PathLanes<L>::judge(int lane, double imbalance) {
  Lane& one = lanes_[static_cast<std::size_t>(lane)];
  const solve::NewtonOptions& options = one.runner->newton();
  one.converged = imbalance <= options.tolerance;
  one.found = !solve::may_improve(imbalance, options.tolerance) ||
              one.iteration == options.max_iterations || is_raised(options.stop);
  if (!one.found) {
    ++one.iteration;
    return;
  }
  auto& work = one.runner->body().work;
  newton_->read(lane, found_.data());
  chain::FieldReader reader{found_.data()};
  chain::visit_unknowns(reader, work.q);
  reader.number(work.moment_scale);
  reader.number(work.force_scale);
  one.placed = one.converged && !one.runner->needs_all();
  if (!one.placed) return;
  newton_->read_places(lane, found_.data());
  chain::FieldReader places{found_.data()};
  chain::visit_places(places, work.placement);
  if (law_ == solve::LaneLaw::Elastic && !one.runner->records_next()) return;
  newton_->read_trial(lane, found_.data());
  chain::FieldReader trial{found_.data()};
  with_joints(*one.runner, [&](auto& joints) { joints.visit_trial(trial, kVisitState); });
}

/// In all lanes, if any has found an equilibrium.
template <class L>
void PathLanes<L>::count_unstable_modes() {
  const bool asked = std::any_of(lanes_.begin(), lanes_.end(), [](const Lane& lane) {
    return lane.seeks && lane.found && lane.converged;
  });
  if (!asked) return;
  std::array<double, solve::kPathLanes> unstable_modes{};
  newton_->count_unstable_modes(unstable_modes.data());
  for (std::size_t i = 0; i < lanes_.size(); ++i) lanes_[i].unstable_modes = unstable_modes[i];
}

template <class L>
void PathLanes<L>::take_found(int lane) {
  Lane& one = lanes_[static_cast<std::size_t>(lane)];
  auto& body = one.runner->body();
  auto& work = body.work;
  if (one.placed) {
    std::copy(work.q.angle.begin(), work.q.angle.end(), work.angles.begin());
  } else if (one.converged) {
    solve::detail::assemble(body.build.chain, *body.joints, work);
    work.recursion.sum(body.build.chain, work.q, work.placement, work.stage, work.joints,
                       work.outer_forces, work.transmitted);
  }
  const bool goes_on = one.runner->take(one.converged, one.iteration, false, one.unstable_modes);
  one.seeks = false;
  if (goes_on && !are_few(1)) {
    one.seeks = true;
    begin_seeking(lane);
    return;
  }
  if (goes_on) one.runner->proceed();
  one.runner->finish();
  fill(lane);
}

/// The iterations of a level for a model's law and instruction set.
inline solve::LaneNewtonTable::Make lane_newton_of(
    const solve::LaneNewtonTable::Make (&makes)[solve::kLaneLaws], const ChainModel& model) {
  return makes[static_cast<std::size_t>(*lane_law(model))];
}

}  // namespace plastica
