#pragma once

#include <cstddef>
#include <vector>

#include "plastica/chain/layout.hpp"
#include "plastica/chain/view.hpp"
#include "plastica/model/motion.hpp"

namespace plastica::chain {

/// Masses and inertias of a chain's segments.
///
/// A segment is a rod of even mass along its chord c, with m c^2/12 across it; its section adds
/// rho (I_x + I_y) per length about the beam's axis and, with rotary inertia, rho I_x and rho I_y
/// about x and y (Rayleigh's beam).
template <class L>
std::vector<Inertia<L>> segment_inertias(const Layout& layout, const View<L>& view,
                                         RotaryInertia rotary) {
  using S = typename L::Scalar;
  std::vector<Inertia<L>> inertias;
  inertias.reserve(layout.size());
  for (std::size_t i = 0; i < layout.size(); ++i) {
    const BeamRegion& region = layout.regions[layout.segment_regions[i].middle];
    const Vec<double, 3> chord = layout.node[i + 1] - layout.node[i];
    const double length = layout.segment_length[i];
    const double mass = region.line_mass() * length;
    const double rod = mass * dot(chord, chord) / 12.0;
    const double line = region.material.density * length;
    const double section = rotary == RotaryInertia::On ? line : 0.0;
    const SectionProperties& p = region.properties;
    const std::array<double, 6> about{0.0,
                                      0.0,
                                      0.0,
                                      rod + section * p.second_moment_x,
                                      rod + section * p.second_moment_y,
                                      line * (p.second_moment_x + p.second_moment_y)};
    Inertia<L> inertia;
    inertia.mass = constant<S>(mass);
    inertia.center = view.point(0.5 * (transpose(layout.segment_frame[i]) * chord));
    const auto rotational = view.rotations(about);
    for (std::size_t k = 0; k < L::kRotations; ++k)
      inertia.rotational(k, k) = constant<S>(rotational[k]);
    inertias.push_back(inertia);
  }
  return inertias;
}

}  // namespace plastica::chain
