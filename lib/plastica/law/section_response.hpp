#pragma once

#include <cstddef>

#include "plastica/base/matrix.hpp"

/// What a law says of a whole cross section.
///
/// All section laws work per length of beam, in the section's axes:
///   strain = (curvature about x, curvature about y, twist per length, axial strain)
///            [rad/m, rad/m, rad/m, 1],
///   force  = (M_x, M_y, T, N) [N m, N m, N m, N].
/// A joint of tributary length l with the angles theta has the strain theta/l, and the stiffness
/// d force/d theta = tangent/l. A component that a level does not have has strain 0.
namespace plastica::law {

inline constexpr std::size_t kSectionAxes = 4;

template <class S>
using SectionStrain = Vec<S, kSectionAxes>;
template <class S>
using SectionForce = Vec<S, kSectionAxes>;
template <class S>
using SectionTangent = Mat<S, kSectionAxes, kSectionAxes>;

/// What `respond(law, before, after, strain)` of a section law returns; the state after the
/// increment goes into `after`, where a step that is tried again leaves it unused.
template <class S>
struct SectionResponse {
  SectionForce<S> force;
  SectionTangent<S> tangent;  ///< d force / d strain, consistent with the increment
  S elastic_energy;           ///< stored per length [J/m]
  S plastic_work;             ///< of this increment per length [J/m]
};

/// Whether the stiffness of a section that bends in its plane is told about the other axis, too.
template <class Law>
inline constexpr bool kSeesAside = requires {
  Law::kSeesAside;
};

/// The components of strain that a level has: some of bending and twist, and the axial one if it
/// stretches. A law whose components do not know of each other leaves out the others, which are 0.
template <std::size_t First, std::size_t Count, bool Axial>
struct Components {
  static constexpr bool has(std::size_t axis) {
    return (axis >= First && axis < First + Count) || (Axial && axis == kSectionAxes - 1);
  }
};
using AllComponents = Components<0, kSectionAxes, true>;

/// Gives the length of the step to those laws of a section that have a rate.
template <class Section>
void set_time(Section& section, double seconds) {
  if constexpr (requires { section.set_time(seconds); }) {
    section.set_time(seconds);
  } else if constexpr (requires { section.each_uniaxial([](auto&) {}); }) {
    section.each_uniaxial([&](auto& uniaxial) {
      if constexpr (requires { uniaxial.set_time(seconds); }) uniaxial.set_time(seconds);
    });
  }
}

}  // namespace plastica::law
