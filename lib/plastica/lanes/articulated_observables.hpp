#pragma once

#include <cstddef>

#include "plastica/lanes/planar_form.hpp"
#include "plastica/lanes/spatial_form.hpp"

namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// Where beams are between two steps, and their energies.
/// @tparam Form  PlanarForm or SpatialForm
template <class Form>
[[gnu::noinline]] void articulated_observables(const typename Form::Beam& beam) {
  using S = typename Form::Scalar;
  using L = typename Form::L;
  using Kind = typename Form::Kind;
  using Load = typename Form::Load;
  using State = typename Form::State;
  using OfKind = typename Kind::Fields;
  using OfLoad = typename Load::Fields;
  using OfState = typename State::Fields;
  using Sums = typename Form::Sums::Fields;
  constexpr std::size_t kR = L::kRotations;
  constexpr std::size_t kT = L::kTranslations;
  typename Form::Aim aim;
  typename L::Point place{}, velocity{};
  S kinetic{}, elastic{}, potential{};
  for (std::size_t i = 0; i < beam.segments; ++i) {
    const Kind kind(beam.kinds, beam.kind[i]);
    const Load load(beam.loads, beam.load[i]);
    const State state(beam.state, i);
    const typename Form::Observables observables(beam.observables, i);
    const auto angle = get_vec<kR>(state, OfState::Angle);
    const typename Form::Axes axes = Form::rotated(kind, angle, aim);
    aim.spin += get_vec<kR>(state, OfState::Rate);
    set_vec(observables, Form::Observables::Fields::Place, place);
    Form::observe(aim, axes, observables);
    set_vec(observables, Form::Observables::Fields::Spin, aim.spin);

    const auto stretched = angle - get_vec<kR>(state, OfState::Plastic);
    for_each_of<kR>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      elastic += kind.get(OfKind::Stiffness + k) * stretched[k] * stretched[k];
    });
    // m v^2 + 2 v . (spin x first moment) + spin . I spin.
    const auto swing = L::spun(aim.spin, axes.along);
    const S first = constant<S>(2) * kind.get(OfKind::FirstMoment);
    kinetic += kind.get(OfKind::Mass) * dot(velocity, velocity);
    kinetic += first * dot(velocity, swing);
    kinetic += Form::spun(kind, axes, aim.spin);
    potential = dot_add(get_vec<kT>(load, OfLoad::Force), place, potential);
    potential = dot_add(get_vec<kT>(load, OfLoad::Lever), axes.along, potential);
    if constexpr (kR == 1) potential += load.get(OfLoad::Moment) * aim.direction;

    const S length = kind.get(OfKind::Length);
    place = scale_add(length, axes.along, place);
    velocity = scale_add(length, swing, velocity);
  }
  const typename Form::Sums sums(beam.sums, 0);
  const S half = constant<S>(0.5);
  sums.set(Sums::Kinetic, half * kinetic);
  sums.set(Sums::Elastic, half * elastic);
  sums.set(Sums::Potential, potential);
}

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
