#pragma once

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "plastica/chain/builder.hpp"

/// Supports that hold along a normal, springs to the ground, and hinges.
namespace plastica::chain {

template <class L>
void Builder<L>::add_along_normal(const Support& support, std::size_t index, double fraction) {
  const SegmentPoint point = segment_point(layout_, fraction);
  LoopConstraint<L> constraint = constraint_at(index, point);
  constraint.node = node_of(point, fraction);
  constraint.one_sided = traits_of(support).one_sided;
  constraint.direction = view_.point(vector(support.normal));
  constraint.history = support.moves() ? add_history(support.history) : 0;
  constraint.motion = dot(constraint.direction, view_.point(vector(support.translation)));
  constraint.target = dot(constraint.direction, undeformed_point(point)) - constant<S>(support.gap);
  add_with_twin(constraint);
}

/// The joint there has no law for bending. The halves of its segments are not strained, as at an
/// end without moment: of order 2, since the moment grows from zero.
template <class L>
void Builder<L>::release_bending(double fraction) {
  const std::size_t node = segment_point(layout_, fraction).segment + 1;
  const auto released = view_.rotations(HeldFreedoms{false, false, false, true, true, false});
  for (std::size_t k = 0; k < kR; ++k) {
    if (released[k]) build_.joints[node].active[k] = false;
  }
}

/// Two springs for what lies on each segment, at its Gauss points: they make the force and the
/// moment of an even bed on a segment that stays straight.
template <class L>
void Builder<L>::add_bed(const Support& support, std::size_t index, std::size_t history,
                         double from, double to) {
  const auto stiffness = view_.translations(six(support.stiffness, {}));
  for (std::size_t i = 0; i < layout_.size(); ++i) {
    const double begin = std::max(from, layout_.ends[i]);
    const double end = std::min(to, layout_.ends[i + 1]);
    if (end <= begin) continue;
    const double half = 0.5 * (end - begin);
    const double length =
        layout_.segment_length[i] * 2.0 * half / (layout_.ends[i + 1] - layout_.ends[i]);
    for (const double side : {-1.0, 1.0}) {
      const double fraction = begin + half * (1.0 + side / std::numbers::sqrt3);
      const SegmentPoint point = segment_point(layout_, fraction);
      Spring<L> spring;
      spring.support = index;
      spring.segment = point.segment;
      spring.history = history;
      spring.arm = view_.point(point.arm);
      for (std::size_t k = 0; k < kT; ++k) {
        spring.stiffness[k] = constant<S>(0.5 * length * stiffness[k]);
      }
      spring.rest = undeformed_point(point);
      spring.motion = view_.point(vector(support.translation));
      build_.chain.springs.push_back(spring);
    }
  }
}

template <class L>
void Builder<L>::add_springs(const Support& support, std::size_t index, std::size_t history,
                             double fraction) {
  const SegmentPoint point = segment_point(layout_, fraction);
  Spring<L> spring;
  spring.support = index;
  spring.segment = point.segment;
  spring.history = history;
  spring.arm = view_.point(point.arm);
  const std::size_t beyond = point.segment + 1;
  const bool joins = beyond < layout_.size() && fraction == layout_.ends[beyond];
  const double part = joins && shares_forces(beyond) ? 0.5 : 1.0;
  const auto stiffness = view_.translations(six(support.stiffness, {}));
  for (std::size_t k = 0; k < kT; ++k) spring.stiffness[k] = constant<S>(part * stiffness[k]);
  spring.rest = undeformed_point(point);
  spring.motion = view_.point(vector(support.translation));
  build_.chain.springs.push_back(spring);
  if (part < 1.0) {
    spring.segment = beyond;
    spring.arm = {};
    build_.chain.springs.push_back(spring);
  }
  const std::size_t node = fraction == 0.0 ? 0 : beyond;
  const auto rotational = view_.rotations(six({}, springs_at(support, node)));
  if (std::none_of(rotational.begin(), rotational.begin() + kR, [](double k) { return k > 0.0; })) {
    return;
  }
  if (fraction == 0.0) {
    for (std::size_t k = 0; k < kR; ++k) build_.joints[0].spring[k] += rotational[k];
    return;
  }
  const auto motion = view_.spin(vector(support.rotation));
  if (!joins) {
    add_ground_joint(index, history, point.segment, true, {}, motion);
    build_.joints.back().spring = rotational;
    return;
  }
  // It acts on the node between two half joints, which is condensed out (joint_numbers.hpp).
  std::array<bool, 3> acts{};
  for (std::size_t k = 0; k < kR; ++k) acts[k] = rotational[k] > 0.0;
  JointPlan& between = build_.joints[beyond];
  for (std::size_t k = 0; k < kR; ++k) between.node_spring[k] += rotational[k];
  const JointPlan whole = between;
  for (const bool outer : {true, false}) {
    add_ground_joint(index, history, outer ? point.segment : beyond, outer, acts, motion);
    JointPlan& half = build_.joints.back();
    half.half_of_node = true;
    half.node_spring = rotational;
    half.before = whole.before;
    half.length = whole.length;
    half.region_a = whole.region_a;
    half.region_b = whole.region_b;
    half.is_before = outer;
    if (is_of_leg(acts)) continue;
    half.axes_a = whole.axes_a;
    half.axes_b = whole.axes_b;
  }
}

}  // namespace plastica::chain
