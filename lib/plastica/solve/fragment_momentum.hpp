#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

#include "plastica/chain/inverse.hpp"
#include "plastica/chain/placement.hpp"
#include "plastica/solve/segment_motion.hpp"

/// The momentum of fragments of a beam: README.md, "Momentum".
namespace plastica::solve {

/// What sums over a beam and its motion are kept in: double, for float, too; in lanes its scalar.
template <class S>
using sum_t = std::conditional_t<kHasLanes<S>, S, double>;

/// Momentum of the segments of a fragment, and what its changes are small against.
template <class L>
struct FragmentMotion {
  using S = typename L::Scalar;
  S mass{};
  typename L::Point center{};    ///< of mass [m]
  typename L::Point momentum{};  ///< [N s]
  typename L::Spin angular{};    ///< angular momentum about the center of mass [N m s]
  sum_t<S> size{};               ///< sum of the sizes of the segments' momenta [N s]
  sum_t<S> angular_size{};       ///< the same of their angular momenta about the center [N m s]
};

/// @param first, end  segments of the fragment, `end` not included
template <class L>
FragmentMotion<L> fragment_motion(const std::vector<chain::Inertia<L>>& inertias,
                                  const chain::Placement<L>& placement,
                                  const std::vector<SegmentMotion<L>>& motion, std::size_t first,
                                  std::size_t end) {
  using S = typename L::Scalar;
  FragmentMotion<L> fragment;
  for (std::size_t i = first; i < end; ++i) {
    const S mass = inertias[i].mass;
    fragment.mass = fragment.mass + mass;
    fragment.center += mass * placement.point(i, inertias[i].center);
    fragment.momentum += mass * motion[i].velocity;
    fragment.size += size_of(mass * motion[i].velocity);
  }
  const S fraction = constant<S>(1) / fragment.mass;
  fragment.center = fraction * fragment.center;
  const typename L::Point mean = fraction * fragment.momentum;
  for (std::size_t i = first; i < end; ++i) {
    const typename L::Point arm = placement.point(i, inertias[i].center) - fragment.center;
    const typename L::Spin own = L::moment(arm, inertias[i].mass * (motion[i].velocity - mean)) +
                                 angular_momentum(inertias[i], placement.frame[i], motion[i].spin);
    fragment.angular += own;
    fragment.angular_size += size_of(own);
  }
  return fragment;
}

/// Adds the rigid motion of a fragment that has a given momentum.
/// @param about     point that the angular momentum is about
/// @param momentum  of the motion that is added, and its angular momentum
template <class L>
void add_momentum(const std::vector<chain::Inertia<L>>& inertias,
                  const chain::Placement<L>& placement, const typename L::Point& about,
                  const chain::Wrench<L>& momentum, std::size_t first, std::size_t end,
                  std::vector<SegmentMotion<L>>& motion) {
  using S = typename L::Scalar;
  constexpr std::size_t kR = L::kRotations;
  constexpr std::size_t kT = L::kTranslations;
  chain::Impedance<L> a{};
  const auto arm_of = [&](std::size_t i) { return placement.point(i, inertias[i].center) - about; };
  for (std::size_t i = first; i < end; ++i) {
    const S mass = inertias[i].mass;
    const auto by = L::spun_by(arm_of(i));
    const auto axes = L::axes(placement.frame[i]);
    for (std::size_t k = 0; k < kT; ++k) a.tt(k, k) = a.tt(k, k) + mass;
    a.tr += mass * by;
    a.rt += mass * transpose(by);
    a.rr += axes * inertias[i].rotational * transpose(axes) + mass * (transpose(by) * by);
  }
  Mat<S, kR + kT, kR + kT> m;
  put(m, 0, 0, a.rr);
  put(m, 0, kR, a.rt);
  put(m, kR, 0, a.tr);
  put(m, kR, kR, a.tt);
  Vec<S, kR + kT> right;
  for (std::size_t k = 0; k < kR; ++k) right[k] = momentum.moment[k];
  for (std::size_t k = 0; k < kT; ++k) right[kR + k] = momentum.force[k];
  const Vec<S, kR + kT> moves = chain::inverse(m) * right;
  typename L::Spin spin;
  typename L::Point shift;
  for (std::size_t k = 0; k < kR; ++k) spin[k] = moves[k];
  for (std::size_t k = 0; k < kT; ++k) shift[k] = moves[kR + k];
  for (std::size_t i = first; i < end; ++i) {
    motion[i].velocity += shift + L::spun(spin, arm_of(i));
    motion[i].spin += transposed_times(L::axes(placement.frame[i]), spin);
  }
}

/// What a fragment's momentum has changed by beyond the impulses of its loads, so far.
template <class L>
struct MomentumError {
  using S = typename L::Scalar;
  using E = sum_t<S>;
  typename L::Point lost{};    ///< [N s]
  typename L::Spin angular{};  ///< [N m s]
  E largest_lost{};            ///< of them, so far
  E largest_angular{};         ///< likewise
  E size{};                    ///< `FragmentMotion::size`, the largest so far
  E angular_size{};            ///< likewise
  chain::Wrench<L> outside{};  ///< what acted on it at the step's begin, about its center
  bool knows_outside = false;

  /// The largest over the largest momentum so far [1].
  /// @param length  of the beam [m]
  E fraction(const E& length) const {
    const E none = constant<E>(0.0);
    // A fragment that hardly turns has no angular momentum but rounding.
    const E no_spin = constant<E>(kIsDouble<S> ? 1e-9 : 1e-3);
    const E scale = max(angular_size, no_spin * size * length);
    // Nor has one that turns about its center a linear one.
    const E no_drift = constant<E>(kIsDouble<S> ? 1e-6 : 1e-3);
    const E linear = max(size, no_drift * angular_size / length);
    return max(select(linear > none, largest_lost / linear, none),
               select(scale > none, largest_angular / scale, none));
  }
};

}  // namespace plastica::solve
