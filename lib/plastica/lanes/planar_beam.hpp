#pragma once

#include <cstddef>
#include <cstdint>

/// What the planar kernels work on: plain memory, so that files compiled for different instruction
/// sets can share it. W scenarios lie side by side: number k of entry i of an array with K numbers
/// an entry is at [(i K + k) W + lane], aligned to 64 bytes.
namespace plastica::lanes {

/// Numbers of a kind of segment, with the joint at its inner end. Segments of one kind share them,
/// so that a uniform beam's stay in the nearest cache.
struct PlanarKind {
  enum : std::size_t {
    Length,       ///< from its inner to its outer joint [m]
    Mass,         ///< [kg]
    FirstMoment,  ///< mass times the distance of its center from the inner joint [kg m]
    Inertia,      ///< about the inner joint [kg m^2]
    Rest,         ///< direction from the inner neighbour's in the unloaded beam [rad]
    Stiffness,    ///< of the joint [N m/rad]
    Compliance,   ///< its inverse; infinite for a joint without any [rad/(N m)]
    Damping,      ///< of the joint [N m s/rad]
    Cap,          ///< moment at which the joint yields [N m]
    Hold,         ///< infinite for a clamped joint, else 0 [kg m^2]
    kCount
  };
};

/// Forces on a segment that keep their direction, at one time.
struct PlanarLoad {
  enum : std::size_t {
    ForceX,  ///< [N]
    ForceY,  ///< [N]
    LeverX,  ///< sum of force x distance along the segment from its inner joint [N m]
    LeverY,  ///< [N m]
    Moment,  ///< free [N m]
    Force = ForceX,
    Lever = LeverX,
    kCount = Moment + 1
  };
};

/// What a segment and its joint are between two steps.
struct PlanarState {
  enum : std::size_t {
    Angle,                ///< of the joint [rad]
    Rate,                 ///< [rad/s]
    Plastic,              ///< permanent angle of the joint [rad]
    Accumulated,          ///< sum of its changes' sizes [rad]
    AngularAcceleration,  ///< angular acceleration of the segment over the step before [rad/s^2]
    kCount
  };
};

/// What a step needs of a segment from one sweep to the next.
struct PlanarWork {
  enum : std::size_t {
    Cosine,  ///< of the segment's direction where the step's forces act
    Sine,
    Spin,                        ///< of the segment there [rad/s]
    ByAngularAcceleration,       ///< angular acceleration of the joint by the inner
                                 ///< neighbour's …
    ByAcceleration,              ///< … and by the joint's, along x and y,
    Given = ByAcceleration + 2,  ///< and what remains [rad/s^2]
    kCount
  };
};

/// Sums over steps and segments of each scenario.
struct PlanarSums {
  enum : std::size_t {
    Damping,               ///< dissipated by the joints' damping [J]
    NumericalDissipation,  ///< dissipated by the scheme: see README.md [J]
    Loads,                 ///< work of the loads, where it is counted [J]
    FastestSpin,           ///< largest |spin| of a segment at the end of a step [rad/s]
    // What `PlanarObservables` goes with, at one time:
    Kinetic,    ///< energy [J]
    Elastic,    ///< energy of the joints [J]
    Potential,  ///< work of the loads from the origin, were they always as they are now [J]
    kCount
  };
};

/// Where a segment is, between two steps.
struct PlanarObservables {
  enum : std::size_t {
    Place,  ///< of its inner joint, from the beam's start [m]
    X = Place,
    Y,
    Direction,  ///< [rad]
    Cosine,     ///< of the direction
    Sine,
    Spin,  ///< [rad/s]
    kCount
  };
};

template <class Real>
struct PlanarBeam {
  std::size_t segments;
  const std::uint32_t* kind;  ///< of each segment (segments)
  const Real* kinds;          ///< (kinds x PlanarKind::kCount)
  const std::uint32_t* load;  ///< of each segment (segments)
  const Real* loads;          ///< (loads x PlanarLoad::kCount)
  Real* state;                ///< (segments x PlanarState::kCount)
  Real* work;                 ///< (segments x PlanarWork::kCount)
  Real* sums;                 ///< (PlanarSums::kCount)
  Real* observables;          ///< (segments x PlanarObservables::kCount)
  bool counts_loads;          ///< whether PlanarSums::Loads is counted
};

}  // namespace plastica::lanes
