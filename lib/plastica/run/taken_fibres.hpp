#pragma once

#include "plastica/model/scene.hpp"

namespace plastica {

/// The largest `solver.fibres` with which a scene is the same to run: of thin walls few fibres are
/// as many as more (`law::taken_fibres`). That of the options where the joints have no fibres, and
/// of a scene that is refused.
int taken_fibres(const Scene& scene, const SolverOptions& options);

}  // namespace plastica
