#pragma once

#include <vector>

namespace plastica {

/// How a beam is deformed; decides what strain and stress mean. They are those of the extreme
/// fibre:
/// tension: strain = elongation/length,                  stress = F/A;
/// bending (about x): strain = curvature h/2,            stress = M/W_x (elastic modulus);
/// torsion: strain = gamma = (J/W_t) twist per length,   stress = T/W_t.
enum class Deformation { Tension, Bending, Torsion };

/// A prescribed strain history, from an undeformed beam at zero.
struct Drive {
  Deformation deformation = Deformation::Tension;
  std::vector<double> strain;  ///< at each sample [1] (n_samples), any path: up, down, reversed
};

}  // namespace plastica
