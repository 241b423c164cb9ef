#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plastica/model/choose_level.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::model_detail {

/// An estimate of the lowest frequency at which a beam deforms.
struct FirstFrequency {
  double hertz = 0.0;
  bool torsion = false;        ///< of a beam that only twists; else in bending
  bool leaves_masses = false;  ///< the beam carries point masses, which are left out
};

/// Of the scene's own section and material, straight, over the longest stretch between supports
/// that hold it rigidly; a support inside of the beam counts as a pin, towards an overhang as a
/// clamp. Springs and pillars count as nothing. Empty for a single segment.
///
/// Bending: omega = (beta L)^2 sqrt(E I/(rho A L^4)), in the weaker of the planes of the level.
/// @param section  of the scene's own
/// @param ends     of `segment_ends`
/// Torsion: omega = (pi/L, one end free of two: pi/2L) sqrt(G J/(rho (I_x + I_y))).
/// Source: Blevins, Formulas for Natural Frequency and Mode Shape (1979), ch. 8.
std::optional<FirstFrequency> first_frequency(const Scene& scene, const LevelChoice& level,
                                              const SectionProperties& section,
                                              std::span<const double> ends);

/// A history that is smooth, as a sine, and the shortest period in it [s]: that of a sine of the
/// same range and the same largest curvature.
struct HistoryPeriod {
  double period = 0.0;
  std::string name{};  ///< "load[2].history"
};
/// The shortest of a scene's smooth histories; empty if it has none.
std::optional<HistoryPeriod> shortest_history(const Scene& scene);

/// The part of `scene_warnings` that only dynamics have.
std::vector<std::string> motion_warnings(const Scene& scene, const SolverOptions& options,
                                         const LevelChoice& level, const SectionProperties& section,
                                         std::span<const double> ends);

}  // namespace plastica::model_detail
