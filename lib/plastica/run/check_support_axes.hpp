#pragma once

#include "plastica/chain/layout.hpp"
#include "plastica/model/scene.hpp"

namespace plastica {

/// Refuses supports that hold or spring rotations about axes of the world to which those of the
/// joint there lie skew, of a beam in a plane, too, whose stability out of it is looked at; and
/// moments that follow the beam at a rotational spring within, which would take its share as if
/// they did not.
/// @throws InputError
void check_support_axes(const Scene& scene, const chain::Layout& layout);

}  // namespace plastica
