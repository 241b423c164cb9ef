#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "plastica/chain/joint_laws.hpp"
#include "plastica/law/axial_control.hpp"
#include "plastica/law/section_form.hpp"
#include "plastica/law/section_response.hpp"

/// What a chain's joints are made of, and what is read of them, whatever their law.
namespace plastica::chain {

/// Where the freedoms of a level's joints stand among the strains of a section law (curvature
/// about x, about y, twist, axial), and along which of its axes x, y, z the level shifts. A planar
/// chain bends about one axis only.
template <class L>
struct SectionAxes;

template <class S>
struct SectionAxes<Twist<S>> {
  static constexpr std::size_t kTwist = 2;
  std::size_t rotation(std::size_t /*k*/) const { return kTwist; }
  std::size_t translation(std::size_t k) const { return k; }
  /// Calls `use` with the number of the first rotation's strain as a constant.
  template <class Use>
  void with_first(const Use& use) const {
    use(std::integral_constant<std::size_t, kTwist>{});
  }
};

template <class S>
struct SectionAxes<Planar<S>> {
  std::size_t bending = 0;  ///< 0: about x, 1: about y
  std::size_t rotation(std::size_t /*k*/) const { return bending; }
  std::size_t translation(std::size_t k) const { return k == kAxialShift ? 2 : 1 - bending; }
  template <class Use>
  void with_first(const Use& use) const {
    if (bending == 0) {
      use(std::integral_constant<std::size_t, 0>{});
    } else {
      use(std::integral_constant<std::size_t, 1>{});
    }
  }
  static constexpr std::size_t kAxialShift = 0;  ///< the shift along the beam
};

template <class S>
struct SectionAxes<Spatial<S>> {
  std::size_t rotation(std::size_t k) const { return k; }
  std::size_t translation(std::size_t k) const { return k; }
  template <class Use>
  void with_first(const Use& use) const {
    use(std::integral_constant<std::size_t, 0>{});
  }
  static constexpr std::size_t kAxialShift = 2;
};

/// What a joint is made of besides its law.
template <class L>
struct SectionJoint {
  using S = typename L::Scalar;
  std::size_t law = 0;     ///< which of the laws
  bool stretches = false;  ///< where joints do: whether this one stretches and shears
  /// Tributary length l as each component of the section's strain sees it [m]: one length, but
  /// where two sections meet.
  law::SectionStrain<S> length;
  typename L::Spin active;            ///< 1 where the law acts, 0 where the joint is free
  typename L::Spin spring;            ///< stiffness beside the law [N m/rad]
  typename L::Point shear_stiffness;  ///< kappa G A of each shift across the beam [N]
  law::SectionForce<S> stiffness;     ///< EI_x, EI_y [N m^2], GJ [N m^2], EA [N]
  S axial_yield{};                    ///< the axial force at which all of the section yields [N]

  /// What the law takes of the joint's angle elastically under a moment [rad], of its elongation
  /// under an axial force [m].
  /// @param axis  of the section
  S elastic_deformation(std::size_t axis, const S& force) const {
    return force * length[axis] / stiffness[axis];
  }
  /// The law's elastic moment per angle [N m/rad].
  /// @param k  rotation of the level, about `axis` of the section
  S rotational_stiffness(std::size_t k, std::size_t axis) const {
    return active[k] * stiffness[axis] / length[axis];
  }
};

/// What the solver's observers read of a chain's joints, whatever their law.
template <class L, bool kElastic>
class SectionJointsBase : public JointLaws<L, kElastic> {
 public:
  using S = typename L::Scalar;

  explicit SectionJointsBase(std::vector<SectionJoint<L>> joints)
      : joints_(std::move(joints)),
        force_(joints_.size()),
        elastic_(joints_.size()),
        work_(joints_.size()),
        plastic_(joints_.size()) {}

  const std::vector<SectionJoint<L>>& joints() const { return joints_; }
  /// Whether no joint can yield.
  bool is_elastic() const { return is_elastic_; }
  /// Section forces of the last trial (M_x, M_y, T, N) of each joint (joints).
  const std::vector<law::SectionForce<S>>& section_forces() const { return force_; }
  /// Elastic energy of each joint in the last trial [J] (joints).
  const std::vector<S>& elastic_energy() const { return elastic_; }
  /// Plastic work of each joint up to the last commit [J] (joints).
  const std::vector<S>& plastic_work() const { return plastic_; }

  /// Plastic work of each joint in the last trial alone [J] (joints).
  const std::vector<S>& work_increment() const { return work_; }

  /// Stiffness per length of planar joints about the other axis in the last trial [N m^2] (joints);
  /// empty where the law leaves it elastic.
  const std::vector<S>& stiffness_aside() const { return aside_; }

  /// Of joints whose axial force is given, the section's axial strain and force in the last trial
  /// (joints); empty where the law does not see that force.
  const std::vector<law::AxialState<S>>& axial_states() const { return axial_after_; }

  /// Back to the virgin state.
  virtual void reset() = 0;

  /// Visits what only motions ask of joints: chain/lane_fields.hpp.
  template <class V>
  void visit_stiffness(V& v) {
    for (SectionJoint<L>& joint : joints_) {
      for (S& number : joint.stiffness.at) v.number(number);
    }
  }
  /// Visits what is read of joints.
  template <class V>
  void visit_found(V& v, const SectionAxes<L>& axes) {
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      for (std::size_t k = 0; k < L::kRotations; ++k) v.number(force_[j][axes.rotation(k)]);
      if constexpr (kElastic) v.number(force_[j][law::kAxial]);
      v.number(elastic_[j]);
      v.number(work_[j]);
      v.number(plastic_[j]);
    }
  }

 protected:
  std::vector<SectionJoint<L>> joints_;
  std::vector<law::SectionForce<S>> force_;
  std::vector<S> elastic_, work_, plastic_, aside_;
  std::vector<law::AxialState<S>> axial_after_;
  bool is_elastic_ = false;
};

}  // namespace plastica::chain
