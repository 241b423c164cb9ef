#pragma once

#include "plastica/model/scene.hpp"

namespace plastica {

/// @throws InputError if a region cannot follow the law of the rest of the beam
void check_regions(const Scene& scene);

}  // namespace plastica
