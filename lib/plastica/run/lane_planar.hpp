#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "plastica/lanes/kernel_table.hpp"
#include "plastica/run/chain_body.hpp"
#include "plastica/run/lane_numbers.hpp"
#include "plastica/run/prescribed_joints.hpp"

namespace plastica {

/// What the planar kernels' numbers are in a chain.
struct PlanarLanes {
  using Level = chain::Planar<double>;
  using Body = ChainBody<Level, false>;
  using Kind = lanes::PlanarKind;
  using Load = lanes::PlanarLoad;
  using State = lanes::PlanarState;
  using Work = lanes::PlanarWork;
  using Sums = lanes::PlanarSums;
  using Observables = lanes::PlanarObservables;
  template <class Real>
  using Beam = lanes::PlanarBeam<Real>;
  /// Whether the work of a moment that does not change follows from where the beam is.
  static constexpr bool kMomentsHavePotential = true;

  template <class Real>
  static const lanes::StepKernels<Beam<Real>>& kernels(const lanes::KernelsOf<Real>& table,
                                                       int order, bool yields) {
    return table.planar[order - 1][yields ? 1 : 0];
  }

  template <class Real>
  static const lanes::ObservablesKernels<Beam<Real>>& observables(
      const lanes::KernelsOf<Real>& table) {
    return table.planar_observables;
  }

  static std::array<double, Kind::kCount> kind(const Body& body,
                                               const PrescribedJoints<Level>& joints,
                                               std::size_t i) {
    const auto& chain = body.build.chain;
    const auto& inertia = chain.inertias[i];
    const double center = inertia.center[0];
    const double outer = i == 0 ? chain.root.ground.angle : chain.segments[i - 1].outer.angle;
    const double stiffness = joints.stiffness(i, 0);
    const SolverOptions& options = body.model.options;
    const bool damped = options.damping == Damping::Stiffness;
    std::array<double, Kind::kCount> kind{};
    kind[Kind::Length] = chain.segments[i].arm[0];
    kind[Kind::Mass] = inertia.mass;
    kind[Kind::FirstMoment] = inertia.mass * center;
    kind[Kind::Inertia] = inertia.rotational(0, 0) + inertia.mass * center * center;
    kind[Kind::Rest] = outer - chain.segments[i].inner.angle;
    kind[Kind::Stiffness] = stiffness;
    kind[Kind::Compliance] = 1.0 / stiffness;
    kind[Kind::Damping] = damped ? options.damping_time * stiffness : 0.0;
    kind[Kind::Cap] = cap(body, i);
    const bool clamped = i == 0 && chain.root.clamped[0];
    kind[Kind::Hold] = clamped ? std::numeric_limits<double>::infinity() : 0.0;
    for (double& number : kind) number = without_noise(number);
    kind[Kind::Rest] = std::nearbyint(kind[Kind::Rest] * 0x1p50) * 0x1p-50;
    return kind;
  }

  /// Adds a load at a factor 1.
  static void add_load(const chain::SegmentLoad<Level>& load,
                       std::array<double, Load::kCount>& sum) {
    const double lever = without_noise(load.arm[0]);
    const double along = without_noise(load.force[0]);
    const double across = without_noise(load.force[1]);
    sum[Load::ForceX] += along;
    sum[Load::ForceY] += across;
    sum[Load::LeverX] += lever * along;
    sum[Load::LeverY] += lever * across;
    sum[Load::Moment] += load.moment[0];
  }

  /// The state of the joints at a begin, from how fast the segments turn.
  static std::array<double, State::kCount> state(
      const Body& /*body*/, const std::vector<solve::SegmentMotion<Level>>& motion, std::size_t i) {
    std::array<double, State::kCount> state{};
    state[State::Rate] = motion[i].spin[0] - (i == 0 ? 0.0 : motion[i - 1].spin[0]);
    return state;
  }

  /// Takes a joint's state into the chain.
  static void read(const std::array<double, State::kCount>& state, std::size_t i, Body& body,
                   PrescribedJoints<Level>& joints, Level::Spin& angular_acceleration) {
    const double angle = state[State::Angle];
    body.work.q.angle[i] = {{angle}};
    joints.prescribe(i, {{angle - state[State::Plastic]}}, plastic_work(state, body, i));
    angular_acceleration = {{state[State::AngularAcceleration]}};
  }

  static double plastic_work(const std::array<double, State::kCount>& state, const Body& body,
                             std::size_t i) {
    const double flowed = state[State::Accumulated];
    return flowed > 0.0 ? flowed * cap(body, i) : 0.0;
  }

  /// Sums of the sizes of a joint's permanent turns [rad].
  static Level::Spin accumulated(const std::array<double, State::kCount>& state) {
    return {{state[State::Accumulated]}};
  }

  /// Takes where a segment is.
  static void place(const std::array<double, Observables::kCount>& observables, std::size_t i,
                    Body& body) {
    const Level::Point& start = body.build.chain.root.position;
    body.work.placement.position[i] =
        start + Level::Point{{observables[Observables::X], observables[Observables::Y]}};
    body.work.placement.frame[i] = {observables[Observables::Direction],
                                    observables[Observables::Cosine],
                                    observables[Observables::Sine]};
  }
  /// How a segment turns, in its own axes.
  static Level::Spin spin(const std::array<double, Observables::kCount>& observables) {
    return {{observables[Observables::Spin]}};
  }

 private:
  static double cap(const Body& body, std::size_t i) {
    return body.joint_models[i].cap[body.view.section_axes().rotation(0)];
  }
};

}  // namespace plastica
