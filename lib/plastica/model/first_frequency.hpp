#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plastica/model/choose_level.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::model_detail {

enum class Vibration { Bending, Torsion, Stretch };

/// An estimate of the lowest frequency at which a beam deforms.
struct FirstFrequency {
  double hertz = 0.0;
  Vibration of = Vibration::Bending;
  bool leaves_masses = false;  ///< the beam carries point masses, which are left out
};

/// Of the scene's own section and material, straight, over the longest stretch between supports
/// that hold it rigidly; a support inside of the beam counts as a pin, towards an overhang as a
/// clamp. Springs and pillars count as nothing. Empty for a single segment.
///
/// Bending: omega = (beta L)^2 sqrt(E I/(rho A L^4)), in the weaker of the planes of the level.
/// Torsion of a beam that only twists: omega = (pi/L, one end free of two: pi/2L)
/// sqrt(G J/(rho (I_x + I_y))); stretching: with sqrt(E/rho).
/// Source: Blevins, Formulas for Natural Frequency and Mode Shape (1979), ch. 8.
/// @param section  of the scene's own
/// @param ends     of `segment_ends`
std::optional<FirstFrequency> first_frequency(const Scene& scene, const LevelChoice& level,
                                              const SectionProperties& section,
                                              std::span<const double> ends);

/// What of a motion says which of its vibrations are excited.
struct ExcitedMotion {
  JointTranslation translation = JointTranslation::Rigid;
  double duration = 0.0;  ///< [s]
};

/// What is excited besides: the first twist in space, and the first stretch of joints that stretch,
/// where a load, a support or an initial motion about or along the axis makes it swing, and the
/// beam is no spring of point masses. Gravity stretches by next to nothing.
std::vector<FirstFrequency> excited_frequencies(const Scene& scene, const LevelChoice& level,
                                                const ExcitedMotion& motion,
                                                const SectionProperties& section,
                                                std::span<const double> ends);

/// "first frequency in torsion, about 682 Hz"
std::string frequency_text(const FirstFrequency& first);

}  // namespace plastica::model_detail
