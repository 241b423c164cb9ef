#pragma once

#include "plastica/solve/path.hpp"
#include "plastica/solve/stability_count.hpp"

/// Where a path loses its stability: README.md, Stability.
namespace plastica::solve {

template <class L, bool kElastic>
bool PathContinuation<L, kElastic>::bifurcated_before_limit() const {
  return status_ == Status::LimitLoad && limit_ && !critical_.above.empty() &&
         critical_.above.front() < (1.0 - kCriticalWidth) * limit_->below;
}

template <class L, bool kElastic>
Status PathContinuation<L, kElastic>::status() const {
  const bool at_end =
      status_ == Status::Completed || status_ == Status::Broken || bifurcated_before_limit();
  return at_end && unstable_ ? Status::Unstable : status_;
}

template <class L, bool kElastic>
void PathContinuation<L, kElastic>::factor_tangent() {
  detail::assemble(chain_, laws_, w_);
  if (condition_.active) detail::stiffen_condition(chain_, condition_, w_);
  w_.recursion.factor(chain_, w_.q, w_.placement, w_.stage, w_.joints, w_.outer_forces,
                      w_.transmitted);
}

/// The unstable modes of the trial; -1 where they are not asked for.
template <class L, bool kElastic>
int PathContinuation<L, kElastic>::count_unstable_modes() {
  if constexpr (L::kTranslations == 0) return 0;  // the joints' own stiffness is all there is
  double count = found_modes_;
  found_modes_ = -1.0;
  if (!at_time_ && options_.control != PathControl::Displacement) return -1;
  if (!(count >= 0.0)) {
    if (!holds_tangent_) factor_tangent();
    holds_tangent_ = true;
    const bool holds = options_.control == PathControl::Displacement;
    count = static_cast<double>(unstable_modes(chain_, condition_, holds, w_));
  }
  if (!conservative_) return std::abs(static_cast<int>(count)) % 2;
  return static_cast<int>(count) + observer_.unstable_beside(w_);
}

/// Whether a step that changes the number of unstable modes is short enough to be taken.
template <class L, bool kElastic>
bool PathContinuation<L, kElastic>::may_change_stability(bool shortest) {
  trial_modes_ = count_unstable_modes();
  if (trial_modes_ == modes_ || trial_modes_ < 0 || modes_ < 0 || shortest) return true;
  if (critical_.factor.size() >= kMaxCritical) return true;
  return std::fabs(w_.time - time_) <= kCriticalWidth * std::fabs(w_.time);
}

/// Notes the time at which the determinant is zero in a step that changes the unstable modes: it
/// goes along a straight line in so short a step.
template <class L, bool kElastic>
void PathContinuation<L, kElastic>::note_critical() {
  if (critical_.factor.size() >= kMaxCritical) return;
  const bool holds = options_.control == PathControl::Displacement;
  const auto logarithm = [&] {
    return log_determinant(chain_, condition_, holds, w_) + observer_.log_determinant_beside(w_);
  };
  if (!holds_tangent_) factor_tangent();
  const double end = logarithm();
  const int beside = observer_.unstable_beside(w_);
  const double trial_time = w_.time;
  previous_ = w_.q;  // which accepting drops
  restore();
  factor_tangent();
  const double begin = logarithm();
  const bool out_of_plane = observer_.unstable_beside(w_) != beside;
  // As many factors of the determinant as modes change their signs, at one place.
  const double changes = std::abs(trial_modes_ - modes_);
  const double fraction = 1.0 / (1.0 + std::exp((end - begin) / changes));
  critical_.below.push_back(std::min(time_, trial_time));
  critical_.above.push_back(std::max(time_, trial_time));
  critical_.factor.push_back(time_ + fraction * (trial_time - time_));
  critical_.unstable_modes.push_back(trial_modes_);
  critical_.out_of_plane.push_back(out_of_plane ? 1 : 0);
  observer_.note_mode(out_of_plane, w_, critical_.mode);
  w_.q = previous_;
  w_.time = trial_time;
  factor_tangent();
  holds_tangent_ = true;
}

}  // namespace plastica::solve
