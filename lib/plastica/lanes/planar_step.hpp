#pragma once

#include <cstddef>
#include <cstdint>

#include "plastica/base/always_inline.hpp"
#include "plastica/base/pack.hpp"
#include "plastica/base/scalar.hpp"
#include "plastica/base/sine_cosine.hpp"
#include "plastica/lanes/joint_component.hpp"
#include "plastica/lanes/planar_beam.hpp"

/// Steps of planar beams that are held at their start alone, W at a time: the recursion of
/// articulated bodies with joint springs implicit. README.md derives it.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// The steps of one beam (of W).
/// @tparam kOrder   1: linearly implicit Euler; 2: linearly implicit midpoint
/// @tparam kYields  whether joints yield at their cap
template <class S, int kOrder, bool kYields>
class PlanarSteps {
 public:
  using Real = real_t<S>;
  using Kind = ConstantEntry<S, PlanarKind>;
  using Load = ConstantEntry<S, PlanarLoad>;
  using State = Entry<S, PlanarState>;
  using Work = Entry<S, PlanarWork>;

  PLASTICA_ALWAYS_INLINE PlanarSteps(const PlanarBeam<Real>& beam, double step)
      : beam_(beam),
        h_(constant<S>(step)),
        ahead_(constant<S>(kOrder == 2 ? 0.5 * step : 0.0)),
        joints_(step) {}

  /// Looks from the state where the forces of a step act.
  PLASTICA_ALWAYS_INLINE void aim() const {
    S direction = constant<S>(0);
    S spin = constant<S>(0);
    for (std::size_t i = 0; i < beam_.segments; ++i) {
      const State state(beam_.state, i);
      direction = direction + Kind(beam_.kinds, beam_.kind[i]).get(PlanarKind::Rest) +
                  state.get(PlanarState::Angle);
      spin = spin + state.get(PlanarState::Rate);
      aim_segment(i, direction, spin, state.get(PlanarState::Turning));
    }
  }

  PLASTICA_ALWAYS_INLINE void step() const {
    inward();
    outward();
  }

 private:
  /// What acts on a body at its joint: force and moment by its acceleration and without it.
  struct Body {
    S rr, rx, ry, xx, xy, yy;  ///< moment by turning, by x, by y; force likewise (symmetric)
    S r, x, y;                 ///< what is needed without any acceleration
  };

  PLASTICA_ALWAYS_INLINE void aim_segment(std::size_t i, const S& direction, const S& spin,
                                          const S& turning) const {
    const SineCosine<S> at(multiply_add(ahead_, spin, direction));
    const Work work(beam_.work, i);
    work.set(PlanarWork::Cosine, at.cosine);
    work.set(PlanarWork::Sine, at.sine);
    work.set(PlanarWork::Spin, multiply_add(ahead_, turning, spin));
  }

  /// From the free end to the start: what each body, with all outside of it, asks of its joint.
  PLASTICA_ALWAYS_INLINE void inward() const {
    const S zero = constant<S>(0);
    Body a{zero, zero, zero, zero, zero, zero, zero, zero, zero};
    for (std::size_t i = beam_.segments; i-- > 0;) {
      const Kind kind(beam_.kinds, beam_.kind[i]);
      const Work work(beam_.work, i);
      add_segment(kind, Load(beam_.loads, beam_.load[i]), work, a);
      const State state(beam_.state, i);
      ComponentMoment<S> joint = joints_.moment(kind, state, state.get(PlanarState::Rate), 0);
      joint.resistance = joint.resistance + kind.get(PlanarKind::Hold);
      release_joint(joint, work, a);
      if (i > 0) {
        carry_inward(Kind(beam_.kinds, beam_.kind[i - 1]), Work(beam_.work, i - 1), a);
      }
    }
  }

  PLASTICA_ALWAYS_INLINE static void add_segment(const Kind& kind, const Load& load,
                                                 const Work& work, Body& a) {
    const S c = work.get(PlanarWork::Cosine);
    const S s = work.get(PlanarWork::Sine);
    const S spin = work.get(PlanarWork::Spin);
    const S first = kind.get(PlanarKind::FirstMoment);
    const S mass = kind.get(PlanarKind::Mass);
    const S arm_x = first * c;
    const S arm_y = first * s;
    const S pull = spin * spin;
    a.rr = a.rr + kind.get(PlanarKind::Inertia);
    a.rx = a.rx - arm_y;
    a.ry = a.ry + arm_x;
    a.xx = a.xx + mass;
    a.yy = a.yy + mass;
    a.r = a.r - multiply_add(
                    c, load.get(PlanarLoad::LeverY),
                    multiply_add(-s, load.get(PlanarLoad::LeverX), load.get(PlanarLoad::Moment)));
    a.x = a.x - multiply_add(pull, arm_x, load.get(PlanarLoad::ForceX));
    a.y = a.y - multiply_add(pull, arm_y, load.get(PlanarLoad::ForceY));
  }

  /// Eliminates the joint's acceleration. With resistance k and D = rr + k, what is left of rr is
  /// rr - rr^2/D = rr k/D, without a difference of large numbers.
  PLASTICA_ALWAYS_INLINE static void release_joint(const ComponentMoment<S>& joint,
                                                   const Work& work, Body& a) {
    const S inverse = constant<S>(1) / (a.rr + joint.resistance);
    const S by_turning = a.rr * inverse;
    const S by_x = a.rx * inverse;
    const S by_y = a.ry * inverse;
    const S given = (joint.moment - a.r) * inverse;
    work.set(PlanarWork::ByTurning, by_turning);
    work.set(PlanarWork::ByX, by_x);
    work.set(PlanarWork::ByY, by_y);
    work.set(PlanarWork::Given, given);
    const S left = joint.resistance * inverse;
    a.xx = multiply_add(-a.rx, by_x, a.xx);
    a.xy = multiply_add(-a.rx, by_y, a.xy);
    a.yy = multiply_add(-a.ry, by_y, a.yy);
    a.r = multiply_add(a.rr, given, a.r);
    a.x = multiply_add(a.rx, given, a.x);
    a.y = multiply_add(a.ry, given, a.y);
    a.rr = a.rr * left;
    a.rx = a.rx * left;
    a.ry = a.ry * left;
  }

  /// The same about the joint of the inner neighbour: its outer end accelerates with it by
  /// (ex, ey) times its turning and towards its inner end by its spin.
  PLASTICA_ALWAYS_INLINE static void carry_inward(const Kind& inner, const Work& work, Body& a) {
    const S length = inner.get(PlanarKind::Length);
    const S spin = work.get(PlanarWork::Spin);
    const S ex = -(length * work.get(PlanarWork::Sine));
    const S ey = length * work.get(PlanarWork::Cosine);
    const S pull = spin * spin;
    const S px = -(pull * ey);
    const S py = pull * ex;
    a.r = multiply_add(a.rx, px, multiply_add(a.ry, py, a.r));
    a.x = multiply_add(a.xx, px, multiply_add(a.xy, py, a.x));
    a.y = multiply_add(a.xy, px, multiply_add(a.yy, py, a.y));
    const S rx = multiply_add(ex, a.xx, multiply_add(ey, a.xy, a.rx));
    const S ry = multiply_add(ex, a.xy, multiply_add(ey, a.yy, a.ry));
    a.rr = multiply_add(ex, a.rx + rx, multiply_add(ey, a.ry + ry, a.rr));
    a.rx = rx;
    a.ry = ry;
    a.r = multiply_add(ex, a.x, multiply_add(ey, a.y, a.r));
  }

  /// From the start to the free end: accelerations, and the state at the end of the step.
  PLASTICA_ALWAYS_INLINE void outward() const {
    const S zero = constant<S>(0);
    Entry<S, PlanarSums> sums(beam_.sums, 0);
    Losses<S> losses{sums.get(PlanarSums::Damping), sums.get(PlanarSums::Numerical)};
    S fastest = sums.get(PlanarSums::FastestSpin);
    S turning = zero, x = zero, y = zero, direction = zero, spin = zero;
    S free_x = zero, free_y = zero;  // without what spins pull
    S mean_spin = zero, velocity_x = zero, velocity_y = zero;
    S loads = sums.get(PlanarSums::Loads);
    for (std::size_t i = 0; i < beam_.segments; ++i) {
      const Kind kind(beam_.kinds, beam_.kind[i]);
      const State state(beam_.state, i);
      const Work work(beam_.work, i);
      const S c = work.get(PlanarWork::Cosine);
      const S s = work.get(PlanarWork::Sine);
      const S pull = work.get(PlanarWork::Spin) * work.get(PlanarWork::Spin);
      const S joint = multiply_add(
          -work.get(PlanarWork::ByTurning), turning,
          multiply_add(-work.get(PlanarWork::ByX), x,
                       multiply_add(-work.get(PlanarWork::ByY), y, work.get(PlanarWork::Given))));
      turning = turning + joint;
      const S rate_before = state.get(PlanarState::Rate);
      const S angle_before = state.get(PlanarState::Angle);
      const S rate = multiply_add(h_, joint, rate_before);
      const S mean = kOrder == 2 ? constant<S>(0.5) * (rate_before + rate) : rate;
      const S angle = multiply_add(h_, mean, angle_before);
      state.set(PlanarState::Rate, rate);
      state.set(PlanarState::Angle, angle);
      state.set(PlanarState::Turning, turning);
      joints_.settle(kind, state, 0, angle_before, angle, mean, losses);
      if constexpr (kOrder == 1) {
        losses.numerical = losses.numerical + lost(kind, c, s, turning, free_x, free_y);
      }
      spin = spin + rate;
      direction = direction + kind.get(PlanarKind::Rest) + angle;
      fastest = max(fastest, abs(spin));
      aim_segment(i, direction, spin, turning);
      const S length = kind.get(PlanarKind::Length);
      const S ex = -(length * s);
      const S ey = length * c;
      if (beam_.counts_loads) {
        const Load load(beam_.loads, beam_.load[i]);
        mean_spin = mean_spin + mean;
        loads = multiply_add(h_, power(load, c, s, mean_spin, velocity_x, velocity_y), loads);
        velocity_x = multiply_add(mean_spin, ex, velocity_x);
        velocity_y = multiply_add(mean_spin, ey, velocity_y);
      }
      x = multiply_add(turning, ex, multiply_add(-pull, ey, x));
      y = multiply_add(turning, ey, multiply_add(pull, ex, y));
      if constexpr (kOrder == 1) {
        free_x = multiply_add(turning, ex, free_x);
        free_y = multiply_add(turning, ey, free_y);
      }
    }
    sums.set(PlanarSums::Damping, losses.damping);
    sums.set(PlanarSums::Numerical, losses.numerical);
    sums.set(PlanarSums::Loads, loads);
    sums.set(PlanarSums::FastestSpin, fastest);
  }

  PLASTICA_ALWAYS_INLINE static S power(const Load& load, const S& c, const S& s, const S& spin,
                                        const S& velocity_x, const S& velocity_y) {
    const S moment =
        multiply_add(c, load.get(PlanarLoad::LeverY),
                     multiply_add(-s, load.get(PlanarLoad::LeverX), load.get(PlanarLoad::Moment)));
    return multiply_add(load.get(PlanarLoad::ForceX), velocity_x,
                        multiply_add(load.get(PlanarLoad::ForceY), velocity_y, moment * spin));
  }

  /// What Euler's rule loses of a segment's kinetic energy in a step: half of h^2 times the
  /// product of its inertia with the squares of its accelerations.
  PLASTICA_ALWAYS_INLINE S lost(const Kind& kind, const S& c, const S& s, const S& turning,
                                const S& x, const S& y) const {
    const S first = kind.get(PlanarKind::FirstMoment);
    const S twice = multiply_add(kind.get(PlanarKind::Inertia) * turning, turning,
                                 kind.get(PlanarKind::Mass) * multiply_add(x, x, y * y)) +
                    constant<S>(2) * first * turning * multiply_add(c, y, -(s * x));
    return constant<S>(0.5) * h_ * h_ * twice;
  }

  const PlanarBeam<Real>& beam_;
  S h_;
  S ahead_;  ///< from the begin of a step to where its geometry is taken
  JointComponents<S, kOrder, kYields, Kind, State> joints_;
};

/// `steps` steps of one length.
/// @param aimed  whether the step before had the same length and loads
template <class S, int kOrder, bool kYields>
[[gnu::noinline]] void planar_steps(const PlanarBeam<real_t<S>>& beam, double step,
                                    std::size_t steps, bool aimed) {
  const PlanarSteps<S, kOrder, kYields> kernel(beam, step);
  if (!aimed) kernel.aim();
  for (std::size_t k = 0; k < steps; ++k) kernel.step();
}

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
