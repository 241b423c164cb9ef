#pragma once

#include <cstddef>
#include <vector>

#include "plastica/law/fibre_layout.hpp"
#include "plastica/law/plastic_work.hpp"
#include "plastica/law/section_form.hpp"
#include "plastica/law/section_response.hpp"

namespace plastica::law {

/// A section cut into fibres under one kind of stress, each with the uniaxial law: the true
/// moment-curvature curve, partial unloading, residual stress, and bending with axial force as they
/// yield together; or the true torque-twist curve of what twists alone. What bends about both axes
/// and twists is in law/fibre_grid.hpp.
///
/// Signs: a fibre at (x, y) has the strain axial + y kappa_x - x kappa_y (a positive rotation about
/// x turns the y axis to z), so that M_x = sum y stress area, M_y = -sum x stress area: positive
/// curvature gives positive moment. Bending about the other axis has a stiffness, by which a beam
/// would leave its plane; other components that the layout's plane does not see have neither force
/// nor stiffness.
/// @tparam Uniaxial  one of `UniaxialLaws`
template <class S, class Uniaxial>
struct FibreSection {
  const FibreLayout* layout;  ///< AboutX, AboutY or Torsion; lives at least as long
  Uniaxial fibre;             ///< under normal stress; of Torsion, under shear

  /// Calls `use` with each uniaxial law.
  template <class Use>
  void each_uniaxial(const Use& use) {
    use(fibre);
  }

  static constexpr bool kSeesAxial = true;
  static constexpr bool kSeesAside = true;

  /// Of one fibre; a joint has an array of `layout->states()` of them.
  using State = typename Uniaxial::State;
};

/// @param before, after  states of the fibres (layout->states()); may be the same
template <class S, class Uniaxial>
inline SectionResponse<S> respond(const FibreSection<S, Uniaxial>& law,
                                  const typename Uniaxial::State* before,
                                  typename Uniaxial::State* after, const SectionStrain<S>& strain) {
  const FibreLayout& layout = *law.layout;
  const bool twists = layout.plane == FibrePlane::Torsion;
  const std::size_t along = twists                               ? kTorsion
                            : layout.plane == FibrePlane::AboutY ? kBendingY
                                                                 : kBendingX;
  const std::size_t aside = along == kBendingX ? kBendingY : kBendingX;
  const std::vector<double>& levers = twists ? layout.lever : layout.depth;
  const S axial = twists ? constant<S>(0) : strain[kAxial];
  SectionResponse<S> now{};
  S square{};
  for (std::size_t i = 0; i < layout.area.size(); ++i) {
    const S lever = constant<S>(levers[i]);
    const S area = constant<S>(layout.area[i]);
    const auto fibre = respond(law.fibre, before[i], S(axial + lever * strain[along]));
    const S force = fibre.stress * area;
    const S stiff = fibre.tangent * area;
    now.plastic_work += area * plastic_work(law.fibre, before[i], fibre);
    after[i] = fibre.state;
    square += fibre.stress * force;
    now.force[along] += force * lever;
    now.tangent(along, along) += stiff * lever * lever;
    if (twists) continue;
    now.force[kAxial] += force;
    now.tangent(kAxial, kAxial) += stiff;
    now.tangent(along, kAxial) += stiff * lever;
    now.tangent(aside, aside) += stiff * constant<S>(layout.aside[i]);
  }
  if (!twists) now.tangent(kAxial, along) = now.tangent(along, kAxial);
  now.elastic_energy = constant<S>(0.5) * square / law.fibre.stiffness;
  return now;
}

/// What a material says of a fibre under normal or shear stress: with whatever formulas the joints
/// are set up, it is a point of the material.
template <class S>
inline UniaxialMaterial<S> fibre_material(const SectionForm& form, Axis axis,
                                          const MaterialValues<S>& material) {
  UniaxialForm point = form.axis[axis];
  point.stiffness_factor = point.cap_factor = 1.0;
  return uniaxial_material(point, material);
}

/// @param layout    of one kind of stress, of the same section; kept by address
/// @tparam Uniaxial see FibreSection
template <class Uniaxial, class S>
inline FibreSection<S, Uniaxial> fibre_section(const FibreLayout& layout, const SectionForm& form,
                                               const MaterialValues<S>& material) {
  const Axis axis = layout.plane == FibrePlane::Torsion ? kTorsion : kAxial;
  return {&layout, Uniaxial::of(fibre_material(form, axis, material), material)};
}

}  // namespace plastica::law
