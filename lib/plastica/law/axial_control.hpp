#pragma once

#include <cstddef>
#include <type_traits>

#include "plastica/law/section_form.hpp"
#include "plastica/law/section_response.hpp"

/// A section of which the axial force is given, and not the axial strain: that of a joint that does
/// not stretch, whose axial force follows from equilibrium.
///
/// With curvatures and twist k given, the axial strain e solves N(k, e) = N. A plastic increment
/// makes the most of a convex potential, so N rises with e: the root is bracketed, and Newton's
/// method finds it. Its tangent is the condensed one, by d N = 0:
///   d m = (C_kk - C_ke C_ek/C_ee) d k + C_ke/C_ee d N.
/// What e has of permanent strain is in the state. The joint does not show it.
namespace plastica::law {

/// Whether a section law sees the axial force: its moments depend on it.
template <class Law>
inline constexpr bool kSeesAxial = requires {
  Law::kSeesAxial;
};

/// Axial strain and force of a section [1, N].
template <class S>
struct AxialState {
  S strain{};
  S force{};
};

/// The response of a section under a given axial force.
template <class S>
struct ForcedResponse {
  /// Condensed; energies are those of bending and torsion: what they store, and what their moments
  /// do on permanent strain. N does no work on what a joint does not show.
  SectionResponse<S> section;
  SectionForce<S> by_force;  ///< d force / d N
  AxialState<S> after;
  mask_t<S> carries;  ///< false: no axial strain up to 1 carries the force; 0.999 of yield acts
};

namespace detail {

/// Seeks the axial strain of one force in all lanes.
template <class S, class Respond>
class AxialSearch {
 public:
  /// @param stiffness  E A [N]
  /// @param yield      the axial force at which all of the section yields [N]
  /// @param tolerance  of the force over `yield`, in double
  AxialSearch(const Respond& respond, const SectionStrain<S>& strain, const AxialState<S>& before,
              const S& stiffness, const S& yield, double tolerance)
      : respond_(respond),
        strain_(strain),
        before_(before),
        stiffness_(stiffness),
        unit_(yield / stiffness),
        enough_(constant<S>(kDouble ? tolerance : 1e-5) * yield) {}

  /// Starts from the strain that an elastic increment would have.
  /// @return where the force is not met within a strain of 1
  mask_t<S> seek(const S& force) {
    const S zero = constant<S>(0);
    force_ = force;
    S e = before_.strain + (force - before_.force) / stiffness_;
    evaluate(e);
    S low = e;
    S high = e;
    S reach = unit_;
    mask_t<S> has_low = zero > constant<S>(1);
    mask_t<S> has_high = has_low;
    mask_t<S> lost = has_low;
    mask_t<S> active = abs(miss_) > enough_;
    S last = miss_;
    mask_t<S> slow = has_low;
    for (int step = 0; step < kMaxSteps && any(active); ++step) {
      const mask_t<S> below = miss_ > zero;
      low = select(active & below, strain_[kAxial], low);
      high = select(active & !below, strain_[kAxial], high);
      has_low = has_low | (active & below);
      has_high = has_high | (active & !below);
      const mask_t<S> between = has_low & has_high;
      const S newton = next_by_newton();
      // Where N rests while the section flows, its slope tells nothing of how far.
      const S least = select(slow, reach, zero);
      const S distance = max(least, min(reach, abs(newton - strain_[kAxial])));
      const S outward = strain_[kAxial] + select(below, distance, -distance);
      const mask_t<S> fits = (newton > low) & (newton < high) & !slow;
      const S inward = select(fits, newton, constant<S>(0.5) * (low + high));
      e = select(active, select(between, inward, outward), strain_[kAxial]);
      reach = constant<S>(4) * reach;
      last = miss_;
      evaluate(e);
      slow = abs(miss_) > constant<S>(0.5) * abs(last);
      // The strain cannot be told from its neighbours any more.
      const S width = constant<S>(kDouble ? 1e-15 : 5e-7) * max(abs(e), unit_);
      const mask_t<S> narrow = between & (high - low <= width);
      // The step that goes this far may be the one that goes beyond the root.
      const mask_t<S> crossed = between | (has_high & (miss_ > zero)) | (has_low & (miss_ < zero));
      const mask_t<S> far = (abs(e - before_.strain) > constant<S>(1)) & !crossed;
      active = active & (abs(miss_) > enough_) & !narrow;
      lost = lost | (active & far);
      active = active & !far;
    }
    lost = lost | active;
    if constexpr (kCarriesDerivatives<S>) evaluate(next_by_newton());
    return lost;
  }

  const SectionResponse<S>& now() const { return now_; }
  const S& strain() const { return strain_[kAxial]; }

 private:
  static constexpr bool kDouble = sizeof(real_t<S>) == 8;
  static constexpr int kMaxSteps = 100;

  void evaluate(const S& e) {
    strain_[kAxial] = e;
    now_ = respond_(strain_);
    miss_ = force_ - now_.force[kAxial];
  }
  S next_by_newton() const {
    const S slope = max(now_.tangent(kAxial, kAxial), constant<S>(1e-12) * stiffness_);
    return strain_[kAxial] + miss_ / slope;
  }

  const Respond& respond_;
  SectionStrain<S> strain_;
  const AxialState<S>& before_;
  S stiffness_, unit_, enough_;
  S force_{}, miss_{};
  SectionResponse<S> now_;
};

}  // namespace detail

/// Responds to curvatures and twist under an axial force.
/// @param respond    (strain) -> SectionResponse; the last call leaves the state of the increment
/// @param strain     its axial component is not read
/// @param force      N [N]
/// @param stiffness  E A [N]
/// @param yield      the axial force at which all of the section yields [N]
/// @param tolerance  to which N is met, over `yield`, in double [1]
template <class S, class Respond>
ForcedResponse<S> respond_to_force(const Respond& respond, const SectionStrain<S>& strain,
                                   const S& force, const AxialState<S>& before, const S& stiffness,
                                   const S& yield, double tolerance = 1e-13) {
  const S half = constant<S>(0.5);
  const S zero = constant<S>(0);
  detail::AxialSearch<S, Respond> search(respond, strain, before, stiffness, yield, tolerance);
  const mask_t<S> lost = search.seek(force);
  if (any(lost)) {
    const S most = constant<S>(0.999) * yield;
    search.seek(select(lost, select(force > zero, most, -most), force));
  }
  ForcedResponse<S> found{search.now(), {}, {}, !lost};
  SectionResponse<S>& now = found.section;
  found.after = {search.strain(), now.force[kAxial]};
  const S slope = max(now.tangent(kAxial, kAxial), constant<S>(1e-9) * stiffness);
  for (std::size_t i = 0; i < kAxial; ++i) {
    found.by_force[i] = select(lost, zero, now.tangent(i, kAxial) / slope);
  }
  found.by_force[kAxial] = constant<S>(1);
  for (std::size_t i = 0; i < kAxial; ++i) {
    for (std::size_t j = 0; j < kAxial; ++j) {
      now.tangent(i, j) =
          now.tangent(i, j) - now.tangent(i, kAxial) * now.tangent(kAxial, j) / slope;
    }
  }
  const S change = found.after.force - before.force;
  const S permanent = found.after.strain - before.strain - change / stiffness;
  now.elastic_energy =
      now.elastic_energy - half * found.after.force * found.after.force / stiffness;
  // An elastic increment does none, and not what rounding makes of it.
  const mask_t<S> flows = (now.plastic_work > zero) | (now.plastic_work < zero);
  const S work = now.plastic_work - half * (found.after.force + before.force) * permanent;
  now.plastic_work = select(flows, work, zero);
  return found;
}

}  // namespace plastica::law
