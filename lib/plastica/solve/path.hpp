#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "plastica/base/status.hpp"
#include "plastica/solve/control_point.hpp"
#include "plastica/solve/newton.hpp"
#include "plastica/solve/path_options.hpp"
#include "plastica/solve/stability_count.hpp"

namespace plastica::solve {

/// Follows an equilibrium path: README.md.
template <class L, bool kElastic>
class PathContinuation {
 public:
  using Laws = chain::JointLaws<L, kElastic>;
  using Work = NewtonWork<L, kElastic>;
  using Observer = PathObserver<L, kElastic>;
  using S = typename L::Scalar;
  using Value = typename ControlPoint<L>::Value;

  PathContinuation(const chain::Chain<L>& chain, Laws& laws, const PathOptions& options,
                   const ControlPoint<L>& control, Work& work, chain::Coordinates<L>& committed,
                   chain::Coordinates<L>& previous, ElasticResponses<L>& elastic,
                   Observer& observer)
      : chain_(chain),
        laws_(laws),
        options_(options),
        control_(control),
        w_(work),
        committed_(committed),
        previous_(previous),
        elastic_(elastic),
        observer_(observer),
        conservative_(is_conservative(chain)),
        has_pillars_(std::any_of(chain.constraints.begin(), chain.constraints.end(),
                                 [](const auto& loop) { return loop.one_sided; })) {}

  // A path is followed from one trial to the next, so that beams may seek equilibria side by side.

  /// Goes up to the first one, or to the path's end.
  /// @return whether one is sought: at `work.time`, from the unknowns in `work`
  bool begin() {
    status_ = find_first();
    return status_ == Status::Completed && begin_control();
  }

  /// Takes what was found, which is in `work`, and goes on to the next.
  /// @param factored  whether `work` holds the tangent, too
  /// @param unstable_modes  of the same name, if that was asked for; else below 0
  bool take(bool converged, int iterations, bool factored, double unstable_modes = -1.0) {
    holds_tangent_ = factored;
    found_modes_ = unstable_modes;
    const Trial trial = judge(converged, iterations, shortest_);
    factored_ = factored_ && factored;
    return go_on(trial);
  }

  /// Whether what is sought, once taken, is recorded.
  bool records_next() const { return next_ == options_.stops[stop_] && options_.recorded[stop_]; }

  /// Seeks this one and all that follow.
  void proceed() {
    bool seeks = true;
    while (seeks) {
      const auto outcome = equilibrate(chain_, laws_, options_.newton, w_);
      seeks = take(outcome.converged, outcome.iterations, true);
    }
  }

  /// How the path has ended.
  Status status() const;
  /// Whether what acts at time 0 was put on in parts, which its observer has not seen.
  bool loaded_gradually() const { return loaded_gradually_; }

  /// Number of unstable modes of the last equilibrium; -1: not known.
  int known_unstable_modes() const { return modes_; }
  const PathCounters& counters() const { return counters_; }
  const std::optional<LimitLoad>& limit() const { return limit_; }
  /// With times in the place of factors; of load control.
  const std::optional<Plateau>& plateau() const { return plateau_; }
  /// With times in the place of factors.
  const CriticalPoints& critical() const { return critical_; }

 private:
  enum class Trial { Accepted, Failed, Ended };  // the last: the path ends here, see `ended`

  /// Relative stiffness below which the supports leave the beam free to move.
  static constexpr double kMechanism = kIsDouble<S> ? 1e-11 : 1e-6;
  /// Fraction of a motion that a constraint's own stiffness leaves, below which it holds nothing.
  static constexpr double kHeldTwice = kIsDouble<S> ? 1e-12 : 1e-6;
  /// The least displacement of the control point that is no rounding, over the beam's length.
  static constexpr double kMinPath = kIsDouble<S> ? 1e-13 : 1e-6;
  static constexpr double kTiny = std::numeric_limits<double>::min();
  static constexpr double kForever = std::numeric_limits<double>::infinity();
  static constexpr int kMaxArcs = 400;  ///< that cross what load control does not
  /// How much longer than the first an arc may become: a path that bends sharply is long.
  static constexpr double kArcGrowth = 32.0;

  static bool finite(const NewtonOutcome<S>& outcome) {
    return std::isfinite(outcome.imbalance[static_cast<std::size_t>(outcome.iterations)]);
  }

  /// Whether it lost its stability before it came to its limit load: at that itself, the count may
  /// change within rounding.
  bool bifurcated_before_limit() const;

  void restore() {
    w_.q = committed_;
    w_.time = time_;
  }

  void accept() {
    if (trial_modes_ >= 0 && modes_ >= 0 && trial_modes_ != modes_) note_critical();
    modes_ = trial_modes_;
    // Arcs go over unstable equilibria on purpose: what counts is where they end.
    unstable_ = modes_ > 0 || (unstable_ && options_.control != PathControl::ArcLength);
    laws_.commit();
    std::swap(previous_, committed_);
    committed_ = w_.q;
    previous_time_ = time_;
    time_ = w_.time;
    const Value at = control_.value(w_.placement);
    traversed_ += size_of(at - at_);
    at_ = at;
    // Where nothing has flowed the laws are as they were in the last iteration.
    factored_ = !observer_.yields();
    speed_ = 1.0;
    rate_before_ = time_ > previous_time_ ? rotated_ / (time_ - previous_time_) : 0.0;
    ++counters_.steps;
    interrupted_ = !observer_.accept(w_);
  }

  /// How a path ends that finds nothing more: where a section would have to carry more axial force
  /// than it can, at a limit load.
  Status end_lost() {
    if (!overloaded_) return Status::NotConverged;
    limit_ = LimitLoad{time_, w_.time};
    return Status::LimitLoad;
  }

  Status end_broken() {
    accept();
    observer_.record(w_);
    return Status::Broken;
  }

  /// How a path ends whose last trial has ended it.
  Status ended() const { return interrupted_ ? Status::Interrupted : Status::Broken; }

  /// Whether a constraint holds what the rigid segments and the others hold already: once those
  /// before it hold, a unit force along it moves nothing.
  bool holds_twice();

  /// Of the step just taken; the first stretch of such counts.
  void note_plateau(double slope);
  /// How the last step has turned the segments: path_continuity.hpp.
  template <class IncrementOf, class Visit>
  void for_each_rotation(const IncrementOf& increment, const Visit& visit) const;
  template <class IncrementOf>
  double size_of_rotations(const IncrementOf& increment) const;
  bool rotates_too_far() const;
  double rotation_rate();
  bool points_on();

  /// Whether the equilibria are stable: path_stability.hpp.
  void factor_tangent();
  int count_unstable_modes();
  bool may_change_stability(bool shortest);
  void note_critical();

  /// Seeks an equilibrium from the unknowns in `w_` and takes it, if it is near enough.
  template <class Condition>
  Trial attempt(const Condition& condition, bool shortest) {
    const auto outcome = equilibrate(chain_, laws_, options_.newton, w_, condition);
    holds_tangent_ = true;
    found_modes_ = -1.0;
    condition_ = condition(w_);
    return judge(outcome.converged, outcome.iterations, shortest);
  }

  /// Whether the path ends here because it was stopped from outside.
  bool stopped() {
    interrupted_ = interrupted_ || is_raised(options_.newton.stop);
    return interrupted_;
  }

  /// Takes an equilibrium that has been sought, if it is near enough.
  Trial judge(bool converged, int iterations, bool shortest) {
    factored_ = solved_ = false;
    counters_.iterations += iterations;
    iterations_ = iterations;
    if (stopped()) return Trial::Ended;
    overloaded_ = converged && laws_.overloaded();
    if (!converged || overloaded_) return Trial::Failed;
    if ((beyond_ = !at_time_ && w_.time > latest_)) return Trial::Failed;
    if (rotates_too_far() || !points_on() || !may_change_stability(shortest)) return Trial::Failed;
    const double slope = watches_slope_ && observer_.yields() ? relative_slope() : 1.0;
    flat_ = slope < kLimitSlope;
    // A bend of the path is looked at closely: from far off a limit that the beam escapes by
    // swinging out of the way of its load is a slope like any other.
    const bool bends = flat_ || slope < kBend * slope_;
    if (bends && !shortest && w_.time - time_ > kLimitWidth * w_.time) return Trial::Failed;
    switch (observer_.judge(w_, shortest)) {
      case Verdict::TooFar: return Trial::Failed;
      case Verdict::End:
        end_broken();
        interrupted_ = false;
        return Trial::Ended;
      case Verdict::Accept: break;
    }
    accept();
    if (slope < kPlateauSlope) note_plateau(slope);
    gradual_ = slope_ < kGradual;
    slope_ = slope;
    return interrupted_ ? Trial::Ended : Trial::Accepted;
  }

  /// Where to seek the equilibrium at a time from.
  void aim(double time) {
    restore();
    at_time_ = true;
    condition_ = {};
    if (goes_on_) {
      extrapolate(speed_ * (time - time_) / (time_ - previous_time_));
    } else {
      predict(time);
    }
    w_.time = time;
  }

  Trial attempt_time(double time, bool shortest) {
    aim(time);
    return attempt([](const Work&) { return PathCondition<L>{}; }, shortest);
  }

  /// Load control's first guess, and its rates: path_load.hpp.
  void predict(double time);
  void solve_rates(const PathCondition<L>& at_time);

  /// What this step would have moved the control point by elastically, over what it did; 1 where it
  /// is too little to tell.
  double relative_slope() const {
    const Value moved = control_.value(w_.placement) - at_;
    const double elastic = size_of(moves_elastically(time_, w_.time));
    if (!(elastic > kLeastPath * reach_)) return 1.0;
    return elastic / std::max<double>(size_of(moved), kTiny);
  }
  /// Displacement of the control point between two times as `begin_slopes` has seen it answer.
  Value moves_elastically(double begin, double end) const {
    Value sum{};
    for (const auto& one : elastic_.responses) {
      const History& history = chain_.histories[one.history];
      sum += constant<S>(history.at(end) - history.at(begin)) * one.by_unit;
    }
    return sum;
  }

  /// Of a joint, from the undeformed beam.
  double largest_rotation() const {
    double farthest = 0.0;
    for (const typename L::Spin& angle : w_.q.angle) {
      farthest = std::max(farthest, static_cast<double>(size_of(angle)));
    }
    return farthest;
  }

  /// The least displacement of the control point that is no rounding [m].
  double least_path() const {
    return kMinPath * (L::kTranslations > 0 ? static_cast<double>(chain_.length) : 1.0);
  }
  double smallest() const { return options_.smallest_step * options_.stops.front(); }

  /// The equilibrium without loads.
  Status find_first();
  NewtonOutcome<S> load_gradually();
  bool begin_control();
  bool end(Status status) {
    status_ = status;
    return false;
  }
  /// Aims at a time up to the next stop.
  bool seek();
  /// Load control after a trial at the time that was sought.
  bool go_on(Trial trial);
  void pass_stop(const SpeedChange& change);

  /// The plane n . (u - u0) + weight (t - t0) = length in which the next equilibrium is sought;
  /// (n, weight) is a unit vector in (u/path, t/span), times `path`.
  struct Arc {
    Value from{};
    Value direction{};
    double from_time = 0.0;
    double time_weight = 0.0;  ///< [m/s]
    double length = 0.0;       ///< [m]
  };

  /// How u and t go on elastically from the committed state: sets the scales of an arc.
  bool begin_arcs();
  /// Solves for the rates at the committed state, and takes the control point.
  void look_around();
  /// How the control point answers: for `relative_slope`. @return whether anything moves it
  bool begin_slopes();
  /// Motion of a segment in a unit of time, with the constraints kept; after `solve_rates`.
  chain::Motion<L> rate_of(std::size_t segment) const;
  /// Takes the segment end that moves most, since one that is held tells nothing of the path.
  void find_control();
  bool set_scales(const Value& rate);
  Arc next_arc(double length) const;
  PathCondition<L> condition_of(const Arc& arc, const Work& w) const;
  /// One arc, shorter if need be; `arc_length_` follows the convergence.
  Trial advance_arc();
  /// Starts where the last step points to, `part` of it further.
  void extrapolate(double part);
  void set_arc_length(double length, double growth);
  Status follow_arcs();
  /// Load control has found nothing before `stop`: follows the path by arcs, until it gets there
  /// (then it went around a turn), or carries no more (a limit load), or is lost.
  Trial cross_by_arc(double stop);
  /// The limit from above: the least time at which load control finds nothing, starting from the
  /// last equilibrium.
  void bracket_limit(double highest);
  bool turns_back();
  Status follow_displacement();

  const chain::Chain<L>& chain_;
  Laws& laws_;
  const PathOptions& options_;
  ControlPoint<L> control_;
  Work& w_;
  chain::Coordinates<L>& committed_;
  chain::Coordinates<L>& previous_;
  ElasticResponses<L>& elastic_;
  Observer& observer_;

  PathCounters counters_{};
  std::optional<LimitLoad> limit_{};
  double time_ = 0.0;
  double previous_time_ = 0.0, step_ = 0.0;
  double above_ = 0.0;     ///< the last time at which load control found nothing
  std::size_t stop_ = 0;   ///< load control: the next one
  double next_ = 0.0;      ///< the time that is sought, so far from the last step
  double length_ = 0.0;    ///< [s]
  bool shortest_ = false;  ///< which cannot be cut back
  Status status_ = Status::NotRun;
  int iterations_ = 0;
  bool loaded_gradually_ = false;
  bool interrupted_ = false;  ///< the observer does not want to go on, or the path was stopped
  bool overloaded_ = false;   ///< the last trial was an equilibrium that no section carries
  bool factored_ = false;     ///< `w_` holds the tangent at the committed unknowns
  bool solved_ = false;       ///< and all columns

  double span_ = 1.0;          ///< scale of time
  double elastic_path_ = 0.0;  ///< displacement of the control point in `span_`, if elastic
  double reach_ = 0.0;         ///< what all factors at their largest would move it by
  Value rate_{};               ///< of the control point, elastically
  double arc_length_ = 0.0, largest_arc_ = 0.0, smallest_arc_ = 0.0;
  double latest_ = kForever;  ///< time at which arcs end
  bool beyond_ = false;       ///< whether the last trial of an arc was after it
  Value secant_{};
  double secant_time_ = 0.0, secant_length_ = 1.0;
  bool has_secant_ = false;
  bool conservative_ = true, has_pillars_ = false;
  CriticalPoints critical_{};
  PathCondition<L> condition_{};  ///< of the trial
  double found_modes_ = -1.0;     ///< see `take`
  int modes_ = -1;                ///< unstable modes after the last step; -1: not counted
  int trial_modes_ = -1;
  bool unstable_ = false;
  bool at_time_ = false;        ///< whether the trial was sought at a given time
  bool holds_tangent_ = false;  ///< whether `w_` holds the tangent of the trial
  double rotated_ = 0.0;        ///< by the trial, of all segments: see `size_of_rotations`
  double rate_before_ = 0.0;    ///< likewise, in a unit of time before it, or where it begins
  double speed_ = 1.0;          ///< of what moves, over that in the last step
  Value at_{};                  ///< the control point at the last step
  bool has_scale_ = false;      ///< whether anything moves the control point
  bool watches_slope_ = false;  ///< load control: see `attempt`
  bool flat_ = false;
  std::optional<Plateau> plateau_{};
  double plateau_elastic_ = 0.0;  ///< what the control point would have moved along it [m]
  double plateau_moved_ = 0.0;    ///< and has [m]
  bool gradual_ = false;          ///< whether the step before was nearly flat, too
  double traversed_ = 0.0;        ///< length of the control point's path so far
  double slope_ = 1.0;            ///< of the last step, see `relative_slope`
  bool goes_on_ = false;          ///< whether the last step may be continued
};

}  // namespace plastica::solve

#include "plastica/solve/path_arc.hpp"
#include "plastica/solve/path_continuity.hpp"
#include "plastica/solve/path_load.hpp"
#include "plastica/solve/path_stability.hpp"
