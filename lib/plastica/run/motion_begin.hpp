#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "plastica/model/beam_axis.hpp"
#include "plastica/run/chain_body.hpp"
#include "plastica/run/path_stops.hpp"
#include "plastica/solve/motion_options.hpp"
#include "plastica/solve/segment_motion.hpp"

/// How a motion is solved, what it begins with, and what is told of it.
namespace plastica {

template <class L, bool kElastic>
solve::MotionOptions motion_options(const ChainBody<L, kElastic>& body) {
  const SolverOptions& solver = body.model.options;
  solve::MotionOptions options;
  options.newton.max_iterations = std::min(solver.max_iterations, solve::kMaxIterations);
  options.newton.tolerance = solver.tolerance;
  options.scheme = solver.scheme;
  options.rho_infinity = solver.rho_infinity;
  options.damping = solver.damping;
  options.damping_time = solver.damping_time;
  // Time steps that come to the same are the same run to the end, the smallest step included.
  options.time_step =
      solver.step_error > 0.0
          ? solver.time_step
          : fixed_steps({body.model.stops, body.model.recorded}, solver.time_step).longest;
  options.step_error = solver.step_error;
  options.smallest_step = solver.smallest_step;
  options.largest_rotation = solver.largest_rotation;
  options.stops = body.model.stops;
  options.recorded = body.model.recorded;
  for (const auto& constraint : body.build.chain.constraints) {
    options.restitution.push_back(body.model.scene.supports[constraint.support].restitution);
  }
  return options;
}

/// The motions that the scene gives to segments, which joints and supports need not allow.
/// @param motion  (N)
template <class L, bool kElastic>
void set_initial_motion(const ChainBody<L, kElastic>& body,
                        std::vector<solve::SegmentMotion<L>>& motion) {
  const chain::Layout& layout = body.model.layout;
  const auto& chain = body.build.chain;
  const auto& placement = body.work.placement;
  const auto vector = [](const std::array<double, 3>& v) { return Vec<double, 3>{v}; };
  motion.assign(chain.size(), {});
  for (const InitialMotion& part : body.model.scene.initial_motions) {
    const double from = fraction_of(part.from, layout.ends);
    const double to = fraction_of(part.to, layout.ends);
    const chain::SegmentPoint about =
        chain::segment_point(layout, fraction_of(part.about, layout.ends));
    const auto center = placement.point(about.segment, body.view.point(about.arm));
    const auto velocity = body.view.point(vector(part.velocity));
    const auto spin = body.view.spin(vector(part.spin));
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const double middle = 0.5 * (layout.ends[i] + layout.ends[i + 1]);
      if (middle < from || middle > to) continue;
      const auto arm = placement.point(i, chain.inertias[i].center) - center;
      motion[i].velocity += velocity + L::spun(spin, arm);
      motion[i].spin += transposed_times(L::axes(placement.frame[i]), spin);
    }
  }
}

/// Whether nothing holds the start.
template <class L, bool kElastic>
bool starts_free(const ChainBody<L, kElastic>& body) {
  const auto& root = body.build.chain.root;
  const chain::JointPlan& joint = body.build.joints[0];
  for (std::size_t k = 0; k < L::kTranslations; ++k) {
    if (root.held[k]) return false;
  }
  for (std::size_t k = 0; k < L::kRotations; ++k) {
    if (root.clamped[k] || joint.active[k] || joint.spring[k] != 0.0) return false;
  }
  return true;
}

/// Back to the virgin beam, placed at time 0, and an empty response.
template <class L, bool kElastic>
void begin_motion(const MaterialValues<double>& material, ChainBody<L, kElastic>& body,
                  Response& response) {
  body.reset(material);
  response.samples = 0;
  clear_motion(response);
  response.counters = {};
  response.limit.reset();
  response.plateau.reset();
  response.axial.reset();
  response.chain.events.clear();
  body.record.begin_frames(response);
  auto& work = body.work;
  chain::place<kElastic>(body.build.chain, work.q, 0.0, work.placement);
  if (!starts_free(body)) return;
  work.q.open[0] = true;
  work.q.pose[0] = {work.placement.position[0], work.placement.frame[0]};
}

/// Writes a sample.
template <class L, bool kElastic>
void record_motion(const std::vector<solve::SegmentMotion<L>>& motion, double kinetic,
                   const solve::EnergyFlows& flows, ChainBody<L, kElastic>& body,
                   Response& response) {
  body.record.set_motion(motion, kinetic, flows);
  body.record.write(body.work, *body.joints, body.strains, response.samples, response);
  response.chain.iterations[response.samples] = response.counters.iterations;
  ++response.samples;
}

/// What is said of the whole motion.
template <class L, bool kElastic>
void end_motion(double momentum_error, ChainBody<L, kElastic>& body, Response& response) {
  body.record.end_motion();
  body.finish_axial(response);
  body.record.end_frames(response);
  set_energy_balance(body.model.scene.beam.length, response);
  response.momentum_error = momentum_error;
  judge_balance(response);
  response.permanent_strain = body.watch.largest_strain(body.strains);
}

}  // namespace plastica
