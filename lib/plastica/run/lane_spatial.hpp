#pragma once

#include <algorithm>
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

/// What the spatial kernels' numbers are in a chain that lies straight along z.
struct SpatialLanes {
  using Level = chain::Spatial<double>;
  using Body = ChainBody<Level, false>;
  using Kind = lanes::SpatialKind;
  using Load = lanes::SpatialLoad;
  using State = lanes::SpatialState;
  using Work = lanes::SpatialWork;
  using Sums = lanes::SpatialSums;
  using Observables = lanes::SpatialObservables;
  template <class Real>
  using Beam = lanes::SpatialBeam<Real>;
  static constexpr bool kMomentsHavePotential = false;

  template <class Real>
  static const lanes::StepKernels<Beam<Real>>& kernels(const lanes::KernelsOf<Real>& table,
                                                       int order, bool yields) {
    return table.spatial[order - 1][yields ? 1 : 0];
  }
  template <class Real>
  static const lanes::ObservablesKernels<Beam<Real>>& observables(
      const lanes::KernelsOf<Real>& table) {
    return table.spatial_observables;
  }

  static std::array<double, Kind::kCount> kind(const Body& body,
                                               const PrescribedJoints<Level>& joints,
                                               std::size_t i) {
    const auto& chain = body.build.chain;
    const auto& inertia = chain.inertias[i];
    const double center = inertia.center[2];
    const SolverOptions& options = body.model.options;
    const bool damped = options.damping == Damping::Stiffness;
    std::array<double, Kind::kCount> kind{};
    kind[Kind::Length] = chain.segments[i].arm[2];
    kind[Kind::Mass] = inertia.mass;
    kind[Kind::FirstMoment] = inertia.mass * center;
    const double lever = inertia.mass * center * center;
    for (std::size_t k = 0; k < 3; ++k) {
      const double stiffness = joints.stiffness(i, k);
      kind[Kind::Inertia + k] = inertia.rotational(k, k) + (k < 2 ? lever : 0.0);
      kind[Kind::Stiffness + k] = stiffness;
      kind[Kind::Compliance + k] = 1.0 / stiffness;
      kind[Kind::Damping + k] = damped ? options.damping_time * stiffness : 0.0;
      kind[Kind::Cap + k] = body.joint_models[i].cap[k];
    }
    kind[Kind::Free] = i == 0 && chain.root.clamped[0] ? 0.0 : 1.0;
    for (double& number : kind) number = without_noise(number);
    return kind;
  }

  /// Adds a load at a factor 1.
  static void add_load(const chain::SegmentLoad<Level>& load,
                       std::array<double, Load::kCount>& sum) {
    const double lever = without_noise(load.arm[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      const double force = without_noise(load.force[k]);
      sum[Load::Force + k] += force;
      sum[Load::Lever + k] += lever * force;
      sum[Load::Moment + k] += load.moment[k];
    }
  }

  /// The state of the joints at a begin, from how fast the segments turn.
  static std::array<double, State::kCount> state(
      const Body& /*body*/, const std::vector<solve::SegmentMotion<Level>>& motion, std::size_t i) {
    std::array<double, State::kCount> state{};
    for (std::size_t k = 0; k < 3; ++k) {
      // The beam is unloaded: all axes are the world's.
      const double rate = motion[i].spin[k] - (i == 0 ? 0.0 : motion[i - 1].spin[k]);
      state[State::Rate + k] = rate;
      state[State::AngleRate + k] = rate;
    }
    return state;
  }

  /// Takes a joint's state into the chain.
  static void read(const std::array<double, State::kCount>& state, std::size_t i, Body& body,
                   PrescribedJoints<Level>& joints, Level::Spin& angular_acceleration) {
    Level::Spin elastic;
    for (std::size_t k = 0; k < 3; ++k) {
      body.work.q.angle[i][k] = state[State::Angle + k];
      elastic[k] = state[State::Angle + k] - state[State::Plastic + k];
      angular_acceleration[k] = state[State::AngularAcceleration + k];
    }
    joints.prescribe(i, elastic, plastic_work(state, body, i));
  }

  static double plastic_work(const std::array<double, State::kCount>& state, const Body& body,
                             std::size_t i) {
    double work = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double flowed = state[State::Accumulated + k];
      if (flowed > 0.0) work += flowed * body.joint_models[i].cap[k];
    }
    return work;
  }

  /// Sums of the sizes of a joint's permanent turns [rad].
  static Level::Spin accumulated(const std::array<double, State::kCount>& state) {
    return {
        {state[State::Accumulated], state[State::Accumulated + 1], state[State::Accumulated + 2]}};
  }

  /// Takes where a segment is.
  static void place(const std::array<double, Observables::kCount>& observables, std::size_t i,
                    Body& body) {
    const Level::Point& start = body.build.chain.root.position;
    auto& placement = body.work.placement;
    for (std::size_t k = 0; k < 3; ++k) {
      placement.position[i][k] = start[k] + observables[Observables::Place + k];
      for (std::size_t column = 0; column < 3; ++column) {
        placement.frame[i].axes(k, column) = observables[Observables::Axes + 3 * column + k];
      }
    }
  }
  /// How a segment turns, in its own axes.
  static Level::Spin spin(const std::array<double, Observables::kCount>& observables) {
    Level::Spin spin;
    for (std::size_t column = 0; column < 3; ++column) {
      for (std::size_t k = 0; k < 3; ++k) {
        spin[column] +=
            observables[Observables::Axes + 3 * column + k] * observables[Observables::Spin + k];
      }
    }
    return spin;
  }

  /// The kernels' steps are void where a joint turns so far [rad].
  static constexpr double kLargestAngle = 6.283185307179586;
};

}  // namespace plastica
