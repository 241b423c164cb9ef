#pragma once

#include "plastica/solve/path.hpp"

/// Whether a step goes on along the path, or has come to another equilibrium.
namespace plastica::solve {

/// Sums what the joints' turns come to along the chain, segment by segment, in world axes.
///
/// In a plane it is the turn of the segment, full turns counted; in space the same to first order
/// in the turns, and still large where a segment has come back after a full turn.
/// @param turn  of joint i, in its inner axes
template <class L, bool kElastic>
template <class IncrementOf, class Visit>
void PathContinuation<L, kElastic>::for_each_rotation(const IncrementOf& increment,
                                                      const Visit& visit) const {
  typename L::Spin sum{};
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    const typename L::Spin own = increment(i);
    sum += L::axes(w_.placement.near[i]) * own;
    visit(own, sum);
  }
}

/// Root of the mean square of the segments' turns [rad].
template <class L, bool kElastic>
template <class IncrementOf>
double PathContinuation<L, kElastic>::size_of_rotations(const IncrementOf& increment) const {
  double squares = 0.0;
  for_each_rotation(increment, [&](const typename L::Spin& /*own*/, const typename L::Spin& sum) {
    squares += static_cast<double>(dot(sum, sum));
  });
  return std::sqrt(squares / static_cast<double>(chain_.size()));
}

template <class L, bool kElastic>
bool PathContinuation<L, kElastic>::rotates_too_far() const {
  const double largest = options_.largest_rotation;
  bool too_far = false;
  for_each_rotation([&](std::size_t i) { return w_.q.angle[i] - committed_.angle[i]; },
                    [&](const typename L::Spin& own, const typename L::Spin& sum) {
                      for (std::size_t k = 0; k < L::kRotations; ++k) {
                        too_far = too_far || std::fabs(static_cast<double>(own[k])) > largest;
                      }
                      if constexpr (L::kTranslations > 0) {
                        too_far = too_far ||
                                  static_cast<double>(size_of(sum)) > kSegmentRotation * largest;
                      }
                    });
  return too_far;
}

/// Of the turns in a unit of time, along the tangent at the unknowns in `w_` [rad/s].
template <class L, bool kElastic>
double PathContinuation<L, kElastic>::rotation_rate() {
  const PathCondition<L> condition = PathCondition<L>::unit_time();
  if (!holds_tangent_) {
    detail::assemble(chain_, laws_, w_);
    w_.recursion.factor(chain_, w_.q, w_.placement, w_.stage, w_.joints, w_.outer_forces,
                        w_.transmitted);
    holds_tangent_ = true;
  }
  detail::solve_imbalance(chain_, condition, w_);
  for (std::size_t k = 0; k < chain_.constraints.size(); ++k)
    detail::solve_constraint(chain_, k, w_);
  detail::solve_time(chain_, condition, w_);
  detail::join_columns(chain_, condition, w_);
  return size_of_rotations([&](std::size_t i) {
    typename L::Spin increment;
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      increment[k] = w_.columns.back().joint[i][k];
      for (std::size_t j = 0; j < chain_.constraints.size(); ++j) {
        if (w_.closed[j]) increment[k] += w_.small.b(j) * w_.columns[1 + j].joint[i][k];
      }
    }
    return increment;
  });
}

/// The mean turns of a step lie between those that its begin and its end point to, unless it has
/// left the path: then it has turned by far more than either. (Twice as much is what the kink does
/// where a hinge forms under a force that it swings away from: the turn is a root of the load.) A
/// step that does not continue another is held to the rule of the trapezoid, too, which a path that
/// is nearly straight in the step meets.
template <class L, bool kElastic>
bool PathContinuation<L, kElastic>::points_on() {
  rotated_ = size_of_rotations([&](std::size_t i) { return w_.q.angle[i] - committed_.angle[i]; });
  if constexpr (L::kTranslations == 0) return true;  // the angle of a twisted chain has no other
  const double span = w_.time - time_;
  if (!at_time_ || rotated_ < kNoRotation || !(span > 0.0)) return true;
  const double before = rate_before_ * span;
  const bool first = !goes_on_ && !observer_.yields() && !has_pillars_;
  if (!first && rotated_ <= kGrowth * before) return true;
  const double after = rotation_rate() * span;
  if (rotated_ > kJump * std::max(before, after)) return false;
  if (!first) return true;
  const bool alike = std::max(before, after) <= 3.0 * std::min(before, after);
  return alike && std::fabs(0.5 * (before + after) - rotated_) <= 0.2 * rotated_;
}

}  // namespace plastica::solve
