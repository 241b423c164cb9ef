#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "plastica/run/chain_model.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// What a frame of a chain's history consists of.
inline constexpr std::array<std::vector<double> ChainHistory::*, 9> kShapeValues{
    &ChainHistory::position,       &ChainHistory::moment,        &ChainHistory::force,
    &ChainHistory::angle,          &ChainHistory::plastic_angle, &ChainHistory::rotation,
    &ChainHistory::plastic_strain, &ChainHistory::stress,        &ChainHistory::reaction};

/// Makes room for so many frames, with zeros.
inline void size_shape(const ChainModel& model, std::size_t frames, ChainHistory& history) {
  history.joints = model.layout.size() + 1;
  history.supports = model.scene.supports.size();
  const std::size_t joints = frames * history.joints;
  for (std::vector<double>* values : {&history.position, &history.moment, &history.force,
                                      &history.angle, &history.plastic_angle}) {
    values->assign(3 * joints, 0.0);
  }
  history.rotation.assign(3 * frames * model.layout.size(), 0.0);
  history.plastic_strain.assign(joints, 0.0);
  history.stress.assign(joints, 0.0);
  history.reaction.assign(6 * frames * history.supports, 0.0);
}

}  // namespace plastica
