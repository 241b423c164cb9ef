#pragma once

#include <vector>

#include "plastica/chain/joint_model.hpp"
#include "plastica/run/chain_model.hpp"

namespace plastica {

/// The joints at a chain's nodes with the material numbers of its scene (N + 1).
std::vector<chain::JointModel> scene_joints(const ChainModel& model);

}  // namespace plastica
