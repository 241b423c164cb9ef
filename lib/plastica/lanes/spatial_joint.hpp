#pragma once

#include <cstddef>

#include "plastica/base/always_inline.hpp"
#include "plastica/lanes/spatial_beam.hpp"
#include "plastica/lanes/spatial_body.hpp"

/// Joints of the spatial kernels. The energy is that of three springs along the components of the
/// rotation vector, each of which may yield on its own, so that the moments of the scheme are those
/// of three planar joints; B, the rows that turn a joint's rate into its angle's, brings them to
/// world axes: moment B^T m, resistance B^T diag(k) B. As the angle goes by h B (mean rate), what
/// the moments do in a step is exactly what the springs store.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// Energy lost in a step and those before.
template <class S>
struct Losses {
  S damping, numerical;
};

template <class S, std::size_t kStride, int kOrder, bool kYields>
class SpatialJoints {
 public:
  using Kind = ConstantEntry<S, SpatialKind, kStride>;
  using State = Entry<S, SpatialState, kStride>;
  using Vector = Triple<S>;

  PLASTICA_ALWAYS_INLINE explicit SpatialJoints(double step)
      : h_(constant<S>(step)),
        to_force_(constant<S>(kOrder == 2 ? 0.5 * step : step)),
        calm_(constant<S>(0.5 * kCalm * step)) {}

  /// @param b  rows of B
  PLASTICA_ALWAYS_INLINE JointMoment<S> moment(const Kind& kind, const State& state,
                                               const Columns<S>& b) const {
    const Vector rate = rows_times(b, get_triple(state, SpatialState::Rate));
    const Component x = component(kind, state, rate.x, 0);
    const Component y = component(kind, state, rate.y, 1);
    const Component z = component(kind, state, rate.z, 2);
    const S zero = constant<S>(0);
    const Symmetric<S> none{zero, zero, zero, zero, zero, zero};
    return {columns_times(b, Vector{x.moment, y.moment, z.moment}),
            square_add(x.resistance, b.x,
                       square_add(y.resistance, b.y, square_add(z.resistance, b.z, none)))};
  }

  /// Counts what a step has dissipated; lets what is beyond its cap flow.
  /// @param rate  mean of the angle's
  PLASTICA_ALWAYS_INLINE void settle(const Kind& kind, const State& state, const Vector& before,
                                     const Vector& angle, const Vector& rate,
                                     Losses<S>& losses) const {
    settle_component(kind, state, 0, before.x, angle.x, rate.x, losses);
    settle_component(kind, state, 1, before.y, angle.y, rate.y, losses);
    settle_component(kind, state, 2, before.z, angle.z, rate.z, losses);
  }

 private:
  /// Moment of a component without the acceleration of this step, and how much it resists that.
  struct Component {
    S moment, resistance;
  };
  PLASTICA_ALWAYS_INLINE Component component(const Kind& kind, const State& state, const S& rate,
                                             std::size_t k) const {
    const S angle = state.get(SpatialState::Angle + k);
    const S stiffness = kind.get(SpatialKind::Stiffness + k);
    const S damping = kind.get(SpatialKind::Damping + k);
    Component joint;
    S slope = stiffness;
    if constexpr (kYields) {
      const S plastic = state.get(SpatialState::Plastic + k);
      const S cap = kind.get(SpatialKind::Cap + k);
      const S trial = stiffness * (multiply_add(h_, rate, angle) - plastic);
      const S clipped = min(max(trial, -cap), cap);
      slope = select(abs(trial) > cap, constant<S>(kRestOfSlope) * stiffness, stiffness);
      joint.moment = kOrder == 2
                         ? constant<S>(-0.5) * multiply_add(stiffness, angle - plastic, clipped)
                         : -clipped;
    } else {
      joint.moment = -(stiffness * multiply_add(to_force_, rate, angle));
    }
    if constexpr (kOrder == 2) {
      const S change = rate - state.get(SpatialState::AngleRate + k);
      joint.moment = multiply_add(-(calm_ * slope), change, joint.moment);
      slope = constant<S>(1.0 + kCalm) * slope;
    }
    joint.moment = joint.moment - damping * rate;
    joint.resistance = to_force_ * multiply_add(to_force_, slope, damping);
    return joint;
  }

  PLASTICA_ALWAYS_INLINE void settle_component(const Kind& kind, const State& state, std::size_t k,
                                               const S& before, const S& angle, const S& rate,
                                               Losses<S>& losses) const {
    losses.damping =
        multiply_add(kind.get(SpatialKind::Damping + k) * h_, rate * rate, losses.damping);
    const S turn = angle - before;
    S slope = kind.get(SpatialKind::Stiffness + k);
    if constexpr (kYields) {
      const S trial = slope * (angle - state.get(SpatialState::Plastic + k));
      const S cap = kind.get(SpatialKind::Cap + k);
      slope = select(abs(trial) > cap, constant<S>(kRestOfSlope) * slope, slope);
      flow(kind, state, k, before, angle, losses.numerical);
    } else if constexpr (kOrder == 1) {
      losses.numerical = multiply_add(constant<S>(0.5) * slope, turn * turn, losses.numerical);
    }
    if constexpr (kOrder == 2) {
      const S change = rate - state.get(SpatialState::AngleRate + k);
      losses.numerical = multiply_add(calm_ * slope * change, turn, losses.numerical);
    }
  }

  /// Returns the moment to its cap; adds what the scheme's moment did beyond the plastic work and
  /// the elastic energy.
  PLASTICA_ALWAYS_INLINE static void flow(const Kind& kind, const State& state, std::size_t k,
                                          const S& angle_before, const S& angle, S& numerical) {
    const S stiffness = kind.get(SpatialKind::Stiffness + k);
    const S compliance = kind.get(SpatialKind::Compliance + k);
    const S cap = kind.get(SpatialKind::Cap + k);
    const S before = state.get(SpatialState::Plastic + k);
    const S half = constant<S>(0.5);
    const S trial = stiffness * (angle - before);
    const S moment = min(max(trial, -cap), cap);
    const S flowed = (trial - moment) * compliance;
    const S moment_before = stiffness * (angle_before - before);
    const S mean = kOrder == 2 ? half * (moment_before + moment) : moment;
    const S stored = half * compliance * (moment * moment - moment_before * moment_before);
    state.set(SpatialState::Plastic + k, before + flowed);
    state.set(SpatialState::Accumulated + k,
              state.get(SpatialState::Accumulated + k) + abs(flowed));
    numerical = numerical + (mean * (angle - angle_before) - stored - moment * flowed);
  }

  /// Share of the elastic slope that a yielding component keeps, as a planar joint's.
  static constexpr double kRestOfSlope = sizeof(real_t<S>) == 8 ? 1e-9 : 1e-4;

  /// What of half a step's change of the angle's mean rate, times the step, order 2 adds to the
  /// mean angle: an error of second order like the midpoint's own, with which what rings faster
  /// than the step dies out. Without it that lives on, and where bending and twist meet, it grows:
  /// the turning of the moments with the segments is explicit (README.md).
  static constexpr double kCalm = 0.1;

  S h_;
  S to_force_;  ///< the step of which a joint's angle by the rate, and the rate by the
                ///< acceleration, is taken for the moment
  S calm_;      ///< by which a change of the angle's rate counts as angle
};

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
