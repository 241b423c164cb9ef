#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
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
        observables_(Form::template observables<Real>(
            lanes::of_precision<Real>(lanes::kernels(resolved(model.options.isa))))) {}

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
    observed_ = false;
    alone_lane_ = kNone;
    memory_.set(scenarios(), count_ == 1 ? 1 : lanes::kManyLanes<Real>);
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
    observe();
    last_balances_.assign(count_, {});
    for (std::size_t lane = 0; lane < count_; ++lane) {
      last_balances_[lane].potential = memory_.sum(Sums::Potential, lane);
      const Balance begin = balance_of(memory_, lane, lane);
      last_balances_[lane].sum = begin.sum;
      last_balances_[lane].size = begin.size;
    }
    record();
  }

  /// Writes a sample of all that run.
  void record() {
    observe();
    for (std::size_t lane = 0; lane < count_; ++lane) {
      Scenario& scenario = scenarios_[lane];
      if (!scenario.running()) continue;
      scenario.arrive(time_, memory_, lane, counts_loads_, false);
      scenario.record();
    }
    sampled_.copy_states(memory_);
    sampled_time_ = time_;
  }

  void observe() {
    if (!observed_)
      (count_ == 1 ? observables_.one : observables_.many)(memory_.beam(counts_loads_));
    observed_ = true;
  }

  /// Ends a lane where its last sample was.
  void stop(std::size_t lane, Status status) {
    memory_.copy_lane(lane, sampled_, lane);
    observed_ = false;
    observe();
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

  /// Takes even steps from a time on; fewer if all are stopped meanwhile.
  void march(Memory& memory, lanes::StepKernel<Beam> kernel, double from, double step,
             std::size_t steps, bool aimed) {
    const Beam beam = memory.beam(counts_loads_);
    memory.reset_extremes();
    const std::size_t at_once = std::max(std::size_t{1}, kStepsOfSegments / memory.numbers());
    for (std::size_t done = 0; done < steps && !stopped(); done += at_once) {
      const std::size_t end = std::min(steps, done + at_once);
      if (!loads_change_) {
        kernel(beam, step, end - done, aimed || done > 0);
        continue;
      }
      for (std::size_t k = done; k < end; ++k) {
        const double begin = from + static_cast<double>(k) * step;
        set_loads(memory, begin, begin + step);
        kernel(beam, step, 1, aimed || k > 0);
      }
    }
  }

  /// Whether all that run were stopped from outside.
  bool stopped() {
    const auto all = scenarios();
    return std::none_of(all.begin(), all.end(), [](const Scenario& s) {
      return s.running() && !is_raised(s.hooks().stop);
    });
  }

  /// Goes to a stop, so many steps at a time that a failure does not cost much and that those who
  /// watch are told in between.
  void go_to(double to) {
    const SolverOptions& options = scenarios_.front().model().options;
    const double from = time_;
    const double parts = std::max(1.0, std::ceil((to - from) / options.time_step - 1e-9));
    const double step = (to - from) / parts;
    for (double done = 0.0; done < parts && any_runs();) {
      const double steps = std::min(parts - done, kSteps);
      if (sampled_time_ == time_) {
        before_ = &sampled_;
      } else {
        kept_.copy_states(memory_);
        before_ = &kept_;
      }
      march(memory_, count_ == 1 ? kernels_.one : kernels_.many, time_, step,
            static_cast<std::size_t>(steps), step == last_step_);
      observed_ = false;
      last_step_ = step;
      for (std::size_t lane = 0; lane < count_; ++lane) {
        if (scenarios_[lane].running() && is_raised(scenarios_[lane].hooks().stop)) {
          stop(lane, Status::Interrupted);
        }
      }
      observe();
      for (std::size_t lane = 0; lane < count_; ++lane) {
        if (scenarios_[lane].running()) judge(lane, step, steps);
      }
      done += steps;
      time_ = done < parts ? from + done * step : to;
      for (std::size_t lane = 0; lane < count_; ++lane) tell(lane);
    }
  }

  /// Takes the steps of a lane, or goes them again with shorter ones.
  void judge(std::size_t lane, double step, double steps) {
    auto& counters = scenarios_[lane].response().counters;
    counters.iterations += static_cast<int>(steps);
    // A number that is not finite leaves no energies that balance.
    if (rotates_little(memory_, lane, step) && energy_is_balanced(memory_, lane, lane)) {
      counters.steps += static_cast<int>(steps);
      note_step(step, scenarios_[lane].response());
      return;
    }
    if (retry(lane, step, steps)) return;
    const bool stopped = is_raised(scenarios_[lane].hooks().stop);
    stop(lane, stopped ? Status::Interrupted : Status::NotConverged);
  }

  void tell(std::size_t lane) {
    Scenario& scenario = scenarios_[lane];
    const auto& report = scenario.hooks().on_progress;
    if (scenario.running() && report && !report(time_)) stop(lane, Status::Interrupted);
  }

  /// Whether the steps of a memory's lane are short enough for how fast it turns.
  bool rotates_little(const Memory& memory, std::size_t lane, double step) const {
    const double most = scenarios_.front().model().options.largest_rotation;
    if constexpr (requires { Sums::LargestAngle; }) {
      if (!(memory.sum(Sums::LargestAngle, lane) < Form::kLargestAngle)) return false;
    }
    return memory.sum(Sums::FastestSpin, lane) * step <= most;
  }

  /// Whether the energies of the last steps balance; takes them if they do. Where the explicit
  /// geometry is too coarse (a beam that whips, a string under tension) they do not.
  bool energy_is_balanced(const Memory& memory, std::size_t memory_lane, std::size_t lane) {
    LastBalance& last = last_balances_[lane];
    const Balance now = balance_of(memory, memory_lane, lane);
    const double size = std::max(last.size, now.size);
    constexpr double kRounding = 256.0 * std::numeric_limits<Real>::epsilon();
    if (!(std::fabs(now.sum - last.sum) <= kBalanceTolerance * size + kRounding * now.terms)) {
      return false;
    }
    last.sum = now.sum;
    last.size = size;
    return true;
  }

  /// The energy balance of a lane.
  struct Balance {
    double sum;    ///< of what is there and what has gone, less what has come in [J]
    double size;   ///< the largest of the entries [J]
    double terms;  ///< the largest term that these are differences of [J]
  };
  Balance balance_of(const Memory& memory, std::size_t memory_lane, std::size_t lane) const {
    const double kinetic = memory.sum(Sums::Kinetic, memory_lane);
    const double elastic = memory.sum(Sums::Elastic, memory_lane);
    const double dissipated = memory.sum(Sums::Damping, memory_lane) +
                              memory.sum(Sums::NumericalDissipation, memory_lane) +
                              scenarios_[lane].plastic_work(memory, memory_lane);
    const double potential = memory.sum(Sums::Potential, memory_lane);
    const double came = counts_loads_ ? memory.sum(Sums::Loads, memory_lane)
                                      : potential - last_balances_[lane].potential;
    return {kinetic + elastic + dissipated - came,
            std::max({kinetic, elastic, std::fabs(dissipated), std::fabs(came)}),
            std::max({kinetic, elastic, std::fabs(potential),
                      std::fabs(last_balances_[lane].potential)})};
  }

  /// Goes from the last state that held with shorter steps, alone. @return whether it got there
  bool retry(std::size_t lane, double step, double steps) {
    Scenario& scenario = scenarios_[lane];
    const double shortest = std::max(scenario.model().options.smallest_step, kShortest);
    if (alone_lane_ != lane) alone_.set(std::span<const Scenario>(&scenario, 1), 1);
    alone_lane_ = lane;
    if (!loads_change_) set_loads(alone_, time_, time_);
    for (double cut = 2.0; 1.0 / cut >= shortest && !is_raised(scenario.hooks().stop); cut *= 2.0) {
      ++scenario.response().counters.cutbacks;
      alone_.copy_lane(0, *before_, lane);
      if (!march_alone(lane, step / cut, steps * cut)) continue;
      observables_.one(alone_.beam(counts_loads_));
      if (!energy_is_balanced(alone_, 0, lane)) continue;
      memory_.copy_lane(lane, alone_, 0);
      last_step_ = 0.0;  // this lane aims anew, with the same bits for all others
      observed_ = false;
      observe();
      scenario.response().counters.steps += static_cast<int>(steps * cut);
      note_step(step / cut, scenario.response());
      return true;
    }
    return false;
  }

  /// @return whether all steps could be taken
  bool march_alone(std::size_t lane, double step, double steps) {
    for (double done = 0.0; done < steps; done += kSteps) {
      const double now = std::min(steps - done, kSteps);
      march(alone_, kernels_.one, time_ + done * step, step, static_cast<std::size_t>(now),
            done > 0.0);
      scenarios_[lane].response().counters.iterations += static_cast<int>(now);
      if (is_raised(scenarios_[lane].hooks().stop)) return false;
      if (!alone_.is_finite(0) || !rotates_little(alone_, 0, step)) return false;
    }
    return true;
  }

  /// Steps between two observations.
  static constexpr double kSteps = 256.0;
  /// Steps times segments times lanes between two questions whether to stop: some 20 ms.
  static constexpr std::size_t kStepsOfSegments = std::size_t{1} << 20;
  /// Steps are cut back to no less than this part, whatever `smallest_step` allows: what is not
  /// stable then will not be.
  static constexpr double kShortest = 1.0 / 1024.0;

  int order_;
  const lanes::StepKernels<Beam>& kernels_;
  const lanes::ObservablesKernels<Beam>& observables_;
  std::vector<Scenario> scenarios_;
  std::size_t count_ = 0;  ///< of them that run
  Memory memory_;
  Memory sampled_;                  ///< states at the last sample
  Memory kept_;                     ///< and later than that, before the last steps
  const Memory* before_ = nullptr;  ///< that of them from before the last steps
  double sampled_time_ = 0.0;
  Memory alone_;  ///< of a lane that needs shorter steps
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::size_t alone_lane_ = kNone;  ///< which
  bool observed_ = false;           ///< whether the memory's observables are of its states
  /// Energies of a lane so far [J].
  struct LastBalance {
    double sum = 0.0, size = 0.0, potential = 0.0;
  };
  std::vector<LastBalance> last_balances_;
  bool loads_change_ = false;
  bool counts_loads_ = false;
  double time_ = 0.0;
  double last_step_ = 0.0;  ///< that the memory is aimed for; 0: none
};

}  // namespace plastica
