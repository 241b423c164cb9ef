#pragma once

#include <cstddef>

#include "plastica/base/always_inline.hpp"
#include "plastica/lanes/spatial_beam.hpp"
#include "plastica/lanes/spatial_body.hpp"
#include "plastica/lanes/spatial_joint.hpp"
#include "plastica/lanes/spatial_turn.hpp"

/// Steps of straight spatial beams that are held at their start alone, W at a time, as
/// planar_step.hpp. README.md derives it.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// The steps of one beam, or of as many as S has lanes.
/// @tparam kStride  lanes of the beams' memory
/// @tparam kOrder   1: linearly implicit Euler; 2: linearly implicit midpoint
/// @tparam kYields  whether joints yield at their caps
template <class S, std::size_t kStride, int kOrder, bool kYields>
class SpatialSteps {
 public:
  using Real = real_t<S>;
  using Kind = ConstantEntry<S, SpatialKind, kStride>;
  using Load = ConstantEntry<S, SpatialLoad, kStride>;
  using State = Entry<S, SpatialState, kStride>;
  using Work = Entry<S, SpatialWork, kStride>;
  using Vector = Triple<S>;

  PLASTICA_ALWAYS_INLINE SpatialSteps(const SpatialBeam<Real>& beam, double step)
      : beam_(beam),
        h_(constant<S>(step)),
        ahead_(constant<S>(kOrder == 2 ? 0.5 * step : 0.0)),
        joints_(step) {}

  /// Looks from the state where the forces of a step act.
  [[gnu::noinline]] void aim() const {
    Aim aim = begin();
    for (std::size_t i = 0; i < beam_.segments; ++i) {
      const State state(beam_.state, i);
      aim.spin = aim.spin + get_triple(state, SpatialState::Rate);
      aim_segment(i, get_triple(state, SpatialState::Angle),
                  get_triple(state, SpatialState::AngleRate),
                  get_triple(state, SpatialState::Turning), aim);
    }
  }

  PLASTICA_ALWAYS_INLINE void step() const {
    inward();
    outward();
  }

 private:
  /// A segment at the end of a step and, by its frame, where the next step's forces act.
  struct Aim {
    Quaternion<S> frame;
    Columns<S> axes;
    Vector spin;
  };
  PLASTICA_ALWAYS_INLINE static Aim begin() {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const Vector none{zero, zero, zero};
    return {{one, none}, {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}, none};
  }

  /// @param aim  its frame and axes: of the inner neighbour, then of the segment
  PLASTICA_ALWAYS_INLINE void aim_segment(std::size_t i, const Vector& angle,
                                          const Vector& angle_rate, const Vector& turning,
                                          Aim& aim) const {
    const Work work(beam_.work, i);
    const JointTurn<S> turn =
        joint_turn(kOrder == 2 ? scale_add(ahead_, angle_rate, angle) : angle);
    const Columns<S> rows = angle_rate_rows(turn, aim.axes);
    set_columns(work, SpatialWork::AngleX, rows);
    aim.frame = aim.frame.then(turn);
    aim.axes = aim.frame.axes();
    set_triple(work, SpatialWork::AxisY, aim.axes.y);
    set_triple(work, SpatialWork::AxisZ, aim.axes.z);
    set_triple(work, SpatialWork::Spin, scale_add(ahead_, turning, aim.spin));
  }

  /// Takes what a joint answers.
  struct Sink {
    Work work;

    PLASTICA_ALWAYS_INLINE void given(const Vector& v) const {
      set_triple(work, SpatialWork::Given, v);
    }
    PLASTICA_ALWAYS_INLINE void by_turning(std::size_t column, const Vector& v) const {
      set_triple(work, SpatialWork::ByTurning + 3 * column, v);
    }
    PLASTICA_ALWAYS_INLINE void by_acceleration(std::size_t column, const Vector& v) const {
      set_triple(work, SpatialWork::ByAcceleration + 3 * column, v);
    }
  };

  /// From the free end to the start: what each body, with all outside of it, asks of its joint.
  PLASTICA_ALWAYS_INLINE void inward() const {
    SpatialBody<S> body = SpatialBody<S>::none();
    for (std::size_t i = beam_.segments; i-- > 0;) {
      const Kind kind(beam_.kinds, beam_.kind[i]);
      const Work work(beam_.work, i);
      const Vector z = get_triple(work, SpatialWork::AxisZ);
      const Vector spin = get_triple(work, SpatialWork::Spin);
      const Vector pull = centripetal(spin, z);
      const S length = kind.get(SpatialKind::Length);
      body.carry(length * z, length * pull);
      add_segment(kind, Load(beam_.loads, beam_.load[i]), z, get_triple(work, SpatialWork::AxisY),
                  spin, pull, body);
      const JointMoment<S> joint =
          joints_.moment(kind, State(beam_.state, i), get_columns(work, SpatialWork::AngleX));
      body.release(joint, kind.get(SpatialKind::Free), Sink{work});
    }
  }

  /// w x (w x z).
  PLASTICA_ALWAYS_INLINE static Vector centripetal(const Vector& w, const Vector& z) {
    return scale_add(dot(w, z), w, -dot(w, w) * z);
  }

  /// Its inertia is Ix + (Iy - Ix) y y^T + (Iz - Ix) z z^T, of which only the last two have a
  /// gyroscopic moment.
  PLASTICA_ALWAYS_INLINE static void add_segment(const Kind& kind, const Load& load,
                                                 const Vector& z, const Vector& y,
                                                 const Vector& spin, const Vector& pull,
                                                 SpatialBody<S>& a) {
    const S across = kind.get(SpatialKind::Inertia);
    const S more_y = kind.get(SpatialKind::Inertia + 1) - across;
    const S more_z = kind.get(SpatialKind::Inertia + 2) - across;
    a.rr = square_add(more_y, y, square_add(more_z, z, a.rr));
    a.rr.xx = a.rr.xx + across;
    a.rr.yy = a.rr.yy + across;
    a.rr.zz = a.rr.zz + across;
    const Vector momentum = scale_add(more_y * dot(spin, y), y, (more_z * dot(spin, z)) * z);
    const Vector moment =
        cross_add(z, get_triple(load, SpatialLoad::Lever), get_triple(load, SpatialLoad::Moment));
    a.r = cross_add(spin, momentum, a.r - moment);
    const S first = kind.get(SpatialKind::FirstMoment);
    const S mass = kind.get(SpatialKind::Mass);
    const Vector arm = first * z;
    a.rt.x.y = a.rt.x.y + arm.z;
    a.rt.x.z = a.rt.x.z - arm.y;
    a.rt.y.x = a.rt.y.x - arm.z;
    a.rt.y.z = a.rt.y.z + arm.x;
    a.rt.z.x = a.rt.z.x + arm.y;
    a.rt.z.y = a.rt.z.y - arm.x;
    a.tt.xx = a.tt.xx + mass;
    a.tt.yy = a.tt.yy + mass;
    a.tt.zz = a.tt.zz + mass;
    a.t = scale_add(first, pull, a.t - get_triple(load, SpatialLoad::Force));
  }

  /// From the start to the free end: accelerations, and the state at the end of the step.
  PLASTICA_ALWAYS_INLINE void outward() const {
    Entry<S, SpatialSums, kStride> sums(beam_.sums, 0);
    Losses<S> losses{sums.get(SpatialSums::Damping), sums.get(SpatialSums::Numerical)};
    S fastest = constant<S>(0);
    S largest = constant<S>(0);
    S loads = sums.get(SpatialSums::Loads);
    Aim aim = begin();
    Vector turning = aim.spin, acceleration = aim.spin;
    Vector free = aim.spin;  // without what spins pull
    Vector mean_spin = aim.spin, velocity = aim.spin;
    for (std::size_t i = 0; i < beam_.segments; ++i) {
      const Kind kind(beam_.kinds, beam_.kind[i]);
      const State state(beam_.state, i);
      const Work work(beam_.work, i);
      const Vector joint =
          columns_add(get_columns(work, SpatialWork::ByTurning), -turning,
                      columns_add(get_columns(work, SpatialWork::ByAcceleration), -acceleration,
                                  get_triple(work, SpatialWork::Given)));
      turning = turning + joint;
      const Vector rate_before = get_triple(state, SpatialState::Rate);
      const Vector rate = scale_add(h_, joint, rate_before);
      const Vector mean = kOrder == 2 ? constant<S>(0.5) * (rate_before + rate) : rate;
      const Vector angle_before = get_triple(state, SpatialState::Angle);
      const Vector angle_rate = rows_times(get_columns(work, SpatialWork::AngleX), mean);
      const Vector angle = scale_add(h_, angle_rate, angle_before);
      set_triple(state, SpatialState::Rate, rate);
      set_triple(state, SpatialState::Angle, angle);
      set_triple(state, SpatialState::Turning, turning);
      joints_.settle(kind, state, angle_before, angle, angle_rate, losses);
      set_triple(state, SpatialState::AngleRate, angle_rate);
      const Vector z = get_triple(work, SpatialWork::AxisZ);
      const Vector y = get_triple(work, SpatialWork::AxisY);
      const Vector spin_there = get_triple(work, SpatialWork::Spin);
      if constexpr (kOrder == 1) {
        losses.numerical = losses.numerical + lost(kind, z, y, turning, free);
      }
      aim.spin = aim.spin + rate;
      fastest = max(fastest, dot(aim.spin, aim.spin));
      largest = max(largest, dot(angle, angle));
      aim_segment(i, angle, angle_rate, turning, aim);
      const S length = kind.get(SpatialKind::Length);
      const Vector e = length * z;
      if (beam_.counts_loads) {
        mean_spin = mean_spin + mean;
        loads = multiply_add(h_, power(Load(beam_.loads, beam_.load[i]), z, mean_spin, velocity),
                             loads);
        velocity = cross_add(mean_spin, e, velocity);
      }
      acceleration =
          cross_add(turning, e, scale_add(length, centripetal(spin_there, z), acceleration));
      if constexpr (kOrder == 1) free = cross_add(turning, e, free);
    }
    sums.set(SpatialSums::Damping, losses.damping);
    sums.set(SpatialSums::Numerical, losses.numerical);
    sums.set(SpatialSums::Loads, loads);
    sums.set(SpatialSums::FastestSpin, max(sums.get(SpatialSums::FastestSpin), sqrt(fastest)));
    sums.set(SpatialSums::LargestAngle, max(sums.get(SpatialSums::LargestAngle), sqrt(largest)));
  }

  PLASTICA_ALWAYS_INLINE static S power(const Load& load, const Vector& z, const Vector& spin,
                                        const Vector& velocity) {
    const Vector moment =
        cross_add(z, get_triple(load, SpatialLoad::Lever), get_triple(load, SpatialLoad::Moment));
    return dot_add(get_triple(load, SpatialLoad::Force), velocity, dot(moment, spin));
  }

  /// What Euler's rule loses of a segment's kinetic energy in a step: half of h^2 times the
  /// product of its inertia with the squares of its accelerations.
  PLASTICA_ALWAYS_INLINE S lost(const Kind& kind, const Vector& z, const Vector& y,
                                const Vector& turning, const Vector& free) const {
    const S across = kind.get(SpatialKind::Inertia);
    const S by_y = dot(y, turning);
    const S by_z = dot(z, turning);
    const S spun =
        multiply_add(across, dot(turning, turning),
                     multiply_add((kind.get(SpatialKind::Inertia + 1) - across) * by_y, by_y,
                                  (kind.get(SpatialKind::Inertia + 2) - across) * by_z * by_z));
    const S mixed =
        constant<S>(2) * kind.get(SpatialKind::FirstMoment) * dot(turning, cross(z, free));
    return constant<S>(0.5) * h_ * h_ *
           (multiply_add(kind.get(SpatialKind::Mass), dot(free, free), spun) + mixed);
  }

  const SpatialBeam<Real>& beam_;
  S h_;
  S ahead_;  ///< from the begin of a step to where its geometry is taken
  SpatialJoints<S, kStride, kOrder, kYields> joints_;
};

/// `steps` steps of one length.
/// @param aimed  whether the step before had the same length and left off here
template <class S, std::size_t kStride, int kOrder, bool kYields>
[[gnu::noinline]] void spatial_steps_of(const SpatialBeam<real_t<S>>& beam, double step,
                                        std::size_t steps, bool aimed) {
  const SpatialSteps<S, kStride, kOrder, kYields> kernel(beam, step);
  if (!aimed) kernel.aim();
  for (std::size_t k = 0; k < steps; ++k) kernel.step();
}

/// The same of kStride beams, as many together as a register holds: a body alone fills most of the
/// registers there are.
template <class Real, std::size_t kStride, int kOrder, bool kYields>
void spatial_steps(const SpatialBeam<Real>& beam, double step, std::size_t steps, bool aimed) {
  if constexpr (kStride == 1) {
    spatial_steps_of<Real, 1, kOrder, kYields>(beam, step, steps, aimed);
  } else {
    constexpr std::size_t kTogether = plastica::detail::kRegisterBytes / sizeof(Real);
    using S = Pack<Real, static_cast<int>(kTogether)>;
    for (std::size_t lane = 0; lane < kStride; lane += kTogether) {
      SpatialBeam<Real> part = beam;
      part.kinds += lane;
      part.loads += lane;
      part.state += lane;
      part.work += lane;
      part.sums += lane;
      spatial_steps_of<S, kStride, kOrder, kYields>(part, step, steps, aimed);
    }
  }
}

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
