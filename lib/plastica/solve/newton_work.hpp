#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "plastica/base/stop_flag.hpp"
#include "plastica/chain/joint_laws.hpp"
#include "plastica/chain/recursion.hpp"
#include "plastica/solve/small_system.hpp"

namespace plastica::solve {

/// A condition that makes the time an unknown: value(state, time) = 0, where
/// d value = covector . d(motion of `segment`) + time_slope d time.
template <class L>
struct PathCondition {
  bool active = false;
  std::size_t segment = 0;
  chain::Wrench<L> covector{};
  typename L::Scalar time_slope{};
  typename L::Scalar value{};

  /// What makes the last column that of a unit of time.
  static PathCondition unit_time() {
    using S = typename L::Scalar;
    return {true, 0, {}, constant<S>(1), constant<S>(-1)};
  }
};

/// Everything that an equilibrium is sought in; sized once, so that iterations do not allocate.
template <class L, bool kElastic>
struct NewtonWork {
  using S = typename L::Scalar;
  chain::Coordinates<L> q;
  double time = 0.0;

  chain::Placement<L> placement;
  chain::Stage<L> stage;  ///< where forces act; statics leave it as it is
  chain::JointForces<L, kElastic> joints;
  chain::OuterForces<L> outer_forces;
  chain::Transmitted<L> transmitted;
  chain::Transmitted<L> impulses;  ///< of `solve/rates.hpp`, likewise
  chain::Recursion<L, kElastic> recursion;
  std::vector<typename L::Spin> angles;  ///< of all joints with a law, ground joints included
  std::vector<mask_t<S>> closed;         ///< whether a constraint acts
  std::vector<mask_t<S>> may_close;      ///< whether a one-sided one may
  bool closed_anew = false;              ///< whether one has just closed or opened
  std::vector<S> gap;                    ///< of each constraint
  /// How far a twin holds its point off the support: where a joint that stretched and sheared has
  /// let go of it [m] (constraints).
  std::vector<S> held_off;
  chain::RightSide<L> right;
  /// Of the imbalance, of each constraint, and of the time (1 + constraints + 1).
  std::vector<chain::Solution<L, kElastic>> columns;
  SmallSystem<S> small;
  SmallSystem<S> pivots;  ///< the same, to look at before it is solved
  /// The largest moment and force so far: what an imbalance is small against.
  S moment_scale{};
  S force_scale{};
  /// In dynamics, of the steps taken, fading: what a failed iteration has met is forgotten.
  S settled_moment{};
  S settled_force{};
  bool forgets = false;
  /// Lanes in which nothing is sought: they stay where they are.
  mask_t<S> settled{};
  /// 1 once the unknowns come from a step of Newton's method: what is left may be rounding then.
  S stepped{};
  /// Below this a force that a step of Newton's method has left is nothing, whatever the others are
  /// [N]; see MotionStep::set_force_floor.
  S force_floor{};

  /// A step was taken: its scales stay, those of steps before fade.
  void settle_scales() {
    const S half = constant<S>(0.5);
    settled_moment = max(half * settled_moment, half * moment_scale);
    settled_force = max(half * settled_force, half * force_scale);
  }

  void resize(const chain::Chain<L>& chain) {
    const std::size_t n = chain.size();
    const std::size_t constraints = chain.constraints.size();
    q.angle.assign(n, {});
    q.shift.assign(kElastic ? n : 0, {});
    q.root = {};
    q.multiplier.assign(constraints, {});
    const mask_t<S> never{constant<S>(1) < constant<S>(0)};
    q.open.assign(n, never);
    q.pose.assign(n, {});
    q.released_constraint.assign(constraints, never);
    for (std::size_t k = 0; k < constraints; ++k) {
      const bool waits = chain.constraints[k].waits_for != chain::kInside;
      if (waits) q.released_constraint[k] = mask_t<S>{constant<S>(0) < constant<S>(1)};
    }
    q.released_ground_joint.assign(chain.ground_joints.size(), never);
    time = 0.0;
    placement.resize(n);
    stage.placement.resize(n);
    stage.shift.assign(kElastic ? n : 0, {});
    stage.to_joint.assign(n, {});
    stage.from_joint.assign(n, {});
    stage.ground_axes.assign(chain.ground_joints.size(), {});
    joints.force.assign(chain.joints(), {});
    joints.tangent.assign(chain.joints(), {});
    outer_forces.reset(n);
    transmitted.outer.assign(n, {});
    impulses.outer.assign(n, {});
    recursion.resize(n);
    angles.assign(chain.joints(), {});
    closed.assign(constraints, mask_t<S>{constant<S>(0) < constant<S>(1)});
    may_close.assign(constraints, mask_t<S>{constant<S>(0) < constant<S>(1)});
    gap.assign(constraints, {});
    held_off.assign(constraints, {});
    right.reset(n);
    columns.resize(constraints + 2);
    for (auto& column : columns) column.resize(n);
    small.resize(0);
    pivots.resize(constraints + 1);
    small.resize(constraints + 1);
    moment_scale = constant<S>(0);
    force_scale = constant<S>(0);
    force_floor = constant<S>(0);
    settled_moment = constant<S>(0);
    settled_force = constant<S>(0);
    settled = never;
    stepped = constant<S>(0);
    forgets = false;
  }
};

inline constexpr int kMaxIterations = 64;
inline constexpr int kMaxPatience = 5;

/// A tolerance that a scalar can meet: as asked for; with float no less than 170 units of its
/// rounding, since what joints transmit are sums over the chain. If after six iterations that is
/// not met, 4200 units: the moment of a joint to the ground is that of its angle, a small
/// difference between the ground's angle and the sum of all the joints'.
template <class S>
constexpr double reachable(double tolerance, int iteration = 0) {
  return kIsDouble<S> ? tolerance : std::max(tolerance, iteration < 6 ? 2e-5 : 5e-4);
}

inline constexpr double kOneSolveTolerance = 1e-5;

/// How far a constraint may be off after a step of one solve, over the beam's length [1].
template <class S>
inline constexpr double kConstraintTolerance = kIsDouble<S> ? 1e-7 : 1e-5;

struct NewtonOptions {
  int max_iterations = 25;   ///< <= kMaxIterations
  double tolerance = 1e-10;  ///< see SolverOptions::tolerance
  /// One linear solve is enough; more are made only while a constraint is off by more than
  /// `kConstraintTolerance` of the length, or a joint is out of balance by more than
  /// `one_solve_tolerance` of the largest moment: it has begun to yield, or turned far.
  bool one_solve = false;
  double one_solve_tolerance = kOneSolveTolerance;
  /// Solves once more after convergence: what is left is rounding then, not the tolerance.
  bool polishes = false;
  /// Gives up when the imbalance has not fallen to a tenth in so many iterations; 0: never.
  int patience = 0;  ///< <= kMaxPatience
  /// Once raised, no further iteration is begun: what is not converged then stays so.
  StopFlag stop = nullptr;
};

/// How an equilibrium was sought. @tparam S a lane has its own answer
template <class S>
struct NewtonOutcome {
  mask_t<S> converged{};
  int iterations = 0;  ///< factorizations
  S solves{};          ///< of a lane, which waits for others once it is done
  /// Relative imbalance at the beginning of each iteration, and at the end (iterations + 1).
  std::array<S, kMaxIterations + 1> imbalance{};
};

}  // namespace plastica::solve
