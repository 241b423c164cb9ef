#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "plastica/chain/section_joints.hpp"

/// Joint moments of a step that keeps energy.
namespace plastica::solve {

/// What a joint did before a step, and does now, in its own coordinates: angles, then shifts.
template <class L, bool kElastic>
struct JointStep {
  static constexpr std::size_t kJ = chain::kFreedoms<L, kElastic>;
  using S = typename L::Scalar;
  using Vector = Vec<S, kJ>;
  typename L::Spin angle_before, angle_now;
  Vector stress_before, stress_now;  ///< conjugate to the coordinates
  Vector step;                       ///< Cayley's spin in the axes of the inner side, and shifts
  Vector stiffness;                  ///< elastic, of each coordinate
  S energy;                          ///< stored and dissipated in the step
};

template <class L, bool kElastic>
struct MeanMoment {
  static constexpr std::size_t kJ = chain::kFreedoms<L, kElastic>;
  using S = typename L::Scalar;
  Vec<S, kJ> force;
  Mat<S, kJ, kJ> tangent;
};

/// The part of the elastic angle below which a step is too small to be corrected: there the
/// correction is below 1e-10 of the stored energy, and its rounding above 1e-11 of the moment (of
/// float 3e-5 and 2e-5).
template <class S>
inline constexpr double kMinStep = kIsDouble<S> ? 1e-5 : 5e-3;

/// Generalized forces m that work on a step just what a joint stores and dissipates in it:
/// m . step = energy. The mean of both ends does that for a linear law; what yields, or turns in
/// space, gets the rest along its stiffness times the step (the discrete gradient of Gonzalez, J.
/// Nonlinear Sci. 6, 1996, 449):
///   m = m0 + kappa K step, kappa = (energy - m0 . step)/(step . K step).
/// @param end   of the law at the step's end, as it works on spins and shifts
/// @param slope of `end`
/// @param slopes  whether the whole tangent is asked for, else the part without the discrete
/// gradient
template <class L, bool kElastic>
MeanMoment<L, kElastic> mean_moment(
    const JointStep<L, kElastic>& joint,
    const Vec<typename L::Scalar, chain::kFreedoms<L, kElastic>>& end,
    const Mat<typename L::Scalar, chain::kFreedoms<L, kElastic>, chain::kFreedoms<L, kElastic>>&
        slope,
    bool slopes = true) {
  using S = typename L::Scalar;
  constexpr std::size_t kR = L::kRotations;
  constexpr std::size_t kJ = chain::kFreedoms<L, kElastic>;
  const S half = constant<S>(0.5);
  const S zero = constant<S>(0);
  const S one = constant<S>(1);
  Vec<S, kJ> mean = half * (joint.stress_before + joint.stress_now);
  if constexpr (kR == 3) {
    const Vec<S, 3> angle = half * (joint.angle_before + joint.angle_now);
    const auto to_angle =
        chain::inverse_tangent_map(angle, chain::RotationCoefficients<S>(dot(angle, angle)));
    const Vec<S, 3> moment = transposed_times(to_angle, Vec<S, 3>{{mean[0], mean[1], mean[2]}});
    for (std::size_t k = 0; k < 3; ++k) mean[k] = moment[k];
  }
  MeanMoment<L, kElastic> result{mean, half * slope};

  Vec<S, kJ> elastic;
  for (std::size_t k = 0; k < kJ; ++k) elastic[k] = joint.stiffness[k] * joint.step[k];
  const S size = dot(joint.step, elastic);
  S stored = zero;  // twice the elastic energy
  for (std::size_t k = 0; k < kJ; ++k) {
    const S stress = max(abs(joint.stress_before[k]), abs(joint.stress_now[k]));
    const auto resists = joint.stiffness[k] > zero;
    stored =
        stored + select(resists, stress * stress / select(resists, joint.stiffness[k], one), zero);
  }
  const auto corrected = size > constant<S>(kMinStep<S> * kMinStep<S>) * stored;
  if (!any(corrected)) return result;
  const S divisor = select(corrected, size, one);
  const S kappa = select(corrected, (joint.energy - dot(mean, joint.step)) / divisor, zero);
  result.force += kappa * elastic;
  if (!slopes) return result;
  // d(energy) = end . d(step); d(step) is taken for that of the end.
  Vec<S, kJ> by = end - mean - transposed_times(result.tangent, joint.step);
  by -= (constant<S>(2) * kappa) * elastic;
  const S scale = select(corrected, one / divisor, zero);
  result.tangent += outer(scale * elastic, by);
  for (std::size_t k = 0; k < kJ; ++k) {
    result.tangent(k, k) = result.tangent(k, k) + kappa * joint.stiffness[k];
  }
  return result;
}

}  // namespace plastica::solve
