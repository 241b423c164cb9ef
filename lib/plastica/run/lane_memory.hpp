#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "plastica/run/lane_arrays.hpp"
#include "plastica/run/lane_scenario.hpp"

namespace plastica {

/// What the kernels know of scenarios that are stepped side by side.
template <class Form, class Real>
class LaneMemory {
 public:
  using Kind = typename Form::Kind;
  using Load = typename Form::Load;
  using State = typename Form::State;
  using Sums = typename Form::Sums;
  using Observables = typename Form::Observables;
  using Scenario = LaneScenario<Form>;

  /// Lays out `width` lanes; those beyond the scenarios are like the last one.
  void set(std::span<const Scenario> scenarios, std::size_t width) {
    width_ = width;
    segments_ = scenarios.front().chain().size();
    histories_ = scenarios.front().chain().histories.size();
    set_kinds(scenarios);
    set_load_forms(scenarios);
    state_ = AlignedNumbers<Real>(segments_ * State::kCount * width);
    work_ = AlignedNumbers<Real>(segments_ * Form::Work::kCount * width);
    sums_ = AlignedNumbers<Real>(Sums::kCount * width);
    observables_ = AlignedNumbers<Real>(segments_ * Observables::kCount * width);
    for (std::size_t i = 0; i < segments_; ++i) {
      for (std::size_t lane = 0; lane < width; ++lane) {
        const auto state = of_lane(scenarios, lane).state(i);
        for (std::size_t field = 0; field < State::kCount; ++field) {
          state_[index<State>(i, field, lane)] = static_cast<Real>(state[field]);
        }
      }
    }
  }

  /// Segments of all lanes.
  std::size_t numbers() const { return segments_ * width_; }

  /// Takes the factors of all loads.
  /// @param factor  of a history's number
  template <class Factor>
  void set_loads(const Factor& factor) {
    const std::size_t size = Load::kCount * width_;
    const AlignedNumbers<double>& forms = load_forms_.numbers();
    const std::size_t kinds = loads_.size() / size;
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      for (std::size_t j = 0; j < size; ++j) {
        double sum = 0.0;
        for (std::size_t h = 0; h < histories_; ++h) {
          sum += factor(h) * forms[(kind * histories_ + h) * size + j];
        }
        loads_[kind * size + j] = static_cast<Real>(sum);
      }
    }
  }

  typename Form::template Beam<Real> beam(bool counts_loads) {
    return {segments_,           kinds_.index(), kinds_.numbers().data(),
            load_forms_.index(), loads_.data(),  state_.data(),
            work_.data(),        sums_.data(),   observables_.data(),
            counts_loads};
  }

  std::array<double, State::kCount> state(std::size_t i, std::size_t lane) const {
    std::array<double, State::kCount> state{};
    for (std::size_t field = 0; field < State::kCount; ++field) {
      state[field] = static_cast<double>(state_[index<State>(i, field, lane)]);
    }
    return state;
  }
  std::array<double, Observables::kCount> observables(std::size_t i, std::size_t lane) const {
    std::array<double, Observables::kCount> observables{};
    for (std::size_t field = 0; field < Observables::kCount; ++field) {
      observables[field] = static_cast<double>(observables_[index<Observables>(i, field, lane)]);
    }
    return observables;
  }
  double sum(std::size_t field, std::size_t lane) const {
    return static_cast<double>(sums_[field * width_ + lane]);
  }
  /// Forgets how fast segments have been and how far joints have turned.
  void reset_extremes() {
    for (std::size_t lane = 0; lane < width_; ++lane) {
      sums_[Sums::FastestSpin * width_ + lane] = Real(0);
      if constexpr (requires { Sums::LargestAngle; }) {
        sums_[Sums::LargestAngle * width_ + lane] = Real(0);
      }
    }
  }
  /// Whether all of a lane's state is.
  bool is_finite(std::size_t lane) const {
    Real none = 0;
    for (std::size_t k = lane; k < state_.size(); k += width_) none += state_[k] * Real(0);
    return none == Real(0);
  }

  /// Takes states and sums of a memory of the same layout.
  void copy_states(const LaneMemory& from) {
    if (state_.size() != from.state_.size()) {
      width_ = from.width_;
      segments_ = from.segments_;
      state_ = AlignedNumbers<Real>(from.state_.size());
      sums_ = AlignedNumbers<Real>(from.sums_.size());
    }
    state_.copy(from.state_);
    sums_.copy(from.sums_);
  }
  /// Takes state and sums of one lane.
  void copy_lane(std::size_t to, const LaneMemory& from, std::size_t lane) {
    for (std::size_t i = 0; i < segments_; ++i) {
      for (std::size_t field = 0; field < State::kCount; ++field) {
        state_[index<State>(i, field, to)] = from.state_[from.index<State>(i, field, lane)];
      }
    }
    for (std::size_t field = 0; field < Sums::kCount; ++field) {
      sums_[field * width_ + to] = from.sums_[field * from.width_ + lane];
    }
  }

 private:
  template <class Fields>
  std::size_t index(std::size_t i, std::size_t field, std::size_t lane) const {
    return (i * Fields::kCount + field) * width_ + lane;
  }
  static const Scenario& of_lane(std::span<const Scenario> scenarios, std::size_t lane) {
    return scenarios[std::min(lane, scenarios.size() - 1)];
  }

  void set_kinds(std::span<const Scenario> scenarios) {
    std::vector<double> entries(segments_ * Kind::kCount * width_);
    for (std::size_t i = 0; i < segments_; ++i) {
      for (std::size_t lane = 0; lane < width_; ++lane) {
        const auto kind = of_lane(scenarios, lane).kind(i);
        for (std::size_t field = 0; field < Kind::kCount; ++field) {
          entries[index<Kind>(i, field, lane)] = kind[field];
        }
      }
    }
    kinds_.set(entries, Kind::kCount * width_);
  }

  /// Loads at a unit factor of each history.
  void set_load_forms(std::span<const Scenario> scenarios) {
    const std::size_t size = Load::kCount * width_;
    std::vector<double> entries(segments_ * histories_ * size);
    for (std::size_t lane = 0; lane < width_; ++lane) {
      for (const auto& load : of_lane(scenarios, lane).chain().loads) {
        std::array<double, Load::kCount> numbers{};
        Form::add_load(load, numbers);
        for (std::size_t field = 0; field < Load::kCount; ++field) {
          entries[(load.segment * histories_ + load.history) * size + field * width_ + lane] +=
              numbers[field];
        }
      }
    }
    load_forms_.set(entries, histories_ * size);
    loads_ = AlignedNumbers<Real>(load_forms_.numbers().size() / histories_);
  }

  std::size_t width_ = 0;
  std::size_t segments_ = 0;
  std::size_t histories_ = 0;
  SharedEntries<Real> kinds_;
  SharedEntries<double> load_forms_;  ///< (histories x Load::kCount an entry)
  AlignedNumbers<Real> loads_, state_, work_, sums_, observables_;
};

}  // namespace plastica
