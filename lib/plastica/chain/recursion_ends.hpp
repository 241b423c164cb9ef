#pragma once

#include "plastica/chain/recursion.hpp"

/// Where the recursion along the chain turns: the root and the starts of pieces; and the sweeps for
/// a right-hand side.
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
  note_pivot(root_inverse_, chain.closure_stiffness);
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
    Joint& joint = joints_[i];
    const typename L::Point shift = kElastic ? q.shift[i] : typename L::Point{};
    if (!stage.half_way) set_axes(placement.near[i], placement.far[i], shift, joint);
    set_work(stage, i, joint);
    Vec<S, kJ> carried = joint.work_spin * w.moment;
    if constexpr (kElastic) carried += joint.work_shift * w.force;
    balance_[i] = laws.force[i] - carried;
    for (std::size_t k = 0; i == 0 && k < kR; ++k) {
      if (chain.root.welded[k]) balance_[0][k] = constant<S>(0);
    }
    if (any(q.open[i])) {
      PieceStart start;
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
  for (std::size_t k = 0; k < kT; ++k) {
    root_balance_[k] = chain.root.held[k] ? constant<S>(0) : w.force[k];
  }
}

/// Solves a piece at its start, in the lanes where one begins, and leaves nothing for the joint.
/// @param a  the piece's impedance
/// @param w  what acts on it; nothing afterwards
/// @param given  the impedance with the joint eliminated; nothing afterwards
template <class L, bool kElastic>
void Recursion<L, kElastic>::factor_piece(std::size_t i, const mask_t<S>& open,
                                          const Impedance<L>& a, Wrench<L>& w, Impedance<L>& given,
                                          Joint& joint) {
  PieceStart start;
  start.joint = i;
  start.open = open;
  start.balance = {select(open, w.force, {}), select(open, w.moment, {})};
  Mat<S, kFree, kFree> m;
  for (std::size_t k = 0; k < kR; ++k) {
    for (std::size_t j = 0; j < kR; ++j) m(k, j) = a.rr(k, j);
    for (std::size_t j = 0; j < kT; ++j) m(k, kR + j) = a.rt(k, j);
  }
  for (std::size_t k = 0; k < kT; ++k) {
    for (std::size_t j = 0; j < kR; ++j) m(kR + k, j) = a.tr(k, j);
    for (std::size_t j = 0; j < kT; ++j) m(kR + k, kR + j) = a.tt(k, j);
  }
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
  balance_[i] = select(open, {}, balance_[i]);
}

template <class L, bool kElastic>
void Recursion<L, kElastic>::solve(const RightSide<L, kElastic>& right, bool with_balance,
                                   Solution<L, kElastic>& solution) {
  const std::size_t n = joints_.size();
  Wrench<L> b{};
  auto start = starts_.begin();
  for (std::size_t i = n; i-- > 0;) {
    const Joint& joint = joints_[i];
    b = b + right.wrench[i];
    Vec<S, kJ> rest = right.joint[i] + joint.work_spin * b.moment;
    if constexpr (kElastic) rest += joint.work_shift * b.force;
    if (with_balance) rest -= balance_[i];
    // Between the two sweeps the solution holds D^-1 (P b - balance).
    const JointVector gives = joint.inverse * rest;
    solution.joint[i] = gives;
    if (start != starts_.end() && start->joint == i) {
      solve_piece(*start, with_balance, b);
      ++start;
    }
    b.force -= joint.u_shift * gives;
    b.moment -= joint.u_spin * gives;
    if (i > 0) b.moment += transposed_times(joint.work_by, b.force);
  }
  // The root's translations; the ground's own motion is given.
  typename L::Point lack =
      b.force - root_impedance_.tt * right.ground.shift - root_impedance_.tr * right.ground.spin;
  if (with_balance) lack += root_balance_;
  Motion<L> motion = right.ground;
  solution.root = root_inverse_ * lack;
  motion.shift += solution.root;
  auto piece = starts_.rbegin();
  for (std::size_t i = 0; i < n; ++i) {
    const Joint& joint = joints_[i];
    if (i > 0) motion.shift += joint.by * motion.spin;
    const JointVector moved = solution.joint[i] - joint.inverse * (joint.v_spin * motion.spin +
                                                                   joint.v_shift * motion.shift);
    solution.joint[i] = moved;
    motion.spin += joint.axes_spin * moved;
    if constexpr (kElastic) motion.shift += joint.axes_shift * moved;
    if (piece != starts_.rend() && piece->joint == i) {
      motion = {select(piece->open, piece->motion.shift, motion.shift),
                select(piece->open, piece->motion.spin, motion.spin)};
      ++piece;
    }
    solution.motion[i] = motion;
  }
}

/// The motion of a piece's first segment; in the lanes where it begins no force goes further in.
template <class L, bool kElastic>
void Recursion<L, kElastic>::solve_piece(PieceStart& start, bool with_balance, Wrench<L>& b) {
  Wrench<L> acting = b;
  if (with_balance) acting = acting + start.balance;
  Vec<S, kFree> rest;
  for (std::size_t k = 0; k < kR; ++k) rest[k] = acting.moment[k];
  for (std::size_t k = 0; k < kT; ++k) rest[kR + k] = acting.force[k];
  const Vec<S, kFree> moved = start.inverse * rest;
  for (std::size_t k = 0; k < kR; ++k) start.motion.spin[k] = moved[k];
  for (std::size_t k = 0; k < kT; ++k) start.motion.shift[k] = moved[kR + k];
  b = {select(start.open, {}, b.force), select(start.open, {}, b.moment)};
}

}  // namespace plastica::chain
