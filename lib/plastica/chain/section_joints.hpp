#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "plastica/chain/section_joint.hpp"
#include "plastica/chain/uneven_flow.hpp"
#include "plastica/law/axial_control.hpp"
#include "plastica/law/per_axis.hpp"
#include "plastica/law/section_response.hpp"

namespace plastica::chain {

/// The joints of a chain whose sections follow a law per length (law/section_response.hpp).
///
/// @tparam Law  respond(law, before, after, strain) with Law::State by reference; or, of a section
///              that has many states (law.layout->states()), by the address of the first
template <class L, bool kElastic, class Law>
class SectionJoints final : public SectionJointsBase<L, kElastic> {
 public:
  using S = typename L::Scalar;
  static constexpr std::size_t kR = L::kRotations;
  static constexpr std::size_t kT = L::kTranslations;
  static constexpr std::size_t kJ = kFreedoms<L, kElastic>;
  static constexpr std::size_t kAxial = 3;

  SectionJoints(SectionAxes<L> axes, std::vector<Law> laws, std::vector<SectionJoint<L>> joints)
      : SectionJointsBase<L, kElastic>(std::move(joints)), axes_(axes), laws_(std::move(laws)) {
    std::size_t states = 0;
    for (const SectionJoint<L>& joint : joints_) {
      if constexpr (kManyStates) {
        states_.first.push_back(states);
        states += laws_[joint.law].layout->states();
      } else {
        ++states;
      }
      scales_.push_back(scale_of(joint));
    }
    before_.resize(states);
    after_.resize(states);
    find_uneven();
    this->is_elastic_ = std::is_empty_v<typename Law::State>;
    if constexpr (kSeesAside) aside_.resize(joints_.size());
    if constexpr (kSeesAxial) {
      this->sees_axial_ = true;
      axial_before_.resize(joints_.size());
      axial_after_.resize(joints_.size());
    }
  }
  /// @param kept  what laws with many states point to
  SectionJoints(SectionAxes<L> axes, std::vector<Law> laws, std::vector<SectionJoint<L>> joints,
                const std::shared_ptr<const void>& kept) requires requires(const Law& law) {
    law.layout->states();
  } : SectionJoints(axes, std::move(laws), std::move(joints)) {
    states_.kept = kept;
  }

  void evaluate(std::span<const typename L::Spin> angles, std::span<const typename L::Point> shifts,
                JointForces<L, kElastic>& forces) override {
    if constexpr (kSeesAxial) this->overloaded_ = false;
    axes_.with_first([&](auto first) {
      for (std::size_t j = 0; j < joints_.size(); ++j) {
        const typename L::Point shift =
            kElastic && j < shifts.size() ? shifts[j] : typename L::Point{};
        evaluate_joint<decltype(first)::value>(j, angles[j], shift, forces);
      }
    });
  }

  const SectionAxes<L>& axes() const { return axes_; }

  void set_time(double seconds) override {
    for (Law& law : laws_) law::set_time(law, seconds);
  }

  void commit() override {
    before_ = after_;
    uneven_before_ = uneven_after_;
    if constexpr (kSeesAxial) axial_before_ = axial_after_;
    for (std::size_t j = 0; j < joints_.size(); ++j) plastic_[j] = plastic_[j] + work_[j];
  }

  /// Visits which joints there are and all their numbers: chain/lane_fields.hpp.
  /// @param visit_law  (visitor, law)
  template <class V, class VisitLaw>
  void visit(V& v, const VisitLaw& visit_law) {
    if constexpr (requires { axes_.bending; }) v.index(axes_.bending);
    v.size(laws_);
    for (Law& law : laws_) visit_law(v, law);
    v.size(joints_);
    v.size(scales_);
    v.size(before_);
    v.size(after_);
    v.size(force_);
    v.size(elastic_);
    v.size(work_);
    v.size(plastic_);
    v.size(excess_);
    v.size(uneven_before_);
    v.size(uneven_after_);
    for (std::size_t j = 0; j < excess_.size(); ++j) {
      for (S& number : excess_[j].at) v.number(number);
      for (S& number : joints_[j].stiffness.at) v.number(number);
    }
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      SectionJoint<L>& joint = joints_[j];
      v.index(joint.law);
      for (S& number : joint.length.at) v.number(number);
      for (S& number : joint.active.at) v.number(number);
      for (S& number : joint.spring.at) v.number(number);
      for (S& number : scales_[j].per_length.at) v.number(number);
      for (S& number : scales_[j].rest.at) v.number(number);
    }
  }
  /// Visits the committed states of laws with one each, of the strains that the level has.
  /// @param visit_state  (visitor, state, first strain, how many)
  template <class V, class VisitState>
  void visit_states(V& v, const VisitState& visit_state) {
    for (typename Law::State& state : before_) visit_state(v, state, axes_.rotation(0), kR);
    for (auto& one : uneven_before_) {
      for (std::size_t k = 0; k < kR; ++k) v.number(one.permanent[axes_.rotation(k)]);
    }
  }
  /// The same of what the last trial has found: energies and, where the law can yield, forces, work
  /// and states.
  template <class V, class VisitState>
  void visit_trial(V& v, const VisitState& visit_state) {
    for (S& energy : elastic_) v.number(energy);
    if constexpr (!std::is_empty_v<typename Law::State>) {
      for (std::size_t j = 0; j < joints_.size(); ++j) {
        for (std::size_t k = 0; k < kR; ++k) v.number(force_[j][axes_.rotation(k)]);
        v.number(work_[j]);
        visit_state(v, after_[j], axes_.rotation(0), kR);
      }
      for (auto& one : uneven_after_) {
        for (std::size_t k = 0; k < kR; ++k) v.number(one.permanent[axes_.rotation(k)]);
      }
    }
  }

  void reset() override {
    std::fill(before_.begin(), before_.end(), typename Law::State{});
    for (auto* axial : {&axial_before_, &axial_after_}) axial->assign(axial->size(), {});
    std::fill(plastic_.begin(), plastic_.end(), constant<S>(0));
    std::fill(uneven_before_.begin(), uneven_before_.end(), UnevenState<S>{});
  }

 private:
  using SectionJointsBase<L, kElastic>::joints_;
  using SectionJointsBase<L, kElastic>::force_;
  using SectionJointsBase<L, kElastic>::elastic_;
  using SectionJointsBase<L, kElastic>::work_;
  using SectionJointsBase<L, kElastic>::plastic_;
  using SectionJointsBase<L, kElastic>::aside_;
  using SectionJointsBase<L, kElastic>::axial_after_;

  static constexpr bool kManyStates = requires(const Law& law) { law.layout->states(); };
  static constexpr bool kSeesAxial = law::kSeesAxial<Law> && kT > 0;
  static constexpr bool kSeesAside = law::kSeesAside<Law> && kT == 2;

  /// Where the states of each joint begin, of laws with many.
  struct ManyStates {
    std::vector<std::size_t> first;    ///< (joints)
    std::shared_ptr<const void> kept;  ///< what the laws point to
  };
  struct OneState {};

  std::size_t first_state(std::size_t j) const {
    if constexpr (kManyStates) {
      return states_.first[j];
    } else {
      return j;
    }
  }

  /// What the numbers of a joint are multiplied by in each trial.
  struct Scale {
    law::SectionStrain<S> per_length;  ///< 1/l [1/m]
    typename L::Spin rest;             ///< see `rest_of`; with the spring beside [N m/rad]
    S axial_rest;                      ///< [N/m]
  };

  Scale scale_of(const SectionJoint<L>& joint) const {
    Scale scale;
    for (std::size_t k = 0; k < law::kSectionAxes; ++k) {
      scale.per_length[k] = constant<S>(1) / joint.length[k];
    }
    for (std::size_t k = 0; k < kR; ++k) {
      const std::size_t axis = axes_.rotation(k);
      scale.rest[k] =
          joint.spring[k] + rest_of(joint.active[k] * joint.stiffness[axis], joint.length[axis]);
    }
    scale.axial_rest = rest_of(joint.stiffness[kAxial], joint.length[kAxial]);
    return scale;
  }

  template <class Has>
  law::SectionResponse<S> respond_to(std::size_t j, const law::SectionStrain<S>& strain) {
    const Law& law = laws_[joints_[j].law];
    const auto* before = &before_[first_state(j)];
    auto* after = &after_[first_state(j)];
    if constexpr (kManyStates) {
      return respond(law, before, after, strain);
    } else if constexpr (requires { respond(law, *before, *after, strain, Has{}); }) {
      return respond(law, *before, *after, strain, Has{});
    } else {
      return respond(law, *before, *after, strain);
    }
  }

  /// Whether a joint's axial force is given, and not its axial strain.
  bool axial_is_given(std::size_t j, const JointForces<L, kElastic>& forces) const {
    if (forces.axial.empty() || (kElastic && joints_[j].stretches)) return false;
    bool acts = false;
    for (const S& active : joints_[j].active.at) acts = acts || any(active > constant<S>(0));
    return acts;
  }

  /// The response under the axial force that is given.
  /// @param by_axial  d(moment)/d(axial force) [m]
  template <std::size_t First>
  law::SectionResponse<S> respond_to_axial(std::size_t j, const law::SectionStrain<S>& strain,
                                           const S& axial, typename L::Spin& by_axial) {
    const SectionJoint<L>& joint = joints_[j];
    double tolerance = 1e-13;
    if constexpr (requires { Law::kForceTolerance; }) tolerance = Law::kForceTolerance;
    const auto found = law::respond_to_force(
        [&](const law::SectionStrain<S>& at) { return respond_to<law::AllComponents>(j, at); },
        strain, axial, axial_before_[j], joint.stiffness[kAxial], joint.axial_yield, tolerance);
    axial_after_[j] = found.after;
    this->overloaded_ = this->overloaded_ || any(!found.carries);
    for (std::size_t k = 0; k < kR; ++k) by_axial[k] = joint.active[k] * found.by_force[First + k];
    return found.section;
  }

  /// Slope that a joint of an elastic stiffness per length keeps for Newton's method when its law
  /// has none: where all joints of a bar yield at once without hardening, their fractions of a
  /// prescribed rotation would be undetermined (with float, nothing but rounding). What has
  /// converged does not know of it, and a step is off by this fraction.
  static S rest_of(const S& stiffness, const S& length) {
    return constant<S>(kIsDouble<S> ? 1e-9 : 1e-4) * stiffness / length;
  }

  /// @tparam First  number of the first rotation's strain
  template <std::size_t First>
  void evaluate_joint(std::size_t j, const typename L::Spin& angle, const typename L::Point& shift,
                      JointForces<L, kElastic>& forces) {
    const SectionJoint<L>& joint = joints_[j];
    const Scale& scale = scales_[j];
    law::SectionStrain<S> strain;
    for (std::size_t k = 0; k < kR; ++k) {
      strain[First + k] = joint.active[k] * angle[k] * scale.per_length[First + k];
    }
    if constexpr (kElastic) {
      strain[kAxial] = shift[SectionAxes<L>::kAxialShift] * scale.per_length[kAxial];
    }
    typename L::Spin by_axial;
    const bool axial_given = kSeesAxial && axial_is_given(j, forces);
    const law::SectionResponse<S> now = [&] {
      if constexpr (kSeesAxial) {
        if (axial_given) return respond_to_axial<First>(j, strain, forces.axial[j], by_axial);
      }
      return respond_to<law::Components<First, kR, kElastic>>(j, strain);
    }();
    force_[j] = now.force;
    if constexpr (kSeesAside) aside_[j] = now.tangent(1 - First, 1 - First);
    const S energy_length = joint.length[First];
    elastic_[j] = energy_length * now.elastic_energy;
    work_[j] = energy_length * now.plastic_work;
    if constexpr (kR > 1 || kElastic) {
      if (!excess_.empty()) add_uneven<First>(j, strain, now, axial_given);
    }

    typename L::Spin moment;
    Mat<S, kR, kR> slope;
    for (std::size_t k = 0; k < kR; ++k) {
      const S sprung = joint.spring[k] * angle[k];
      moment[k] = joint.active[k] * now.force[First + k] + sprung;
      elastic_[j] = elastic_[j] + constant<S>(0.5) * sprung * angle[k];
      for (std::size_t m = 0; m < kR; ++m) {
        slope(k, m) = joint.active[k] * joint.active[m] * now.tangent(First + k, First + m) *
                      scale.per_length[First + m];
      }
      slope(k, k) = slope(k, k) + scale.rest[k];
    }
    // The map from d angle to the spins that the chain works with; see rotation.hpp.
    Mat<S, kR, kR> to_angle = identity<S, kR>();
    if constexpr (kR == 3) {
      const RotationCoefficients<S> k(dot(angle, angle));
      to_angle = inverse_tangent_map(angle, k);
      slope = (transpose(to_angle) * slope + moment_slope(angle, moment, k)) * to_angle;
      moment = transposed_times(to_angle, moment);
    }
    if constexpr (kSeesAxial) {
      if (!forces.by_axial.empty()) forces.by_axial[j] = transposed_times(to_angle, by_axial);
    }
    Vec<S, kJ>& force = forces.force[j];
    Mat<S, kJ, kJ>& tangent = forces.tangent[j];
    if constexpr (kElastic) tangent = {};  // has what a scheme added, where the law has nothing
    for (std::size_t k = 0; k < kR; ++k) {
      force[k] = moment[k];
      for (std::size_t m = 0; m < kR; ++m) tangent(k, m) = slope(k, m);
    }
    if constexpr (kElastic) {
      add_shifts<First>(shift, now, to_angle, j, force, tangent);
    }
  }

  /// Whether joints have components of another length than the first one.
  void find_uneven() {
    std::vector<law::SectionStrain<S>> excess(joints_.size());
    bool uneven = false;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const auto& length = joints_[j].length;
      const auto add = [&](std::size_t axis) {
        excess[j][axis] = length[axis] - length[axes_.rotation(0)];
        uneven = uneven || any(abs(excess[j][axis]) > constant<S>(0));
      };
      for (std::size_t k = 1; k < kR; ++k) add(axes_.rotation(k));
      if constexpr (kElastic) add(kAxial);
    }
    if (!uneven) return;
    excess_ = std::move(excess);
    uneven_before_.resize(joints_.size());
    uneven_after_.resize(joints_.size());
  }

  /// Adds what components do that are longer than the first: uneven_flow.hpp.
  /// @param axial_given  the axial force does no work here, and its strain is not in `strain`
  template <std::size_t First>
  void add_uneven(std::size_t j, const law::SectionStrain<S>& strain,
                  const law::SectionResponse<S>& now, bool axial_given) {
    std::array<std::size_t, kR + 1> seen{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < kR; ++k) seen[count++] = First + k;
    if (kElastic && !axial_given) seen[count++] = kAxial;
    const std::span<const std::size_t> components(seen.data(), count);
    const auto& stiffness = joints_[j].stiffness;
    const auto& excess = excess_[j];
    for (const std::size_t k : components) {
      elastic_[j] = elastic_[j] + excess[k] * energy_of(now.force[k], stiffness[k]);
    }
    if constexpr (!std::is_empty_v<typename Law::State>) {
      uneven_after_[j] = uneven_state(strain, now, stiffness, components);
      work_[j] =
          work_[j] + uneven_work<law::kIsPerAxis<Law>>(excess, uneven_before_[j], uneven_after_[j],
                                                       now, stiffness, components);
    }
  }

  template <std::size_t First>
  void add_shifts(const typename L::Point& shift, const law::SectionResponse<S>& now,
                  const Mat<S, kR, kR>& to_angle, std::size_t j, Vec<S, kJ>& force,
                  Mat<S, kJ, kJ>& tangent) {
    constexpr std::size_t kAlong = SectionAxes<L>::kAxialShift;
    const SectionJoint<L>& joint = joints_[j];
    const Scale& scale = scales_[j];
    for (std::size_t k = 0; k < kT; ++k) {
      const S shear = joint.shear_stiffness[k] * scale.per_length[kAxial];
      const bool along = k == kAlong;
      force[kR + k] = along ? now.force[kAxial] : shear * shift[k];
      const S stretch = now.tangent(kAxial, kAxial) * scale.per_length[kAxial] + scale.axial_rest;
      tangent(kR + k, kR + k) = along ? stretch : shear;
      if (!along) {
        elastic_[j] = elastic_[j] + constant<S>(0.5) * shear * shift[k] * shift[k];
      }
    }
    // Axial force and bending yield together.
    for (std::size_t k = 0; k < kR; ++k) {
      S down = constant<S>(0);
      S right = constant<S>(0);
      for (std::size_t m = 0; m < kR; ++m) {
        const S part = joint.active[m] * to_angle(m, k);
        down = down + part * now.tangent(First + m, kAxial) * scale.per_length[kAxial];
        right = right + part * now.tangent(kAxial, First + m) * scale.per_length[First + m];
      }
      tangent(k, kR + kAlong) = down;
      tangent(kR + kAlong, k) = right;
    }
  }

  SectionAxes<L> axes_;
  std::vector<Law> laws_;
  [[no_unique_address]] std::conditional_t<kManyStates, ManyStates, OneState> states_;
  std::vector<Scale> scales_;                        ///< (joints)
  std::vector<typename Law::State> before_, after_;  ///< (states of all joints)
  /// Where any component has another length than the first: by how much [m], and what has flowed,
  /// committed and of the last trial (joints); else empty.
  std::vector<law::SectionStrain<S>> excess_;
  std::vector<UnevenState<S>> uneven_before_, uneven_after_;
  std::vector<law::AxialState<S>> axial_before_;  ///< as `axial_after_` (joints)
};

}  // namespace plastica::chain
