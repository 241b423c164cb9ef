#pragma once

#include <string>

#include "plastica/model/scene.hpp"

namespace plastica {

/// The plane of a planar level, by the axis about which its joints bend.
enum class BendingAxis {
  X,  ///< in the y-z plane
  Y,  ///< in the x-z plane
};

/// How much of a scene is modelled, and why.
struct LevelChoice {
  Level level = Level::Spatial;          ///< never Auto
  BendingAxis bending = BendingAxis::X;  ///< Planar alone
  std::string reason;  ///< one line: "planar: every load, support and joint axis lies in …"
};

/// Chooses the level of a scene whose parts are valid.
///
/// Level::Auto takes the least level that holds what acts on the beam: forces, moments, gravity,
/// moving supports, the push of pillars, initial motions, and its undeformed shape. What only holds
/// the beam still asks for nothing. Sections have their principal axes along x and y, so a load
/// along y bends about x alone. Where loads along the axis fit both planes, it is the one of least
/// stiffness, in which the beam buckles first. Planar levels do not see what leaves their plane by
/// itself, such as lateral buckling.
/// @throws InputError if `options.level` is too small: it names what does not fit
LevelChoice choose_level(const Scene& scene, const SolverOptions& options);

}  // namespace plastica
