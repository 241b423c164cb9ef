#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "plastica/model/scene.hpp"
#include "plastica/run/response.hpp"
#include "plastica/solve/control_point.hpp"

namespace plastica::solve {

/// How a path is to be followed.
struct PathOptions {
  NewtonOptions newton{};
  std::vector<double> stops{};   ///< times at which a step must end, rising; the last is the end
  std::vector<bool> recorded{};  ///< which of them are recorded
  PathControl control = PathControl::Auto;
  int steps = 20;               ///< recorded steps of displacement and arc-length control
  double largest_turn = 0.2;    ///< of a joint in a step [rad]
  double smallest_step = 1e-6;  ///< of the first step [1]
  /// Whether the control point is a guess that may give way to one that moves.
  bool finds_control = false;
  /// Displacement control: where the control point is taken, from where it starts.
  std::array<double, 3> control_motion{};
};

/// What an observer says of a converged step.
enum class Verdict {
  Accept,
  TooFar,  ///< try it again shorter, if that can be done
  End,     ///< the path ends here (a break)
};

/// Looks at the steps of a path.
template <class L, bool kElastic>
class PathObserver {
 public:
  virtual ~PathObserver() = default;
  /// Whether the last converged step does plastic work.
  virtual bool yields() const = 0;
  /// @param shortest  whether the step cannot be cut back any more
  virtual Verdict judge(const NewtonWork<L, kElastic>& w, bool shortest) = 0;
  /// After a step was accepted and its state committed.
  virtual void accept(const NewtonWork<L, kElastic>& w) = 0;
  /// @return whether there is room for more
  virtual bool record(const NewtonWork<L, kElastic>& w) = 0;
};

/// Below this share of the first slope of time over the control point's way, and downwards, a path
/// carries no more load.
inline constexpr double kLimitSlope = 1e-3;

/// A path whose slope falls to less than this part of the step before bends.
inline constexpr double kBend = 0.1;

/// A limit load is bracketed within this share of it.
inline constexpr double kLimitWidth = 1e-4;

/// Follows an equilibrium path: README.md.
template <class L, bool kElastic>
class PathWalker {
 public:
  using Laws = chain::JointLaws<L, kElastic>;
  using Work = NewtonWork<L, kElastic>;
  using Observer = PathObserver<L, kElastic>;
  using Value = typename ControlPoint<L>::Value;

  PathWalker(const chain::Chain<L>& chain, Laws& laws, const PathOptions& options,
             const ControlPoint<L>& control, Work& work, chain::Coordinates<L>& committed,
             chain::Coordinates<L>& previous, Observer& observer)
      : chain_(chain),
        laws_(laws),
        options_(options),
        control_(control),
        w_(work),
        committed_(committed),
        previous_(previous),
        observer_(observer) {}

  Status walk() {
    const auto outcome = equilibrate(chain_, laws_, options_.newton, w_);
    counters_.iterations += outcome.iterations;
    if (!(w_.recursion.least_pivot() > kMechanism)) return Status::Mechanism;
    if (holds_twice()) return Status::HeldTwice;
    if (!outcome.converged) return finite(outcome) ? Status::NotConverged : Status::NonFinite;
    if (observer_.judge(w_, true) == Verdict::End) return end_broken();
    accept();
    observer_.record(w_);
    step_ = options_.stops.front();
    switch (options_.control) {
      case PathControl::Displacement: return walk_displacement();
      case PathControl::ArcLength: return walk_arc();
      case PathControl::Auto:
      case PathControl::Load: return walk_load();
    }
    return Status::NotRun;
  }

  const PathCounters& counters() const { return counters_; }
  const std::optional<LimitLoad>& limit() const { return limit_; }

 private:
  enum class Trial { Accepted, Failed, Ended };

  /// Relative stiffness below which the supports leave the beam free to move.
  static constexpr double kMechanism = 1e-11;
  /// Share of the way that a closure's own stiffness would leave, below which it holds nothing.
  static constexpr double kHeldTwice = 1e-8;
  static constexpr double kTiny = std::numeric_limits<double>::min();
  static constexpr int kMostArcs = 400;
  /// How much longer than the first an arc may become: a way that bends sharply is long.
  static constexpr double kArcGrowth = 32.0;

  static bool finite(const NewtonOutcome<double>& outcome) {
    return std::isfinite(outcome.imbalance[static_cast<std::size_t>(outcome.iterations)]);
  }

  void restore() {
    w_.q = committed_;
    w_.time = time_;
  }

  void accept() {
    laws_.commit();
    std::swap(previous_, committed_);
    committed_ = w_.q;
    previous_time_ = time_;
    time_ = w_.time;
    at_ = control_.value(w_.placement);
    ++counters_.steps;
    observer_.accept(w_);
  }

  Status end_broken() {
    accept();
    observer_.record(w_);
    return Status::Broken;
  }

  /// Whether a closure holds what the rigid segments and the other supports hold already: a unit
  /// force along it moves nothing.
  bool holds_twice() {
    for (std::size_t k = 0; k < chain_.closures.size(); ++k) {
      if (!w_.closed[k]) continue;
      const auto& closure = chain_.closures[k];
      detail::solve_closure(chain_, k, w_);
      const double way = detail::power(chain::unit_wrench(closure, w_.placement),
                                       w_.columns[1 + k].motion[closure.segment]);
      if (!(way * detail::stiffness_of<double>(chain_, closure) > kHeldTwice)) return true;
    }
    return false;
  }

  double largest_turn() const {
    double largest = 0.0;
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      for (std::size_t k = 0; k < L::kRotations; ++k) {
        largest = std::max(largest, std::fabs(w_.q.angle[i][k] - committed_.angle[i][k]));
      }
    }
    return largest;
  }

  /// Seeks an equilibrium from the unknowns in `w_` and takes it, if it is near enough.
  template <class Condition>
  Trial attempt(const Condition& condition, bool shortest) {
    const auto outcome = equilibrate(chain_, laws_, options_.newton, w_, condition);
    counters_.iterations += outcome.iterations;
    iterations_ = outcome.iterations;
    if (!outcome.converged) return Trial::Failed;
    if (largest_turn() > options_.largest_turn) return Trial::Failed;
    const double slope = watches_slope_ && observer_.yields() ? relative_slope() : 1.0;
    flat_ = slope < kLimitSlope;
    // A bend of the path is looked at closely: from far off a limit that the beam escapes by
    // swinging out of the way of its load is a slope like any other.
    const bool bends = flat_ || slope < kBend * slope_;
    if (bends && !shortest && w_.time - time_ > kLimitWidth * w_.time) return Trial::Failed;
    switch (observer_.judge(w_, shortest)) {
      case Verdict::TooFar: return Trial::Failed;
      case Verdict::End: end_broken(); return Trial::Ended;
      case Verdict::Accept: break;
    }
    accept();
    slope_ = slope;
    return Trial::Accepted;
  }

  Trial attempt_time(double time, bool shortest) {
    restore();
    if (goes_on_) {
      extrapolate((time - time_) / (time_ - previous_time_));
    } else {
      predict(time);
    }
    w_.time = time;
    return attempt([](const Work&) { return PathCondition<L>{}; }, shortest);
  }

  /// One step of Newton's method that takes the time along: loads and prescribed motions meet the
  /// whole beam at once. A motion that the nearest joint had to take alone might make it yield.
  void predict(double time) {
    PathCondition<L> at_time;
    at_time.active = true;
    at_time.time_slope = 1.0;
    at_time.value = w_.time - time;
    solve_rates(at_time);
    detail::combine_columns(chain_, at_time, w_);
    detail::take_step(chain_, at_time, false, w_);
  }

  /// All columns at the current unknowns, and how much of each meets a condition on the time.
  void solve_rates(const PathCondition<L>& at_time) {
    detail::assemble(chain_, laws_, w_);
    w_.recursion.factor(chain_, w_.q, w_.placement, w_.joints, w_.outer_forces, w_.transmitted);
    detail::solve_imbalance(chain_, at_time, w_);
    for (std::size_t k = 0; k < chain_.closures.size(); ++k) detail::solve_closure(chain_, k, w_);
    detail::solve_time(chain_, at_time, w_);
    detail::join_columns(chain_, at_time, w_);
  }

  /// Load over the control point's way in this step, relative to the first slope.
  double relative_slope() const {
    const Value moved = control_.value(w_.placement) - at_;
    return (w_.time - time_) / std::max(span_ / way_ * size_of(moved), kTiny);
  }

  double smallest() const { return options_.smallest_step * options_.stops.front(); }

  /// Steps of given time up to a stop. @return Failed where even the smallest finds nothing
  Trial advance_to(double stop) {
    while (time_ < stop) {
      // No sliver is left before the stop.
      const double left = stop - time_;
      const double length = left <= 1.001 * step_ ? left : std::min(step_, 0.5 * left);
      const double next = length == left ? stop : time_ + length;
      const bool shortest = length <= smallest();
      const Trial trial = attempt_time(next, shortest);
      if (trial == Trial::Ended) return trial;
      if (trial == Trial::Accepted) {
        goes_on_ = true;
        if (iterations_ <= 6) step_ = 2.0 * std::max(length, step_);
        if (!flat_) continue;
        limit_ = LimitLoad{previous_time_, time_};
        return Trial::Failed;
      }
      above_ = next;
      ++counters_.cutbacks;
      if (shortest) return Trial::Failed;
      step_ = std::max(0.5 * length, smallest());
    }
    return Trial::Accepted;
  }

  Status walk_load() {
    watches_slope_ = begin_arcs();
    for (std::size_t k = 0; k < options_.stops.size(); ++k) {
      Trial trial = advance_to(options_.stops[k]);
      if (trial == Trial::Failed && !limit_) trial = cross_by_arc(options_.stops[k]);
      if (trial == Trial::Ended) return Status::Broken;
      if (trial == Trial::Failed) return limit_ ? Status::LimitLoad : Status::NotConverged;
      if (options_.recorded[k]) observer_.record(w_);
      if (is_corner(options_.stops[k])) goes_on_ = false;
    }
    return Status::Completed;
  }

  /// Whether a load or motion changes its rate at a time: what comes then is no continuation.
  bool is_corner(double time) const {
    for (const History& history : chain_.histories) {
      if (history.is_ramp()) continue;
      for (const double corner : history.time) {
        if (std::fabs(corner - time) < 1e-9 * options_.stops.back()) return true;
      }
    }
    return false;
  }

  // --- arc length ---------------------------------------------------------------------------

  /// The plane n . (u - u0) + weight (t - t0) = length in which the next equilibrium is sought;
  /// (n, weight) is a unit vector in (u/way, t/span), times `way`.
  struct Arc {
    Value from{};
    Value direction{};
    double from_time = 0.0;
    double time_weight = 0.0;  ///< [m/s]
    double length = 0.0;       ///< [m]
  };

  /// How u and t go on elastically from the committed state: sets the scales of an arc.
  bool begin_arcs() {
    restore();
    PathCondition<L> unit_time;
    unit_time.active = true;
    unit_time.time_slope = 1.0;
    unit_time.value = -1.0;
    solve_rates(unit_time);
    if (options_.finds_control) find_control();
    at_ = control_.value(w_.placement);
    return set_scales(control_.rate(rate_of(control_.segment), w_.placement));
  }

  /// Motion of a segment in a unit of time, with the closures kept; after `solve_rates`.
  chain::Motion<L> rate_of(std::size_t segment) const {
    chain::Motion<L> rate = w_.columns.back().motion[segment];
    for (std::size_t j = 0; j < chain_.closures.size(); ++j) {
      const double weight = w_.closed[j] ? w_.small.b(j) : 0.0;
      rate.shift += weight * w_.columns[1 + j].motion[segment].shift;
      rate.spin += weight * w_.columns[1 + j].motion[segment].spin;
    }
    return rate;
  }

  /// Takes the segment end that moves most, since one that is held tells nothing of the path.
  void find_control() {
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

  bool set_scales(const Value& rate) {
    span_ = options_.stops.back();
    way_ = size_of(rate) * span_;
    if (!(way_ > 0.0) || !std::isfinite(way_)) return false;
    rate_ = rate;
    return true;
  }

  Arc next_arc(double length) const {
    Arc arc;
    arc.from = control_.value(w_.placement);
    arc.from_time = time_;
    arc.length = length * way_;
    Value du = (span_ / way_) * rate_;
    double dt = 1.0;
    if (has_secant_) {
      du = (1.0 / way_) * secant_;
      dt = secant_time_ / span_;
    }
    const double norm = std::sqrt(dot(du, du) + dt * dt);
    arc.direction = (1.0 / norm) * du;
    arc.time_weight = dt / norm * way_ / span_;
    return arc;
  }

  PathCondition<L> condition_of(const Arc& arc, const Work& w) const {
    PathCondition<L> condition;
    condition.active = true;
    condition.segment = control_.segment;
    condition.covector = control_.covector(arc.direction, w.placement);
    condition.time_slope = arc.time_weight;
    condition.value = dot(arc.direction, control_.value(w.placement) - arc.from) +
                      arc.time_weight * (w.time - arc.from_time) - arc.length;
    return condition;
  }

  /// One arc, shorter if need be; `arc_length_` follows the convergence.
  Trial advance_arc() {
    for (;;) {
      restore();
      chain::place<kElastic>(chain_, w_.q, w_.time, w_.placement);
      const Arc arc = next_arc(arc_length_);
      const Value from = arc.from;
      const double from_time = time_;
      if (has_secant_) extrapolate(arc_length_ / secant_length_);
      const bool shortest = arc_length_ <= smallest_arc_;
      const Trial trial = attempt([&](const Work& w) { return condition_of(arc, w); }, shortest);
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

  /// Starts where the last step points to, `part` of it further.
  void extrapolate(double part) {
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      w_.q.angle[i] += part * (committed_.angle[i] - previous_.angle[i]);
      if constexpr (kElastic) {
        w_.q.shift[i] += part * (committed_.shift[i] - previous_.shift[i]);
      }
    }
    w_.q.root += part * (committed_.root - previous_.root);
    for (std::size_t k = 0; k < chain_.closures.size(); ++k) {
      w_.q.multiplier[k] += part * (committed_.multiplier[k] - previous_.multiplier[k]);
    }
    w_.time += part * (time_ - previous_time_);
  }

  void set_arc_length(double length, double growth) {
    arc_length_ = length;
    largest_arc_ = growth * length;
    smallest_arc_ = options_.smallest_step * length;
    has_secant_ = false;
  }

  Status walk_arc() {
    if (!begin_arcs()) return Status::NotConverged;
    const double end = options_.stops.back();
    set_arc_length(std::sqrt(2.0) / options_.steps, kArcGrowth);
    for (int k = 0; k < kMostArcs; ++k) {
      const Trial trial = advance_arc();
      if (trial == Trial::Ended) return Status::Broken;
      if (trial == Trial::Failed) return Status::NotConverged;
      if (time_ >= end) {
        // The end itself, from the last point before it.
        if (attempt_time(end, true) != Trial::Accepted) return Status::NotConverged;
        observer_.record(w_);
        return Status::Completed;
      }
      if (!observer_.record(w_)) return Status::Completed;
    }
    return Status::Completed;
  }

  /// Load control has found nothing before `stop`: follows the path by arcs, until it gets there
  /// (then it went around a turn), or carries no more (a limit load), or is lost.
  Trial cross_by_arc(double stop) {
    if (!watches_slope_) return Trial::Failed;
    watches_slope_ = false;
    set_arc_length(1e-2, 1.0);
    double highest = time_;
    const double first_slope = span_ / way_;
    for (int k = 0; k < kMostArcs; ++k) {
      const Trial trial = advance_arc();
      if (trial == Trial::Ended) return trial;
      if (trial == Trial::Failed) return Trial::Failed;
      if (time_ >= stop) {
        if (options_.control == PathControl::Load) return Trial::Failed;
        step_ = smallest();
        watches_slope_ = true;
        return attempt_time(stop, true) == Trial::Accepted ? Trial::Accepted : Trial::Failed;
      }
      highest = std::max(highest, time_);
      const double least = observer_.yields() ? kLimitSlope * first_slope : 0.0;
      if (secant_time_ <= least * size_of(secant_)) {
        bracket_limit(highest);
        return Trial::Failed;
      }
    }
    return Trial::Failed;
  }

  /// The limit from above: the least time at which load control finds nothing, starting from the
  /// last equilibrium.
  void bracket_limit(double highest) {
    LimitLoad limit;
    limit.below = highest;
    limit.above = std::max(above_, highest);
    for (double part = 1e-4; part < 1.0; part *= 4.0) {
      const double time = highest + part * highest;
      restore();
      w_.time = time;
      const auto outcome = equilibrate(chain_, laws_, options_.newton, w_);
      counters_.iterations += outcome.iterations;
      if (outcome.converged && largest_turn() <= options_.largest_turn) continue;
      limit.above = time;
      break;
    }
    restore();
    detail::assemble(chain_, laws_, w_);
    limit_ = limit;
  }

  // --- displacement -------------------------------------------------------------------------

  Status walk_displacement() {
    chain::place<kElastic>(chain_, w_.q, w_.time, w_.placement);
    const Value start = control_.value(w_.placement);
    Value way;
    for (std::size_t k = 0; k < way.at.size(); ++k) way[k] = options_.control_motion[k];
    const double length = size_of(way);
    if (!(length > 0.0)) return Status::NotConverged;
    const Value direction = (1.0 / length) * way;
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
        if (goes_on_) extrapolate((next - reached) / last);
        const Trial trial = attempt(
            [&](const Work& w) {
              PathCondition<L> condition;
              condition.active = true;
              condition.segment = control_.segment;
              condition.covector = control_.covector(direction, w.placement);
              condition.value = dot(direction, control_.value(w.placement) - start) - next;
              return condition;
            },
            shortest);
        if (trial == Trial::Ended) return Status::Broken;
        if (trial == Trial::Accepted) {
          goes_on_ = true;
          last = next - reached;
          reached = next;
          if (iterations_ <= 6) step = std::min(even, 2.0 * step);
          continue;
        }
        ++counters_.cutbacks;
        if (shortest) return Status::NotConverged;
        step = 0.5 * (next - reached);
      }
      if (!observer_.record(w_)) break;
    }
    return Status::Completed;
  }

  const chain::Chain<L>& chain_;
  Laws& laws_;
  const PathOptions& options_;
  ControlPoint<L> control_;
  Work& w_;
  chain::Coordinates<L>& committed_;
  chain::Coordinates<L>& previous_;
  Observer& observer_;

  PathCounters counters_{};
  std::optional<LimitLoad> limit_{};
  double time_ = 0.0;
  double previous_time_ = 0.0;
  double step_ = 0.0;
  double above_ = 0.0;  ///< the last time at which load control found nothing
  int iterations_ = 0;

  double span_ = 1.0;  ///< scale of time
  double way_ = 1.0;   ///< of the control point, the way that it would go elastically in `span_`
  Value rate_{};       ///< of the control point, elastically
  double arc_length_ = 0.0, largest_arc_ = 0.0, smallest_arc_ = 0.0;
  Value secant_{};
  double secant_time_ = 0.0, secant_length_ = 1.0;
  bool has_secant_ = false;
  Value at_{};                  ///< the control point at the last step
  bool watches_slope_ = false;  ///< load control: see `attempt`
  bool flat_ = false;
  double slope_ = 1.0;    ///< of the last step, see `relative_slope`
  bool goes_on_ = false;  ///< whether the last step may be continued
};

}  // namespace plastica::solve
