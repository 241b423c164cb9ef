#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "plastica/solve/mean_moments.hpp"
#include "plastica/solve/motion_options.hpp"
#include "plastica/solve/scheme.hpp"

/// The joints of a chain in a step: their laws, as the scheme takes them, and their damping.
namespace plastica::solve {

template <class L, bool kElastic>
class JointMotion {
 public:
  using S = typename L::Scalar;
  static constexpr std::size_t kR = L::kRotations;
  static constexpr std::size_t kT = L::kTranslations;
  static constexpr std::size_t kJ = chain::kFreedoms<L, kElastic>;
  using Joints = chain::SectionJointsBase<L, kElastic>;
  using Forces = chain::JointForces<L, kElastic>;
  using Vector = Vec<S, kJ>;
  using Matrix = Mat<S, kJ, kJ>;

  /// @param axes      of the sections, as the laws number them
  /// @param segments  each has a joint; those behind are to the ground
  JointMotion(const Joints& joints, chain::SectionAxes<L> axes, std::size_t segments)
      : joints_(&joints), axes_(axes), segments_(segments) {
    for (const auto& joint : joints.joints()) stiffness_.push_back(stiffness_of(joint));
    const std::size_t n = stiffness_.size();
    angle_.resize(n);
    rotation_.resize(n);
    rotation_now_.resize(n);
    shift_.resize(n);
    stress_.resize(n);
    stored_.resize(n);
    step_.resize(n);
    law_.resize(n);
    law_before_.resize(n);
    damped_.resize(n);
    damped_before_.resize(n);
    rate_.resize(n);
    rate_before_.resize(n);
  }

  /// Takes what the laws have just said as the state before a step.
  void begin(std::span<const typename L::Spin> angles, std::span<const typename L::Point> shifts,
             const Forces& forces) {
    for (std::size_t j = 0; j < stiffness_.size(); ++j) {
      angle_[j] = angles[j];
      rotation_[j] = rotation_now_[j] = L::rotation(angle_[j]);
      shift_[j] = shift_of(shifts, j);
      stress_[j] = stress(j, angles[j], shift_[j]);
      stored_[j] = joints_->elastic_energy()[j];
      law_before_[j] = forces.force[j];
      damped_before_[j] = {};
    }
    length_before_ = 0.0;
  }

  /// By its angle at the step's end.
  void note_rotation(std::size_t joint, const typename L::Frame& rotation) {
    rotation_now_[joint] = rotation;
  }

  /// Turns what the laws say of the end of a step into what the scheme takes of it, and adds
  /// damping. To be called when `note_rotation` has been told of each joint of a segment.
  /// @param spins   of the joints at the end [rad/s]; empty: see `damp` (joints)
  /// @param slopes  whether tangents are asked for, too
  /// @param forces  of the laws at the end; replaced
  void take(const MotionOptions& options, const StepRule& rule, double h,
            std::span<const typename L::Spin> angles, std::span<const typename L::Point> shifts,
            std::span<const typename L::Spin> spins, bool slopes, Forces& forces) {
    length_ = h;
    for (std::size_t j = segments_; j < stiffness_.size(); ++j) {
      rotation_now_[j] = L::rotation(angles[j]);
    }
    for (std::size_t j = 0; j < stiffness_.size(); ++j) {
      const typename L::Point shift = shift_of(shifts, j);
      const JointStep<L, kElastic> step = step_of(j, angles[j], shift);
      step_[j] = step.step;
      const Matrix slope = forces.tangent[j];
      if (rule.midpoint) {
        const auto mean = mean_moment<L, kElastic>(step, forces.force[j], slope, slopes);
        forces.force[j] = mean.force;
        forces.tangent[j] = mean.tangent;
      }
      law_[j] = forces.force[j];
      if (options.damping != Damping::None) {
        damp(options, rule, h, j, step, shift, slope, spins.empty() ? nullptr : &spins[j], forces);
      }
    }
  }

  /// Damping of the joints in the step that was taken, and what the scheme's moments did in it
  /// beyond what was stored and dissipated.
  /// @param moves  whether a joint still joins (joints)
  template <class Moves, class E>
  void add_flows(const StepRule& rule, const Moves& moves, EnergyFlowsOf<E>& flows) const {
    for (std::size_t j = 0; j < stiffness_.size(); ++j) {
      if (!moves(j)) continue;
      const S now = constant<S>(rule.end_work);
      const S then = constant<S>(1.0 - rule.end_work);
      flows.damping += dot(now * damped_[j] + then * damped_before_[j], step_[j]);
      flows.numerical_dissipation +=
          dot(now * law_[j] + then * law_before_[j], step_[j]) - energy(j);
    }
  }

  /// The step is over: its end is the next one's begin.
  void commit(std::span<const typename L::Spin> angles, std::span<const typename L::Point> shifts) {
    for (std::size_t j = 0; j < stiffness_.size(); ++j) {
      angle_[j] = angles[j];
      rotation_[j] = rotation_now_[j];
      shift_[j] = shift_of(shifts, j);
      stress_[j] = stress(j, angle_[j], shift_[j]);
      stored_[j] = joints_->elastic_energy()[j];
    }
    std::swap(law_before_, law_);
    std::swap(damped_before_, damped_);
    std::swap(rate_before_, rate_);
    length_before_ = length_;
  }

  /// The rates that damping comes from have jumped: it begins anew, from the joints' spins (shifts
  /// are taken as at rest). The moments of joints that can yield may go no further: by their rates
  /// damping begins from none, of first order in the step.
  /// @param spins  [rad/s]; empty: not known (joints)
  /// @param forces  of the laws; damping is added
  void begin_damping(const MotionOptions& options, std::span<const typename L::Spin> angles,
                     std::span<const typename L::Spin> spins, Forces& forces) {
    length_before_ = 0.0;
    for (std::size_t j = 0; j < stiffness_.size(); ++j) {
      damped_before_[j] = {};
      if (spins.empty() || options.damping == Damping::None) continue;
      const S time = constant<S>(options.damping_time);
      Vec<S, kR> rate;
      for (std::size_t m = 0; m < kR; ++m) rate[m] = spins[j][m];
      if (options.damping == Damping::Relaxation) {
        if (!joints_->is_elastic()) continue;
        for (std::size_t k = 0; k < kJ; ++k) {
          for (std::size_t m = 0; m < kR; ++m)
            damped_before_[j][k] += time * forces.tangent[j](k, m) * rate[m];
        }
      } else {
        Mat<S, kR, kR> to_angle = identity<S, kR>();
        if constexpr (kR == 3) {
          const Vec<S, 3> angle = angles[j];
          to_angle =
              chain::inverse_tangent_map(angle, chain::RotationCoefficients<S>(dot(angle, angle)));
          rate = to_angle * rate;
        }
        for (std::size_t m = 0; m < kR; ++m) rate[m] = time * stiffness_[j][m] * rate[m];
        const Vec<S, kR> moment = transposed_times(to_angle, rate);
        for (std::size_t m = 0; m < kR; ++m) damped_before_[j][m] = moment[m];
      }
      forces.force[j] += damped_before_[j];
    }
  }
  const typename L::Spin& angle_before(std::size_t j) const { return angle_[j]; }

 private:
  static typename L::Point shift_of(std::span<const typename L::Point> shifts, std::size_t j) {
    return kElastic && j < shifts.size() ? shifts[j] : typename L::Point{};
  }

  Vector stiffness_of(const chain::SectionJoint<L>& joint) const {
    Vector k;
    for (std::size_t m = 0; m < kR; ++m) {
      const std::size_t axis = axes_.rotation(m);
      k[m] = joint.rotational_stiffness(m, axis) + joint.spring[m];
    }
    if constexpr (kElastic) {
      constexpr std::size_t kAxial = 3;
      for (std::size_t m = 0; m < kT; ++m) {
        const bool along = m == chain::SectionAxes<L>::kAxialShift;
        k[kR + m] =
            (along ? joint.stiffness[kAxial] : joint.shear_stiffness[m]) / joint.length[kAxial];
      }
    }
    return k;
  }

  /// Conjugate to angles and shifts.
  Vector stress(std::size_t j, const typename L::Spin& angle,
                const typename L::Point& shift) const {
    const chain::SectionJoint<L>& joint = joints_->joints()[j];
    const auto& force = joints_->section_forces()[j];
    Vector s;
    for (std::size_t m = 0; m < kR; ++m) {
      s[m] = joint.active[m] * force[axes_.rotation(m)] + joint.spring[m] * angle[m];
    }
    if constexpr (kElastic) {
      constexpr std::size_t kAxial = 3;
      for (std::size_t m = 0; m < kT; ++m) {
        const bool along = m == chain::SectionAxes<L>::kAxialShift;
        s[kR + m] = along ? force[kAxial] : stiffness_[j][kR + m] * shift[m];
      }
    }
    return s;
  }

  S energy(std::size_t j) const {
    return joints_->elastic_energy()[j] - stored_[j] + joints_->work_increment()[j];
  }

  JointStep<L, kElastic> step_of(std::size_t j, const typename L::Spin& angle,
                                 const typename L::Point& shift) const {
    JointStep<L, kElastic> step;
    step.angle_before = angle_[j];
    step.angle_now = angle;
    step.stress_before = stress_[j];
    step.stress_now = stress(j, angle, shift);
    const typename L::Spin spin = L::step_spin(rotation_[j], rotation_now_[j]);
    for (std::size_t m = 0; m < kR; ++m) step.step[m] = spin[m];
    if constexpr (kElastic) {
      for (std::size_t m = 0; m < kT; ++m) step.step[kR + m] = shift[m] - shift_[j][m];
    }
    step.stiffness = stiffness_[j];
    step.energy = energy(j);
    return step;
  }

  /// Damping takes the mean rate of the step, which is right half way. At the end it would be of
  /// first order in the damping: generalized-alpha knows the angles' rates there, and the moments'
  /// are foretold from the mean ones of this step and the one before.
  /// @param spin  of the joint at the end [rad/s]; null: the mean rate counts
  void damp(const MotionOptions& options, const StepRule& rule, double h, std::size_t j,
            const JointStep<L, kElastic>& step, const typename L::Point& shift, const Matrix& slope,
            const typename L::Spin* spin, Forces& forces) {
    const S per_step = constant<S>(options.damping_time / h);
    Vector stress;
    Matrix tangent;
    const bool of_angles = options.damping == Damping::Stiffness;
    if (of_angles) {
      Vector moved;
      for (std::size_t m = 0; m < kR; ++m) moved[m] = step.angle_now[m] - step.angle_before[m];
      if constexpr (kElastic) {
        for (std::size_t m = 0; m < kT; ++m) moved[kR + m] = shift[m] - shift_[j][m];
      }
      S by_spin = constant<S>(1);
      if (spin != nullptr) {
        const typename L::Spin at_end = L::add_rotation(constant<S>(h) * *spin, step.angle_now);
        for (std::size_t m = 0; m < kR; ++m) moved[m] = at_end[m] - step.angle_now[m];
        by_spin = constant<S>(rule.velocity);
      }
      for (std::size_t m = 0; m < kJ; ++m) {
        stress[m] = per_step * stiffness_[j][m] * moved[m];
        tangent(m, m) = (m < kR ? by_spin : constant<S>(1)) * per_step * stiffness_[j][m];
      }
    } else {
      stress = per_step * (step.stress_now - step.stress_before);
      tangent = per_step * slope;
    }
    if constexpr (kR == 3) to_spins(rule, step, of_angles, stress, tangent);
    if (!of_angles && !rule.conserves) {
      rate_[j] = stress;
      // Half a step from the middle of this one, on the line through both middles.
      const S ahead = constant<S>(length_before_ > 0.0 ? h / (h + length_before_) : 0.0);
      stress += ahead * (stress - rate_before_[j]);
      tangent += ahead * tangent;
    }
    damped_[j] = stress;
    forces.force[j] += stress;
    forces.tangent[j] += tangent;
  }

  /// Stresses of angles as they work on spins; where the tangent is of angles, it, too.
  static void to_spins(const StepRule& rule, const JointStep<L, kElastic>& step, bool of_angles,
                       Vector& stress, Matrix& tangent) {
    const S fraction = constant<S>(rule.midpoint ? 0.5 : 1.0);
    const Vec<S, 3> angle =
        fraction * step.angle_now + (constant<S>(1) - fraction) * step.angle_before;
    const auto to_angle =
        chain::inverse_tangent_map(angle, chain::RotationCoefficients<S>(dot(angle, angle)));
    const Vec<S, 3> moment =
        transposed_times(to_angle, Vec<S, 3>{{stress[0], stress[1], stress[2]}});
    Mat<S, 3, 3> rotational;
    for (std::size_t k = 0; k < 3; ++k) {
      stress[k] = moment[k];
      for (std::size_t m = 0; m < 3; ++m) rotational(k, m) = tangent(k, m);
    }
    if (!of_angles) return;
    rotational = transpose(to_angle) * rotational * to_angle;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t m = 0; m < 3; ++m) tangent(k, m) = rotational(k, m);
    }
  }

  const Joints* joints_;
  chain::SectionAxes<L> axes_;
  std::size_t segments_ = 0;
  std::vector<Vector> stiffness_;                ///< elastic (joints)
  std::vector<typename L::Spin> angle_;          ///< before the step, like the next four (joints)
  std::vector<typename L::Frame> rotation_;      ///< by these angles
  std::vector<typename L::Frame> rotation_now_;  ///< by those at the step's end (joints)
  std::vector<typename L::Point> shift_;
  std::vector<Vector> stress_;
  std::vector<S> stored_;                       ///< elastic energy
  std::vector<Vector> step_;                    ///< of the joint in the step (joints)
  std::vector<Vector> law_, law_before_;        ///< what laws do, as it works on spins
  std::vector<Vector> damped_, damped_before_;  ///< what damping does
  std::vector<Vector> rate_, rate_before_;      ///< of moments, mean, times the damping time
  double length_ = 0.0, length_before_ = 0.0;   ///< of the steps [s]; before: 0, where none was
};

}  // namespace plastica::solve
