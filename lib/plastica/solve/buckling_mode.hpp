#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "plastica/solve/newton_step.hpp"

namespace plastica::solve {

namespace detail {

/// What weighs motions in `softest_motion`: translations by 1/length^2, spins by 1.
template <class L>
typename L::Scalar weighed(const chain::Chain<L>& chain, const std::vector<chain::Motion<L>>& a,
                           const std::vector<chain::Motion<L>>& b) {
  using S = typename L::Scalar;
  const S weight = constant<S>(1) / (chain.length * chain.length);
  S sum = constant<S>(0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum = sum + weight * dot(a[i].shift, b[i].shift) + dot(a[i].spin, b[i].spin);
  }
  return sum;
}

/// Takes out what of a motion others have, and makes the largest spin 1.
template <class L>
void set_apart(const chain::Chain<L>& chain,
               const std::vector<std::vector<chain::Motion<L>>>& others,
               std::vector<chain::Motion<L>>& motion) {
  using S = typename L::Scalar;
  for (const auto& other : others) {
    const S part = weighed(chain, other, motion) / weighed(chain, other, other);
    for (std::size_t i = 0; i < motion.size(); ++i) {
      motion[i].shift -= part * other[i].shift;
      motion[i].spin -= part * other[i].spin;
    }
  }
  S largest = constant<S>(0);
  for (const auto& of_segment : motion) {
    for (const S& spin : of_segment.spin.at) largest = larger_size(largest, spin);
  }
  const S scale = constant<S>(1) / largest;
  for (auto& of_segment : motion) {
    of_segment.shift = scale * of_segment.shift;
    of_segment.spin = scale * of_segment.spin;
  }
}

/// A motion that has a part of every mode.
/// @param phase  of another one, another
template <class L>
std::vector<chain::Motion<L>> any_motion(const chain::Chain<L>& chain, double phase) {
  using S = typename L::Scalar;
  std::vector<chain::Motion<L>> motion(chain.size());
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const double x = static_cast<double>(i + 1) + phase;
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      motion[i].spin[k] = constant<S>(std::sin(1.7 * x + static_cast<double>(k)) + 0.3);
    }
    for (std::size_t k = 0; k < L::kTranslations; ++k) {
      motion[i].shift[k] = chain.length * constant<S>(std::cos(0.9 * x + static_cast<double>(k)));
    }
  }
  return motion;
}

/// What acts on segments that a motion is sought of, by its weights.
template <class L, bool kElastic>
void push_by(const chain::Chain<L>& chain, const std::vector<chain::Motion<L>>& motion,
             NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  const S weight = constant<S>(1) / (chain.length * chain.length);
  w.right.reset(chain.size());
  for (std::size_t i = 0; i < motion.size(); ++i) {
    w.right.wrench[i] = {weight * motion[i].shift, motion[i].spin};
  }
}

}  // namespace detail

/// How far a factored tangent is from symmetric, over its size: of two sets of forces, the work of
/// each on what the other moves. Rounding leaves some 1e-13.
/// @param w  its columns and right side are used
template <class L, bool kElastic>
typename L::Scalar asymmetry(const chain::Chain<L>& chain, NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  const std::array pushed{detail::any_motion(chain, 0.0), detail::any_motion(chain, 0.31)};
  for (std::size_t j = 0; j < 2; ++j) {
    detail::push_by(chain, pushed[j], w);
    w.recursion.solve(w.right, false, w.columns[j]);
  }
  const auto work = [&](std::size_t forces, std::size_t moved) {
    return detail::weighed(chain, pushed[forces], w.columns[moved].motion);
  };
  const S zero = constant<S>(0);
  // Of two forces that are unlike enough one may do no work on what the other moves.
  const S size = max(abs(work(0, 0)), max(abs(work(1, 1)), abs(work(0, 1))));
  return size > zero ? abs(work(0, 1) - work(1, 0)) / size : zero;
}

/// The motion of the segments that a factored tangent resists least, the largest spin being 1: by
/// inverse iteration K x' = B x among the motions that the constraints allow. B weighs translations
/// by 1/length^2 and spins by 1. The eigenvalue sought is near zero, so that a few iterations leave
/// nothing of the others.
/// @param w       holds the tangent; its columns, small system and right side are used
/// @param others  of an eigenvalue that is there more than once: those that are known already
template <class L, bool kElastic>
std::vector<chain::Motion<L>> softest_motion(
    const chain::Chain<L>& chain, NewtonWork<L, kElastic>& w,
    const std::vector<std::vector<chain::Motion<L>>>& others = {}) {
  using S = typename L::Scalar;
  const std::size_t n = chain.size();
  std::vector<chain::Motion<L>> motion = detail::any_motion(chain, 0.0);
  const PathCondition<L> at_time;
  for (auto& gap : w.gap) gap = constant<S>(0);
  for (int iteration = 0; iteration < 6; ++iteration) {
    detail::push_by(chain, motion, w);
    w.recursion.solve(w.right, false, w.columns[0]);
    for (std::size_t k = 0; k < chain.constraints.size(); ++k)
      detail::solve_constraint(chain, k, w);
    detail::join_columns(chain, at_time, w);
    for (std::size_t i = 0; i < n; ++i) {
      motion[i] = w.columns[0].motion[i];
      for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
        const S fraction = select(w.closed[k], w.small.b(k), constant<S>(0));
        motion[i].shift += fraction * w.columns[1 + k].motion[i].shift;
        motion[i].spin += fraction * w.columns[1 + k].motion[i].spin;
      }
    }
    detail::set_apart(chain, others, motion);
  }
  return motion;
}

/// Scales translations so that the largest component is 1; zero where none exceeds `least`.
template <class Point, class S>
void make_largest_one(std::vector<Point>& mode, const S& least) {
  S largest = constant<S>(0);
  for (const Point& of_joint : mode) {
    for (const S& displacement : of_joint.at) {
      if (abs(displacement) > abs(largest)) largest = displacement;
    }
  }
  const S scale = abs(largest) > least ? constant<S>(1) / largest : constant<S>(0);
  for (Point& displacement : mode) displacement = scale * displacement;
}

/// Translations of the segments' inner joints and of the end (N + 1), the largest being 1; zero
/// where the motion has none but rounding.
template <class L, bool kElastic>
std::vector<typename L::Point> mode_of(const chain::Chain<L>& chain,
                                       const std::vector<chain::Motion<L>>& motion,
                                       const NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  const std::size_t n = chain.size();
  std::vector<typename L::Point> mode(n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    if (i < n) {
      mode[i] = motion[i].shift;
    } else {
      const typename L::Point arm = L::rotate(w.placement.frame[n - 1], chain.segments[n - 1].arm);
      mode[i] = motion[n - 1].shift + L::spun(motion[n - 1].spin, arm);
    }
  }
  // Beside a largest spin of 1.
  make_largest_one(mode, constant<S>(1e-6) * chain.length);
  return mode;
}

/// Both in a row.
template <class L, bool kElastic>
std::vector<typename L::Point> buckling_mode(const chain::Chain<L>& chain,
                                             NewtonWork<L, kElastic>& w) {
  return mode_of(chain, softest_motion(chain, w), w);
}

}  // namespace plastica::solve
