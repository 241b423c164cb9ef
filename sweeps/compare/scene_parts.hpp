#pragma once

#include <array>
#include <string_view>

#include "plastica/model/section.hpp"
#include "sweeps/compare/closed_forms.hpp"

/// What closed forms ask of a scene; not installed. Each throws InputError with a rule in words
/// where the scene is another.
namespace plastica::sweeps {

/// Refuses what a closed form does not hold for.
void require_scene(bool holds, std::string_view rule);

/// A straight, even beam that is clamped at its start and free at its end, and its one load.
struct Cantilever {
  double length = 0.0;  ///< [m]
  SectionProperties section{};
  double bending_stiffness = 0.0;  ///< E I about x [N m^2]
  std::array<double, 3> force{};   ///< at the tip, at the end of the run [N]
  std::array<double, 3> moment{};  ///< at the tip, at the end of the run [N m]
};

/// @throws InputError unless the scene is that, with a point load at its end alone, no gravity
Cantilever cantilever_of(const Setup& setup);

/// The probe of a quantity that is taken of one at the end of the run.
const Probe& end_probe(const Setup& setup, const Quantity& quantity);

/// Time at which a run ends [s].
double end_time(const Setup& setup);

}  // namespace plastica::sweeps
