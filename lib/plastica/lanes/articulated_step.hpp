#pragma once

#include <cstddef>

#include "plastica/base/always_inline.hpp"
#include "plastica/lanes/joint_component.hpp"
#include "plastica/lanes/planar_form.hpp"
#include "plastica/lanes/spatial_form.hpp"

/// Steps of beams that are held at their start alone, W at a time: the recursion of articulated
/// bodies with joint springs implicit. README.md derives it.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// Looks from a segment's state where the forces of a step act on it.
/// @param ahead  from the begin of the step to where its geometry is taken [s]
template <class Form>
PLASTICA_ALWAYS_INLINE inline void aim_segment(const typename Form::Kind& kind,
                                               const typename Form::Work& work,
                                               const typename Form::Scalar& ahead,
                                               const typename Form::L::Spin& angle,
                                               const typename Form::L::Spin& angle_rate,
                                               const typename Form::L::Spin& angular_acceleration,
                                               typename Form::Aim& aim) {
  Form::aim(kind, work, ahead, angle, angle_rate, aim);
  set_vec(work, Form::Work::Fields::Spin, scale_add(ahead, angular_acceleration, aim.spin));
}

/// The same of all segments, for a step that no other led to; whatever its order and law.
template <class Form>
[[gnu::noinline]] void aim_beam(const typename Form::Beam& beam,
                                const typename Form::Scalar& ahead) {
  using State = typename Form::State;
  using OfState = typename State::Fields;
  constexpr std::size_t kR = Form::L::kRotations;
  typename Form::Aim aim;
  for (std::size_t i = 0; i < beam.segments; ++i) {
    const State state(beam.state, i);
    aim.spin += get_vec<kR>(state, OfState::Rate);
    typename Form::L::Spin angle_rate{};
    if constexpr (requires { OfState::AngleRate; })
      angle_rate = get_vec<kR>(state, OfState::AngleRate);
    aim_segment<Form>({beam.kinds, beam.kind[i]}, {beam.work, i}, ahead,
                      get_vec<kR>(state, OfState::Angle), angle_rate,
                      get_vec<kR>(state, OfState::AngularAcceleration), aim);
  }
}

/// The steps of one beam, or of as many as the scalar has lanes.
/// @tparam Form     PlanarForm or SpatialForm
/// @tparam kOrder   1: linearly implicit Euler; 2: linearly implicit midpoint
/// @tparam kYields  whether joints yield at their caps
template <class Form, int kOrder, bool kYields>
class ArticulatedSteps {
 public:
  using S = typename Form::Scalar;
  using L = typename Form::L;
  using Beam = typename Form::Beam;
  using Kind = typename Form::Kind;
  using Load = typename Form::Load;
  using State = typename Form::State;
  using Work = typename Form::Work;
  using Place = typename Form::Place;
  using Spin = typename L::Spin;
  using Point = typename L::Point;
  using OfKind = typename Kind::Fields;
  using OfLoad = typename Load::Fields;
  using OfState = typename State::Fields;
  using OfWork = typename Work::Fields;
  using Sums = typename Form::Sums::Fields;
  static constexpr std::size_t kR = L::kRotations;
  static constexpr std::size_t kT = L::kTranslations;

  PLASTICA_ALWAYS_INLINE ArticulatedSteps(const Beam& beam, double step)
      : beam_(beam),
        h_(constant<S>(step)),
        ahead_(constant<S>(kOrder == 2 ? 0.5 * step : 0.0)),
        joints_(step) {}

  void aim() const { aim_beam<Form>(beam_, ahead_); }

  PLASTICA_ALWAYS_INLINE void step() const {
    inward();
    outward();
  }

 private:
  static constexpr bool kKeepsAngleRate = requires { OfState::AngleRate; };

  PLASTICA_ALWAYS_INLINE Kind kind(std::size_t i) const { return {beam_.kinds, beam_.kind[i]}; }
  PLASTICA_ALWAYS_INLINE Load load(std::size_t i) const { return {beam_.loads, beam_.load[i]}; }

  /// Takes what a joint answers.
  struct Sink {
    Work work;

    PLASTICA_ALWAYS_INLINE void given(const Spin& v) const { set_vec(work, OfWork::Given, v); }
    PLASTICA_ALWAYS_INLINE void by_angular_acceleration(std::size_t column, const Spin& v) const {
      set_vec(work, OfWork::ByAngularAcceleration + kR * column, v);
    }
    PLASTICA_ALWAYS_INLINE void by_acceleration(std::size_t column, const Spin& v) const {
      set_vec(work, OfWork::ByAcceleration + kR * column, v);
    }
  };

  /// From the free end to the start: what each body, with all outside of it, asks of its joint.
  PLASTICA_ALWAYS_INLINE void inward() const {
    ArticulatedBody<L> body{};
    for (std::size_t i = beam_.segments; i-- > 0;) {
      const Kind of = kind(i);
      const Work work(beam_.work, i);
      const Place at(work);
      const S length = of.get(OfKind::Length);
      body.carry(length * at.along, length * at.centripetal);
      add_segment(of, load(i), at, body);
      body.release(joint_moment(of, State(beam_.state, i), work), Form::free(of), Sink{work});
    }
  }

  PLASTICA_ALWAYS_INLINE static void add_segment(const Kind& kind, const Load& load,
                                                 const Place& at, ArticulatedBody<L>& a) {
    const S mass = kind.get(OfKind::Mass);
    a.r -= load_moment(load, at);
    Form::add_inertia(kind, at, a);
    for_each_of<kT>([&](std::size_t k) PLASTICA_ALWAYS_INLINE { a.tt(k, k) += mass; });
    a.t = scale_add(kind.get(OfKind::FirstMoment), at.centripetal,
                    a.t - get_vec<kT>(load, OfLoad::Force));
  }

  /// Of the loads about the segment's inner joint.
  PLASTICA_ALWAYS_INLINE static Spin load_moment(const Load& load, const Place& at) {
    return get_vec<kR>(load, OfLoad::Moment) +
           L::moment(at.along, get_vec<kT>(load, OfLoad::Lever));
  }

  PLASTICA_ALWAYS_INLINE JointMoment<L> joint_moment(const Kind& kind, const State& state,
                                                     const Work& work) const {
    const Spin rate = Form::angle_rate(work, get_vec<kR>(state, OfState::Rate));
    Spin moment, resistance;
    for_each_of<kR>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      const ComponentMoment<S> component = joints_.moment(kind, state, rate[k], k);
      moment[k] = component.moment;
      resistance[k] = component.resistance;
    });
    return Form::in_world(kind, work, moment, resistance);
  }

  /// From the start to the free end: accelerations, and the state at the end of the step.
  PLASTICA_ALWAYS_INLINE void outward() const {
    const typename Form::Sums sums(beam_.sums, 0);
    Losses<S> losses{sums.get(Sums::Damping), sums.get(Sums::NumericalDissipation)};
    S fastest{}, largest{};  // squared
    S loads = sums.get(Sums::Loads);
    typename Form::Aim aim;
    Spin angular_acceleration{}, mean_spin{};
    Point acceleration{}, velocity{};
    Point free{};  // acceleration without what spins add
    for (std::size_t i = 0; i < beam_.segments; ++i) {
      const Kind of = kind(i);
      const State state(beam_.state, i);
      const Work work(beam_.work, i);
      const Spin joint = joint_acceleration(work, angular_acceleration, acceleration);
      angular_acceleration += joint;
      const Spin rate_before = get_vec<kR>(state, OfState::Rate);
      const Spin rate = scale_add(h_, joint, rate_before);
      const Spin mean = kOrder == 2 ? constant<S>(0.5) * (rate_before + rate) : rate;
      const Spin angle_before = get_vec<kR>(state, OfState::Angle);
      const Spin angle_rate = Form::angle_rate(work, mean);
      const Spin angle = scale_add(h_, angle_rate, angle_before);
      set_vec(state, OfState::Rate, rate);
      set_vec(state, OfState::Angle, angle);
      set_vec(state, OfState::AngularAcceleration, angular_acceleration);
      for_each_of<kR>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
        joints_.settle(of, state, k, angle_before[k], angle[k], angle_rate[k], losses);
      });
      if constexpr (kKeepsAngleRate) set_vec(state, OfState::AngleRate, angle_rate);
      const Place at(work);
      if constexpr (kOrder == 1)
        losses.numerical_dissipation += lost(of, at, angular_acceleration, free);
      aim.spin += rate;
      fastest = max(fastest, dot(aim.spin, aim.spin));
      largest = max(largest, dot(angle, angle));
      aim_segment<Form>(of, work, ahead_, angle, angle_rate, angular_acceleration, aim);
      const S length = of.get(OfKind::Length);
      const Point e = length * at.along;
      if (beam_.counts_loads) {
        mean_spin += mean;
        loads += h_ * power(load(i), at, mean_spin, velocity);
        velocity += L::spun(mean_spin, e);
      }
      acceleration =
          scale_add(length, at.centripetal, acceleration) + L::spun(angular_acceleration, e);
      if constexpr (kOrder == 1) free += L::spun(angular_acceleration, e);
    }
    sums.set(Sums::Damping, losses.damping);
    sums.set(Sums::NumericalDissipation, losses.numerical_dissipation);
    sums.set(Sums::Loads, loads);
    sums.set(Sums::FastestSpin, max(sums.get(Sums::FastestSpin), sqrt(fastest)));
    if constexpr (requires { Sums::LargestAngle; }) {
      sums.set(Sums::LargestAngle, max(sums.get(Sums::LargestAngle), sqrt(largest)));
    }
  }

  PLASTICA_ALWAYS_INLINE static Spin joint_acceleration(const Work& work,
                                                        const Spin& angular_acceleration,
                                                        const Point& acceleration) {
    Spin joint = get_vec<kR>(work, OfWork::Given);
    for_each_of<kT>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      joint =
          scale_add(-acceleration[k], get_vec<kR>(work, OfWork::ByAcceleration + kR * k), joint);
    });
    for_each_of<kR>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      joint = scale_add(-angular_acceleration[k],
                        get_vec<kR>(work, OfWork::ByAngularAcceleration + kR * k), joint);
    });
    return joint;
  }

  PLASTICA_ALWAYS_INLINE static S power(const Load& load, const Place& at, const Spin& spin,
                                        const Point& velocity) {
    return dot_add(get_vec<kT>(load, OfLoad::Force), velocity, dot(load_moment(load, at), spin));
  }

  /// What Euler's rule loses of a segment's kinetic energy in a step: half of h^2 times the
  /// product of its inertia with the squares of its accelerations.
  PLASTICA_ALWAYS_INLINE S lost(const Kind& kind, const Place& at, const Spin& angular_acceleration,
                                const Point& free) const {
    const S mixed = constant<S>(2) * kind.get(OfKind::FirstMoment) *
                    dot(angular_acceleration, L::moment(at.along, free));
    return constant<S>(0.5) * h_ * h_ *
           (kind.get(OfKind::Mass) * dot(free, free) + Form::spun(kind, at, angular_acceleration) +
            mixed);
  }

  const Beam& beam_;
  S h_;
  S ahead_;  ///< from the begin of a step to where its geometry is taken
  JointComponents<S, kOrder, kYields, Kind, State> joints_;
};

/// `steps` steps of one length.
/// @param aimed  whether the step before had the same length and left off here
template <class Form, int kOrder, bool kYields>
[[gnu::noinline]] void articulated_steps_of(const typename Form::Beam& beam, double step,
                                            std::size_t steps, bool aimed) {
  const ArticulatedSteps<Form, kOrder, kYields> kernel(beam, step);
  if (!aimed) kernel.aim();
  for (std::size_t k = 0; k < steps; ++k) kernel.step();
}

/// The same of kStride beams, `kTogether` at a time.
template <template <class, std::size_t> class FormOf, class Real, std::size_t kStride,
          std::size_t kTogether, int kOrder, bool kYields>
void articulated_steps(const typename FormOf<Fused<Real>, 1>::Beam& beam, double step,
                       std::size_t steps, bool aimed) {
  using S = Fused<LanesOf<Real, kTogether>>;
  for (std::size_t lane = 0; lane < kStride; lane += kTogether) {
    auto part = beam;
    part.kinds += lane;
    part.loads += lane;
    part.state += lane;
    part.work += lane;
    part.sums += lane;
    articulated_steps_of<FormOf<S, kStride>, kOrder, kYields>(part, step, steps, aimed);
  }
}

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
