#pragma once

#include <cstddef>

#include "plastica/base/sine_cosine.hpp"
#include "plastica/lanes/entry.hpp"
#include "plastica/lanes/planar_beam.hpp"

namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// Where planar beams are between two steps, and their energies.
template <class S>
[[gnu::noinline]] void planar_sight(const PlanarBeam<real_t<S>>& beam) {
  const S zero = constant<S>(0);
  S x = zero, y = zero, velocity_x = zero, velocity_y = zero, direction = zero, spin = zero;
  S kinetic = zero, elastic = zero, potential = zero;
  for (std::size_t i = 0; i < beam.segments; ++i) {
    const ConstantEntry<S, PlanarKind> kind(beam.kinds, beam.kind[i]);
    const ConstantEntry<S, PlanarLoad> load(beam.loads, beam.load[i]);
    const Entry<S, PlanarState> state(beam.state, i);
    const Entry<S, PlanarSight> sight(beam.sight, i);
    const S angle = state.get(PlanarState::Angle);
    direction = direction + kind.get(PlanarKind::Rest) + angle;
    spin = spin + state.get(PlanarState::Rate);
    const SineCosine<S> at(direction);
    sight.set(PlanarSight::X, x);
    sight.set(PlanarSight::Y, y);
    sight.set(PlanarSight::Direction, direction);
    sight.set(PlanarSight::Cosine, at.cosine);
    sight.set(PlanarSight::Sine, at.sine);
    sight.set(PlanarSight::Spin, spin);

    const S stretched = angle - state.get(PlanarState::Plastic);
    elastic = multiply_add(kind.get(PlanarKind::Stiffness) * stretched, stretched, elastic);
    // Of a body with its center off the joint: m v^2 + 2 v . (spin x first moment) + I spin^2.
    const S across = multiply_add(at.cosine, velocity_y, -(at.sine * velocity_x));
    const S speed = multiply_add(velocity_x, velocity_x, velocity_y * velocity_y);
    kinetic = multiply_add(kind.get(PlanarKind::Mass), speed, kinetic);
    kinetic =
        multiply_add(spin,
                     multiply_add(kind.get(PlanarKind::Inertia), spin,
                                  constant<S>(2) * kind.get(PlanarKind::FirstMoment) * across),
                     kinetic);
    potential = multiply_add(load.get(PlanarLoad::ForceX), x, potential);
    potential = multiply_add(load.get(PlanarLoad::ForceY), y, potential);
    potential = multiply_add(load.get(PlanarLoad::LeverX), at.cosine, potential);
    potential = multiply_add(load.get(PlanarLoad::LeverY), at.sine, potential);
    potential = multiply_add(load.get(PlanarLoad::Moment), direction, potential);

    const S length = kind.get(PlanarKind::Length);
    x = multiply_add(length, at.cosine, x);
    y = multiply_add(length, at.sine, y);
    velocity_x = multiply_add(-(length * at.sine), spin, velocity_x);
    velocity_y = multiply_add(length * at.cosine, spin, velocity_y);
  }
  const Entry<S, PlanarSums> sums(beam.sums, 0);
  sums.set(PlanarSums::Kinetic, constant<S>(0.5) * kinetic);
  sums.set(PlanarSums::Elastic, constant<S>(0.5) * elastic);
  sums.set(PlanarSums::Potential, potential);
}

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
