#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "plastica/lanes/kernel_table.hpp"
#include "tests/lib/lanes/memory.hpp"

namespace plastica::lanes::testing {

/// Beams of random numbers, every segment of a kind of its own; lane k of a wide one is the beam of
/// seed k.
template <class Real>
struct RandomBeams {
  std::size_t segments, width;
  std::vector<std::uint32_t> index;
  Numbers<Real> kinds, loads, state, work, sums, observables;

  RandomBeams(std::size_t n, std::size_t lanes, unsigned first_seed = 0)
      : segments(n),
        width(lanes),
        kinds(n * PlanarKind::kCount * lanes),
        loads(n * PlanarLoad::kCount * lanes),
        state(n * PlanarState::kCount * lanes),
        work(n * PlanarWork::kCount * lanes),
        sums(PlanarSums::kCount * lanes),
        observables(n * PlanarObservables::kCount * lanes) {
    for (std::size_t i = 0; i < n; ++i) index.push_back(static_cast<std::uint32_t>(i));
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      std::mt19937 random(first_seed + static_cast<unsigned>(lane));
      for (std::size_t i = 0; i < n; ++i) fill(i, lane, random);
    }
  }

  Real& kind(std::size_t i, std::size_t field, std::size_t lane = 0) const {
    return kinds[place(i, PlanarKind::kCount, field, width, lane)];
  }
  Real& load(std::size_t i, std::size_t field, std::size_t lane = 0) const {
    return loads[place(i, PlanarLoad::kCount, field, width, lane)];
  }
  Real& at(std::size_t i, std::size_t field, std::size_t lane = 0) const {
    return state[place(i, PlanarState::kCount, field, width, lane)];
  }
  Real& sum(std::size_t field, std::size_t lane = 0) const { return sums[field * width + lane]; }

  PlanarBeam<Real> beam() const {
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
    const Real stiffness = between(50.0, 200.0);
    kind(i, PlanarKind::Length, lane) = length;
    kind(i, PlanarKind::Mass, lane) = mass;
    kind(i, PlanarKind::FirstMoment, lane) = mass * center;
    kind(i, PlanarKind::Inertia, lane) = mass * (center * center + length * length / 12);
    kind(i, PlanarKind::Rest, lane) = between(-0.3, 0.3);
    kind(i, PlanarKind::Stiffness, lane) = stiffness;
    kind(i, PlanarKind::Compliance, lane) = 1 / stiffness;
    kind(i, PlanarKind::Damping, lane) = between(0.0, 0.1);
    kind(i, PlanarKind::Cap, lane) = stiffness * between(0.1, 0.3);
    for (std::size_t field = 0; field < PlanarLoad::kCount; ++field) {
      load(i, field, lane) = between(-3.0, 3.0);
    }
    at(i, PlanarState::Angle, lane) = between(-0.2, 0.2);
    at(i, PlanarState::Rate, lane) = between(-1.0, 1.0);
    at(i, PlanarState::AngularAcceleration, lane) = between(-5.0, 5.0);
  }
};

}  // namespace plastica::lanes::testing
