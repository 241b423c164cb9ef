#pragma once

#include <cstddef>
#include <cstdint>

/// What the spatial kernels work on, laid out like PlanarBeam. World axes: the unloaded beam lies
/// along z, straight; each segment's own axes, and those of its joint, are then the world's. Of
/// three components the first is named, those about or along y and z follow.
namespace plastica::lanes {

/// Numbers of a kind of segment, with the joint at its inner end.
struct SpatialKind {
  enum : std::size_t {
    Length,                      ///< from its inner to its outer joint [m]
    Mass,                        ///< [kg]
    FirstMoment,                 ///< mass times the distance of its center from the joint [kg m]
    Inertia,                     ///< about x, y, z through the inner joint [kg m^2], each > 0
    Stiffness = Inertia + 3,     ///< of the joint [N m/rad]
    Compliance = Stiffness + 3,  ///< its inverse; infinite without any [rad/(N m)]
    Damping = Compliance + 3,    ///< of the joint [N m s/rad]
    Cap = Damping + 3,           ///< moments at which the joint yields [N m]
    Free = Cap + 3,              ///< 1; 0 for a clamped joint, which only the first may be
    kCount
  };
};

/// Forces on a segment that keep their direction, at one time; world axes.
struct SpatialLoad {
  enum : std::size_t {
    Force,               ///< [N]
    Lever = Force + 3,   ///< sum of force x distance along the segment from its inner joint [N m]
    Moment = Lever + 3,  ///< free [N m]
    kCount = Moment + 3
  };
};

/// What a segment and its joint are between two steps. Where a motion begins, AngleRate is the
/// rate that the angle has then, and AngularAcceleration 0 or the acceleration; both matter to
/// order 2 alone.
struct SpatialState {
  enum : std::size_t {
    Angle,             ///< rotation vector of the joint, in its inner neighbour's axes [rad]
    Rate = Angle + 3,  ///< spin less the inner neighbour's, world axes [rad/s]
    AngularAcceleration = Rate + 3,  ///< of the segment over the step before, world axes [rad/s^2]
    AngleRate = AngularAcceleration + 3,  ///< mean of d(Angle)/dt over the step before [rad/s]
    Plastic = AngleRate + 3,              ///< permanent part of the angle [rad]
    Accumulated = Plastic + 3,            ///< sum of its changes' sizes [rad]
    kCount = Accumulated + 3
  };
};

/// What a step needs of a segment from one sweep to the next; world axes.
struct SpatialWork {
  enum : std::size_t {
    AxisZ,              ///< of the segment, where the step's forces act
    AxisY = AxisZ + 3,  ///< likewise
    Spin = AxisY + 3,   ///< of the segment there [rad/s]
    AngleX = Spin + 3,  ///< d(joint's angle)/dt by its rate: a row a component
    AngleY = AngleX + 3,
    AngleZ = AngleY + 3,
    ByAngularAcceleration = AngleZ + 3,          ///< angular acceleration of the joint by the inner
                                                 ///< neighbour's: a column a component …
    ByAcceleration = ByAngularAcceleration + 9,  ///< … and by the joint's acceleration
    Given = ByAcceleration + 9,                  ///< and what remains [rad/s^2]
    kCount = Given + 3
  };
};

/// Sums over steps and segments of each scenario.
struct SpatialSums {
  enum : std::size_t {
    Damping,               ///< dissipated by the joints' damping [J]
    NumericalDissipation,  ///< dissipated by the scheme: see README.md [J]
    Loads,                 ///< work of the loads, where it is counted [J]
    FastestSpin,           ///< largest |spin| of a segment at the end of a step [rad/s]
    LargestAngle,          ///< of a joint at the end of a step [rad]; the steps hold below 2 pi
    // What `SpatialObservables` goes with, at one time:
    Kinetic,    ///< energy [J]
    Elastic,    ///< energy of the joints [J]
    Potential,  ///< work of the loads' forces from the origin, were they always as now [J]
    kCount
  };
};

/// Where a segment is, between two steps; world axes.
struct SpatialObservables {
  enum : std::size_t {
    Place,             ///< of its inner joint, from the beam's start [m]
    Axes = Place + 3,  ///< its axes: a column each
    Spin = Axes + 9,   ///< [rad/s]
    kCount = Spin + 3
  };
};

template <class Real>
struct SpatialBeam {
  std::size_t segments;
  const std::uint32_t* kind;  ///< of each segment (segments)
  const Real* kinds;          ///< (kinds x SpatialKind::kCount)
  const std::uint32_t* load;  ///< of each segment (segments)
  const Real* loads;          ///< (loads x SpatialLoad::kCount)
  Real* state;                ///< (segments x SpatialState::kCount)
  Real* work;                 ///< (segments x SpatialWork::kCount)
  Real* sums;                 ///< (SpatialSums::kCount)
  Real* observables;          ///< (segments x SpatialObservables::kCount)
  bool counts_loads;          ///< whether SpatialSums::Loads is counted
};

}  // namespace plastica::lanes
