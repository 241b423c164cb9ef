#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "plastica/law/gauge_form.hpp"
#include "plastica/law/hardening_return.hpp"
#include "plastica/law/project.hpp"
#include "plastica/law/section_form.hpp"
#include "plastica/law/section_response.hpp"
#include "plastica/law/uniaxial.hpp"

namespace plastica::law {

/// As many as any hardening law has.
inline constexpr std::size_t kMaxBacks = 3;

/// What a section with one yield surface remembers.
/// @tparam kBacks  back stresses of its hardening law
template <class S, std::size_t kBacks>
struct InteractionState {
  SectionStrain<S> plastic{};                  ///< permanent section strain
  SectionStrain<S> accumulated{};              ///< sum of |d plastic| by component
  S equivalent{};                              ///< sum of p [1]
  std::array<SectionForce<S>, kBacks> back{};  ///< back stresses over the caps

  InteractionState() = default;
  /// Of another law, with the back stresses that both have.
  template <std::size_t kOthers>
  explicit InteractionState(const InteractionState<S, kOthers>& other)
      : plastic(other.plastic), accumulated(other.accumulated), equivalent(other.equivalent) {
    static_assert(kBacks <= kMaxBacks && kOthers <= kMaxBacks);
    for (std::size_t k = 0; k < std::min(kBacks, kOthers); ++k) back[k] = other.back[k];
  }
};

/// A section with one yield surface over bending, torsion and axial force.
///
/// Forces over their caps z, elastic energy per length of z: sum a_i z_i^2/2, a = cap^2/stiffness.
/// Ideal plasticity is the closest-point projection of the trial force in that energy.
///
/// Hardening turns uniaxial into sectional plastic strain by equal plastic work. With the trial
/// force z^, and z its projection on the surface of radius r = level(p), the direction of z has the
/// areas (r = phi(z), phi the gauge)
///   A_e = sum a_i z_i^2/r^2                  twice the elastic energy at yield,
///   A_p = Y sum V_i z_i^2/r^2,               V_i = modulus cap factor/lever,
/// so that a plastic multiplier lambda [J/m] is the equivalent plastic strain p = lambda/A_p of the
/// uniaxial law. Back stresses X recover as its law says, in all directions, and grow by
/// (A_e/lambda~)(z^ - X' - z) per unit of its source, X' what is left of them, z relative to them,
/// lambda~ = lambda + A_e sum sources. For one component A_e = a_i and A_p = Y V_i: this is exactly
/// the uniaxial law of its extreme fibre. For several it is the natural average, of the force that
/// does the work: along a proportional path increments of any length give the same. (The trial
/// force is no measure of it: where the axial force is given, flow along the beam turns the trial
/// far out of the direction of the force.)
/// @tparam Uniaxial  one of `UniaxialLaws`
template <class S, class Gauge, class Uniaxial>
struct InteractionSection {
  static constexpr bool kSeesAxial = true;

  Gauge gauge;
  SectionForce<S> cap;         ///< [N m, N m, N m, N]
  SectionForce<S> stiffness;   ///< E I_x, E I_y, G J [N m^2], E A [N]
  SectionForce<S> area;        ///< Y V_i [N]
  SectionForce<S> elastic;     ///< a: cap^2/stiffness
  SectionForce<S> compliance;  ///< 1/a
  SectionForce<S> per_strain;  ///< stiffness/cap
  SectionForce<S> per_force;   ///< cap/stiffness
  Uniaxial rule;               ///< with all stresses over the yield stress

  /// Calls `use` with each uniaxial law.
  template <class Use>
  void each_uniaxial(const Use& use) {
    use(rule);
  }

  using State = InteractionState<S, Uniaxial::kBacks>;
};

/// Implicit return with the consistent tangent.
template <class S, class Gauge, class Uniaxial>
inline SectionResponse<S> respond(
    const InteractionSection<S, Gauge, Uniaxial>& law,
    const typename InteractionSection<S, Gauge, Uniaxial>::State& before,
    typename InteractionSection<S, Gauge, Uniaxial>::State& after, const SectionStrain<S>& strain) {
  using Section = InteractionSection<S, Gauge, Uniaxial>;
  constexpr bool kIdeal = Uniaxial::kBacks == 0;
  const S zero = constant<S>(0);
  const S one = constant<S>(1);
  SectionForce<S> z, trial, back;
  for (std::size_t k = 0; k < Uniaxial::kBacks; ++k) back += before.back[k];
  for (std::size_t i = 0; i < kSectionAxes; ++i) {
    z[i] = law.per_strain[i] * (strain[i] - before.plastic[i]);
    trial[i] = z[i] - back[i];
  }
  const S phi = gauge_value(law.gauge, trial);
  // A point that was returned before is on the surface but for rounding.
  const S outside = constant<S>(sizeof(real_t<S>) == 8 ? 1.0 + 1e-13 : 1.0 + 1e-5);
  const S begins = law.rule.radius(before.equivalent, zero).value;
  auto yields = phi > outside * begins;
  if constexpr (requires { law.rule.factor; }) {
    // A rate lets so little through that it would be lost beside the trial force: none, then.
    const S endless = constant<S>(std::numeric_limits<real_t<S>>::infinity());
    const S most = law.rule.factor.reached(S(phi / begins - one), endless);
    S elastic = zero;
    S plastic = zero;
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      elastic += law.elastic[i] * trial[i] * trial[i];
      plastic += law.area[i] * trial[i] * trial[i];
    }
    yields = yields & (most * plastic > constant<S>(1e-12) * elastic);
  }

  SectionResponse<S> now;
  for (std::size_t i = 0; i < kSectionAxes; ++i) now.tangent(i, i) = law.stiffness[i];
  now.plastic_work = zero;
  typename Section::State next = before;
  if (any(yields)) {
    SectionForce<S> returned;
    SectionTangent<S> returned_slope;
    S work;
    typename Section::State flowed = before;
    if constexpr (kIdeal) {
      const Projection<S> projected =
          project(law.gauge, law.compliance, trial, select(yields, phi - one, one), yields);
      returned = projected.point;
      returned_slope = projected.slope;
      work = zero;
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        const S cut = trial[i] - returned[i];
        const S flow = law.per_force[i] * cut;
        flowed.plastic[i] += flow;
        flowed.accumulated[i] += abs(flow);
        work += law.elastic[i] * cut * returned[i];
      }
      S area = zero;
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        area += law.area[i] * returned[i] * returned[i];
      }
      flowed.equivalent += work / area;
    } else {
      detail::HardeningReturn<Section>(law, before, trial, phi, yields)
          .finish(returned, returned_slope, flowed, work);
    }
    now.plastic_work = select(yields, work, zero);
    next.equivalent = select(yields, flowed.equivalent, before.equivalent);
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      z[i] = select(yields, returned[i], z[i]);
      next.plastic[i] = select(yields, flowed.plastic[i], before.plastic[i]);
      next.accumulated[i] = select(yields, flowed.accumulated[i], before.accumulated[i]);
      for (std::size_t k = 0; k < Uniaxial::kBacks; ++k) {
        next.back[k][i] = select(yields, flowed.back[k][i], before.back[k][i]);
      }
      for (std::size_t j = 0; j < kSectionAxes; ++j) {
        now.tangent(i, j) = select(yields, law.cap[i] * returned_slope(i, j) * law.per_strain[j],
                                   now.tangent(i, j));
      }
    }
  }
  after = next;
  now.elastic_energy = zero;
  for (std::size_t i = 0; i < kSectionAxes; ++i) {
    now.force[i] = law.cap[i] * z[i];
    now.elastic_energy += constant<S>(0.5) * law.elastic[i] * z[i] * z[i];
  }
  return now;
}

/// @tparam Uniaxial  see InteractionSection
template <class Uniaxial, class Gauge, class S>
inline InteractionSection<S, Gauge, Uniaxial> interaction_section(
    const SectionForm& form, const Gauge& gauge, const MaterialValues<S>& material) {
  // Its stresses are over the yield stress, so that caps and shear do not enter.
  InteractionSection<S, Gauge, Uniaxial> law{
      gauge, {}, {},
      {},    {}, {},
      {},    {}, Uniaxial::of(over_yield_stress(form.axis[kAxial], material), material)};
  for (std::size_t i = 0; i < kSectionAxes; ++i) {
    const UniaxialMaterial<S> m = uniaxial_material(form.axis[i], material);
    law.cap[i] = m.yield * constant<S>(form.modulus[i]);
    law.stiffness[i] = m.stiffness * constant<S>(form.lever[i] * form.modulus[i]);
    law.area[i] = m.raised * number_of(material, MaterialField::YieldStress) *
                  constant<S>(form.modulus[i] * form.axis[i].cap_factor / form.lever[i]);
    law.per_strain[i] = law.stiffness[i] / law.cap[i];
    law.per_force[i] = law.cap[i] / law.stiffness[i];
    law.elastic[i] = law.cap[i] * law.per_force[i];
    law.compliance[i] = constant<S>(1) / law.elastic[i];
  }
  return law;
}

}  // namespace plastica::law
