#pragma once

#include <array>
#include <string_view>

#include "plastica/model/section.hpp"
#include "plastica/theory/beam_cases.hpp"
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

/// Whether a place is the beam's start (0) or end (1).
bool is_at_end(const Place& place, double fraction, const Setup& setup);

/// Where a place is, from the start along the beam [m].
double distance_of(const Place& place, const Setup& setup);

/// A straight, even beam that a load bends in the y-z plane, small displacements.
struct BentBeam {
  theory::BeamCase beam{};
  SectionProperties section{};
};

/// @throws InputError unless the scene is that: clamped or pinned at its start, free, clamped or
///         held across at its end, with one load along y, one moment about x, or gravity along y
BentBeam bent_beam_of(const Setup& setup);

/// Refuses a beam that yields about x.
/// @param moment  the largest of the run [N m], >= 0
void require_elastic(const Setup& setup, double moment);

/// The largest size of a history's factor up to the end of the run.
double largest_factor(const History& history, const Setup& setup);

/// The probe of a quantity that is taken of one at the end of the run.
const Probe& end_probe(const Setup& setup, const Quantity& quantity);

/// Time at which a run ends [s].
double end_time(const Setup& setup);

}  // namespace plastica::sweeps
