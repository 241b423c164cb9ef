#pragma once

#include <cstddef>
#include <type_traits>

#include "plastica/base/always_inline.hpp"
#include "plastica/lanes/entry.hpp"
#include "plastica/law/ideal_plastic.hpp"
#include "plastica/law/plastic_work.hpp"

/// A component of a joint: the angle of a planar one, each component of the rotation vector of one
/// in space. It is an ideal plastic law between angle and moment (law/ideal_plastic.hpp, with
/// [rad], [N m] for strain and stress) with a damper beside it.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// Energy lost in a step and those before [J].
template <class S>
struct Losses {
  S damping, numerical_dissipation;
};

/// A component's moment without the acceleration of the step, and how much it resists that.
template <class S>
struct ComponentMoment {
  S moment, resistance;
};

/// @tparam kOrder   1: linearly implicit Euler; 2: linearly implicit midpoint
/// @tparam kYields  whether components yield at their cap
/// @tparam Kind     entry of PlanarKind or SpatialKind
/// @tparam State    entry of PlanarState or SpatialState; where it has an AngleRate, order 2 has
///                  numerical dissipation
template <class S, int kOrder, bool kYields, class Kind, class State>
class JointComponents {
 public:
  PLASTICA_ALWAYS_INLINE explicit JointComponents(double step)
      : h_(constant<S>(step)),
        to_force_(constant<S>(kOrder == 2 ? 0.5 * step : step)),
        dissipating_(constant<S>(0.5 * kDissipation * step)) {}

  /// @param rate  of the angle at the step's begin [rad/s]
  PLASTICA_ALWAYS_INLINE ComponentMoment<S> moment(const Kind& kind, const State& state,
                                                   const S& rate, std::size_t k) const {
    const Law law = law_of(kind, k);
    const S angle = state.get(At::Angle + k);
    const S damping = kind.get(Of::Damping + k);
    ComponentMoment<S> joint;
    S slope = law.stiffness;
    if constexpr (kYields) {
      const PlasticState before = plastic_state(state, k);
      const auto foretold = respond(law, before, S(h_ * rate + angle));
      slope = slope_of(law, foretold.tangent);
      const S begin = law.stiffness * (angle - before.plastic);
      joint.moment =
          kOrder == 2 ? S(constant<S>(-0.5) * (begin + foretold.stress)) : -foretold.stress;
    } else {
      joint.moment = -(law.stiffness * (to_force_ * rate + angle));
    }
    if constexpr (kDissipates) {
      const S change = rate - state.get(At::AngleRate + k);
      joint.moment -= dissipating_ * slope * change;
      slope = constant<S>(1.0 + kDissipation) * slope;
    }
    joint.moment -= damping * rate;
    joint.resistance = to_force_ * (to_force_ * slope + damping);
    return joint;
  }

  /// Counts what a step has dissipated; lets what is beyond the cap flow.
  /// @param rate  mean of the angle's [rad/s]
  PLASTICA_ALWAYS_INLINE void settle(const Kind& kind, const State& state, std::size_t k,
                                     const S& angle_before, const S& angle, const S& rate,
                                     Losses<S>& losses) const {
    const Law law = law_of(kind, k);
    const S increment = angle - angle_before;
    losses.damping += kind.get(Of::Damping + k) * h_ * rate * rate;
    S slope = law.stiffness;
    if constexpr (kYields) {
      const PlasticState before = plastic_state(state, k);
      const auto now = respond(law, before, angle);
      slope = slope_of(law, now.tangent);
      state.set(At::Plastic + k, now.state.plastic);
      state.set(At::Accumulated + k, now.state.accumulated);
      // What the scheme's moment did beyond the plastic work and the elastic energy.
      const S half = constant<S>(0.5);
      const S elastic_before = angle_before - before.plastic;
      const S moment_before = law.stiffness * elastic_before;
      const S mean = kOrder == 2 ? S(half * (moment_before + now.stress)) : now.stress;
      const S stored =
          half * (now.stress * (angle - now.state.plastic) - moment_before * elastic_before);
      losses.numerical_dissipation +=
          mean * increment - stored - law::plastic_work(law, before, now);
    } else if constexpr (kOrder == 1) {
      losses.numerical_dissipation += constant<S>(0.5) * slope * increment * increment;
    }
    if constexpr (kDissipates) {
      const S change = rate - state.get(At::AngleRate + k);
      losses.numerical_dissipation += dissipating_ * slope * change * increment;
    }
  }

 private:
  using Of = typename Kind::Fields;
  using At = typename State::Fields;
  using Law = law::IdealPlastic<S>;
  using PlasticState = typename Law::State;

  PLASTICA_ALWAYS_INLINE static Law law_of(const Kind& kind, std::size_t k) {
    return {kind.get(Of::Stiffness + k), kind.get(Of::Compliance + k), kind.get(Of::Cap + k)};
  }
  PLASTICA_ALWAYS_INLINE static PlasticState plastic_state(const State& state, std::size_t k) {
    return {state.get(At::Plastic + k), state.get(At::Accumulated + k)};
  }
  PLASTICA_ALWAYS_INLINE static S slope_of(const Law& law, const S& tangent) {
    return max(tangent, constant<S>(kRestOfSlope) * law.stiffness);
  }

  /// Fraction of the elastic slope that a yielding component keeps, so that a beam whose joints all
  /// yield without inertia to speak of still has a step.
  static constexpr double kRestOfSlope = sizeof(real_t<S>) == 8 ? 1e-9 : 1e-4;

  static constexpr bool kDissipates = kOrder == 2 && requires { At::AngleRate; };
  /// What of half a step's change of the angle's mean rate, times the step, order 2 in space adds
  /// to the mean angle: an error of second order like the midpoint's own, with which what rings
  /// faster than the step dies out. Without it that lives on, and where bending and twist meet, it
  /// grows: the turning of the moments with the segments is explicit (README.md).
  static constexpr double kDissipation = 0.1;

  S h_;
  S to_force_;     ///< the step of which a joint's angle by the rate, and the rate by the
                   ///< acceleration, is taken for the moment
  S dissipating_;  ///< by which a change of the angle's rate counts as angle
};

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
