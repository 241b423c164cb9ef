#pragma once

#include "plastica/solve/path.hpp"

/// The paths on which the time is an unknown: arcs and displacement control.
namespace plastica::solve {

template <class L, bool kElastic>
bool PathContinuation<L, kElastic>::begin_arcs() {
  look_around();
  return set_scales(control_.rate(rate_of(control_.segment), w_.placement));
}

template <class L, bool kElastic>
chain::Motion<L> PathContinuation<L, kElastic>::rate_of(std::size_t segment) const {
  return detail::motion_in_time(chain_, w_, segment);
}

template <class L, bool kElastic>
void PathContinuation<L, kElastic>::find_control() {
  double most = size_of(control_.rate(rate_of(control_.segment), w_.placement));
  ControlPoint<L> candidate;
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    candidate.segment = i;
    candidate.arm = chain_.segments[i].arm;
    const double moves = size_of(candidate.rate(rate_of(i), w_.placement));
    // What the first load pushes is kept unless another moves far more.
    if (moves <= 10.0 * most) continue;
    most = moves;
    control_ = candidate;
  }
}

template <class L, bool kElastic>
bool PathContinuation<L, kElastic>::set_scales(const Value& rate) {
  const double span = options_.stops.back();
  const double path = static_cast<double>(size_of(rate)) * span;
  // What only rounding moves has no scale: an axial load moves no straight beam.
  if (!(path > least_path()) || !std::isfinite(path)) return false;
  span_ = span;
  elastic_path_ = path;
  rate_ = rate;
  return true;
}

template <class L, bool kElastic>
typename PathContinuation<L, kElastic>::Arc PathContinuation<L, kElastic>::next_arc(
    double length) const {
  Arc arc;
  arc.from = control_.value(w_.placement);
  arc.from_time = time_;
  arc.length = length * elastic_path_;
  Value du = constant<S>(span_ / elastic_path_) * rate_;
  double dt = 1.0;
  if (has_secant_) {
    du = constant<S>(1.0 / elastic_path_) * secant_;
    dt = secant_time_ / span_;
  }
  const double norm = std::sqrt(dot(du, du) + dt * dt);
  arc.direction = constant<S>(1.0 / norm) * du;
  arc.time_weight = dt / norm * elastic_path_ / span_;
  return arc;
}

template <class L, bool kElastic>
PathCondition<L> PathContinuation<L, kElastic>::condition_of(const Arc& arc, const Work& w) const {
  PathCondition<L> condition;
  condition.active = true;
  condition.segment = control_.segment;
  condition.covector = control_.covector(arc.direction, w.placement);
  condition.time_slope = constant<S>(arc.time_weight);
  const double along = dot(arc.direction, control_.value(w.placement) - arc.from);
  condition.value = constant<S>(along + arc.time_weight * (w.time - arc.from_time) - arc.length);
  return condition;
}

template <class L, bool kElastic>
typename PathContinuation<L, kElastic>::Trial PathContinuation<L, kElastic>::advance_arc() {
  for (;;) {
    restore();
    chain::place<kElastic>(chain_, w_.q, w_.time, w_.placement);
    const Arc arc = next_arc(arc_length_);
    const Value from = arc.from;
    const double from_time = time_;
    at_time_ = false;
    if (has_secant_) extrapolate(arc_length_ / secant_length_);
    const bool shortest = arc_length_ <= smallest_arc_;
    beyond_ = false;
    Trial trial = attempt([&](const Work& w) { return condition_of(arc, w); }, shortest);
    // A joint that yielded beyond would not come back: the end is sought from the last point
    // before it.
    if (beyond_) trial = attempt_time(latest_, shortest);
    if (trial != Trial::Failed) {
      secant_ = control_.value(w_.placement) - from;
      secant_time_ = time_ - from_time;
      secant_length_ = arc_length_;
      has_secant_ = true;
      if (iterations_ <= 6) arc_length_ = std::min(2.0 * arc_length_, largest_arc_);
      return trial;
    }
    ++counters_.cutbacks;
    if (shortest) return Trial::Failed;
    arc_length_ *= 0.5;
  }
}

template <class L, bool kElastic>
void PathContinuation<L, kElastic>::extrapolate(double fraction) {
  const S part = constant<S>(fraction);
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    w_.q.angle[i] += part * (committed_.angle[i] - previous_.angle[i]);
    if constexpr (kElastic) {
      w_.q.shift[i] += part * (committed_.shift[i] - previous_.shift[i]);
    }
  }
  w_.q.root += part * (committed_.root - previous_.root);
  for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
    w_.q.multiplier[k] += part * (committed_.multiplier[k] - previous_.multiplier[k]);
  }
  w_.time += fraction * (time_ - previous_time_);
}

template <class L, bool kElastic>
void PathContinuation<L, kElastic>::set_arc_length(double length, double growth) {
  arc_length_ = length;
  largest_arc_ = growth * length;
  smallest_arc_ = options_.smallest_step * length;
  has_secant_ = false;
}

template <class L, bool kElastic>
Status PathContinuation<L, kElastic>::follow_arcs() {
  if (!begin_arcs()) return Status::NotConverged;
  const double end = options_.stops.back();
  latest_ = end;
  set_arc_length(std::sqrt(2.0) / options_.steps, kArcGrowth);
  double highest = time_;
  // A hinge may turn for a hundred times the elastic displacement.
  const double most = 400.0 + 50.0 * options_.steps;
  for (double k = 0.0; k < most; k += 1.0) {
    const Trial trial = advance_arc();
    if (trial == Trial::Ended) return ended();
    if (trial == Trial::Failed) return end_lost();
    const bool has_room = observer_.record(w_);
    if (time_ >= end) return Status::Completed;
    highest = std::max(highest, time_);
    // A load that falls may fall for ever; one that rises comes to its end.
    if (!has_room && time_ < highest) break;
  }
  // Of a path that comes down from its limit, what has been followed holds, as unstable.
  condition_ = {};
  at_time_ = true;
  holds_tangent_ = false;
  unstable_ = count_unstable_modes() > 0;
  return unstable_ ? Status::Completed : Status::NotConverged;
}

template <class L, bool kElastic>
typename PathContinuation<L, kElastic>::Trial PathContinuation<L, kElastic>::cross_by_arc(
    double stop) {
  if (!watches_slope_) return Trial::Failed;
  watches_slope_ = false;
  // As all goes on from here, or, where that moves the control point by nothing, as it began.
  const double soon = kSameTime * options_.stops.back();
  set_scales(constant<S>(1.0 / soon) * moves_elastically(time_, time_ + soon));
  if (!(elastic_path_ > 0.0)) return Trial::Failed;
  const double first_slope = span_ / elastic_path_;
  set_arc_length(1e-2, 1.0);
  const bool may_reverse = options_.control != PathControl::Load;
  latest_ = may_reverse ? stop : kForever;
  double highest = time_;
  for (int k = 0; k < kMaxArcs; ++k) {
    const Trial trial = advance_arc();
    if (trial == Trial::Ended) return trial;
    if (trial == Trial::Failed) return Trial::Failed;
    if (time_ >= stop) {
      if (!may_reverse) return Trial::Failed;
      step_ = smallest();
      watches_slope_ = true;
      return trial;
    }
    highest = std::max(highest, time_);
    const double least = observer_.yields() ? kLimitSlope * first_slope : 0.0;
    if (secant_time_ <= least * size_of(secant_)) {
      if (turns_back()) bracket_limit(highest);
      return stopped() ? Trial::Ended : Trial::Failed;
    }
  }
  return Trial::Failed;
}

/// Whether a load that has stopped to rise may have come to its limit. Without yielding it has lost
/// its stability there, or what bends the path is rounding.
template <class L, bool kElastic>
bool PathContinuation<L, kElastic>::turns_back() {
  if (observer_.yields()) return true;
  if (largest_rotation() > kLargeRotation) return false;
  condition_ = {};
  at_time_ = true;
  holds_tangent_ = false;
  return count_unstable_modes() > 0;
}

template <class L, bool kElastic>
void PathContinuation<L, kElastic>::bracket_limit(double highest) {
  LimitLoad limit;
  limit.below = highest;
  limit.above = std::max(above_, highest);
  for (double part = 1e-4; part < 1.0; part *= 4.0) {
    const double time = highest + part * highest;
    restore();
    w_.time = time;
    factored_ = solved_ = false;
    const auto outcome = equilibrate(chain_, laws_, options_.newton, w_);
    counters_.iterations += outcome.iterations;
    if (stopped()) return;
    if (outcome.converged && !laws_.overloaded() && !rotates_too_far()) continue;
    limit.above = time;
    break;
  }
  restore();
  detail::assemble(chain_, laws_, w_);
  limit_ = limit;
}

template <class L, bool kElastic>
Status PathContinuation<L, kElastic>::follow_displacement() {
  chain::place<kElastic>(chain_, w_.q, w_.time, w_.placement);
  const Value start = control_.value(w_.placement);
  Value displacement;
  for (std::size_t k = 0; k < displacement.at.size(); ++k)
    displacement[k] = constant<S>(options_.control_motion[k]);
  const double length = size_of(displacement);
  if (!(length > 0.0)) return Status::NotConverged;
  const Value direction = constant<S>(1.0 / length) * displacement;
  const double even = length / options_.steps;
  double reached = 0.0;
  double step = even;
  double last = even;
  for (int k = 1; k <= options_.steps; ++k) {
    const double target = k == options_.steps ? length : even * k;
    while (reached < target) {
      const double next = std::min(target, reached + step);
      const bool shortest = next - reached <= options_.smallest_step * even;
      restore();
      at_time_ = false;
      if (goes_on_) extrapolate((next - reached) / last);
      const Trial trial = attempt(
          [&](const Work& w) {
            PathCondition<L> condition;
            condition.active = true;
            condition.segment = control_.segment;
            condition.covector = control_.covector(direction, w.placement);
            const double along = dot(direction, control_.value(w.placement) - start);
            condition.value = constant<S>(along - next);
            return condition;
          },
          shortest);
      if (trial == Trial::Ended) return ended();
      if (trial == Trial::Accepted) {
        goes_on_ = true;
        last = next - reached;
        reached = next;
        if (iterations_ <= 6) step = std::min(even, 2.0 * step);
        continue;
      }
      ++counters_.cutbacks;
      if (shortest) return end_lost();
      step = 0.5 * (next - reached);
    }
    if (!observer_.record(w_)) break;
  }
  return Status::Completed;
}

}  // namespace plastica::solve
