#pragma once

#include "plastica/chain/axial.hpp"
#include "plastica/chain/recursion.hpp"

/// The recursion where moments follow axial forces (README.md, "Axial force"). A change b - A v of
/// the wrench beyond a joint changes its moment through b and A's rows of the force, too.
namespace plastica::chain {

template <class L, bool kElastic>
void Recursion<L, kElastic>::set_couplings(const Chain<L>& chain, const Placement<L>& placement,
                                           const JointForces<L, kElastic>& laws,
                                           const AxialForces<L>& axial) {
  const typename L::Point e = along_beam<L>();
  // Where joints stretch, joint 0 does not (`Root::shifts`).
  const std::size_t rigid = chain.root.shifts ? 0 : 1;
  couplings_.resize(kElastic ? rigid : chain.size());
  for (std::size_t i = 0; i < couplings_.size(); ++i) {
    const typename L::Point far = constant<S>(0.5) * L::rotate(placement.far[i], e);
    couplings_[i] = {L::axes(placement.near[i]) * laws.by_axial[i], axial.along[i],
                     L::moment(axial.along[i], axial.force[i]), L::moment(far, axial.across[i])};
  }
  ground_couplings_.resize(chain.ground_joints.size());
  for (std::size_t g = 0; g < chain.ground_joints.size(); ++g) {
    const GroundJoint<L>& joint = chain.ground_joints[g];
    ground_couplings_[g] = {joint.segment, joint.outer, axial.ground_by_axial[g],
                            axial.along[joint.joint]};
  }
  at_start_ = axial.at_start;
}

/// Joints to the ground at one end of a segment, of the impedance beyond that end.
template <class L, bool kElastic>
void Recursion<L, kElastic>::couple_ground_joints(std::size_t segment, bool outer_end,
                                                  Impedance<L>& a) const {
  for (const GroundCoupling& ground : ground_couplings_) {
    if (ground.segment != segment || ground.outer != outer_end) continue;
    a.rt += outer(ground.by, transposed_times(a.tt, ground.along));
    a.rr += outer(ground.by, transposed_times(a.tr, ground.along));
  }
}

/// The same of a right-hand side; at an outer end with what acts at its node, at an inner end
/// without.
template <class L, bool kElastic>
void Recursion<L, kElastic>::couple_ground_joints(std::size_t segment, bool outer_end,
                                                  const RightSide<L>& right, Wrench<L>& b) const {
  typename L::Spin moment{};
  for (std::size_t g = 0; g < ground_couplings_.size(); ++g) {
    const GroundCoupling& ground = ground_couplings_[g];
    if (ground.segment != segment || ground.outer != outer_end) continue;
    const typename L::Point node =
        g < right.at_ground.size() ? right.at_ground[g] : typename L::Point{};
    moment += dot(ground.along, b.force + node_sign<S>(outer_end) * node) * ground.by;
  }
  b.moment += moment;
}

/// Adds what acts on a segment to the impedance of what is beyond it.
template <class L, bool kElastic>
void Recursion<L, kElastic>::add_with_axial(std::size_t segment, const Impedance<L>& own,
                                            Impedance<L>& a) const {
  couple_ground_joints(segment, true, a);
  a += own;
  couple_ground_joints(segment, false, a);
}

template <class L, bool kElastic>
void Recursion<L, kElastic>::eliminate_with_axial(const Chain<L>& chain, const Stage<L>& stage,
                                                  const Mat<S, kJ, kJ>& tangent,
                                                  const Coordinates<L>& q, const Placement<L>& at,
                                                  const Wrench<L>& w, std::size_t i,
                                                  Impedance<L>& a) {
  eliminate<true>(chain, stage, tangent, q, at, w, i, a);
}

template <class L, bool kElastic>
void Recursion<L, kElastic>::couple(std::size_t i, const Impedance<L>& a, Mat<S, kJ, kR>& v_spin,
                                    Mat<S, kJ, kT>& v_shift, Mat<S, kJ, kJ>& d) const {
  if (i >= couplings_.size()) return;
  const AxialCoupling& c = couplings_[i];
  Mat<S, kT, kT> tt = a.tt;
  Mat<S, kT, kR> tr = a.tr;
  if (i == 0) {
    tt -= at_start_.tt;
    tr -= at_start_.tr;
  }
  const typename L::Spin by_spin = transposed_times(tr, c.along);
  add(v_shift, 0, 0, -constant<S>(1) * outer(c.by, transposed_times(tt, c.along)));
  add(v_spin, 0, 0, outer(c.by, c.rotates_inner - by_spin));
  add(d, 0, 0, outer(c.by, c.rotates_joint - by_spin));
}

/// Adds what acts on a segment to the right-hand side beyond it.
/// @return what of it works on the joint's freedoms, less what changes its moment by the axial
/// force
template <class L, bool kElastic>
typename Recursion<L, kElastic>::JointVector Recursion<L, kElastic>::rest_with_axial(
    std::size_t i, const RightSide<L>& right, Wrench<L>& b) const {
  couple_ground_joints(i, true, right, b);
  b = b + right.wrench[i];
  couple_ground_joints(i, false, right, b);
  JointVector rest = in_freedoms(joints_[i], b);
  if (i < couplings_.size()) {
    const AxialCoupling& c = couplings_[i];
    const S force = dot(c.along, i == 0 ? b.force - right.at_start : b.force);
    for (std::size_t k = 0; k < kR; ++k) rest[k] = rest[k] - force * c.by[k];
  }
  return rest;
}

}  // namespace plastica::chain
