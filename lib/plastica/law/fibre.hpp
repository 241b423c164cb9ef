#pragma once

#include <cstddef>
#include <span>

#include "plastica/law/fibre_layout.hpp"
#include "plastica/law/plastic_work.hpp"
#include "plastica/law/section_response.hpp"

namespace plastica::law {

/// A section cut into fibres, each with the uniaxial law: the true moment-curvature curve, partial
/// unloading, residual stress, and bending about both axes with axial force as they yield together.
///
/// Signs: a fibre at (x, y) has the strain axial + y kappa_x - x kappa_y (a positive rotation about
/// x turns the y axis to z), so that M_x = sum y stress area, M_y = -sum x stress area: positive
/// curvature gives positive moment. With layers, bending about the other axis is elastic.
///
/// Torsion of round sections goes through rings, with shear strain radius x twist; other sections
/// have the law of their extreme fibre, with the cap of the form. Normal and shear stress of a
/// fibre do not see each other here: under bending with torsion a fibre section is outside of the
/// true surface, by up to 41 % where both are at their caps. The interaction section sees them.
/// @tparam Uniaxial  IdealPlastic<S>, LinearHardening<S> or VoceChaboche<S>
template <class S, class Uniaxial>
struct FibreSection {
  const FibreLayout* layout;  ///< lives at least as long
  Uniaxial normal;
  Uniaxial shear;
  S other_stiffness;  ///< E I about the axis that the layers do not see [N m^2]

  static constexpr bool kSeesAxial = true;

  /// Of one fibre or ring; a joint has an array of `layout->states()` of them.
  using State = typename Uniaxial::State;
};

namespace detail {

/// Sums over the fibres, in order.
template <class S>
struct FibreSums {
  S normal{}, by_depth{}, by_across{};        ///< stress area (1, depth, across)
  S stiff{}, stiff_depth{}, stiff_across{};   ///< tangent area (1, depth, across)
  S depth_depth{}, across_across{}, mixed{};  ///< tangent area times their products
  S square{}, work{};                         ///< stress^2 area, plastic work area
};

template <bool kGrid, class S, class Uniaxial>
inline FibreSums<S> sum_fibres(const FibreSection<S, Uniaxial>& law,
                               const typename Uniaxial::State* before,
                               typename Uniaxial::State* after, const S& axial, const S& bend_depth,
                               const S& bend_across) {
  const FibreLayout& layout = *law.layout;
  FibreSums<S> sum;
  for (std::size_t i = 0; i < layout.area.size(); ++i) {
    const S depth = constant<S>(layout.depth[i]);
    const S area = constant<S>(layout.area[i]);
    S across{};
    S strain = axial + depth * bend_depth;
    if constexpr (kGrid) {
      across = constant<S>(layout.across[i]);
      strain += across * bend_across;
    }
    const auto now = respond(law.normal, before[i], strain);
    const S force = now.stress * area;
    const S stiff = now.tangent * area;
    sum.work += area * plastic_work(law.normal, before[i], now);
    after[i] = now.state;
    sum.square += now.stress * force;
    sum.normal += force;
    sum.by_depth += force * depth;
    sum.stiff += stiff;
    sum.stiff_depth += stiff * depth;
    sum.depth_depth += stiff * depth * depth;
    if constexpr (kGrid) {
      sum.by_across += force * across;
      sum.stiff_across += stiff * across;
      sum.across_across += stiff * across * across;
      sum.mixed += stiff * depth * across;
    }
  }
  return sum;
}

}  // namespace detail

/// @param before, after  states of the fibres, then of the rings (layout->states()); may be the
/// same
template <class S, class Uniaxial>
inline SectionResponse<S> respond(const FibreSection<S, Uniaxial>& law,
                                  const typename Uniaxial::State* before,
                                  typename Uniaxial::State* after, const SectionStrain<S>& strain) {
  const FibreLayout& layout = *law.layout;
  const bool grid = layout.plane == FibrePlane::Both;
  const std::size_t deep = layout.plane == FibrePlane::AboutY ? kBendingY : kBendingX;
  const std::size_t other = deep == kBendingX ? kBendingY : kBendingX;
  const auto sum = grid ? detail::sum_fibres<true>(law, before, after, strain[kAxial], strain[deep],
                                                   strain[other])
                        : detail::sum_fibres<false>(law, before, after, strain[kAxial],
                                                    strain[deep], strain[other]);
  const S half = constant<S>(0.5);
  SectionResponse<S> now;
  now.force[kAxial] = sum.normal;
  now.force[deep] = sum.by_depth;
  now.tangent(kAxial, kAxial) = sum.stiff;
  now.tangent(deep, deep) = sum.depth_depth;
  now.tangent(deep, kAxial) = now.tangent(kAxial, deep) = sum.stiff_depth;
  now.elastic_energy = half * sum.square / law.normal.stiffness;
  now.plastic_work = sum.work;
  if (grid) {
    now.force[other] = sum.by_across;
    now.tangent(other, other) = sum.across_across;
    now.tangent(other, kAxial) = now.tangent(kAxial, other) = sum.stiff_across;
    now.tangent(other, deep) = now.tangent(deep, other) = sum.mixed;
  } else {
    now.force[other] = law.other_stiffness * strain[other];
    now.tangent(other, other) = law.other_stiffness;
    now.elastic_energy += half * now.force[other] * strain[other];
  }

  S torsion_square{};
  for (std::size_t i = 0; i < layout.ring_area.size(); ++i) {
    const std::size_t state = layout.area.size() + i;
    const S radius = constant<S>(layout.ring_radius[i]);
    const S area = constant<S>(layout.ring_area[i]);
    const auto ring = respond(law.shear, before[state], S(radius * strain[kTorsion]));
    now.plastic_work += area * plastic_work(law.shear, before[state], ring);
    after[state] = ring.state;
    torsion_square += area * ring.stress * ring.stress;
    now.force[kTorsion] += area * radius * ring.stress;
    now.tangent(kTorsion, kTorsion) += area * radius * radius * ring.tangent;
  }
  now.elastic_energy += half * torsion_square / law.shear.stiffness;
  return now;
}

/// @param layout    from the same section and form; kept by address
/// @tparam Uniaxial see FibreSection
template <class Uniaxial, class S>
inline FibreSection<S, Uniaxial> fibre_section(const FibreLayout& layout, const SectionForm& form,
                                               const MaterialValues<S>& material) {
  UniaxialForm shear = form.axis[kTorsion];
  // Rings yield one after the other: the cap is theirs, not the section's.
  if (layout.ring_area.size() > 1) shear.stiffness_factor = shear.cap_factor = 1.0;
  FibreSection<S, Uniaxial> law{&layout, {}, {}, constant<S>(0)};
  law.normal = uniaxial_law<Uniaxial>(uniaxial_material(form.axis[kAxial], material));
  law.shear = uniaxial_law<Uniaxial>(uniaxial_material(shear, material));
  if (layout.plane != FibrePlane::Both) {
    const std::size_t other = layout.plane == FibrePlane::AboutX ? kBendingY : kBendingX;
    law.other_stiffness =
        law.normal.stiffness * constant<S>(form.lever[other] * form.modulus[other]);
  }
  return law;
}

}  // namespace plastica::law
