#pragma once

#include <cstddef>

#include "plastica/run/chain_record.hpp"

/// How far joints have deformed for good.
namespace plastica {

template <class L, bool kElastic>
JointFlow ChainRecord<L, kElastic>::permanent_flow(const Joints& joints, const Work& w,
                                                   std::size_t node) const {
  const std::size_t joint = joint_of_node(node);
  const chain::SectionJoint<L>& numbers = joints.joints()[joint];
  const auto& forces = joints.section_forces()[joint];
  const auto axes = view_.section_axes();
  typename L::Spin left;
  for (std::size_t k = 0; k < L::kRotations; ++k) {
    const std::size_t axis = axes.rotation(k);
    const S elastic = numbers.elastic_deformation(axis, forces[axis]);
    left[k] = numbers.active[k] * (w.angles[joint][k] - elastic);
  }
  const Space angle = joint_spin(left);
  S stretch = constant<S>(0);
  if (!joints.axial_states().empty()) {
    const law::AxialState<S>& axial = joints.axial_states()[joint];
    stretch = axial.strain - axial.force / numbers.stiffness[law::kAxial];
  }
  if constexpr (kElastic) {
    if (numbers.stretches) {
      stretch = (w.q.shift[joint][chain::SectionAxes<L>::kAxialShift] -
                 numbers.elastic_deformation(law::kAxial, forces[law::kAxial])) /
                numbers.length[law::kAxial];
    }
  }
  return {angle[0], angle[1], angle[2],
          static_cast<double>(stretch) * (*joints_)[node].own_length()};
}

}  // namespace plastica
