#pragma once

#include "plastica/chain/recursion.hpp"

/// The pivots of a factored chain: what Sylvester's law of inertia needs.
namespace plastica::chain {

/// The pivots of a symmetric matrix eliminated in its order; a row of zeros gives the pivot 0 and
/// is left out. Their signs are those of the eigenvalues.
template <class S, std::size_t N, class Visit>
void for_each_pivot(Mat<S, N, N> m, const Visit& visit) {
  const S zero = constant<S>(0);
  const S one = constant<S>(1);
  for (std::size_t k = 0; k < N; ++k) {
    visit(m(k, k));
    const auto none = (m(k, k) <= zero) & (m(k, k) >= zero);
    const S scale = select(none, zero, one / select(none, one, m(k, k)));
    for (std::size_t i = k + 1; i < N; ++i) {
      const S factor = m(i, k) * scale;
      for (std::size_t j = k + 1; j < N; ++j) m(i, j) = m(i, j) - factor * m(k, j);
    }
  }
}

/// Visits the pivots of D^-1 of all joints and of the root's inverse: eliminated one after another
/// by their freedoms, these make up the chain's tangent, constraints' stiffness included, so that
/// as many of them are negative as the tangent has negative eigenvalues (at an equilibrium of
/// conservative loads, where it is symmetric). Open joints, of statics none, are not visited.
template <class L, bool kElastic>
template <class Visit>
void Recursion<L, kElastic>::for_each_pivot(const Chain<L>& chain, const Visit& visit) const {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (i > 0) {
      chain::for_each_pivot(joints_[i].inverse, visit);
      continue;
    }
    // Clamped freedoms of the first joint are rows of zeros in its own axes.
    auto axes = identity<S, kJ>();
    put(axes, 0, 0, joints_[0].near);
    Mat<S, kJ, kJ> own = transpose(axes) * (joints_[0].inverse * axes);
    for (std::size_t k = 0; k < kR; ++k) {
      if (!chain.root.clamped[k]) continue;
      for (std::size_t j = 0; j < kJ; ++j) own(k, j) = own(j, k) = constant<S>(0);
    }
    chain::for_each_pivot(own, visit);
  }
  if constexpr (kT > 0) chain::for_each_pivot(root_inverse_, visit);
}

}  // namespace plastica::chain
