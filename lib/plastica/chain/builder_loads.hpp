#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "plastica/chain/builder.hpp"

/// Loads and weights.
namespace plastica::chain {

template <class L>
void Builder<L>::add_load(const Load& load) {
  const std::size_t history = add_history(load.history);
  const double from = fraction_of(load.at, layout_.ends);
  if (!load.to) {
    add_single_load(load, history, from);
    return;
  }
  const double to = fraction_of(*load.to, layout_.ends);
  for (std::size_t i = 0; i < layout_.size(); ++i) {
    const double begin = std::max(from, layout_.ends[i]);
    const double end = std::min(to, layout_.ends[i + 1]);
    if (end <= begin) continue;
    add_point_load(load, history, segment_point(layout_, 0.5 * (begin + end)),
                   (end - begin) * scene_.beam.length);
  }
}

/// A moment at a joint acts on both segments: the joint between, which has the curvatures of
/// both sides over its lengths in both, then turns as the beam does, and the chain keeps its
/// order 2. With M before and M - M_0 behind a joint of compliances a and b it turns by
/// a M + b (M - M_0), so it passes on M - M_0 b/(a + b). A rotational spring there takes its
/// share (`node_shares`).
template <class L>
void Builder<L>::add_single_load(Load load, std::size_t history, double fraction) {
  hold_moment(load, history, fraction);
  const std::array<double, 3> moment = load.moment;
  const SegmentPoint point = segment_point(layout_, fraction);
  const std::size_t beyond = point.segment + 1;
  const bool at_joint =
      beyond < layout_.size() && std::abs(fraction - layout_.ends[beyond]) < kSamePlace;
  const bool has_moment = load.moment != std::array<double, 3>{};
  // A follower's direction is then the mean of both segments', that of the axis at the joint.
  const bool shares = shares_forces(beyond) || load.follows;
  if (!at_joint || (!has_moment && !shares)) {
    add_point_load(load, history, point, 1.0);
    return;
  }
  const std::array<double, 3> springs = springs_of_node(fraction, beyond);
  const NodeShares parts = node_shares(layout_, joint_plan(layout_, beyond), springs);
  if (has_moment && springs != std::array<double, 3>{}) {
    hold_by_springs(load, history, fraction, beyond, springs, parts);
  }
  const auto outer_part = [&](const std::array<double, 3>& whole,
                              const Mat<double, 3, 3>& shares_of) {
    const auto& frame = layout_.joint_frame[beyond];
    // Alike about all axes, it has no rounding of frames.
    if (shares_of.at == (shares_of(0, 0) * identity<double, 3>()).at) {
      return (shares_of(0, 0) * vector(whole)).at;
    }
    return (frame * (shares_of * (transpose(frame) * vector(whole)))).at;
  };
  // The shares are of the whole moment, of which the spring's is taken from the load.
  Load outer = load;
  outer.moment = outer_part(moment, parts.rotational);
  // A force does so where the joint stretches and shears; where it has an axial force or may let
  // go, or the load follows, half of it acts on each segment, so that start and end are alike.
  const Mat<double, 3, 3> none{};
  const Mat<double, 3, 3> half = 0.5 * identity<double, 3>();
  outer.force = outer_part(load.force, options_.shifts ? parts.shifting : shares ? half : none);
  Load inner = load;
  for (std::size_t k = 0; k < 3; ++k) {
    inner.moment[k] -= outer.moment[k];
    inner.force[k] -= outer.force[k];
  }
  add_point_load(inner, history, point, 1.0);
  add_point_load(outer, history, {beyond, {}}, 1.0);
}

/// Takes from a load the moment that goes straight into a support: about axes that it holds by
/// half joints, which lie between the support and the segments.
template <class L>
void Builder<L>::hold_moment(Load& load, std::size_t history, double fraction) {
  if (load.moment == std::array<double, 3>{} || layout_.end_rule != EndRule::HalfJoint) return;
  for (std::size_t s = 0; s < scene_.supports.size(); ++s) {
    const Support& support = scene_.supports[s];
    const bool here =
        !support.to && std::abs(fraction_of(support.at, layout_.ends) - fraction) < kSamePlace;
    if (!here || traits_of(support).releases) continue;
    const std::size_t node =
        fraction < kSamePlace ? 0 : segment_point(layout_, fraction).segment + 1;
    const HeldFreedoms holds = held_at(support, node);
    const auto& frame = layout_.joint_frame[node];
    Vec<double, 3> held = transpose(frame) * vector(load.moment);
    for (std::size_t k = 0; k < 3; ++k) held[k] = holds[3 + k] ? held[k] : 0.0;
    if (dot(held, held) == 0.0) continue;
    held = frame * held;
    build_.held_moments.push_back({s, history, view_.spin(held)});
    for (std::size_t k = 0; k < 3; ++k) load.moment[k] -= held[k];
  }
}

template <class L>
bool Builder<L>::springs_here(const Support& support, double fraction) const {
  return !support.to && traits_of(support).springs &&
         std::abs(fraction_of(support.at, layout_.ends) - fraction) < kSamePlace;
}

/// Of all supports at a node within the beam, about the axes of its joint [N m/rad].
template <class L>
std::array<double, 3> Builder<L>::springs_of_node(double fraction, std::size_t node) const {
  std::array<double, 3> sum{};
  for (const Support& support : scene_.supports) {
    if (!springs_here(support, fraction)) continue;
    const auto own = springs_at(support, node);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += own[k];
  }
  return sum;
}

/// Takes from a load what of its moment rotational springs at the node carry by themselves.
template <class L>
void Builder<L>::hold_by_springs(Load& load, std::size_t history, double fraction, std::size_t node,
                                 const std::array<double, 3>& springs, const NodeShares& shares) {
  const auto& frame = layout_.joint_frame[node];
  const Vec<double, 3> whole = transpose(frame) * vector(load.moment);
  for (std::size_t s = 0; s < scene_.supports.size(); ++s) {
    if (!springs_here(scene_.supports[s], fraction)) continue;
    const auto own = springs_at(scene_.supports[s], node);
    Vec<double, 3> held{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (springs[k] > 0.0) held[k] = own[k] / springs[k] * shares.spring[k] * whole[k];
    }
    held = frame * held;
    build_.held_moments.push_back({s, history, view_.spin(held)});
    for (std::size_t k = 0; k < 3; ++k) load.moment[k] -= held[k];
  }
}

template <class L>
void Builder<L>::add_point_load(const Load& load, std::size_t history, const SegmentPoint& point,
                                double size) {
  SegmentLoad<L> part;
  part.segment = point.segment;
  part.history = history;
  part.arm = view_.point(point.arm);
  part.follows = load.follows;
  // A follower's axes are the world's as the segment was laid out.
  const auto& frame = layout_.segment_frame[point.segment];
  const auto to_load = load.follows ? transpose(frame) : identity<double, 3>();
  part.force = view_.point(to_load * (size * vector(load.force)));
  part.moment = view_.spin(to_load * (size * vector(load.moment)));
  build_.chain.loads.push_back(part);
}

template <class L>
void Builder<L>::add_gravity() {
  const Vec<double, 3> g = vector(scene_.gravity);
  if (dot(g, g) == 0.0) return;
  Load weight;
  const std::size_t history = add_history(scene_.gravity_history);
  for (std::size_t i = 0; i < layout_.size(); ++i) {
    const double middle = 0.5 * (layout_.ends[i] + layout_.ends[i + 1]);
    const BeamRegion& region = layout_.regions[layout_.segment_regions[i].middle];
    const Vec<double, 3> force = region.line_mass() * g;
    weight.force = force.at;
    add_point_load(weight, history, segment_point(layout_, middle), layout_.segment_length[i]);
  }
  for (const PointMass& mass : scene_.masses) {
    weight.force = (mass.mass * g).at;
    add_single_load(weight, history, fraction_of(mass.at, layout_.ends));
  }
}

}  // namespace plastica::chain
