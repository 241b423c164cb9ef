#pragma once

#include "plastica/solve/path.hpp"

/// The beginning of a path, and load control: equilibria at given times.
namespace plastica::solve {

template <class L, bool kElastic>
bool PathContinuation<L, kElastic>::holds_twice() {
  const S zero = constant<S>(0);
  const std::size_t count = chain_.constraints.size();
  for (std::size_t k = 0; k < count; ++k) detail::solve_constraint(chain_, k, w_);
  for (std::size_t k = 0; k < count; ++k) {
    const auto& constraint = chain_.constraints[k];
    const chain::Wrench<L> unit = chain::unit_wrench(constraint, w_.placement);
    for (std::size_t j = 0; j < count; ++j) {
      const S moved = detail::power(unit, w_.columns[1 + j].motion[constraint.segment]);
      w_.small.a(k, j) = w_.closed[k] && w_.closed[j] ? moved : zero;
    }
  }
  w_.pivots = w_.small;
  bool twice = false;
  w_.pivots.for_each_pivot(count, [&](std::size_t k, const S& left) {
    if (!w_.closed[k]) return;
    // Negative under a thrust above what the beam bore without its supports.
    const S alone = std::fabs(w_.small.a(k, k));
    const S stiffness = detail::stiffness_of<S>(chain_, chain_.constraints[k]);
    twice =
        twice || !(alone * stiffness > kHeldTwice) || !(std::fabs(left) > kRoundedPivot<S> * alone);
  });
  return twice;
}

template <class L, bool kElastic>
Status PathContinuation<L, kElastic>::find_first() {
  auto outcome = equilibrate(chain_, laws_, options_.newton, w_);
  counters_.iterations += outcome.iterations;
  if (stopped()) return Status::Interrupted;
  const bool is_mechanism = !(w_.recursion.min_pivot() > kMechanism);
  if (!is_mechanism && (!outcome.converged || rotates_too_far())) {
    // What acts at time 0 already bends the beam far.
    outcome = load_gradually();
    if (stopped()) return Status::Interrupted;
  }
  if (!(w_.recursion.min_pivot() > kMechanism)) return Status::Mechanism;
  if (holds_twice()) return Status::HeldTwice;
  if (!outcome.converged) return finite(outcome) ? Status::NotConverged : Status::NonFinite;
  if (laws_.overloaded()) return Status::NotConverged;
  at_time_ = holds_tangent_ = true;
  trial_modes_ = count_unstable_modes();
  if (observer_.judge(w_, true) == Verdict::End) return end_broken();
  accept();
  observer_.record(w_);
  return interrupted_ ? Status::Interrupted : Status::Completed;
}

/// The first equilibrium, by steps of the loads that act at time 0 that turn no segment too far.
template <class L, bool kElastic>
NewtonOutcome<typename L::Scalar> PathContinuation<L, kElastic>::load_gradually() {
  loaded_gradually_ = true;
  NewtonOutcome<S> outcome;
  const double most = 1.0 / 16.0;
  double part = 0.0;
  double step = most;
  while (part < 1.0) {
    const double next = std::min(1.0, part + step);
    restore();
    const auto factor_at = [&](std::size_t history) {
      return next * chain_.histories[history].at(w_.time);
    };
    outcome = equilibrate(
        chain_, [&](Work& w, bool /*slopes*/) { detail::assemble(chain_, laws_, factor_at, w); },
        options_.newton, w_, [](const Work&) { return PathCondition<L>{}; });
    counters_.iterations += outcome.iterations;
    if (stopped()) break;
    if (outcome.converged && !rotates_too_far()) {
      part = next;
      step = std::min(2.0 * step, most);
      if (part < 1.0) laws_.commit();
      committed_ = w_.q;
      continue;
    }
    ++counters_.cutbacks;
    step *= 0.5;
    if (step < options_.smallest_step) {
      outcome.converged = false;
      break;
    }
  }
  return outcome;
}

template <class L, bool kElastic>
bool PathContinuation<L, kElastic>::begin_control() {
  step_ = options_.stops.front();
  switch (options_.control) {
    case PathControl::Displacement: return end(follow_displacement());
    case PathControl::ArcLength: return end(follow_arcs());
    case PathControl::Auto:
    case PathControl::Load: break;
  }
  watches_slope_ = has_scale_ = begin_slopes();
  return seek();
}

/// One step of Newton's method that takes the time along: loads and prescribed motions meet the
/// whole beam at once. A motion that the nearest joint had to take alone might make it yield.
template <class L, bool kElastic>
void PathContinuation<L, kElastic>::predict(double time) {
  PathCondition<L> at_time;
  at_time.active = true;
  at_time.time_slope = constant<S>(1);
  at_time.value = constant<S>(w_.time - time);
  solve_rates(at_time);
  detail::combine_columns(chain_, at_time, w_);
  solved_ = false;
  rate_before_ = size_of_rotations([&](std::size_t i) {
                   typename L::Spin increment;
                   for (std::size_t k = 0; k < L::kRotations; ++k)
                     increment[k] = w_.columns[0].joint[i][k];
                   return increment;
                 }) /
                 (time - time_);
  detail::take_step(chain_, at_time, false, w_);
}

/// All columns at the committed unknowns, and how much of each meets a condition on the time.
template <class L, bool kElastic>
void PathContinuation<L, kElastic>::solve_rates(const PathCondition<L>& at_time) {
  if (!factored_) {
    detail::assemble(chain_, laws_, w_);
    w_.recursion.factor(chain_, w_.q, w_.placement, w_.stage, w_.joints, w_.outer_forces,
                        w_.transmitted);
    factored_ = true;
  }
  if (!solved_) {
    detail::solve_imbalance(chain_, at_time, w_);
    for (std::size_t k = 0; k < chain_.constraints.size(); ++k)
      detail::solve_constraint(chain_, k, w_);
    detail::solve_time(chain_, at_time, w_);
    solved_ = true;
  }
  detail::join_columns(chain_, at_time, w_);
}

template <class L, bool kElastic>
bool PathContinuation<L, kElastic>::seek() {
  // No sliver is left before the stop.
  const double stop = options_.stops[stop_];
  const double left = stop - time_;
  length_ = left <= 1.001 * step_ ? left : std::min(step_, 0.5 * left);
  next_ = length_ == left ? stop : time_ + length_;
  // As near as two lengths are taken for one above: a step that can hardly be cut is not cut.
  shortest_ = length_ <= 1.001 * smallest();
  aim(next_);
  return true;
}

template <class L, bool kElastic>
bool PathContinuation<L, kElastic>::go_on(Trial trial) {
  if (trial == Trial::Failed) {
    above_ = next_;
    ++counters_.cutbacks;
    if (!shortest_) {
      step_ = std::max(0.5 * length_, smallest());
      return seek();
    }
    if (overloaded_) return end(end_lost());
    trial = cross_by_arc(options_.stops[stop_]);
  } else if (trial == Trial::Accepted) {
    goes_on_ = true;
    if (iterations_ <= 6) step_ = 2.0 * std::max(length_, step_);
    if (flat_) {
      // What the load may still rise by: where it nears its limit at least as fast as one over the
      // path traversed, the slope times that path. (Of a rectangle's fibres, as one over its
      // square.)
      const double elastic = size_of(moves_elastically(previous_time_, time_));
      const double rises =
          gradual_ ? slope_ * (time_ - previous_time_) / elastic * traversed_ : 0.0;
      limit_ = LimitLoad{previous_time_, time_ + rises};
      return end(Status::LimitLoad);
    }
  }
  if (trial == Trial::Ended) return end(ended());
  if (trial == Trial::Failed) return end(limit_ ? Status::LimitLoad : Status::NotConverged);
  while (!(time_ < options_.stops[stop_])) {
    if (options_.recorded[stop_]) observer_.record(w_);
    if (stop_ + 1 == options_.stops.size()) return end(Status::Completed);
    pass_stop(speed_change(chain_, options_.stops[stop_], kSameTime * options_.stops.back()));
    ++stop_;
  }
  return seek();
}

template <class L, bool kElastic>
void PathContinuation<L, kElastic>::note_plateau(double slope) {
  if (plateau_ && plateau_->to < previous_time_) return;
  if (!plateau_) plateau_ = Plateau{previous_time_, time_, 0.0};
  const double elastic = size_of(moves_elastically(previous_time_, time_));
  plateau_elastic_ += elastic;
  plateau_moved_ += elastic / slope;
  plateau_->to = time_;
  plateau_->times = plateau_moved_ / plateau_elastic_;
}

/// What comes after a corner of a load or motion is no continuation.
template <class L, bool kElastic>
void PathContinuation<L, kElastic>::pass_stop(const SpeedChange& change) {
  if (change.is_corner()) goes_on_ = false;
  const double faster = std::fabs(change.factor.value_or(1.0));
  speed_ *= faster;
  rate_before_ *= faster;
  // What begins to move the beam here.
  if (change.is_corner() && !has_scale_) watches_slope_ = has_scale_ = begin_slopes();
}

template <class L, bool kElastic>
void PathContinuation<L, kElastic>::look_around() {
  restore();
  solve_rates(PathCondition<L>::unit_time());
  if (options_.finds_control) find_control();
  at_ = control_.value(w_.placement);
  if (counters_.steps <= 1) traversed_ = 0.0;  // of another control point
}

template <class L, bool kElastic>
bool PathContinuation<L, kElastic>::begin_slopes() {
  look_around();
  const Value rate = control_.rate(rate_of(control_.segment), w_.placement);
  set_scales(rate);
  const auto& histories = chain_.histories;
  auto& [responses, same_as] = elastic_;
  same_as.clear();
  responses.clear();
  for (std::size_t h = 0; h < histories.size(); ++h) {
    const auto first = std::find(histories.begin(), histories.end(), histories[h]);
    same_as.push_back(static_cast<std::size_t>(first - histories.begin()));
    if (same_as[h] == h && histories[h].time.size() > 1) responses.push_back({h, {}});
  }
  const double speed =
      responses.size() == 1 ? histories[responses[0].history].slope_at(time_) : 0.0;
  const bool is_known = speed < 0.0 || speed > 0.0;  // of a single one that acts now
  const PathCondition<L> unit = PathCondition<L>::unit_time();
  reach_ = 0.0;
  for (auto& one : responses) {
    const History& history = histories[one.history];
    if (is_known) {
      one.by_unit = constant<S>(1.0 / speed) * rate;
    } else {
      const auto slope = [&](std::size_t k) {
        return constant<S>(elastic_.same_as[k] == one.history ? 1.0 : 0.0);
      };
      detail::solve_time(chain_, unit, w_, slope);
      detail::join_columns(chain_, unit, w_, slope);
      one.by_unit = control_.rate(rate_of(control_.segment), w_.placement);
      solved_ = false;  // the last column is another one
    }
    double most = std::fabs(history.at(options_.stops.back()));
    for (const double factor : history.factor) most = std::max(most, std::fabs(factor));
    reach_ += most * static_cast<double>(size_of(one.by_unit));
  }
  return reach_ > least_path() && std::isfinite(reach_);
}

}  // namespace plastica::solve
