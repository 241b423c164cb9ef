#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "plastica/law/gauge_form.hpp"
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
/// Hardening turns uniaxial into sectional plastic strain by equal plastic work. The direction of
/// the trial force z^ has the areas (phi the gauge)
///   A_e = sum a_i z^_i^2/phi(z^)^2           twice the elastic energy at yield,
///   A_p = Y sum V_i z^_i^2/phi(z^)^2,        V_i = modulus cap factor/lever,
/// so that a plastic multiplier lambda [J/m] is the equivalent plastic strain p = lambda/A_p of the
/// uniaxial law, and back stresses grow by (A_e/lambda~)(z^ - z) per unit of its law, where
/// lambda~ = lambda + A_e sum shifts and z is the projection of z^ on the surface of radius
/// level(p). For one component A_e = a_i and A_p = Y V_i: this is exactly the uniaxial law of its
/// extreme fibre. For several it is the natural average; z^ fixes it at the start of an increment.
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

namespace detail {

/// The return with hardening: p and all that follows from it, with derivatives by z^.
template <class Section>
class HardeningReturn {
 public:
  using S = std::remove_cvref_t<decltype(Section::cap[0])>;
  using Rule = decltype(Section::rule);
  static constexpr std::size_t kBacks = Rule::kBacks;

  HardeningReturn(const Section& law, const typename Section::State& before,
                  const SectionForce<S>& trial, const S& phi, const mask_t<S>& yields)
      : law_(law), before_(before), elastic_(law.elastic), trial_(trial), phi_(phi) {
    const S inverse = constant<S>(1) / (phi * phi);
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      energy_[i] = elastic_[i] * trial[i];
      work_[i] = law.area[i] * trial[i];
    }
    twice_energy_ = dot(energy_, trial);
    elastic_area_ = twice_energy_ * inverse;
    plastic_area_ = dot(work_, trial) * inverse;
    for (std::size_t k = 0; k < kBacks; ++k) {
      along_[k] = dot(before.back[k], energy_) / twice_energy_ * phi;
      drive_[k] = law.rule.drive(k, before.equivalent, along_[k]);
    }
    solve(yields);
  }

  /// Fills force over caps, its derivative by z^, state and plastic work.
  void finish(SectionForce<S>& z, SectionTangent<S>& slope, typename Section::State& after,
              S& work) const {
    const S one = constant<S>(1);
    const S total = lambda_;  // lambda~
    const S plastic = plastic_area_ * p_;
    const S part = plastic / total;
    const SectionForce<S> cut = trial_ - projected_.point;
    SectionForce<S> flow;  // A cut: normal times lambda~
    SectionForce<S> back;
    for (std::size_t i = 0; i < kSectionAxes; ++i) flow[i] = elastic_[i] * cut[i];
    const S length = total / elastic_area_;
    const S square = dot(flow, cut) / (total * length);
    work = plastic_area_ * law_.rule.radius_integral(before_.equivalent, p_);
    for (std::size_t k = 0; k < kBacks; ++k) {
      after.back[k] = before_.back[k] + (shift_[k].value / length) * cut;
      back += after.back[k];
      const S decayed = decayed_at_end(k);
      const S shifted = law_.rule.source_integral(k, before_.equivalent, p_, decayed) +
                        along_[k] * (decayed - p_);
      work += plastic_area_ * (dot(before_.back[k], flow) / total * p_ + square * shifted);
    }
    z = projected_.point + back;
    after.equivalent = before_.equivalent + p_;
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      const S d = law_.per_force[i] * part * cut[i];
      after.plastic[i] = before_.plastic[i] + d;
      after.accumulated[i] = before_.accumulated[i] + abs(d);
    }

    // d p = (d lambda~ at fixed p - d T)/(T' - d lambda~/d p), T = plastic_area p + elastic_area
    // shifts.
    const SectionForce<S> normal = gauge_gradient(law_.gauge, trial_);
    const S inverse = one / (phi_ * phi_);
    const S two = constant<S>(2);
    SectionForce<S> by_trial;
    const SectionForce<S> d_elastic =
        (two * inverse) * energy_ - (two * elastic_area_ / phi_) * normal;
    const SectionForce<S> d_plastic =
        (two * inverse) * work_ - (two * plastic_area_ / phi_) * normal;
    by_trial = p_ * d_plastic;
    S slope_by_p = plastic_area_;
    for (std::size_t k = 0; k < kBacks; ++k) {
      SectionForce<S> d_along;
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        d_along[i] = phi_ * elastic_[i] * before_.back[k][i] / twice_energy_ +
                     along_[k] * (normal[i] / phi_ - two * energy_[i] / twice_energy_);
      }
      by_trial += shift_[k].value * d_elastic;
      if constexpr (Rule::kRecovers) {
        const S by_along = -law_.rule.recovery(k) * decayed_at_end(k);
        by_trial += (elastic_area_ * by_along) * d_along;
      }
      slope_by_p += elastic_area_ * shift_[k].slope;
    }
    SectionForce<S> d_lambda;
    for (std::size_t i = 0; i < kSectionAxes; ++i) d_lambda[i] = elastic_[i] * by_radius_[i];
    const SectionForce<S> d_p =
        (one / (slope_by_p - lambda_by_radius_ * level_.slope)) * (d_lambda - by_trial);
    const SectionForce<S> d_part = (one / total) * (p_ * d_plastic + plastic_area_ * d_p -
                                                    part * (by_trial + slope_by_p * d_p));
    slope = identity<S, kSectionAxes>() -
            part * (identity<S, kSectionAxes>() - projected_.slope -
                    outer(by_radius_, level_.slope * d_p)) -
            outer(cut, d_part);
  }

 private:
  static constexpr int kMaxSteps = 40;

  S decayed_at_end(std::size_t k) const {
    return back_flow(law_.rule, k, before_.equivalent, p_).decayed;
  }

  /// Projects on the surface of radius level(p); lambda~ and the derivatives by the radius follow
  /// from the homogeneity of both in (z^, radius).
  void project_at(const S& p, const mask_t<S>& mask) {
    const S one = constant<S>(1);
    level_ = law_.rule.radius(before_.equivalent, p);
    const S inverse = one / level_.value;
    const S overshoot = select(mask, phi_ * inverse - one, one);
    projected_ = project(law_.gauge, law_.compliance, inverse * trial_, overshoot, mask);
    projected_.point = level_.value * projected_.point;
    by_radius_ = inverse * (projected_.point - projected_.slope * trial_);
    lambda_ = constant<S>(0);
    S by_trial = constant<S>(0);
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      lambda_ += elastic_[i] * (trial_[i] - projected_.point[i]) * projected_.point[i] * inverse;
      by_trial += elastic_[i] * trial_[i] * by_radius_[i];
    }
    lambda_by_radius_ = (lambda_ - by_trial) * inverse;
    needed_ = plastic_area_ * p;
    needed_slope_ = plastic_area_;
    for (std::size_t k = 0; k < kBacks; ++k) {
      shift_[k] = law_.rule.shift(k, before_.equivalent, drive_[k], p);
      needed_ += elastic_area_ * shift_[k].value;
      needed_slope_ += elastic_area_ * shift_[k].slope;
    }
  }

  /// Newton for lambda~(level(p)) = A_p p + A_e sum shifts(p), inside of a bracket.
  void solve(const mask_t<S>& yields) {
    const S zero = constant<S>(0);
    S low = zero;
    // lambda~ is at most the support function of the surface at A z^, as at radius zero; and no
    // shift undoes more than the back stress that there is.
    S most = zero;
    for (const S& e : energy_.at) most += abs(e);
    for (const S& along : along_) most += elastic_area_ * abs(along);
    S high = select(yields, most / plastic_area_, zero);
    const S begins = law_.rule.radius(before_.equivalent, zero).value;
    p_ = select(yields, first_flow(law_.rule, S(phi_ / begins - constant<S>(1)), high), zero);
    auto active = yields;
    constexpr bool kDouble = sizeof(real_t<S>) == 8;
    const S small = constant<S>(kDouble ? 1e-7 : 1e-3);
    const S smallest = constant<S>(kDouble ? 1e-17 : 1e-8);
    for (int step = 0; step < kMaxSteps; ++step) {
      project_at(p_, yields);
      const S residual = lambda_ - needed_;
      low = select(residual > zero, p_, low);
      high = select(residual < zero, p_, high);
      const S along = residual / (needed_slope_ - lambda_by_radius_ * level_.slope);
      const S newton = stepped(law_.rule, p_, along);
      if (!any(active)) {
        // Squares the error, and gives a dual scalar its derivative.
        p_ = select(yields, newton, zero);
        break;
      }
      const auto inside = (newton >= low) & (newton <= high);
      const S next = select(inside, newton, constant<S>(0.5) * (low + high));
      S least = smallest;
      // The slope of a rate may be so large that less than rounding of the strain is much stress.
      if constexpr (requires { law_.rule.factor; }) {
        least =
            constant<S>(2e-16) * twice_energy_ / (needed_slope_ - lambda_by_radius_ * level_.slope);
      }
      const S limit = max(select(inside, small, constant<S>(kDouble ? 1e-14 : 1e-6)) * next, least);
      const auto moves = active & (abs(next - p_) > limit);
      p_ = select(active, next, p_);
      active = moves;
    }
    project_at(p_, yields);
  }

  const Section& law_;
  const typename Section::State& before_;
  const SectionForce<S>& elastic_;
  const SectionForce<S>& trial_;
  const S& phi_;
  SectionForce<S> energy_, work_;
  S twice_energy_, elastic_area_, plastic_area_;
  std::array<S, kBacks> along_{}, drive_{};
  S p_;
  Grown<S> level_;
  std::array<Grown<S>, kBacks> shift_{};
  Projection<S> projected_;
  SectionForce<S> by_radius_;
  S lambda_, lambda_by_radius_, needed_, needed_slope_;
};

}  // namespace detail

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
      for (std::size_t i = 0; i < kSectionAxes; ++i) area += law.area[i] * trial[i] * trial[i];
      flowed.equivalent += work * phi * phi / area;
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
