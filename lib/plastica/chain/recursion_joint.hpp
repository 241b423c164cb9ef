#pragma once

#include <algorithm>

#include "plastica/base/always_inline.hpp"
#include "plastica/chain/recursion.hpp"

/// One joint of the recursion along the chain.
namespace plastica::chain {

template <class L, bool kElastic>
typename Recursion<L, kElastic>::Carrier Recursion<L, kElastic>::carrier(
    const Placement<L>& placement, std::size_t i, const typename L::Point& shift) {
  const S half = constant<S>(0.5);
  const typename L::Frame& far = placement.far[i];
  return {L::spun_by(half * L::rotate(far, shift)),
          half * (L::frame_matrix(placement.near[i]) + L::frame_matrix(far))};
}

/// What moves the outer segment, and what its wrench works on. Where forces act at the end, both
/// are the same.
template <class L, bool kElastic>
void Recursion<L, kElastic>::set_joint(const Coordinates<L>& q, const Placement<L>& placement,
                                       const Stage<L>& stage, std::size_t i) {
  Joint& joint = joints_[i];
  joint.near = L::axes(placement.near[i]);
  if constexpr (kElastic) {
    joint.moves = carrier(placement, i, q.shift[i]);
    joint.works = stage.midpoint ? carrier(stage.placement, i, stage.shift[i]) : joint.moves;
  }
}

/// Law minus transmitted moment and force.
template <class L, bool kElastic>
void Recursion<L, kElastic>::set_balance(const Chain<L>& chain, const Stage<L>& stage,
                                         const JointVector& law, const Wrench<L>& w,
                                         std::size_t i) {
  Joint& joint = joints_[i];
  typename L::Spin moment = w.moment;
  if constexpr (kElastic) moment += transposed_times(joint.works.by_spin, w.force);
  moment = stage.midpoint ? stage.to_joint[i] * moment : transposed_times(joint.near, moment);
  typename L::Spin residual;
  for (std::size_t k = 0; k < kR; ++k) {
    residual[k] = i == 0 && chain.root.clamped[k] ? constant<S>(0) : law[k] - moment[k];
    balance_[i][k] = residual[k];
  }
  const typename L::Spin in_world =
      stage.midpoint ? stage.from_joint[i] * residual : joint.near * residual;
  for (std::size_t k = 0; k < kR; ++k) joint.residual[k] = in_world[k];
  if constexpr (kElastic) {
    const typename L::Point force = transposed_times(joint.works.along, w.force);
    const bool shifts = i > 0 || chain.root.shifts;
    for (std::size_t k = 0; k < kT; ++k) {
      const S off = shifts ? law[kR + k] - force[k] : constant<S>(0);
      joint.residual[kR + k] = balance_[i][kR + k] = off;
    }
  }
}

/// Eliminates a joint: `a` becomes the impedance that it leaves of what is outside of it.
template <class L, bool kElastic>
template <bool kAxial>
void Recursion<L, kElastic>::eliminate(const Chain<L>& chain, const Stage<L>& stage,
                                       const Mat<S, kJ, kJ>& tangent, const Coordinates<L>& q,
                                       const Placement<L>& at, const Wrench<L>& w, std::size_t i,
                                       Impedance<L>& a) {
  Joint& joint = joints_[i];
  const Spins& from_joint = stage.midpoint ? stage.from_joint[i] : joint.near;
  const Spins back = transpose(joint.near);
  const Spins spinning = from_joint * (block<kR, kR>(tangent, 0, 0) * back);
  Mat<S, kJ, kJ> d;
  Mat<S, kJ, kR> v_spin;
  Mat<S, kJ, kT> v_shift;
  if constexpr (!kElastic) {
    joint.u_spin = a.rr;
    joint.u_shift = a.tr;
    v_spin = a.rr;
    v_shift = a.rt;
    d = spinning + a.rr;
  } else {
    const Carrier& moves = joint.moves;
    const Mat<S, kT, kR> works = joint.works.by_spin;
    const Mat<S, kT, kT> along = transpose(joint.works.along);
    const Mat<S, kR, kT> carried = transpose(works);
    const Spins u_rr = a.rr + a.rt * moves.by_spin;
    const Mat<S, kT, kR> u_tr = a.tr + a.tt * moves.by_spin;
    const Mat<S, kR, kT> u_rt = a.rt * moves.along;
    const Mat<S, kT, kT> u_tt = a.tt * moves.along;
    put(joint.u_spin, 0, 0, u_rr);
    put(joint.u_spin, 0, kR, u_rt);
    put(joint.u_shift, 0, 0, u_tr);
    put(joint.u_shift, 0, kR, u_tt);
    put(v_spin, 0, 0, a.rr + carried * a.tr);
    put(v_spin, kR, 0, along * a.tr);
    put(v_shift, 0, 0, a.rt + carried * a.tt);
    put(v_shift, kR, 0, along * a.tt);
    put(d, 0, 0, spinning + u_rr + carried * u_tr);
    put(d, 0, kR, from_joint * block<kR, kT>(tangent, 0, kR) + u_rt + carried * u_tt);
    put(d, kR, 0, block<kT, kR>(tangent, kR, 0) * back + along * u_tr);
    put(d, kR, kR, block<kT, kT>(tangent, kR, kR) + along * u_tt);
  }
  if constexpr (kAxial) couple(i, a, v_spin, v_shift, d);
  add_rotation_terms(stage, kElastic ? q.shift[i] : typename L::Point{}, at, joint.near, w, i,
                     v_spin, d);
  if constexpr (kElastic) {
    // The force acts on segment i - 1 where the shift has taken it.
    const Mat<S, kR, kT> follows = stage.fraction() * transpose(L::spun_by(w.force));
    add(joint.u_spin, 0, 0, follows * joint.moves.by_spin);
    add(joint.u_spin, 0, kR, follows * joint.moves.along);
  }
  const auto& clamped = chain.root.clamped;
  const bool clamps = std::find(clamped.begin(), clamped.end(), true) != clamped.end();
  if (i == 0 && (clamps || (kElastic && !chain.root.shifts))) {
    joint.inverse =
        inverse_held(d, joint.near, stage.midpoint ? stage.to_joint[0] : back, chain.root);
  } else {
    joint.inverse = inverse(d);
  }
  joint.give_spin = joint.inverse * v_spin;
  joint.give_shift = joint.inverse * v_shift;
  a.tt -= joint.u_shift * joint.give_shift;
  a.tr -= joint.u_shift * joint.give_spin;
  a.rt -= joint.u_spin * joint.give_shift;
  a.rr -= joint.u_spin * joint.give_spin;
}

/// The part of the slope of S^T w that comes from S turning, at constant w. With p = far shift,
/// G = moment + p/2 x force: rows of spins are near^T G, rows of shifts (near + far)^T force/2.
/// Half way, rows and columns do not turn to world axes and back by the same.
/// @param at  where the forces act
template <class L, bool kElastic>
void Recursion<L, kElastic>::add_rotation_terms(const Stage<L>& stage,
                                                const typename L::Point& shift,
                                                const Placement<L>& at, const Spins& near,
                                                const Wrench<L>& w, std::size_t i,
                                                Mat<S, kJ, kR>& v_spin, Mat<S, kJ, kJ>& d) {
  const S fraction = stage.fraction();
  const auto rows = [&](const auto& m) {
    return stage.midpoint ? stage.from_joint[i] * (transpose(L::axes(at.near[i])) * m) : m;
  };
  if constexpr (!kElastic) {
    v_spin += rows(fraction * L::spin_derivative(w.moment));
  } else {
    const S half = constant<S>(0.5);
    const auto columns = [&](const auto& m) {
      return stage.midpoint ? m * (L::axes(at.near[i]) * transpose(near)) : m;
    };
    const typename L::Point p = L::rotate(at.far[i], shift);
    const typename L::Spin g = w.moment + L::moment(half * p, w.force);
    const Spins by_p = (fraction * half) * L::moment_by(p, w.force);
    const Mat<S, kT, kR> by_force = (fraction * half) * L::spun_by(w.force);
    const Mat<S, kT, kR> far_by = transpose(L::frame_matrix(at.far[i])) * by_force;
    add(v_spin, 0, 0, rows(fraction * L::spin_derivative(g) - by_p));
    add(v_spin, kR, 0, transpose(L::frame_matrix(at.near[i])) * by_force + far_by);
    add(d, 0, 0, -constant<S>(1) * rows(columns(by_p)));
    // d(S^T w) is symmetric in spins and shifts: p/2 x force changes with the shift alike.
    add(d, kR, 0, columns(far_by));
    add(d, 0, kR, rows(transpose(far_by)));
  }
}

/// A clamped freedom of the joint's own axes does not move, nor a shift of joint 0 that is not let
/// go.
template <class L, bool kElastic>
Mat<typename L::Scalar, Recursion<L, kElastic>::kJ, Recursion<L, kElastic>::kJ>
Recursion<L, kElastic>::inverse_held(const Mat<S, kJ, kJ>& d, const Spins& near,
                                     const Spins& to_joint, const Root<L>& root) {
  auto rows = identity<S, kJ>();
  auto columns = identity<S, kJ>();
  put(rows, 0, 0, to_joint);
  put(columns, 0, 0, near);
  Mat<S, kJ, kJ> own = rows * d * columns;
  const auto clear = [&](const S& diagonal) {
    for (std::size_t k = 0; k < kJ; ++k) {
      if (k < kR ? !root.clamped[k] : root.shifts) continue;
      for (std::size_t i = 0; i < kJ; ++i) own(k, i) = own(i, k) = constant<S>(0);
      own(k, k) = diagonal;
    }
  };
  clear(constant<S>(1));
  own = inverse(own);
  clear(constant<S>(0));
  return columns * own * rows;
}

/// A wrench on the outer segment as it works on a joint's freedoms: P b.
template <class L, bool kElastic>
typename Recursion<L, kElastic>::JointVector Recursion<L, kElastic>::in_freedoms(
    const Joint& joint, const Wrench<L>& b) {
  if constexpr (!kElastic) {
    return b.moment;
  } else {
    const typename L::Spin moment = b.moment + transposed_times(joint.works.by_spin, b.force);
    const typename L::Point force = transposed_times(joint.works.along, b.force);
    JointVector rest;
    for (std::size_t k = 0; k < kR; ++k) rest[k] = moment[k];
    for (std::size_t k = 0; k < kT; ++k) rest[kR + k] = force[k];
    return rest;
  }
}

/// Takes a motion from the inner to the outer side of a joint.
/// @param moved  of the joint's freedoms; afterwards in its own axes
template <class L, bool kElastic>
void Recursion<L, kElastic>::move(const Joint& joint, JointVector& moved, Motion<L>& motion) {
  typename L::Spin spin;
  for (std::size_t k = 0; k < kR; ++k) spin[k] = moved[k];
  motion.spin += spin;
  if constexpr (kElastic) {
    typename L::Point shift;
    for (std::size_t k = 0; k < kT; ++k) shift[k] = moved[kR + k];
    motion.shift += joint.moves.by_spin * spin + joint.moves.along * shift;
  }
  const typename L::Spin own = transposed_times(joint.near, spin);
  for (std::size_t k = 0; k < kR; ++k) moved[k] = own[k];
}

}  // namespace plastica::chain
