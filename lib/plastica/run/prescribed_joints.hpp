#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "plastica/chain/section_joints.hpp"

namespace plastica {

/// Joints of rigid translation whose state comes from kernels, for what reads joints.
template <class L>
class PrescribedJoints final : public chain::SectionJointsBase<L, false> {
 public:
  using Base = chain::SectionJointsBase<L, false>;
  using S = typename L::Scalar;

  PrescribedJoints(std::vector<chain::SectionJoint<L>> joints, chain::SectionAxes<L> axes)
      : Base(std::move(joints)), axes_(axes) {}

  /// @param elastic  part of the joint's angle [rad]
  /// @param work     plastic work so far [J]
  void prescribe(std::size_t j, const typename L::Spin& elastic, const S& work) {
    const chain::SectionJoint<L>& joint = this->joints_[j];
    S stored = constant<S>(0);
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      const std::size_t axis = axes_.rotation(k);
      const S moment = joint.rotational_stiffness(k, axis) * elastic[k];
      this->force_[j][axis] = moment;
      stored = stored + constant<S>(0.5) * (moment + joint.spring[k] * elastic[k]) * elastic[k];
    }
    this->elastic_[j] = stored;
    this->plastic_[j] = work;
  }

  /// Stiffness of a joint and of the spring beside it [N m/rad].
  S stiffness(std::size_t j, std::size_t k) const {
    const chain::SectionJoint<L>& joint = this->joints_[j];
    return joint.rotational_stiffness(k, axes_.rotation(k)) + joint.spring[k];
  }

  void evaluate(std::span<const typename L::Spin> /*angles*/,
                std::span<const typename L::Point> /*shifts*/,
                chain::JointForces<L, false>& /*forces*/) override {
    assert(false && "the kernels know the laws");
  }
  void commit() override {}
  void reset() override {
    for (std::size_t j = 0; j < this->joints_.size(); ++j) prescribe(j, {}, constant<S>(0));
  }

 private:
  chain::SectionAxes<L> axes_;
};

}  // namespace plastica
