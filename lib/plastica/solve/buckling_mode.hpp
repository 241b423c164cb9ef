#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "plastica/solve/newton_step.hpp"

namespace plastica::solve {

/// The mode that a factored tangent resists least: where the joints go, the largest translation
/// being 1, by inverse iteration K x' = B x among the motions that the closures allow. B weighs
/// translations by 1/length^2 and spins by 1. The eigenvalue sought is near zero, so that a few
/// iterations leave nothing of the others.
/// @param w  holds the tangent; its columns, small system and right side are used
/// @return translations of the segments' inner joints and of the end (N + 1)
template <class L, bool kElastic>
std::vector<typename L::Point> buckling_mode(const chain::Chain<L>& chain,
                                             NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  const std::size_t n = chain.size();
  const S weight = constant<S>(1) / (chain.length * chain.length);
  std::vector<chain::Motion<L>> motion(n);
  for (std::size_t i = 0; i < n; ++i) {
    // Anything that has a part of every mode.
    const double x = static_cast<double>(i + 1);
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      motion[i].spin[k] = constant<S>(std::sin(1.7 * x + static_cast<double>(k)) + 0.3);
    }
    for (std::size_t k = 0; k < L::kTranslations; ++k) {
      motion[i].shift[k] = chain.length * constant<S>(std::cos(0.9 * x + static_cast<double>(k)));
    }
  }
  const PathCondition<L> at_time;
  for (auto& gap : w.gap) gap = constant<S>(0);
  for (int iteration = 0; iteration < 6; ++iteration) {
    w.right.reset(n);
    for (std::size_t i = 0; i < n; ++i) {
      w.right.wrench[i] = {weight * motion[i].shift, motion[i].spin};
    }
    w.recursion.solve(w.right, false, w.columns[0]);
    for (std::size_t k = 0; k < chain.closures.size(); ++k) detail::solve_closure(chain, k, w);
    detail::join_columns(chain, at_time, w);
    S largest = constant<S>(0);
    for (std::size_t i = 0; i < n; ++i) {
      motion[i] = w.columns[0].motion[i];
      for (std::size_t k = 0; k < chain.closures.size(); ++k) {
        const S share = select(w.closed[k], w.small.b(k), constant<S>(0));
        motion[i].shift += share * w.columns[1 + k].motion[i].shift;
        motion[i].spin += share * w.columns[1 + k].motion[i].spin;
      }
      for (const S& spin : motion[i].spin.at) largest = detail::larger_size(largest, spin);
    }
    const S scale = constant<S>(1) / largest;
    for (auto& of_segment : motion) {
      of_segment.shift = scale * of_segment.shift;
      of_segment.spin = scale * of_segment.spin;
    }
  }
  std::vector<typename L::Point> mode(n + 1);
  S largest = constant<S>(0);
  for (std::size_t i = 0; i <= n; ++i) {
    if (i < n) {
      mode[i] = motion[i].shift;
    } else {
      const typename L::Point arm = L::turn(w.placement.frame[n - 1], chain.segments[n - 1].arm);
      mode[i] = motion[n - 1].shift + L::spun(motion[n - 1].spin, arm);
    }
    for (const S& way : mode[i].at) {
      if (abs(way) > abs(largest)) largest = way;
    }
  }
  for (auto& way : mode) way = (constant<S>(1) / largest) * way;
  return mode;
}

}  // namespace plastica::solve
