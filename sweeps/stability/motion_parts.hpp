#pragma once

#include <array>

#include "sweeps/stability/scene_parts.hpp"

/// Motions that scenes of the planar and of the spatial level share.
namespace plastica::sweeps::stability::parts {

/// First period of a free beam that bends [s].
double free_period(const Numbers& b);

/// A beam with pinned ends that vibrates across, along y, in its first mode; its deflection is that
/// of the exact chain.
StabilityCase vibration_on(const Knobs& knobs, Level level);

/// Adds a rigid motion to all of a free beam, and that momenta are kept.
/// @param spin   about world axes [rad/s]
/// @param speed  along y, and half of it along z [m/s]
void fly(StabilityCase& made, const Knobs& knobs, const std::array<double, 3>& spin, double speed);

/// A cantilever whose outer half is struck at `load` times the speed at which a wave of it brings
/// the nominal steel to yield; on the spatial level along x, too.
StabilityCase struck_of(const Knobs& knobs, YieldModel model, Level level);

}  // namespace plastica::sweeps::stability::parts
