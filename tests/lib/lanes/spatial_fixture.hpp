#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "plastica/lanes/kernel_table.hpp"
#include "tests/lib/lanes/memory.hpp"

namespace plastica::lanes::testing {

/// Spatial beams of random numbers, every segment of a kind of its own; lane k of a wide one is the
/// beam of seed k.
template <class Real>
struct RandomSpatialBeams {
  std::size_t segments, width;
  std::vector<std::uint32_t> index;
  Numbers<Real> kinds, loads, state, work, sums, observables;

  RandomSpatialBeams(std::size_t n, std::size_t lanes, unsigned first_seed = 0)
      : segments(n),
        width(lanes),
        kinds(n * SpatialKind::kCount * lanes),
        loads(n * SpatialLoad::kCount * lanes),
        state(n * SpatialState::kCount * lanes),
        work(n * SpatialWork::kCount * lanes),
        sums(SpatialSums::kCount * lanes),
        observables(n * SpatialObservables::kCount * lanes) {
    for (std::size_t i = 0; i < n; ++i) index.push_back(static_cast<std::uint32_t>(i));
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      std::mt19937 random(first_seed + static_cast<unsigned>(lane));
      for (std::size_t i = 0; i < n; ++i) fill(i, lane, random);
    }
  }

  Real& kind(std::size_t i, std::size_t field, std::size_t lane = 0) const {
    return kinds[place(i, SpatialKind::kCount, field, width, lane)];
  }
  Real& load(std::size_t i, std::size_t field, std::size_t lane = 0) const {
    return loads[place(i, SpatialLoad::kCount, field, width, lane)];
  }
  Real& at(std::size_t i, std::size_t field, std::size_t lane = 0) const {
    return state[place(i, SpatialState::kCount, field, width, lane)];
  }
  Real& sum(std::size_t field, std::size_t lane = 0) const { return sums[field * width + lane]; }

  SpatialBeam<Real> beam() const {
    return {segments,     index.data(), kinds.data(), index.data(),       loads.data(),
            state.data(), work.data(),  sums.data(),  observables.data(), true};
  }

 private:
  void fill(std::size_t i, std::size_t lane, std::mt19937& random) {
    const auto between = [&](double a, double b) {
      return static_cast<Real>(std::uniform_real_distribution<double>(a, b)(random));
    };
    const Real length = between(0.05, 0.2);
    const Real mass = between(0.5, 2.0);
    const Real center = length * between(0.3, 0.7);
    kind(i, SpatialKind::Length, lane) = length;
    kind(i, SpatialKind::Mass, lane) = mass;
    kind(i, SpatialKind::FirstMoment, lane) = mass * center;
    kind(i, SpatialKind::Free, lane) = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Real rod = mass * (center * center + length * length / 12);
      kind(i, SpatialKind::Inertia + k, lane) = rod * (k == 2 ? between(0.1, 0.2) : between(1, 2));
      const Real stiffness = between(50.0, 200.0);
      kind(i, SpatialKind::Stiffness + k, lane) = stiffness;
      kind(i, SpatialKind::Compliance + k, lane) = 1 / stiffness;
      kind(i, SpatialKind::Damping + k, lane) = between(0.0, 0.1);
      kind(i, SpatialKind::Cap + k, lane) = stiffness * between(0.1, 0.3);
      at(i, SpatialState::Angle + k, lane) = between(-0.3, 0.3);
      at(i, SpatialState::Rate + k, lane) = between(-1.0, 1.0);
      at(i, SpatialState::AngularAcceleration + k, lane) = between(-5.0, 5.0);
      at(i, SpatialState::AngleRate + k, lane) = between(-1.0, 1.0);
    }
    for (std::size_t field = 0; field < SpatialLoad::kCount; ++field) {
      load(i, field, lane) = between(-1.0, 1.0);
    }
  }
};

}  // namespace plastica::lanes::testing
