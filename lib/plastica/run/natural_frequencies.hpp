#pragma once

#include <vector>

#include "plastica/run/model.hpp"

namespace plastica {

/// The lowest natural frequencies of a beam on which nothing acts: small undamped vibrations about
/// its undeformed shape, rising [Hz] (count).
///
/// The chain is that of the scene's level, with the tangent of its joints' laws at rest, springs,
/// half joints and rigid clamps, and the inertia that `solver.rotary_inertia` asks for. Supports
/// hold their directions still, whatever motion they prescribe; pillars, which push on one side
/// alone, are left out, and so is all that loads and gravity do to the stiffness. Modes that
/// nothing resists (rigid-body motions of a free beam, hinges) have the frequency 0. So have those
/// whose frequency is below 1e-5 of what the softest joint or support and the mass that it moves
/// make. Found by counting negative pivots, in time proportional to segments and `count`.
/// @param model  of a chain
/// @param count  1 … `chain_freedoms`
/// @throws InputError if the model is a coupon or count is out of range
std::vector<double> unloaded_frequencies(const Model& model, int count);

/// The same of a scene, whether it is one of statics or of dynamics.
/// @param options  level, translation, fibres and rotary_inertia are read
/// @throws InputError as `prepare` of the scene in motion, and as above
std::vector<double> unloaded_frequencies(const Scene& scene, const SolverOptions& options,
                                         int count);

/// What `natural_frequencies` gives.
struct LoadedFrequencies {
  Status status = Status::NotRun;  ///< of the path to the loaded state
  std::vector<double> frequency;   ///< [Hz] (count), or none where that was not reached
};

/// The lowest natural frequencies of a beam about its loaded state: the end of a path of
/// equilibria; of a motion, the equilibrium under what acts at its time 0. Where nothing acts,
/// those of the unloaded beam. A planar level has those in its plane. Forces take part in the
/// stiffness, supports that touch hold, and joints that have yielded unload. The unstable modes
/// of an unstable state have the frequency 0.
/// @param options  as for `simulate`
/// @param count    1 … the chain's degrees of freedom
/// @throws InputError as `prepare`, and as above; where loads have no potential (they follow their
///         segment, or in space are moments of a fixed axis)
LoadedFrequencies natural_frequencies(const Scene& scene, const SolverOptions& options, int count);

/// Degrees of freedom of a chain: its number of natural frequencies.
/// @throws InputError if the model is a coupon
int chain_freedoms(const Model& model);

}  // namespace plastica
