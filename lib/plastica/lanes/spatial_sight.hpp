#pragma once

#include <cstddef>

#include "plastica/lanes/spatial_beam.hpp"
#include "plastica/lanes/spatial_turn.hpp"

namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// Where spatial beams are between two steps, and their energies.
template <class S>
[[gnu::noinline]] void spatial_sight(const SpatialBeam<real_t<S>>& beam) {
  const S zero = constant<S>(0);
  const S one = constant<S>(1);
  Quaternion<S> frame{one, {zero, zero, zero}};
  Triple<S> place{zero, zero, zero};
  Triple<S> velocity = place;
  Triple<S> spin = place;
  S kinetic = zero, elastic = zero, potential = zero;
  for (std::size_t i = 0; i < beam.segments; ++i) {
    const ConstantEntry<S, SpatialKind> kind(beam.kinds, beam.kind[i]);
    const ConstantEntry<S, SpatialLoad> load(beam.loads, beam.load[i]);
    const Entry<S, SpatialState> state(beam.state, i);
    const Entry<S, SpatialSight> sight(beam.sight, i);
    const Triple<S> angle = get_triple(state, SpatialState::Angle);
    frame = frame.then(joint_turn(angle));
    const Columns<S> axes = frame.axes();
    spin = spin + get_triple(state, SpatialState::Rate);
    set_triple(sight, SpatialSight::Place, place);
    set_columns(sight, SpatialSight::Axes, axes);
    set_triple(sight, SpatialSight::Spin, spin);

    const Triple<S> stretched = angle - get_triple(state, SpatialState::Plastic);
    const Triple<S> stiffness = get_triple(kind, SpatialKind::Stiffness);
    elastic = multiply_add(stiffness.x * stretched.x, stretched.x, elastic);
    elastic = multiply_add(stiffness.y * stretched.y, stretched.y, elastic);
    elastic = multiply_add(stiffness.z * stretched.z, stretched.z, elastic);
    // m v^2 + 2 v . (spin x first moment) + spin . I spin.
    const Triple<S> swing = cross(spin, axes.z);
    const Triple<S> own = rows_times(axes, spin);
    const Triple<S> inertia = get_triple(kind, SpatialKind::Inertia);
    kinetic = multiply_add(kind.get(SpatialKind::Mass), dot(velocity, velocity), kinetic);
    kinetic = multiply_add(constant<S>(2) * kind.get(SpatialKind::FirstMoment),
                           dot(velocity, swing), kinetic);
    kinetic = multiply_add(inertia.x * own.x, own.x, kinetic);
    kinetic = multiply_add(inertia.y * own.y, own.y, kinetic);
    kinetic = multiply_add(inertia.z * own.z, own.z, kinetic);
    potential = dot_add(get_triple(load, SpatialLoad::Force), place, potential);
    potential = dot_add(get_triple(load, SpatialLoad::Lever), axes.z, potential);

    const S length = kind.get(SpatialKind::Length);
    place = scale_add(length, axes.z, place);
    velocity = scale_add(length, swing, velocity);
  }
  const Entry<S, SpatialSums> sums(beam.sums, 0);
  sums.set(SpatialSums::Kinetic, constant<S>(0.5) * kinetic);
  sums.set(SpatialSums::Elastic, constant<S>(0.5) * elastic);
  sums.set(SpatialSums::Potential, potential);
}

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
