#pragma once

#include <cstddef>
#include <type_traits>

#include "plastica/chain/axial.hpp"
#include "plastica/solve/imbalance.hpp"

/// The parts of one iteration of `equilibrate`.
namespace plastica::solve {

namespace detail {

/// Decides which constraints act, and adds what they do.
template <class L, bool kElastic>
void set_constraints(const chain::Chain<L>& chain, NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  w.closed_anew = false;
  const S zero = constant<S>(0);
  for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
    w.gap[k] = chain::constraint_gap(chain, chain.constraints[k], w.placement, w.time);
    if (chain.constraints[k].waits_for != chain::kInside) w.gap[k] = w.gap[k] - w.held_off[k];
    if (any(w.q.released_constraint[k])) {
      w.closed[k] = w.closed[k] & !w.q.released_constraint[k];
      w.q.multiplier[k] = select(w.closed[k], w.q.multiplier[k], zero);
      w.gap[k] = select(w.closed[k], w.gap[k], zero);
    }
    if (!chain.constraints[k].one_sided) continue;
    // A pillar pushes or is left: whichever the multiplier, less the gap's stiffness, says.
    const mask_t<S> closes = (w.q.multiplier[k] - chain.constraint_stiffness * w.gap[k] >= zero) &
                             !w.q.released_constraint[k] & w.may_close[k];
    const mask_t<S> was = w.closed[k];
    w.closed_anew = w.closed_anew || any((closes & (!was)) | (was & (!closes)));
    w.closed[k] = closes;
    w.q.multiplier[k] = select(w.closed[k], w.q.multiplier[k], zero);
    w.gap[k] = select(w.closed[k], w.gap[k], zero);
  }
  chain::add_constraints(chain, w.placement, w.stage, w.q, w.closed, w.outer_forces);
}

/// Of a placed chain whose laws see the axial force of rigid joints: that follows from all other
/// forces, so the laws come last.
template <class L, bool kElastic, class FactorAt>
void assemble_with_axial(const chain::Chain<L>& chain, chain::JointLaws<L, kElastic>& laws,
                         const FactorAt& factor_at, NewtonWork<L, kElastic>& w) {
  chain::gather_loads(chain, w.placement, w.stage, factor_at, w.outer_forces);
  set_constraints(chain, w);
  chain::find_axial_forces(chain, w.q, w.placement, w.closed, w.time, factor_at,
                           w.outer_forces.wrench, w.outer_forces.axial, w.joints.axial);
  w.joints.by_axial.resize(chain.joints());
  w.right.at_ground.resize(chain.ground_joints.size());
  laws.evaluate(w.angles, w.q.shift, w.joints);
  chain::add_ground_joints_with_axial(chain, w.q, w.stage, w.placement, w.joints, w.outer_forces);
}

/// Places the chain, asks its laws and sums its forces at the current unknowns.
/// @param factor_at  the factor of a load's history, by its number
template <class L, bool kElastic, class FactorAt>
void assemble(const chain::Chain<L>& chain, chain::JointLaws<L, kElastic>& laws,
              const FactorAt& factor_at, NewtonWork<L, kElastic>& w) {
  chain::place<kElastic>(chain, w.q, w.time, w.placement);
  for (std::size_t i = 0; i < chain.size(); ++i) w.angles[i] = w.q.angle[i];
  for (const auto& joint : chain.ground_joints) {
    w.angles[joint.joint] = chain::ground_joint_angle(chain, joint, w.placement, w.time);
  }
  if (L::kTranslations > 0 && laws.sees_axial()) {
    assemble_with_axial(chain, laws, factor_at, w);
    return;
  }
  laws.evaluate(w.angles, w.q.shift, w.joints);
  chain::gather_forces(chain, w.q, w.placement, w.stage, w.joints, factor_at, w.outer_forces);
  set_constraints(chain, w);
}

/// The same at the time of `w`.
template <class L, bool kElastic>
void assemble(const chain::Chain<L>& chain, chain::JointLaws<L, kElastic>& laws,
              NewtonWork<L, kElastic>& w) {
  assemble(
      chain, laws, [&](std::size_t history) { return chain.histories[history].at(w.time); }, w);
}

/// Adds the stiffness of the path condition along its covector; like that of a constraint it does
/// not change the solution.
template <class L, bool kElastic>
void stiffen_condition(const chain::Chain<L>& chain, const PathCondition<L>& condition,
                       NewtonWork<L, kElastic>& w) {
  const auto& c = condition.covector;
  const auto s = chain.constraint_stiffness;
  auto& impedance = w.outer_forces.impedance[condition.segment];
  impedance.tt += outer(s * c.force, c.force);
  impedance.tr += outer(s * c.force, c.moment);
  impedance.rt += outer(s * c.moment, c.force);
  impedance.rr += outer(s * c.moment, c.moment);
}

template <class L>
void add_scaled(const typename L::Scalar& s, const chain::Wrench<L>& wrench,
                chain::Wrench<L>& sum) {
  sum.force += s * wrench.force;
  sum.moment += s * wrench.moment;
}

template <class L>
typename L::Scalar power(const chain::Wrench<L>& wrench, const chain::Motion<L>& motion) {
  return dot(wrench.force, motion.shift) + dot(wrench.moment, motion.spin);
}

template <class S, class L>
S stiffness_of(const chain::Chain<L>& chain, const chain::LoopConstraint<L>& loop) {
  return loop.rotational ? chain.constraint_rotational_stiffness : chain.constraint_stiffness;
}

/// A constraint's wrench at a unit multiplier, where the forces act.
template <class L, bool kElastic>
chain::Wrench<L> active_wrench(const chain::LoopConstraint<L>& loop,
                               const NewtonWork<L, kElastic>& w) {
  return chain::unit_wrench(loop, w.stage.of(w.placement));
}

/// Column 0: the imbalance; and the constraints' gaps through their stiffness.
template <class L, bool kElastic>
void solve_imbalance(const chain::Chain<L>& chain, const PathCondition<L>& condition,
                     NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  w.right.reset(chain.size());
  for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
    const auto& loop = chain.constraints[k];
    const S force = select(w.closed[k], -(stiffness_of<S>(chain, loop) * w.gap[k]), constant<S>(0));
    add_scaled(force, active_wrench(loop, w), w.right.wrench[loop.segment]);
  }
  if (condition.active) {
    add_scaled(-(chain.constraint_stiffness * condition.value), condition.covector,
               w.right.wrench[condition.segment]);
  }
  w.recursion.solve(w.right, true, w.columns[0]);
}

/// Notes where a force of the right-hand side acts on a node that joints to the ground see.
template <class L, bool kElastic>
void add_at_nodes(const chain::Chain<L>& chain, std::size_t segment, const typename L::Point& arm,
                  const typename L::Point& force, NewtonWork<L, kElastic>& w) {
  if (!w.outer_forces.axial.acts()) return;
  if (chain::at_start(chain, segment, arm)) w.right.at_start += force;
  for (std::size_t g = 0; g < chain.ground_joints.size(); ++g) {
    if (chain::at_ground_joint(chain, chain.ground_joints[g], segment, arm)) {
      w.right.at_ground[g] += force;
    }
  }
}

/// The column of a constraint: what a unit force along it moves.
template <class L, bool kElastic>
void solve_constraint(const chain::Chain<L>& chain, std::size_t k, NewtonWork<L, kElastic>& w) {
  const auto& loop = chain.constraints[k];
  w.right.reset(chain.size());
  w.right.wrench[loop.segment] = active_wrench(loop, w);
  if (!loop.rotational) add_at_nodes(chain, loop.segment, loop.arm, loop.direction, w);
  w.recursion.solve(w.right, false, w.columns[1 + k]);
}

/// The slopes of a chain's histories at the time of the work [1/s].
template <class L, bool kElastic>
auto slopes_now(const chain::Chain<L>& chain, const NewtonWork<L, kElastic>& w) {
  return [&](std::size_t history) {
    return chain::factor_as<typename L::Scalar>(chain.histories[history].slope_at(w.time));
  };
}

/// The last column: what a unit of time moves, through loads, springs, the ground and constraints.
/// @param slope  of a history's number
template <class L, bool kElastic, class Slope>
void solve_time(const chain::Chain<L>& chain, const PathCondition<L>& condition,
                NewtonWork<L, kElastic>& w, const Slope& slope) {
  using S = typename L::Scalar;
  w.right.reset(chain.size());
  for (const auto& load : chain.loads) {
    const chain::Wrench<L> unit = chain::unit_wrench(load, w.placement);
    add_scaled(slope(load.history), unit, w.right.wrench[load.segment]);
    add_at_nodes(chain, load.segment, load.arm, slope(load.history) * unit.force, w);
  }
  for (const auto& spring : chain.springs) {
    chain::Wrench<L> rate{};
    for (std::size_t i = 0; i < L::kTranslations; ++i) {
      rate.force[i] = slope(spring.history) * spring.stiffness[i] * spring.motion[i];
    }
    rate.moment = L::moment(L::rotate(w.placement.frame[spring.segment], spring.arm), rate.force);
    add_scaled(constant<S>(1), rate, w.right.wrench[spring.segment]);
    add_at_nodes(chain, spring.segment, spring.arm, rate.force, w);
  }
  for (const auto& joint : chain.ground_joints) {
    // The ground turns against the segment, which the joint's law resists.
    const auto axes = L::axes(chain::ground_joint_axes(joint, w.placement));
    const typename L::Spin increment = transposed_times(axes, slope(joint.history) * joint.motion);
    typename L::Spin moment;
    for (std::size_t i = 0; i < L::kRotations; ++i) {
      for (std::size_t k = 0; k < L::kRotations; ++k) {
        moment[i] += w.joints.tangent[joint.joint](i, k) * increment[k];
      }
    }
    w.right.wrench[joint.segment].moment += axes * moment;
  }
  for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
    const auto& loop = chain.constraints[k];
    const S force = stiffness_of<S>(chain, loop) * slope(loop.history) * loop.motion;
    add_scaled(select(w.closed[k], force, constant<S>(0)), chain::unit_wrench(loop, w.placement),
               w.right.wrench[loop.segment]);
  }
  add_scaled(-(chain.constraint_stiffness * condition.time_slope), condition.covector,
             w.right.wrench[condition.segment]);
  w.right.ground = {slope(chain.root.history) * chain.root.motion,
                    slope(chain.root.history) * chain.root.rotation};
  w.recursion.solve(w.right, false, w.columns.back());
}
template <class L, bool kElastic>
void solve_time(const chain::Chain<L>& chain, const PathCondition<L>& condition,
                NewtonWork<L, kElastic>& w) {
  solve_time(chain, condition, w, slopes_now(chain, w));
}

/// Solves for multipliers and time: the motion must close every gap and meet the condition.
/// @param slope  as for `solve_time`
template <class L, bool kElastic, class Slope>
void join_columns(const chain::Chain<L>& chain, const PathCondition<L>& condition,
                  NewtonWork<L, kElastic>& w, const Slope& slope) {
  using S = typename L::Scalar;
  const std::size_t constraints = chain.constraints.size();
  const S zero = constant<S>(0);
  const S one = constant<S>(1);
  auto& small = w.small;
  for (std::size_t k = 0; k < constraints; ++k) {
    const auto& loop = chain.constraints[k];
    const auto wrench = chain::unit_wrench(loop, w.placement);
    for (std::size_t j = 0; j < constraints; ++j) {
      const S moved = power(wrench, w.columns[1 + j].motion[loop.segment]);
      const S open = k == j ? one : zero;
      small.a(k, j) = select(w.closed[k], select(w.closed[j], moved, zero), open);
    }
    S by_time = zero;
    if (condition.active) {
      const S speed = slope(loop.history);
      by_time = power(wrench, w.columns.back().motion[loop.segment]) - speed * loop.motion;
    }
    small.a(k, constraints) = select(w.closed[k], by_time, zero);
    const S moved = power(wrench, w.columns[0].motion[loop.segment]);
    small.b(k) = select(w.closed[k], -w.gap[k] - moved, zero);
  }
  for (std::size_t j = 0; j <= constraints; ++j) small.a(constraints, j) = zero;
  if (condition.active) {
    const auto& c = condition.covector;
    for (std::size_t j = 0; j < constraints; ++j) {
      const S moved = power(c, w.columns[1 + j].motion[condition.segment]);
      small.a(constraints, j) = select(w.closed[j], moved, zero);
    }
    small.a(constraints, constraints) =
        power(c, w.columns.back().motion[condition.segment]) + condition.time_slope;
    small.b(constraints) = -condition.value - power(c, w.columns[0].motion[condition.segment]);
  } else {
    small.a(constraints, constraints) = one;
    small.b(constraints) = zero;
  }
  small.solve();
}
template <class L, bool kElastic>
void join_columns(const chain::Chain<L>& chain, const PathCondition<L>& condition,
                  NewtonWork<L, kElastic>& w) {
  join_columns(chain, condition, w, slopes_now(chain, w));
}

/// How a segment moves in a unit of time with the constraints kept; after `join_columns`.
template <class L, bool kElastic>
chain::Motion<L> motion_in_time(const chain::Chain<L>& chain, const NewtonWork<L, kElastic>& w,
                                std::size_t segment) {
  using S = typename L::Scalar;
  chain::Motion<L> rate = w.columns.back().motion[segment];
  for (std::size_t j = 0; j < chain.constraints.size(); ++j) {
    const S weight = select(w.closed[j], w.small.b(j), constant<S>(0));
    rate.shift += weight * w.columns[1 + j].motion[segment].shift;
    rate.spin += weight * w.columns[1 + j].motion[segment].spin;
  }
  return rate;
}

/// Adds the columns to the first one by their weights.
template <class L, bool kElastic>
void combine_columns(const chain::Chain<L>& chain, const PathCondition<L>& condition,
                     NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  auto& sum = w.columns[0];
  for (std::size_t j = 0; j <= chain.constraints.size(); ++j) {
    const bool time = j == chain.constraints.size();
    if (time && !condition.active) break;
    const S weight = time ? w.small.b(j) : select(w.closed[j], w.small.b(j), constant<S>(0));
    const auto& column = w.columns[1 + j];
    sum.root += weight * column.root;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      sum.joint[i] += weight * column.joint[i];
      if (!any(w.q.open[i])) continue;
      sum.motion[i].shift += weight * column.motion[i].shift;
      sum.motion[i].spin += weight * column.motion[i].spin;
    }
  }
}

/// Moves the unknowns, by no more than one radian a joint; lanes that are done stay.
template <class L, bool kElastic>
void take_step(const chain::Chain<L>& chain, const PathCondition<L>& condition,
               const mask_t<typename L::Scalar>& done, NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  const auto& step = w.columns[0];
  S largest = constant<S>(0);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      largest = larger_size(largest, step.joint[i][k]);
      if (any(w.q.open[i])) largest = larger_size(largest, step.motion[i].spin[k]);
    }
  }
  const S one = constant<S>(1);
  const S part = select(done, constant<S>(0), one / larger_size(one, largest));
  for (std::size_t i = 0; i < chain.size(); ++i) {
    typename L::Spin spin;
    for (std::size_t k = 0; k < L::kRotations; ++k) spin[k] = part * step.joint[i][k];
    w.q.angle[i] = L::add_rotation(spin, w.q.angle[i]);
    if (any(w.q.open[i])) {
      chain::Pose<L>& pose = w.q.pose[i];
      pose.position += part * step.motion[i].shift;
      pose.frame = L::compose(L::rotation(part * step.motion[i].spin), pose.frame);
    }
    if constexpr (kElastic) {
      for (std::size_t k = 0; k < L::kTranslations; ++k) {
        w.q.shift[i][k] += part * step.joint[i][L::kRotations + k];
      }
    }
  }
  w.q.root += part * step.root;
  for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
    w.q.multiplier[k] += part * w.small.b(k);
  }
  if constexpr (std::is_floating_point_v<S>) {
    if (condition.active) w.time += part * w.small.b(chain.constraints.size());
  }
  w.stepped = constant<S>(1);
}

}  // namespace detail

}  // namespace plastica::solve
