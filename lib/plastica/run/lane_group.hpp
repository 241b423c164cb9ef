#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "plastica/lanes/kernel_table.hpp"
#include "plastica/run/lane_memory.hpp"
#include "plastica/run/lane_program.hpp"

namespace plastica {

/// A lane program of one level and precision.
template <class Form, class Real>
class LaneGroup final : public LaneProgram {
 public:
  using Beam = typename Form::template Beam<Real>;
  using Sums = typename Form::Sums;

  explicit LaneGroup(const ChainModel& model)
      : order_(model.options.scheme == Scheme::ArticulatedEuler ? 1 : 2),
        kernels_(Form::template kernels<Real>(
            lanes::of_precision<Real>(lanes::kernels(resolved(model.options.isa))), order_,
            model.scene.yield_model != YieldModel::Elastic)),
        sight_(Form::template sight<Real>(
            lanes::of_precision<Real>(lanes::kernels(resolved(model.options.isa))))) {}

  std::size_t width() const override { return lanes::kManyLanes<Real>; }

  void run(std::span<const LaneCase> cases) override {
    const auto began = std::chrono::steady_clock::now();
    begin(cases);
    const ChainModel& model = *cases.front().model;
    for (std::size_t k = 0; k < model.stops.size() && any_runs(); ++k) {
      go_to(model.stops[k]);
      if (model.recorded[k]) record();
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    for (Scenario& scenario : scenarios()) {
      scenario.finish(took.count() / static_cast<double>(cases.size()));
    }
  }

 private:
  using Scenario = LaneScenario<Form>;
  using Memory = LaneMemory<Form, Real>;

  std::span<Scenario> scenarios() { return std::span(scenarios_).first(count_); }
  bool any_runs() {
    const auto all = scenarios();
    return std::any_of(all.begin(), all.end(), [](const Scenario& s) { return s.running(); });
  }

  void begin(std::span<const LaneCase> cases) {
    count_ = cases.size();
    if (scenarios_.size() < count_) scenarios_.resize(count_);
    for (std::size_t lane = 0; lane < count_; ++lane) scenarios_[lane].begin(cases[lane]);
    time_ = last_step_ = 0.0;
    memory_.set(scenarios(), count_ == 1 ? 1 : width());
    const ChainModel& model = *cases.front().model;
    loads_change_ = false;
    for (const History& history : scenarios_.front().chain().histories) {
      const auto& f = history.factor;
      loads_change_ =
          loads_change_ || std::adjacent_find(f.begin(), f.end(), std::not_equal_to<>()) != f.end();
    }
    // Of all cases of a shape, or a case's bits would depend on its company.
    counts_loads_ = loads_change_ || (!Form::kMomentsHavePotential && !model.scene.loads.empty());
    set_loads(memory_, 0.0, loads_change_ ? 0.0 : model.stops.back());
    record();
  }

  /// Writes a sample of all that run.
  void record() {
    look();
    for (std::size_t lane = 0; lane < count_; ++lane) {
      Scenario& scenario = scenarios_[lane];
      if (!scenario.running()) continue;
      scenario.arrive(time_, memory_, lane, counts_loads_, false);
      scenario.record();
    }
    sampled_.copy_states(memory_);
    sampled_time_ = time_;
  }

  void look() { (count_ == 1 ? sight_.one : sight_.many)(memory_.beam(counts_loads_)); }

  /// Ends a lane where its last sample was.
  void stop(std::size_t lane, Status status) {
    memory_.copy_lane(lane, sampled_, lane);
    look();
    scenarios_[lane].arrive(sampled_time_, memory_, lane, counts_loads_, true);
    scenarios_[lane].stop(status);
  }

  /// The factors where a step's forces act: the mean over the step, or at its end.
  void set_loads(Memory& memory, double from, double to) const {
    memory.set_loads([&](std::size_t h) {
      const History& history = scenarios_.front().chain().histories[h];
      return order_ == 2 ? 0.5 * (history.at(from) + history.at(to)) : history.at(to);
    });
  }

  /// Takes `parts` even steps.
  void march(Memory& memory, lanes::StepKernel<Beam> kernel, double stop, double parts,
             bool aimed) const {
    const double step = (stop - time_) / parts;
    const auto steps = static_cast<std::size_t>(parts);
    const Beam beam = memory.beam(counts_loads_);
    memory.reset_extremes();
    if (!loads_change_) {
      kernel(beam, step, steps, aimed);
      return;
    }
    for (std::size_t k = 0; k < steps; ++k) {
      const double begin = time_ + static_cast<double>(k) * step;
      set_loads(memory, begin, begin + step);
      kernel(beam, step, 1, aimed || k > 0);
    }
  }

  void go_to(double to) {
    const SolverOptions& options = scenarios_.front().model().options;
    const double parts = std::max(1.0, std::ceil((to - time_) / options.time_step - 1e-9));
    const double step = (to - time_) / parts;
    before_.copy_states(memory_);
    march(memory_, count_ == 1 ? kernels_.one : kernels_.many, to, parts, step == last_step_);
    last_step_ = step;
    memory_.add_up(not_finite_);
    for (std::size_t lane = 0; lane < count_; ++lane) {
      Scenario& scenario = scenarios_[lane];
      if (!scenario.running()) continue;
      const bool held = not_finite_[lane] == Real(0) && turns_little(memory_, lane, step);
      if (!held && !retry(lane, to, parts)) {
        stop(lane, Status::NotConverged);
        continue;
      }
      auto& counters = scenario.response().counters;
      counters.steps += static_cast<int>(parts);
      counters.iterations += static_cast<int>(parts);
      const auto& told = scenario.hooks().on_progress;
      if (told && !told(to)) stop(lane, Status::Interrupted);
    }
    time_ = to;
  }

  /// Whether the steps of a memory's lane are short enough for how fast it turns.
  bool turns_little(const Memory& memory, std::size_t lane, double step) const {
    const double most = scenarios_.front().model().options.largest_turn;
    if constexpr (requires { Sums::LargestAngle; }) {
      if (!(memory.sum(Sums::LargestAngle, lane) < Form::kLargestAngle)) return false;
    }
    return memory.sum(Sums::FastestSpin, lane) * step <= most;
  }

  /// Goes from the last stop with shorter steps, alone. @return whether it got there
  bool retry(std::size_t lane, double stop, double parts) {
    Scenario& scenario = scenarios_[lane];
    const SolverOptions& options = scenario.model().options;
    alone_.set(std::span<const Scenario>(&scenario, 1), 1);
    if (!loads_change_) set_loads(alone_, time_, stop);
    for (double cut = 2.0; 1.0 / cut >= options.smallest_step; cut *= 2.0) {
      ++scenario.response().counters.cutbacks;
      alone_.copy_lane(0, before_, lane);
      march(alone_, kernels_.one, stop, parts * cut, false);
      alone_.add_up(not_finite_alone_);
      if (not_finite_alone_[0] != Real(0)) continue;
      if (!turns_little(alone_, 0, (stop - time_) / (parts * cut))) continue;
      memory_.copy_lane(lane, alone_, 0);
      last_step_ = 0.0;  // this lane aims anew, with the same bits for all others
      return true;
    }
    return false;
  }

  int order_;
  const lanes::StepKernels<Beam>& kernels_;
  const lanes::SightKernels<Beam>& sight_;
  std::vector<Scenario> scenarios_;
  std::size_t count_ = 0;  ///< of them that run
  Memory memory_;
  Memory before_;   ///< states at the last stop
  Memory sampled_;  ///< and at the last sample
  double sampled_time_ = 0.0;
  Memory alone_;  ///< of a lane that needs shorter steps
  std::vector<Real> not_finite_, not_finite_alone_;
  bool loads_change_ = false;
  bool counts_loads_ = false;
  double time_ = 0.0;
  double last_step_ = 0.0;  ///< that the memory is aimed for; 0: none
};

}  // namespace plastica
