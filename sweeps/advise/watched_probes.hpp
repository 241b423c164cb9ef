#pragma once

#include <string>
#include <vector>

#include "plastica/model/field.hpp"
#include "sweeps/advise/outcome.hpp"

/// Which probes advice looks at; not installed.
namespace plastica::sweeps {

struct WatchedProbes {
  std::vector<WatchedProbe> watched;
  std::vector<std::string> left_out;  ///< names, of all that were not asked for by name
};

/// The probes of a scene that are named; without names all but those that are given beforehand
/// (load factors) and those that are errors themselves (residual and numerical energy).
///
/// Each has a value below which it is rounding, 1e-9 of a scale: the beam's length L, one radian,
/// Young's modulus, E I/L of moments and energies, E I/L^2 of forces, L and one radian over the
/// duration of speeds; I is the larger second moment of area.
/// @throws InputError for a name that is no probe's, or if nothing is left to look at
WatchedProbes watched_probes(const Setup& setup, const std::vector<std::string>& names);

}  // namespace plastica::sweeps
