#pragma once

#include <array>
#include <cstddef>

#include "plastica/base/matrix.hpp"
#include "plastica/law/section_form.hpp"
#include "plastica/law/section_response.hpp"

namespace plastica::law {

/// A projected point and its derivative by the target; see project.hpp.
template <class S>
struct Projection {
  SectionForce<S> point;
  SectionTangent<S> slope;
};

/// A yield surface, or a facet of it, of the form (sum d_i u_i)^2 + tau^2 t^2 = 1.
template <class S>
struct LinearFacet {
  SectionForce<S> direction;  ///< d >= 0; d_t is not used
  S tau_squared;
  mask_t<S> applies;  ///< where the surface has this form for the target
  /// Second derivative of f for each component that the target lacks, `kKink` where that stays
  /// away.
  SectionForce<S> beside;
};

namespace detail {

/// Projects onto one linear facet, in the orthant, where the mask holds.
///
/// Stationarity gives u_i = max(0, target_i - mu c_i d_i s) and t = target_t/(1 + mu c_t tau^2) for
/// s = sum d_i u_i; s is the largest of U_I/(1 + mu C_I) over the subsets I of components, with
/// U_I = sum d_i target_i, C_I = sum d_i^2 c_i. What remains is phi(mu) = 1. 1/phi is concave and
/// grows with mu, so Newton's method on it comes from below, and is done in one step where torsion
/// or bending is absent (More and Sorensen, SIAM J. Sci. Stat. Comput. 4, 1983, 553).
/// @tparam Round  whether u_y is absent
template <bool Round, class S>
inline Projection<S> project_on_line(const LinearFacet<S>& facet, const SectionForce<S>& compliance,
                                     const SectionForce<S>& target, mask_t<S> active) {
  constexpr std::size_t kMembers = Round ? 2 : 3;
  constexpr std::size_t kMember[] = {kBendingX, kAxial, kBendingY};
  constexpr std::size_t kSubsets = (1U << kMembers) - 1;
  constexpr bool kDouble = sizeof(real_t<S>) == 8;
  constexpr int kMaxSteps = 40;
  const S zero = constant<S>(0);
  const S one = constant<S>(1);

  std::array<S, kSubsets> length, soft;
  for (std::size_t subset = 1; subset <= kSubsets; ++subset) {
    length[subset - 1] = soft[subset - 1] = zero;
    for (std::size_t m = 0; m < kMembers; ++m) {
      if ((subset >> m & 1U) == 0) continue;
      const S d = facet.direction[kMember[m]];
      length[subset - 1] += d * target[kMember[m]];
      soft[subset - 1] += d * d * compliance[kMember[m]];
    }
  }
  const S soft_t = facet.tau_squared * compliance[kTorsion];
  S mu = zero;
  S s, s_soft, t, inverse_s, inverse_t;
  for (int step = 0; step < kMaxSteps; ++step) {
    s = s_soft = zero;
    for (std::size_t i = 0; i < kSubsets; ++i) {
      const S reached = length[i] / (one + mu * soft[i]);
      const auto more = reached > s;
      s = select(more, reached, s);
      s_soft = select(more, soft[i], s_soft);
    }
    inverse_s = one / (one + mu * s_soft);
    inverse_t = one / (one + mu * soft_t);
    t = target[kTorsion] * inverse_t;
    const S square = s * s + facet.tau_squared * t * t;
    const S phi = sqrt(square);
    // -phi phi'
    const S falls = s * s * s_soft * inverse_s + facet.tau_squared * t * t * soft_t * inverse_t;
    const S more = square * (phi - one) / falls;
    // The step after the last one squares the error, and gives a dual scalar its derivative.
    const bool last = !any(active);
    const auto moves = active & (more > constant<S>(kDouble ? 1e-9 : 1e-4) * mu);
    mu = select(active | (last ? facet.applies : active), mu + more, mu);
    active = moves;
    if (last) break;
  }
  // s and t at the last mu.
  Projection<S> now;
  SectionForce<S> bend;   // c d on the members that are left
  SectionForce<S> stays;  // 1 where a component is left, or not touched
  S reached = zero;
  for (std::size_t i = 0; i < kSubsets; ++i) {
    reached = max(reached, length[i] / (one + mu * soft[i]));
  }
  S left = zero;
  for (std::size_t m = 0; m < kMembers; ++m) {
    const std::size_t i = kMember[m];
    const S shift = mu * compliance[i] * facet.direction[i] * reached;
    const S u = target[i] - shift;
    const auto vanishes = (u <= zero) & (shift > zero);
    stays[i] = select(vanishes, zero, one);
    now.point[i] = select(vanishes, zero, u);
    bend[i] = stays[i] * compliance[i] * facet.direction[i];
    left += bend[i] * facet.direction[i];
  }
  inverse_s = one / (one + mu * left);
  inverse_t = one / (one + mu * soft_t);
  now.point[kTorsion] = target[kTorsion] * inverse_t;

  // M = 1/c + mu (d d^T + tau^2 e_t e_t^T) on what stays: slope = M^-1 (1 - g n^T)/c with
  // g = (s d, tau^2 t), n = M^-1 g/(g^T M^-1 g).
  SectionForce<S> moved = (reached * inverse_s) * bend;  // M^-1 g
  moved[kTorsion] = compliance[kTorsion] * inverse_t * facet.tau_squared * now.point[kTorsion];
  const S across = one / (reached * reached * left * inverse_s +
                          facet.tau_squared * now.point[kTorsion] * moved[kTorsion]);
  for (std::size_t i = 0; i < kSectionAxes; ++i) {
    for (std::size_t j = 0; j < kSectionAxes; ++j) {
      S entry = -across * moved[i] * moved[j];
      if (i != kTorsion && j != kTorsion) entry -= mu * inverse_s * bend[i] * bend[j];
      now.slope(i, j) = entry / compliance[j];
    }
    now.slope(i, i) += i == kTorsion ? inverse_t : stays[i];
    const auto absent = !(target[i] > zero);
    const S lone = one / (one + mu * compliance[i] * facet.beside[i]);
    for (std::size_t j = 0; j < kSectionAxes; ++j) {
      now.slope(i, j) = select(absent, i == j ? lone : zero, now.slope(i, j));
    }
  }
  return now;
}

}  // namespace detail
}  // namespace plastica::law
