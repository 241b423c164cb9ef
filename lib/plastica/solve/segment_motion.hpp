#pragma once

#include <cstddef>
#include <vector>

#include "plastica/base/always_inline.hpp"
#include "plastica/chain/loads.hpp"
#include "plastica/solve/scheme.hpp"

/// How segments move, and what resists that.
namespace plastica::solve {

/// Velocities of a segment's center of mass in world axes, of its turning in its own.
template <class L>
struct SegmentMotion {
  typename L::Point velocity{};  ///< [m/s]
  typename L::Spin spin{};       ///< [rad/s]
  // What only generalized-alpha uses:
  typename L::Point acceleration{}, resisting{};        ///< [m/s^2]
  typename L::Spin spin_rate{}, resisting_spin_rate{};  ///< [rad/s^2]
};

/// Whether segments turn about the beam's own axis, and by how much of a spin in their own axes.
template <class L>
inline constexpr bool kTwists = L::kTranslations != 2;
template <class L>
typename L::Scalar twist_of(const typename L::Spin& spin) {
  return spin[L::kRotations - 1];
}

/// A force at a segment's center of mass, and a moment about it, in world axes.
template <class L>
struct CenterForce {
  typename L::Point force{};
  typename L::Spin moment{};
};

/// The displacement of a segment in a step: of its center of mass, and Cayley's spin in world axes.
template <class L>
struct SegmentStep {
  typename L::Point displacement{};
  typename L::Spin spin{};
};

template <class L>
inline SegmentStep<L> segment_step(const chain::Inertia<L>& inertia, std::size_t i,
                                   const chain::Placement<L>& begin,
                                   const chain::Placement<L>& end) {
  return {end.point(i, inertia.center) - begin.point(i, inertia.center),
          L::step_spin(begin.frame[i], end.frame[i])};
}

/// How a segment moves at the end of a step, by a scheme's rule.
/// @param spin  of the step, in the segment's axes
template <class L>
PLASTICA_ALWAYS_INLINE inline SegmentMotion<L> motion_after(const StepFactors& of,
                                                            const SegmentMotion<L>& before,
                                                            const typename L::Point& displacement,
                                                            const typename L::Spin& spin) {
  using S = typename L::Scalar;
  const auto c = [](double x) { return constant<S>(x); };
  const auto follow = [&](const auto& moved, const auto& v0, const auto& a0, const auto& r0,
                          auto& v, auto& a, auto& r) {
    v = c(of.velocity) * moved + c(of.velocity_v) * v0;
    a = c(of.acceleration) * moved + c(of.acceleration_v) * v0;
    r = a;
    if (!of.remembers) return;
    v += c(of.velocity_a) * a0;
    a += c(of.acceleration_a) * a0;
    r = c(of.scale) * (a + c(of.weight_a) * a0 - c(of.weight_r) * r0);
  };
  SegmentMotion<L> now;
  follow(displacement, before.velocity, before.acceleration, before.resisting, now.velocity,
         now.acceleration, now.resisting);
  follow(spin, before.spin, before.spin_rate, before.resisting_spin_rate, now.spin, now.spin_rate,
         now.resisting_spin_rate);
  return now;
}

/// Angular momentum about the center of mass, in world axes.
template <class L>
inline typename L::Spin angular_momentum(const chain::Inertia<L>& inertia,
                                         const typename L::Frame& frame,
                                         const typename L::Spin& spin) {
  return L::axes(frame) * (inertia.rotational * spin);
}

template <class L>
inline typename L::Scalar kinetic_energy(const chain::Inertia<L>& inertia,
                                         const SegmentMotion<L>& motion) {
  using S = typename L::Scalar;
  return constant<S>(0.5) * (inertia.mass * dot(motion.velocity, motion.velocity) +
                             dot(motion.spin, inertia.rotational * motion.spin));
}

/// With what a segment resists a step: -m r and, in conservation form, minus the change of its
/// angular momentum over the step; generalized-alpha: -R (J r + w x J w).
template <class L>
CenterForce<L> inertia_force(const StepFactors& of, const chain::Inertia<L>& inertia,
                             const typename L::Frame& begin, const typename L::Frame& end,
                             const SegmentMotion<L>& before, const SegmentMotion<L>& now) {
  using S = typename L::Scalar;
  CenterForce<L> resists;
  resists.force = -(inertia.mass * now.resisting);
  if (of.conserves) {
    resists.moment = constant<S>(of.rate) * (angular_momentum(inertia, begin, before.spin) -
                                             angular_momentum(inertia, end, now.spin));
  } else {
    const typename L::Spin momentum = inertia.rotational * now.spin;
    resists.moment = -(L::axes(end) * (inertia.rotational * now.resisting_spin_rate +
                                       L::spin_derivative(momentum) * now.spin));
  }
  return resists;
}

/// What a segment's inertia resists a unit acceleration of its inner joint and its spin by.
template <class L>
chain::Impedance<L> inertia_impedance(const chain::Inertia<L>& inertia,
                                      const typename L::Frame& frame) {
  const auto axes = L::axes(frame);
  const auto by = L::spun_by(L::rotate(frame, inertia.center));
  chain::Impedance<L> a{};
  for (std::size_t k = 0; k < L::kTranslations; ++k) a.tt(k, k) = inertia.mass;
  a.tr = inertia.mass * by;
  a.rt = transpose(a.tr);
  a.rr = axes * inertia.rotational * transpose(axes) + inertia.mass * (transpose(by) * by);
  return a;
}

/// Minus the slope of the moment of `inertia_force` by the segment's spin at the end.
/// @param spin  of the step, in the segment's axes
template <class L>
Mat<typename L::Scalar, L::kRotations, L::kRotations> rotational_impedance(
    const StepFactors& of, const chain::Inertia<L>& inertia, const typename L::Frame& end,
    const SegmentMotion<L>& now, const typename L::Spin& spin, const typename L::Spin& moment) {
  using S = typename L::Scalar;
  const auto axes = L::axes(end);
  const auto slope = L::step_spin_slope(spin);
  const S velocity = constant<S>(of.velocity);
  const typename L::Spin momentum = inertia.rotational * now.spin;
  if (of.conserves) {
    return constant<S>(of.rate) *
           (L::spin_derivative(axes * momentum) +
            axes * ((velocity * inertia.rotational) * slope) * transpose(axes));
  }
  const S stiff = constant<S>(of.resisting);
  const auto by_spin =
      velocity * (L::spin_derivative(momentum) - L::spin_derivative(now.spin) * inertia.rotational);
  return axes * ((stiff * inertia.rotational + by_spin) * slope) * transpose(axes) -
         L::spin_derivative(moment);
}

/// Adds what a segment resists.
/// @param active  where forces act
template <class L>
void add_inertia_force(const chain::Inertia<L>& inertia, std::size_t i,
                       const chain::Placement<L>& active, const CenterForce<L>& resists,
                       chain::OuterForces<L>& outer_forces) {
  const typename L::Point work_arm = L::rotate(active.frame[i], inertia.center);
  chain::Wrench<L>& wrench = outer_forces.wrench[i];
  wrench.force += resists.force;
  wrench.moment += resists.moment + L::moment(work_arm, resists.force);
}

/// Adds how that changes as the segment moves.
/// @param rotational  `rotational_impedance`
template <class L>
void add_inertia_slope(const StepFactors& of, const chain::Inertia<L>& inertia, std::size_t i,
                       const chain::Placement<L>& end, const chain::Placement<L>& active,
                       const CenterForce<L>& resists,
                       const Mat<typename L::Scalar, L::kRotations, L::kRotations>& rotational,
                       chain::OuterForces<L>& outer_forces) {
  using S = typename L::Scalar;
  const typename L::Point arm = L::rotate(end.frame[i], inertia.center);
  const typename L::Point work_arm = L::rotate(active.frame[i], inertia.center);
  const S mass = constant<S>(of.resisting) * inertia.mass;
  const auto by = L::spun_by(arm);
  const auto work_by = L::spun_by(work_arm);
  chain::Impedance<L>& a = outer_forces.impedance[i];
  for (std::size_t k = 0; k < L::kTranslations; ++k) a.tt(k, k) = a.tt(k, k) + mass;
  a.tr += mass * by;
  a.rt += mass * transpose(work_by);
  a.rr += rotational + mass * (transpose(work_by) * by) -
          constant<S>(of.midpoint ? 0.5 : 1.0) * L::moment_by(arm, resists.force);
}

}  // namespace plastica::solve
