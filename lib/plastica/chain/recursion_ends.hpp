#pragma once

#include "plastica/chain/recursion.hpp"

/// Where the recursion along the chain turns: the root and the starts of fragments; and the sweeps
/// for a right-hand side.
namespace plastica::chain {

template <class L, bool kElastic>
void Recursion<L, kElastic>::factor_root(const Chain<L>& chain, const mask_t<S>& open,
                                         const Impedance<L>& outside) {
  root_impedance_ = outside;
  Mat<S, kT, kT> a = select(open, identity<S, kT>(), outside.tt);
  for (std::size_t k = 0; k < kT; ++k) {
    if (!chain.root.held[k]) continue;
    for (std::size_t i = 0; i < kT; ++i) {
      a(k, i) = constant<S>(0);
      a(i, k) = constant<S>(0);
    }
    a(k, k) = constant<S>(1);
  }
  root_inverse_ = inverse(a);
  for (std::size_t k = 0; k < kT; ++k) {
    if (chain.root.held[k]) root_inverse_(k, k) = constant<S>(0);
  }
  root_inverse_ = select(open, {}, root_inverse_);
  S softest = constant<S>(0);
  for (const S& entry : root_inverse_.at) softest = max(abs(entry), softest);
  const S one = constant<S>(1);
  min_pivot_ = min(one / max(chain.constraint_stiffness * softest, one), min_pivot_);
}

template <class L, bool kElastic>
void Recursion<L, kElastic>::set_root_balance(const Chain<L>& chain, const Wrench<L>& w) {
  for (std::size_t k = 0; k < kT; ++k) {
    root_balance_[k] = chain.root.held[k] ? constant<S>(0) : w.force[k];
  }
}

template <class L, bool kElastic>
void Recursion<L, kElastic>::sum(const Chain<L>& chain, const Coordinates<L>& q,
                                 const Placement<L>& placement, const Stage<L>& stage,
                                 const JointForces<L, kElastic>& laws,
                                 const OuterForces<L>& outer_forces, Transmitted<L>& transmitted) {
  const Placement<L>& at = stage.of(placement);
  starts_.clear();
  Wrench<L> w{};
  for (std::size_t i = chain.size(); i-- > 0;) {
    w = w + outer_forces.wrench[i];
    transmitted.outer[i] = w;
    set_joint(q, placement, stage, i);
    set_balance(chain, stage, laws.force[i], w, i);
    if (any(q.open[i])) {
      FragmentStart start;
      start.joint = i;
      start.open = q.open[i];
      start.balance = {select(q.open[i], w.force, {}), select(q.open[i], w.moment, {})};
      starts_.push_back(start);
      w = {select(q.open[i], {}, w.force), select(q.open[i], {}, w.moment)};
      transmitted.outer[i] = w;
      balance_[i] = select(q.open[i], {}, balance_[i]);
    }
    if (i > 0) w.moment += L::moment(at.position[i] - at.position[i - 1], w.force);
  }
  set_root_balance(chain, w);
}

/// Solves a fragment at its start, in the lanes where one begins, and leaves nothing for the joint.
/// @param a  the fragment's impedance
/// @param w  what acts on it; nothing afterwards
/// @param given  the impedance with the joint eliminated; nothing afterwards
template <class L, bool kElastic>
void Recursion<L, kElastic>::factor_fragment(std::size_t i, const mask_t<S>& open,
                                             const Impedance<L>& a, Wrench<L>& w,
                                             Impedance<L>& given, Joint& joint) {
  FragmentStart start;
  start.joint = i;
  start.open = open;
  start.balance = {select(open, w.force, {}), select(open, w.moment, {})};
  Mat<S, kFree, kFree> m;
  put(m, 0, 0, a.rr);
  put(m, 0, kR, a.rt);
  put(m, kR, 0, a.tr);
  put(m, kR, kR, a.tt);
  start.inverse = inverse(select(open, m, identity<S, kFree>()));
  starts_.push_back(start);
  w = {select(open, {}, w.force), select(open, {}, w.moment)};
  given.tt = select(open, {}, given.tt);
  given.tr = select(open, {}, given.tr);
  given.rt = select(open, {}, given.rt);
  given.rr = select(open, {}, given.rr);
  joint.inverse = select(open, {}, joint.inverse);
  joint.u_shift = select(open, {}, joint.u_shift);
  joint.u_spin = select(open, {}, joint.u_spin);
  joint.give_shift = select(open, {}, joint.give_shift);
  joint.give_spin = select(open, {}, joint.give_spin);
  balance_[i] = select(open, {}, balance_[i]);
}

template <class L, bool kElastic>
void Recursion<L, kElastic>::solve(const RightSide<L>& right, bool with_balance,
                                   Solution<L, kElastic>& solution) {
  const std::size_t n = joints_.size();
  Wrench<L> b{};
  auto start = starts_.begin();
  for (std::size_t i = n; i-- > 0;) {
    const Joint& joint = joints_[i];
    JointVector rest;
    if (follows_axial_) {
      rest = rest_with_axial(i, right, b);
    } else {
      b = b + right.wrench[i];
      rest = in_freedoms(joint, b);
    }
    if (with_balance) rest -= joint.residual;
    // Between the two sweeps the solution holds D^-1 (P b - balance).
    const JointVector correction = joint.inverse * rest;
    solution.joint[i] = correction;
    if (start != starts_.end() && start->joint == i) {
      solve_fragment(*start, with_balance, b);
      ++start;
    }
    b.force -= joint.u_shift * correction;
    b.moment -= joint.u_spin * correction;
    if (i > 0) b.moment += L::moment(joint.work_arm, b.force);
  }
  // The root's translations; the ground's own motion is given.
  typename L::Point residual =
      b.force - root_impedance_.tt * right.ground.shift - root_impedance_.tr * right.ground.spin;
  if (with_balance) residual += root_balance_;
  Motion<L> motion = right.ground;
  solution.root = root_inverse_ * residual;
  motion.shift += solution.root;
  auto fragment = starts_.rbegin();
  for (std::size_t i = 0; i < n; ++i) {
    const Joint& joint = joints_[i];
    if (i > 0) motion.shift += L::spun(motion.spin, joint.arm);
    JointVector moved =
        solution.joint[i] - joint.give_spin * motion.spin - joint.give_shift * motion.shift;
    move(joint, moved, motion);
    solution.joint[i] = moved;
    if (fragment != starts_.rend() && fragment->joint == i) {
      motion = {select(fragment->open, fragment->motion.shift, motion.shift),
                select(fragment->open, fragment->motion.spin, motion.spin)};
      ++fragment;
    }
    solution.motion[i] = motion;
  }
}

/// The motion of a fragment's first segment; in the lanes where it begins no force goes further in.
template <class L, bool kElastic>
void Recursion<L, kElastic>::solve_fragment(FragmentStart& start, bool with_balance, Wrench<L>& b) {
  Wrench<L> active = b;
  if (with_balance) active = active + start.balance;
  Vec<S, kFree> rest;
  for (std::size_t k = 0; k < kR; ++k) rest[k] = active.moment[k];
  for (std::size_t k = 0; k < kT; ++k) rest[kR + k] = active.force[k];
  const Vec<S, kFree> moved = start.inverse * rest;
  for (std::size_t k = 0; k < kR; ++k) start.motion.spin[k] = moved[k];
  for (std::size_t k = 0; k < kT; ++k) start.motion.shift[k] = moved[kR + k];
  b = {select(start.open, {}, b.force), select(start.open, {}, b.moment)};
}

}  // namespace plastica::chain
