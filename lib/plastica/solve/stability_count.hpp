#pragma once

#include <cmath>

#include "plastica/solve/newton_step.hpp"

/// Whether an equilibrium is stable, from the factored tangent.
namespace plastica::solve {

/// Whether all that acts has a potential, so that the tangent at an equilibrium is symmetric: no
/// load follows its segment, and in space none has a moment of fixed axes.
template <class L>
bool is_conservative(const chain::Chain<L>& chain) {
  for (const auto& load : chain.loads) {
    if (load.follows) return false;
    if constexpr (L::kRotations > 1) {
      for (std::size_t k = 0; k < L::kRotations; ++k) {
        const auto none = constant<typename L::Scalar>(0);
        if (any((load.moment[k] > none) | (load.moment[k] < none))) return false;
      }
    }
  }
  return true;
}

/// Whether the tangent is symmetric at an equilibrium: that of yielding beside an axial force that
/// equilibrium gives is not.
template <class L, bool kElastic>
bool is_symmetric(const chain::Chain<L>& chain, const NewtonWork<L, kElastic>& w) {
  return !w.outer_forces.axial.acts() && is_conservative(chain);
}

namespace detail {

/// Visits the pivots of what is left of the tangent for constraints, negated.
///
/// With K the tangent stiffened by sum s w w^T, the constrained problem is [K, W; W^T, 0], whose
/// Schur complement is -W^T K^-1 W. A path's condition w_c that is only there to be regular is
/// taken out by [K, w_c; w_c^T, 1/s], whose complement is the tangent without it; one that holds
/// the beam (displacement control) is a constraint like others.
/// @param condition  with which `w.recursion` was factored
/// @param holds      whether it holds the beam
template <class L, bool kElastic, class Visit>
void for_each_constraint_pivot(const chain::Chain<L>& chain, const PathCondition<L>& condition,
                               bool holds, NewtonWork<L, kElastic>& w, const Visit& visit) {
  using S = typename L::Scalar;
  const S zero = constant<S>(0);
  const S one = constant<S>(1);
  const std::size_t constraints = chain.constraints.size();
  for (std::size_t k = 0; k < constraints; ++k) solve_constraint(chain, k, w);
  if (condition.active) {
    w.right.reset(chain.size());
    w.right.wrench[condition.segment] = condition.covector;
    w.recursion.solve(w.right, false, w.columns.back());
  }
  const std::size_t n = constraints + (condition.active ? 1 : 0);
  auto& small = w.small;
  for (std::size_t k = 0; k < n; ++k) {
    const bool of_path = k == constraints;
    const std::size_t segment = of_path ? condition.segment : chain.constraints[k].segment;
    const chain::Wrench<L> wrench =
        of_path ? condition.covector : chain::unit_wrench(chain.constraints[k], w.placement);
    for (std::size_t j = 0; j < n; ++j) {
      const S moved = power(wrench, w.columns[1 + j].motion[segment]);
      const S row = of_path ? moved : select(w.closed[k], moved, zero);
      small.a(k, j) = j == constraints ? row : select(w.closed[j], row, zero);
    }
    if (of_path && !holds) small.a(k, k) = small.a(k, k) - one / chain.constraint_stiffness;
  }
  small.for_each_pivot(n, [&](std::size_t /*row*/, const S& pivot) { visit(-pivot); });
}

}  // namespace detail

/// Number of independent unstable modes of an equilibrium: that of the negative eigenvalues of the
/// tangent among the motions that the constraints allow (0: stable), by Sylvester's law of inertia
///
///   count = negative(K) + negative(-W^T K^-1 W) - constraints,
///
/// K the tangent with the constraints' stiffness (README.md). A symmetric K without a negative
/// pivot is positive definite, so also among the motions that the constraints allow: 0 at once.
/// Where loads have no potential only its parity means something, the sign of the determinant: it
/// is taken then, which tells divergence, and not flutter. `w` holds what `equilibrate` has left;
/// its columns and small system are used.
template <class L, bool kElastic>
typename L::Scalar unstable_modes(const chain::Chain<L>& chain, const PathCondition<L>& condition,
                                  bool holds, NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  const S zero = constant<S>(0);
  const S one = constant<S>(1);
  S count = zero;
  const auto add = [&](const S& pivot) { count = count + select(pivot < zero, one, zero); };
  mask_t<S> definite = zero <= zero;
  w.recursion.for_each_pivot(chain, [&](const S& pivot) {
    add(pivot);
    definite = definite & (pivot > zero);
  });
  if (!condition.active && !any(!definite) && is_symmetric(chain, w)) return zero;
  detail::for_each_constraint_pivot(chain, condition, holds, w, add);
  for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
    count = count - select(w.closed[k], one, zero);
  }
  return condition.active && holds ? count - one : count;
}

/// Logarithm of the size of the determinant whose sign changes with the parity of `unstable_modes`,
/// up to a constant of the chain and the set of constraints that act.
template <class L, bool kElastic>
double log_determinant(const chain::Chain<L>& chain, const PathCondition<L>& condition, bool holds,
                       NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  double sum = 0.0;
  const auto size = [](const S& pivot) {
    const double p = std::fabs(static_cast<double>(pivot));
    return p > 0.0 ? std::log(p) : 0.0;
  };
  w.recursion.for_each_pivot(chain, [&](const S& pivot) { sum -= size(pivot); });
  detail::for_each_constraint_pivot(chain, condition, holds, w,
                                    [&](const S& pivot) { sum += size(pivot); });
  return sum;
}

}  // namespace plastica::solve
