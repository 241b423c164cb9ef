#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "plastica/run/response.hpp"

namespace plastica::testing {

/// All that a response says, but how long it took, bit by bit: two runs that are the same have
/// equal ones.
inline std::vector<std::uint64_t> bits_of(const Response& response) {
  std::vector<std::uint64_t> bits;
  const auto add = [&](double number) { bits.push_back(std::bit_cast<std::uint64_t>(number)); };
  const auto add_all = [&](const std::vector<double>& numbers) {
    bits.push_back(numbers.size());
    for (const double number : numbers) add(number);
  };
  bits.push_back(static_cast<std::uint64_t>(response.status));
  bits.push_back(response.samples);
  for (const int count :
       {response.counters.steps, response.counters.iterations, response.counters.cutbacks}) {
    bits.push_back(static_cast<std::uint64_t>(count));
  }
  add(response.permanent_strain);
  add(response.momentum_error);
  bits.push_back(response.axial ? 1 : 0);
  if (response.axial) {
    for (const double number : {response.axial->ratio, response.axial->fraction,
                                response.axial->left, response.axial->thrust}) {
      add(number);
    }
  }
  add(response.energy_balance_error);
  add(response.shortest_step);
  add(response.longest_step);
  bits.push_back(response.unheld_thrust ? 1 : 0);
  if (response.limit) {
    add(response.limit->below);
    add(response.limit->above);
  }
  for (const std::vector<double>& probe : response.probes) add_all(probe);
  const ChainHistory& chain = response.chain;
  for (const std::vector<double>* numbers :
       {&chain.time, &chain.factor, &chain.position, &chain.moment, &chain.force, &chain.angle,
        &chain.plastic_angle, &chain.rotation, &chain.velocity, &chain.spin, &chain.plastic_strain,
        &chain.stress, &chain.reaction}) {
    add_all(*numbers);
  }
  for (const Energies& energy : chain.energy) {
    for (const double term :
         {energy.elastic, energy.plastic, energy.external, energy.residual, energy.kinetic,
          energy.damping, energy.numerical_dissipation, energy.impact, energy.fracture}) {
      add(term);
    }
  }
  for (const int count : chain.iterations) bits.push_back(static_cast<std::uint64_t>(count));
  for (const std::size_t sample : chain.frame_sample) bits.push_back(sample);
  for (const ChainBreak& event : chain.events) {
    add(event.time);
    for (const BrokenJoint& joint : event.joints) {
      bits.push_back(static_cast<std::uint64_t>(joint.joint));
      for (const double term : {joint.strain, joint.moment[0], joint.dissipation}) add(term);
    }
  }
  return bits;
}

}  // namespace plastica::testing
