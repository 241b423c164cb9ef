#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "plastica/chain/chain.hpp"
#include "plastica/chain/layout.hpp"
#include "plastica/chain/view.hpp"
#include "plastica/model/beam_axis.hpp"

namespace plastica::chain {

/// What of a point mass one segment carries.
struct CarriedMass {
  SegmentPoint at;
  double mass = 0.0;            ///< [kg]
  Mat<double, 3, 3> inertia{};  ///< about its center, in the segment's frame [kg m^2]
};

/// The segments that carry a point mass.
///
/// At a joint both do, half each: start and end are then alike, and each fragment of a break there
/// keeps its half. Where the joint does not stretch, the mass itself moves as the joint does. The
/// inertia follows the mean of both segments' spins: between it and the axis a compliance of
/// l/4EI is missing, l the joint's length, so that what it adds to a motion is right to first order
/// in l; within a segment, in its middle, to second order.
inline std::vector<CarriedMass> carried_masses(const Layout& layout, const PointMass& mass) {
  const double fraction = fraction_of(mass.at, layout.ends);
  const SegmentPoint point = segment_point(layout, fraction);
  const std::size_t beyond = point.segment + 1;
  const bool at_joint = beyond < layout.size() && fraction == layout.ends[beyond];
  const double part = at_joint ? 0.5 : 1.0;
  Mat<double, 3, 3> inertia;
  for (std::size_t k = 0; k < 3; ++k) inertia(k, k) = part * mass.inertia[k];
  std::vector<CarriedMass> carried;
  const auto add = [&](const SegmentPoint& at) {
    const auto& frame = layout.segment_frame[at.segment];
    carried.push_back({at, part * mass.mass, transpose(frame) * inertia * frame});
  };
  add(point);
  if (at_joint) add({beyond, {}});
  return carried;
}

/// A moment of inertia in a segment's frame as a level sees it.
template <class L>
Mat<typename L::Scalar, L::kRotations, L::kRotations> inertia_of_level(
    const View<L>& view, const Mat<double, 3, 3>& inertia) {
  using S = typename L::Scalar;
  const auto rotational = [&](double x, double y, double z) {
    return view.rotations(std::array<double, 6>{0.0, 0.0, 0.0, x, y, z});
  };
  const auto x = rotational(inertia(0, 0), inertia(0, 1), inertia(0, 2));
  const auto y = rotational(inertia(1, 0), inertia(1, 1), inertia(1, 2));
  const auto z = rotational(inertia(2, 0), inertia(2, 1), inertia(2, 2));
  Mat<S, L::kRotations, L::kRotations> seen;
  for (std::size_t k = 0; k < L::kRotations; ++k) {
    const auto column = rotational(x[k], y[k], z[k]);
    for (std::size_t i = 0; i < L::kRotations; ++i) seen(i, k) = constant<S>(column[i]);
  }
  return seen;
}

/// Adds a body to a segment's inertia: about the common center, a pair of masses m and M at the
/// distance d turns like the reduced mass m M/(m + M) on an arm d.
template <class L>
void add_body(const typename L::Scalar& mass, const typename L::Point& at,
              const Mat<typename L::Scalar, L::kRotations, L::kRotations>& rotational,
              Inertia<L>& inertia) {
  const auto total = inertia.mass + mass;
  const auto by = L::spun_by(at - inertia.center);
  inertia.rotational += rotational + (inertia.mass * mass / total) * (transpose(by) * by);
  inertia.center += (mass / total) * (at - inertia.center);
  inertia.mass = total;
}

/// Adds the point masses of a scene to the inertias of its segments.
template <class L>
void add_point_masses(const Scene& scene, const Layout& layout, const View<L>& view,
                      std::vector<Inertia<L>>& inertias) {
  using S = typename L::Scalar;
  for (const PointMass& mass : scene.masses) {
    for (const CarriedMass& part : carried_masses(layout, mass)) {
      add_body(constant<S>(part.mass), view.point(part.at.arm),
               inertia_of_level<L>(view, part.inertia), inertias[part.at.segment]);
    }
  }
}

}  // namespace plastica::chain
