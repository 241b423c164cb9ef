#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "plastica/solve/newton_step.hpp"
#include "plastica/solve/segment_motion.hpp"

namespace plastica::solve {

/// At a corner of a history, a time of the segment that ends there.
inline double just_before(double time) { return (1.0 - 1e-12) * time; }

/// The tangent of an equilibrium that changes with one number at the same shape: K(x) = K + x K'
/// (chain/README.md, Buckling and vibration). Both parts are what acts on the segments, so that a
/// factorization costs as much as one of K.
template <class L, bool kElastic>
class Pencil {
 public:
  using S = typename L::Scalar;

  /// K' = 0 at first.
  /// @param w  holds an assembled equilibrium, and in `joints.tangent` what its joints resist; both
  ///           outlive the pencil, which factors in it
  Pencil(const chain::Chain<L>& chain, NewtonWork<L, kElastic>& w)
      : chain_(chain), w_(w), base_(w.outer_forces), joint_base_(w.joints.tangent) {
    rate_.reset(chain.size());
    moment_rate_.assign(chain.joints(), {});
  }
  /// Leaves forces and tangents as they were.
  ~Pencil() {
    w_.outer_forces = base_;
    w_.joints.tangent = joint_base_;
  }
  Pencil(const Pencil&) = delete;
  Pencil& operator=(const Pencil&) = delete;

  /// K' of all forces as they grow in a unit of time: of loads, and of what holds against them.
  /// That follows from what the materials resist at this shape, as if it were the undeformed one:
  /// forces that are in equilibrium with each other there, whichever end is held. Where the
  /// materials alone resist too little, as in a chain that hangs, it follows from the whole
  /// tangent.
  void let_forces_grow() {
    factor(0.0);
    solve_rates();
    rotation_.resize(chain_.size());
    for (std::size_t i = 0; i < chain_.size(); ++i) rotation_[i] = rate_of(i).spin;
    take_forces_now();
    set_rates();
    rate_.reset(chain_.size());
    const auto slope = [&](std::size_t history) {
      return chain_.histories[history].slope_at(w_.time);
    };
    chain::detail::add_loads(chain_, w_.placement, slope, constant<S>(1), rate_);
    for (const auto& spring : chain_.springs) {
      const typename L::Point arm = L::rotate(w_.placement.frame[spring.segment], spring.arm);
      const chain::Motion<L> moves = rate_of(spring.segment);
      typename L::Point force = constant<S>(slope(spring.history)) * spring.motion -
                                (moves.shift + L::spun(moves.spin, arm));
      for (std::size_t i = 0; i < L::kTranslations; ++i) force[i] = spring.stiffness[i] * force[i];
      add_force(spring.segment, arm, force);
    }
    for (const auto& joint : chain_.ground_joints) {
      const auto axes = L::axes(chain::ground_joint_axes(joint, w_.placement));
      const auto tangent =
          block<L::kRotations, L::kRotations>(w_.joints.tangent[joint.joint], 0, 0);
      const typename L::Spin increment =
          constant<S>(slope(joint.history)) * joint.motion - rate_of(joint.segment).spin;
      add_ground_moment(joint.segment, axes * (tangent * transposed_times(axes, increment)));
    }
    for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
      if (w_.closed[k]) add_constraint_force(chain_.constraints[k], w_.small.b(k));
    }
    set_moment_rates();
  }

  /// K' = -M, so that K(omega^2) is singular at natural frequencies.
  void let_inertia_resist() {
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      chain::Impedance<L> mass = inertia_impedance(chain_.inertias[i], w_.placement.frame[i]);
      const S minus = constant<S>(-1);
      chain::Impedance<L>& rate = rate_.impedance[i];
      rate = {minus * mass.tt, minus * mass.tr, minus * mass.rt, minus * mass.rr};
    }
  }

  /// Leaves the factored K(x) in `w`, for counts of its negative eigenvalues and modes.
  void factor(double x) {
    const S fraction = constant<S>(x);
    chain::OuterForces<L>& sum = w_.outer_forces;
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      const chain::Impedance<L>& rate = rate_.impedance[i];
      sum.wrench[i] = base_.wrench[i] + chain::Wrench<L>{fraction * rate_.wrench[i].force,
                                                         fraction * rate_.wrench[i].moment};
      sum.impedance[i] = base_.impedance[i];
      sum.impedance[i] +=
          {fraction * rate.tt, fraction * rate.tr, fraction * rate.rt, fraction * rate.rr};
    }
    if constexpr (L::kRotations > 1) {
      for (std::size_t i = 0; i < chain_.size(); ++i) {
        auto& tangent = w_.joints.tangent[i];
        tangent = joint_base_[i];
        add(tangent, 0, 0, constant<S>(0.5 * x) * L::spin_derivative(moment_rate_[i]));
      }
    }
    w_.recursion.factor(chain_, w_.q, w_.placement, w_.stage, w_.joints, sum, w_.transmitted);
  }

  /// How fast a segment turns with the forces, as all resists; after `let_forces_grow` [rad/s].
  S rotation_rate(std::size_t segment) const { return size_of(rotation_[segment]); }

 private:
  /// How the moment of each joint grows, in its axes. As it works on spins, m = T^-T s, it turns by
  /// half of the joint's own spin: what of that grows stands in the law's tangent, and makes K'
  /// symmetric with the other half, by which the recursion turns it with the inner segment.
  void set_moment_rates() {
    chain::Wrench<L> sum{};
    for (std::size_t i = chain_.size(); i-- > 0;) {
      sum = sum + rate_.wrench[i];
      typename L::Spin moment = sum.moment;
      if constexpr (kElastic) {
        const S half = constant<S>(0.5);
        moment += L::moment(half * L::rotate(w_.placement.far[i], w_.q.shift[i]), sum.force);
      }
      moment_rate_[i] = transposed_times(L::axes(w_.placement.near[i]), moment);
      if (i == 0) break;
      sum.moment += L::moment(w_.placement.position[i] - w_.placement.position[i - 1], sum.force);
    }
  }

  /// K' of all forces as they are, so that K(-1) is what the materials resist.
  void take_forces_now() {
    const auto now = [&](std::size_t history) { return chain_.histories[history].at(w_.time); };
    chain::detail::add_loads(chain_, w_.placement, now, constant<S>(1), rate_);
    for (const auto& spring : chain_.springs) {
      const typename L::Point arm = L::rotate(w_.placement.frame[spring.segment], spring.arm);
      typename L::Point force = spring.rest + constant<S>(now(spring.history)) * spring.motion -
                                w_.placement.position[spring.segment] - arm;
      for (std::size_t i = 0; i < L::kTranslations; ++i) force[i] = spring.stiffness[i] * force[i];
      add_force(spring.segment, arm, force);
    }
    for (const auto& joint : chain_.ground_joints) {
      typename L::Spin moment;
      for (std::size_t i = 0; i < L::kRotations; ++i) moment[i] = w_.joints.force[joint.joint][i];
      add_ground_moment(joint.segment,
                        L::axes(chain::ground_joint_axes(joint, w_.placement)) * moment);
    }
    for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
      if (w_.closed[k]) add_constraint_force(chain_.constraints[k], w_.q.multiplier[k]);
    }
    set_moment_rates();
  }

  /// How the segments move, and the multipliers change (`w.small`), in a unit of time as the
  /// materials resist.
  void set_rates() {
    constexpr double kFree = 1e-9;
    factor(-1.0);
    const bool holds = w_.recursion.min_pivot() > constant<S>(kFree);
    if (holds) solve_rates();
    if (holds && are_finite()) return;
    factor(0.0);
    solve_rates();
  }

  bool are_finite() const {
    bool finite = true;
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      finite = finite && std::isfinite(static_cast<double>(size_of(rate_of(i).spin)));
    }
    for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
      finite = finite && std::isfinite(static_cast<double>(w_.small.b(k)));
    }
    return finite;
  }

  void solve_rates() {
    const auto unit_time = PathCondition<L>::unit_time();
    w_.columns[0] = {};
    w_.columns[0].resize(chain_.size());
    for (S& gap : w_.gap) gap = constant<S>(0);
    for (std::size_t k = 0; k < chain_.constraints.size(); ++k)
      detail::solve_constraint(chain_, k, w_);
    detail::solve_time(chain_, unit_time, w_);
    detail::join_columns(chain_, unit_time, w_);
  }

  chain::Motion<L> rate_of(std::size_t segment) const {
    return detail::motion_in_time(chain_, w_, segment);
  }

  void add_force(std::size_t segment, const typename L::Point& arm,
                 const typename L::Point& force) {
    rate_.wrench[segment].force += force;
    rate_.wrench[segment].moment += L::moment(arm, force);
    rate_.impedance[segment].rr -= L::moment_by(arm, force);
  }

  /// With the half that its law's tangent has, as `set_moment_rates`.
  void add_ground_moment(std::size_t segment, const typename L::Spin& moment) {
    rate_.wrench[segment].moment += moment;
    rate_.impedance[segment].rr -= constant<S>(0.5) * L::spin_derivative(moment);
  }

  void add_constraint_force(const chain::LoopConstraint<L>& constraint, const S& force) {
    if (constraint.rotational) {
      rate_.wrench[constraint.segment].moment += force * constraint.axis;
    } else {
      add_force(constraint.segment,
                L::rotate(w_.placement.frame[constraint.segment], constraint.arm),
                force * constraint.direction);
    }
  }

  const chain::Chain<L>& chain_;
  NewtonWork<L, kElastic>& w_;
  chain::OuterForces<L> base_;
  chain::OuterForces<L> rate_;
  std::vector<Mat<S, chain::kFreedoms<L, kElastic>, chain::kFreedoms<L, kElastic>>> joint_base_;
  std::vector<typename L::Spin> moment_rate_;  ///< of the joints of segments are read (joints)
  std::vector<typename L::Spin> rotation_;     ///< how the segments turn in a unit of time (N)
};

}  // namespace plastica::solve
