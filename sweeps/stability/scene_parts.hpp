#pragma once

#include "plastica/model/section.hpp"
#include "sweeps/stability/base_scene.hpp"

/// What the makers of base scenes share.
namespace plastica::sweeps::stability::parts {

/// The yield stress that sizes of loads refer to, whatever the beam's own is [Pa].
inline constexpr double kNominalYield = 250e6;

/// A straight beam of the knobs without supports, loads and probes.
StabilityCase beam(const Knobs& knobs, Level level, YieldModel model);
/// The same, clamped at its start.
StabilityCase cantilever(const Knobs& knobs, Level level, YieldModel model);

/// Numbers of a beam.
struct Numbers {
  explicit Numbers(const Knobs& knobs);

  double L, h;         ///< length, depth [m]
  double n;            ///< segments
  double EI, GJ;       ///< [N m^2]
  double area;         ///< [m^2]
  double yield;        ///< first yield of the nominal steel [N m]
  double twist_yield;  ///< torque at first yield of the nominal steel [N m]
  double rho_A;        ///< mass per length [kg/m]
  double rho_I;        ///< rotary inertia of bending per length [kg m]
  SectionProperties section;
};

/// Adds a probe. @return its number
std::size_t probe(StabilityCase& made, ProbeQuantity quantity, Place at, Component component);
std::size_t probe(StabilityCase& made, EnergyKind energy);

/// A load at a place.
void push(StabilityCase& made, Place at, const std::array<double, 3>& force,
          const std::array<double, 3>& moment, const History& history = History::ramp());

/// Steps of the knobs.
/// @param period  of the slowest vibration [s]
void in_motion(StabilityCase& made, const Knobs& knobs, double period);

/// First period of a cantilever in bending, of a bar clamped at one end in torsion [s].
double bending_period(const Numbers& beam);
double twisting_period(const Numbers& beam);

/// 1, or how many of a chain's parts a number of segments makes: integers of knobs.
int rounded(double number);

}  // namespace plastica::sweeps::stability::parts
