#pragma once

#include "plastica/chain/layout.hpp"
#include "plastica/model/scene.hpp"

namespace plastica {

/// In space: refuses supports that hold or spring rotations about axes of the world to which those
/// of the joint there lie skew.
/// @throws InputError
void check_support_axes(const Scene& scene, const chain::Layout& layout);

}  // namespace plastica
