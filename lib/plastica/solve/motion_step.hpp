#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "plastica/solve/fragment_momentum.hpp"
#include "plastica/solve/joint_motion.hpp"
#include "plastica/solve/newton.hpp"
#include "plastica/solve/rates.hpp"
#include "plastica/solve/speed_jump.hpp"

namespace plastica::solve {

/// One beam in motion, a step at a time: README.md, "Motion".
///
/// A step is tried (`attempt`) and then taken (`accept`) or left; what a joint was, where segments
/// were and how fast, stays as it was until then.
///
/// In lanes there are beams side by side that take the same steps, without contacts and breaks; a
/// lane whose step fails rides no longer.
template <class L, bool kElastic>
class MotionStep {
 public:
  using S = typename L::Scalar;
  using E = sum_t<S>;
  using Work = NewtonWork<L, kElastic>;
  using Joints = chain::SectionJointsBase<L, kElastic>;
  using Motions = std::vector<SegmentMotion<L>>;
  using Placement = chain::Placement<L>;

  MotionStep(const chain::Chain<L>& chain, Joints& joints, chain::SectionAxes<L> axes,
             const MotionOptions& options, Work& work)
      : chain_(chain),
        joints_(joints),
        options_(options),
        rule_(step_rule(options.scheme, options.rho_infinity)),
        claims_(claims_of(options.scheme, options.rho_infinity)),
        newton_(options.newton),
        w_(work),
        joint_motion_(joints, axes, chain.size()) {
    newton_.patience = 5;
    newton_.tolerance = std::max(newton_.tolerance, kMinTolerance);
    newton_.one_solve = claims_.one_solve;
    const std::size_t n = chain.size();
    motion_.resize(n);
    motion_now_.resize(n);
    inertia_.resize(n);
    inertia_now_.resize(n);
    step_.resize(n);
    acceleration_.resize(n);
    if constexpr (kTwists<L>) twist_rate_.resize(n);
    const std::size_t constraints = chain.constraints.size();
    rates_.acts.resize(constraints);
    rates_.rate.resize(constraints);
    carried_.shift.resize(n);
    carried_.spin.resize(n);
    ground_moment_.resize(chain.ground_joints.size());
    no_laws_.force.assign(chain.joints(), {});
    no_laws_.tangent.assign(chain.joints(), {});
    history_factor_.resize(chain.histories.size());
    for (const auto& inertia : chain.inertias) mass_ += inertia.mass;
    laws_alone_ = no_laws_;
    no_motion_.follows = 0.0;
  }

  /// No further iteration is begun once a flag is raised; what is tried then has no solution.
  void stop_by(StopFlag stop) { newton_.stop = stop; }

  /// Begins at time 0 with velocities that joints and supports need not allow yet.
  /// @return false if a support holds what others hold already
  mask_t<S> start(const Motions& motion) {
    motion_ = motion;
    const std::size_t constraints = chain_.constraints.size();
    if constexpr (!kHasLanes<S>) {
      contacts_.rests_on.assign(constraints, false);
      contacts_.bounces.assign(constraints, 0);
      struck_.reserve(constraints);
    }
    multiplier_.assign(constraints, constant<S>(0));
    root_wrench_ = {};
    flows_ = {};
    momentum_.assign(chain_.size(), {});
    rests_ = constant<S>(0);
    fastest_ = 0.0;
    h_ = h_before_ = time_ = 0.0;
    w_.stage.midpoint = false;
    w_.forgets = true;
    w_.time = 0.0;
    chain::place<kElastic>(chain_, w_.q, w_.time, w_.placement);
    joints_.set_time(0.0);
    evaluate_laws();
    joint_motion_.begin(w_.angles, w_.q.shift, w_.joints);
    for (std::size_t g = 0; g < ground_moment_.size(); ++g) ground_moment_[g] = ground_moment(g);
    note_begin();
    if constexpr (!kHasLanes<S>) {
      for (std::size_t k = 0; k < constraints; ++k) {
        contacts_.rests_on[k] = chain_.constraints[k].one_sided && gap_of(k, begin_, 0.0) <= 0.0;
      }
    }
    const mask_t<S> holds = fit_velocities(motion_);
    note_fastest();
    restart();
    return holds;
  }

  /// Tries a step; it ends sooner where a contact closes.
  /// @return whether it has a solution that turns no joint too far
  bool attempt(double h) {
    iterations_ = 0;
    for (int tries = 0; tries < kMaxContactTries; ++tries) {
      w_.may_close = contacts_.rests_on;
      if (!solve(h, true)) return false;
      if (leaves_loaded()) continue;
      const double fraction = free_fraction();
      if (fraction >= 1.0) return true;
      if (fraction > 0.0) {
        h *= fraction;
      } else {
        meet_at_begin();
      }
    }
    return false;
  }

  /// The same in lanes; nothing is sought in those that do not ride any more.
  mask_t<S> attempt(double h, const mask_t<S>& rides) { return solve(h, rides); }

  /// Takes the step that was tried.
  void accept() {
    joints_.commit();
    w_.settle_scales();
    balance_momentum();
    add_flows();
    joint_motion_.commit(w_.angles, w_.q.shift);
    std::swap(inertia_, inertia_now_);
    time_ = w_.time;
    if (options_.step_error > 0.0) note_accelerations();
    h_before_ = h_;
    std::swap(motion_, motion_now_);
    note_fastest();
    begin_.frame = w_.placement.frame;
    begin_.position = w_.placement.position;
    begin_.near = w_.placement.near;
    if constexpr (kElastic) begin_.far = w_.placement.far;
    copy_unknowns(w_.q, q_begin_);
    settle();
  }

  /// Lets a joint go: that of a segment, or, of number N, what holds the end.
  /// Call `opened` after the last one.
  void open(std::size_t joint) {
    const std::size_t n = chain_.size();
    if (joint < n) {
      if (w_.q.open[joint]) return;
      w_.q.open[joint] = true;
      w_.q.pose[joint] = {w_.placement.position[joint], w_.placement.frame[joint]};
      flows_.fracture += joints_.elastic_energy()[joint];
      wake_twins(joint);
      return;
    }
    for (std::size_t g = 0; g < chain_.ground_joints.size(); ++g) {
      const auto& ground = chain_.ground_joints[g];
      if (ground.node != n || w_.q.released_ground_joint[g]) continue;
      w_.q.released_ground_joint[g] = true;
      flows_.fracture += joints_.elastic_energy()[ground.joint];
    }
    for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
      const auto& constraint = chain_.constraints[k];
      if (constraint.node == n && !constraint.one_sided) w_.q.released_constraint[k] = true;
    }
  }

  /// Supports at an open joint hold the segment beyond, too, as they hold the one before.
  void wake_twins(std::size_t joint);

  /// Goes on with what `open` has changed.
  void opened() {
    chain::place<kElastic>(chain_, w_.q, w_.time, w_.placement);
    jumped();
    restart();
  }

  /// Back to the last step that was taken, in `work`, too.
  void restore() {
    w_.q = q_begin_;
    w_.time = time_;
    chain::place<kElastic>(chain_, w_.q, w_.time, w_.placement);
    joints_.set_time(0.0);
    evaluate_laws();
  }

  double time() const { return time_; }
  /// How far the scheme is off in the step that was tried, at most [m]: see motion_predict.hpp.
  double error() const;
  int iterations() const { return iterations_; }  ///< of the last attempt
  const S& solves() const { return solves_; }     ///< the same, of each lane
  /// Whether velocities have jumped at the end of the last step, so that forces are those after it.
  bool has_restarted() const { return has_restarted_; }
  const EnergyFlowsOf<E>& flows() const { return flows_; }
  /// See `Response::momentum_error`.
  E momentum_error() const;
  const Motions& motions() const { return motion_; }
  /// Where the segments were before the last attempt.
  const Placement& begin() const { return begin_; }
  E kinetic() const {
    E energy = constant<E>(0.0);
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      energy += kinetic_energy(chain_.inertias[i], motion_[i]);
    }
    return energy;
  }
  /// Whether a joint still joins: of a segment, or to the ground.
  bool joins(std::size_t joint) const {
    if (joint < chain_.size()) return any(!w_.q.open[joint]);
    for (std::size_t g = 0; g < chain_.ground_joints.size(); ++g) {
      if (chain_.ground_joints[g].joint == joint) return any(!w_.q.released_ground_joint[g]);
    }
    return true;
  }

 private:
  /// Steps for which a start from rest is tried first, once it has found what the other did not.
  static constexpr int kRests = 10;
  static constexpr int kMaxContactTries = 30;
  static constexpr double kRounding = 1e-9;  ///< of times, over a step
  /// A contact that strikes in as many steps in a row comes to rest.
  static constexpr int kMaxBounces = 5;

  /// The beam as it is placed now is where the next step begins.
  void note_begin() {
    begin_ = w_.placement;
    q_begin_ = w_.q;
    in_fragments_ = std::any_of(w_.q.open.begin(), w_.q.open.end(),
                                [](const mask_t<S>& open) { return any(open); });
  }
  /// What a step changes; poses are unknowns of fragments alone.
  void copy_unknowns(const chain::Coordinates<L>& from, chain::Coordinates<L>& to) const {
    to.angle = from.angle;
    to.shift = from.shift;
    to.root = from.root;
    to.multiplier = from.multiplier;
    if (in_fragments_) to.pose = from.pose;
  }
  /// The same in some lanes.
  void select_unknowns(const mask_t<S>& mask, const chain::Coordinates<L>& from,
                       chain::Coordinates<L>& to) const {
    for (std::size_t i = 0; i < from.angle.size(); ++i) {
      to.angle[i] = select(mask, from.angle[i], to.angle[i]);
      if (!in_fragments_) continue;
      to.pose[i] = {select(mask, from.pose[i].position, to.pose[i].position),
                    L::select(mask, from.pose[i].frame, to.pose[i].frame)};
    }
    to.root = select(mask, from.root, to.root);
    for (std::size_t k = 0; k < from.multiplier.size(); ++k) {
      to.multiplier[k] = select(mask, from.multiplier[k], to.multiplier[k]);
    }
  }
  // motion_predict.hpp
  void predict(double h);
  void predict_joint(std::size_t i, const S& h, const typename L::Spin& inner_spin,
                     const typename L::Point& inner_velocity);
  void note_accelerations();
  void set_force_floor();
  // motion_forces.hpp
  void set_length(double h);
  mask_t<S> solve(double h, const mask_t<S>& rides);
  mask_t<S> solve_from(const mask_t<S>& predicted, const mask_t<S>& found);
  void note_fastest();
  void evaluate_laws();
  void set_factors();
  void assemble(bool slopes);
  void set_stage();
  void set_joint_spins(const Motions& motion, double time);
  mask_t<S> rotates_little() const;
  mask_t<S> is_finite() const;
  // motion_flows.hpp
  void add_flows();
  E load_work() const;
  typename L::Spin ground_moment(std::size_t ground_joint) const;
  E ground_work();
  E inertia_work() const;
  // motion_momentum.hpp
  bool is_held(std::size_t first, std::size_t end) const;
  void balance_momentum();
  void balance_fragment(std::size_t first, std::size_t end, const chain::Wrench<L>& residual);
  // motion_impact.hpp
  double gap_of(std::size_t constraint, const Placement& placement, double time) const;
  double free_fraction() const;
  void meet_at_begin();
  bool leaves_loaded();
  /// From the time that is reached, which may be a corner but for rounding, to where histories are
  /// as they go on [s]: behind it, but at the end of the motion, where supports do not stop any
  /// more.
  double reach() const {
    const auto& stops = options_.stops;
    const bool ends = !stops.empty() && w_.time >= stops.back() - kRounding * h_;
    return ends ? -kRounding * h_ : kRounding * h_;
  }
  /// Of a history there.
  S slope_of(std::size_t history) const {
    return chain::factor_as<S>(chain_.histories[history].slope_at(w_.time + reach()));
  }
  double approach_of(std::size_t constraint) const;
  mask_t<S> fit_velocities(Motions& motion);
  void set_support_rates();
  mask_t<S> fit_to_rates(Motions& motion);
  bool note_contacts();
  void settle();
  void jumped();
  /// A contact that the beam has come to, and the speeds at which it came and goes [m/s].
  struct Struck {
    std::size_t constraint = 0;
    double came = 0.0;
    double goes = 0.0;
  };
  void strike(bool corner);
  E lost_by_struck() const;
  void book_impact(const E& lost);
  bool supports_move() const;
  SupportSpeed speed_of_supports() const;
  void restart();
  void note_root_wrench();

  struct Contacts {
    std::vector<bool> rests_on;  ///< one-sided constraints that are closed (constraints)
    std::vector<int> bounces;    ///< in a row (constraints)
  };
  struct NoContacts {};

  const chain::Chain<L>& chain_;
  Joints& joints_;
  const MotionOptions& options_;
  StepRule rule_;
  SchemeClaims claims_;
  NewtonOptions newton_;
  Work& w_;
  JointMotion<L, kElastic> joint_motion_;
  chain::JointForces<L, kElastic> no_laws_;     ///< zeros: what impulses see of the joints
  chain::JointForces<L, kElastic> laws_alone_;  ///< forces without slopes
  ConstraintRates<L> rates_;
  CarriedMotion<L> carried_;
  Motions given_;              ///< velocities that are to fit
  chain::Stage<L> no_motion_;  ///< forces act at the end, and follow nothing
  E mass_{};
  double h_ = 0.0;
  StepFactors factors_;
  std::vector<E> history_factor_;  ///< where forces act (histories)
  double time_ = 0.0;
  int iterations_ = 0;
  S solves_{};
  bool has_restarted_ = false;
  bool in_fragments_ = false;  ///< whether any joint is open
  S rests_{};                  ///< steps that are tried from rest first
  double fastest_ = 0.0;       ///< speed of a segment so far [m/s]
  // At the begin of the step:
  Placement begin_;
  chain::Coordinates<L> q_begin_;
  chain::Coordinates<L> q_found_;  ///< of lanes, while others seek once more
  Motions motion_;
  std::vector<typename L::Point> acceleration_;  ///< accelerations over the step before
  std::vector<S> twist_rate_;                    ///< of `twist_of` the spins, where there are any
  double h_before_ = 0.0;                        ///< its length; 0: none, or a jump since
  std::vector<CenterForce<L>> inertia_;
  std::conditional_t<kHasLanes<S>, NoContacts, Contacts> contacts_;
  std::vector<Struck> struck_;                   ///< at the last impact
  std::vector<S> multiplier_;                    ///< (constraints)
  chain::Wrench<L> root_wrench_;                 ///< what the root passed on; not of midpoints
  std::vector<typename L::Spin> ground_moment_;  ///< of ground joints on their segments
  // At its end:
  Motions motion_now_;
  std::vector<CenterForce<L>> inertia_now_;
  std::vector<SegmentStep<L>> step_;
  std::vector<typename L::Spin> spins_;  ///< of joints, where damping asks for them
  EnergyFlowsOf<E> flows_;
  std::vector<MomentumError<L>> momentum_;  ///< of the fragment that begins with a segment (N)
};

}  // namespace plastica::solve

#include "plastica/solve/motion_flows.hpp"
#include "plastica/solve/motion_forces.hpp"
#include "plastica/solve/motion_impact.hpp"
#include "plastica/solve/motion_momentum.hpp"
#include "plastica/solve/motion_predict.hpp"
