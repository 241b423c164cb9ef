#pragma once

#include <vector>

#include "plastica/chain/joint_model.hpp"
#include "plastica/run/chain_model.hpp"

namespace plastica {

/// The joints at a chain's nodes (N + 1).
/// @param material  of the scene's own parts; where two parts meet, it decides which is the weaker
///                  one, whose joint it is
std::vector<chain::JointModel> scene_joints(const ChainModel& model,
                                            const MaterialValues<double>& material);

}  // namespace plastica
