#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "plastica/chain/build.hpp"
#include "plastica/chain/inertia.hpp"
#include "plastica/chain/joint_plan.hpp"
#include "plastica/chain/layout.hpp"
#include "plastica/chain/placement.hpp"
#include "plastica/chain/point_masses.hpp"
#include "plastica/chain/support_axes.hpp"
#include "plastica/chain/view.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/support_kind.hpp"

namespace plastica::chain {

/// Turns a laid-out scene into the chain of a level, for `build_chain` alone: who needs that for
/// other scalars than it is compiled for includes this.
template <class L>
class Builder {
 public:
  using S = typename L::Scalar;
  static constexpr std::size_t kT = L::kTranslations;
  static constexpr std::size_t kR = L::kRotations;
  static constexpr double kSamePlace = 1e-9;  ///< of the length

  Builder(const Scene& scene, const Layout& layout, const View<L>& view,
          const BuildOptions& options)
      : scene_(scene), layout_(layout), view_(view), options_(options) {}

  Build<L> build() {
    Chain<L>& chain = build_.chain;
    chain.length = constant<S>(scene_.beam.length);
    chain.histories.push_back({{0.0}, {0.0}});  // of what does not move
    add_segments();
    chain.inertias = segment_inertias(layout_, view_, options_.rotary);
    add_point_masses(scene_, layout_, view_, chain.inertias);
    chain.root.position = view_.point(layout_.node[0]);
    chain.root.ground = view_.frame(layout_.joint_frame[0]);
    set_shifts();
    place_undeformed();
    for (std::size_t s = 0; s < scene_.supports.size(); ++s) add_support(s);
    for (const Load& load : scene_.loads) add_load(load);
    add_gravity();
    std::stable_sort(chain.loads.begin(), chain.loads.end(),
                     [](const auto& a, const auto& b) { return a.segment < b.segment; });
    return std::move(build_);
  }

 private:
  std::size_t add_history(const History& history) {
    build_.chain.histories.push_back(history);
    return build_.chain.histories.size() - 1;
  }

  void add_segments() {
    const std::size_t n = layout_.size();
    build_.chain.segments.reserve(n);
    build_.joints.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto& frame = layout_.segment_frame[i];
      const auto back = transpose(frame);
      Segment<L> segment;
      segment.arm = view_.point(back * (layout_.node[i + 1] - layout_.node[i]));
      segment.inner = view_.frame(back * layout_.joint_frame[i]);
      segment.outer = view_.frame(back * layout_.joint_frame[i + 1]);
      build_.chain.segments.push_back(segment);
      build_.joints.push_back(joint_plan(layout_, i));
    }
  }

  void set_shifts() {
    for (const Support& support : scene_.supports) {
      if (layout_.size() > 1 || fraction_of(support.at, layout_.ends) != 0.0) continue;
      const auto held = view_.translations(support.held());
      build_.chain.root.shifts =
          build_.chain.root.shifts ||
          std::all_of(held.begin(), held.begin() + kT, [](bool h) { return h; });
    }
  }

  /// The segment end at the point, if it is one.
  std::size_t node_of(const SegmentPoint& point, double fraction) const {
    if (fraction == layout_.ends[point.segment + 1]) return point.segment + 1;
    return fraction == layout_.ends[point.segment] ? point.segment : kInside;
  }

  /// Which rotations a support holds, about the axes of the joint at a node; as the scene names
  /// them where these lie skew, which `check_support_axes` refuses.
  HeldFreedoms held_at(const Support& support, std::size_t node) const {
    HeldFreedoms held = support.held();
    if (const auto own = held_rotations(support, layout_.joint_frame[node])) {
      std::copy(own->begin(), own->end(), held.begin() + 3);
    }
    return held;
  }
  std::array<double, 3> springs_at(const Support& support, std::size_t node) const {
    return rotational_springs(support, layout_.joint_frame[node])
        .value_or(support.rotational_stiffness);
  }

  void place_undeformed() {
    const std::size_t n = layout_.size();
    Coordinates<L> q;
    q.angle.resize(n);
    q.open.resize(n);
    build_.undeformed.resize(n);
    place<false>(build_.chain, q, 0.0, build_.undeformed);
  }

  void add_support(std::size_t index) {
    const Support& support = scene_.supports[index];
    const std::size_t history = support.moves() ? add_history(support.history) : 0;
    const double fraction = fraction_of(support.at, layout_.ends);
    if (traits_of(support).releases) {
      release_bending(fraction);
      return;
    }
    if (support.to) {
      add_bed(support, index, history, fraction, fraction_of(*support.to, layout_.ends));
      return;
    }
    const HeldFreedoms held = support.held();
    const bool holds = std::find(held.begin(), held.end(), true) != held.end();
    if (fraction == 0.0) {
      // Of the supports at the start the one that holds is the root's, wherever it is listed.
      if (holds || !root_is_held_) add_root(support, index, history);
      root_is_held_ = root_is_held_ || holds;
    } else {
      add_held_point(support, index, history, fraction);
    }
    if (support.has_normal()) add_along_normal(support, index, fraction);
    if (traits_of(support).springs) add_springs(support, index, history, fraction);
  }

  void add_root(const Support& support, std::size_t index, std::size_t history) {
    Root<L>& root = build_.chain.root;
    root.support = index;
    root.history = history;
    root.motion = view_.point(vector(support.translation));
    root.rotation = view_.spin(vector(support.rotation));
    root.held = view_.translations(support.held());
    const auto held = view_.rotations(held_at(support, 0));
    if (layout_.end_rule == EndRule::HalfJoint) {
      build_.joints[0].active = held;
    } else {
      root.clamped = held;
    }
  }

  void add_held_point(const Support& support, std::size_t index, std::size_t history,
                      double fraction) {
    const SegmentPoint point = segment_point(layout_, fraction);
    const auto translation = view_.point(vector(support.translation));
    const auto held = view_.translations(support.held());
    for (std::size_t k = 0; k < kT; ++k) {
      if (!held[k]) continue;
      LoopConstraint<L> constraint = constraint_at(index, point);
      constraint.node = node_of(point, fraction);
      constraint.history = history;
      constraint.direction = unit_vector<typename L::Point>(k);
      constraint.target = undeformed_point(point)[k];
      constraint.motion = translation[k];
      add_with_twin(constraint);
    }
    hold_rotation(support, index, history, point);
  }

  /// A rotation that is held at a segment's end: half joints to the ground on both sides, where
  /// there is a segment, in place of the joint between; a rigid clamp holds the segments
  /// themselves.
  void hold_rotation(const Support& support, std::size_t index, std::size_t history,
                     const SegmentPoint& point) {
    const bool half = layout_.end_rule == EndRule::HalfJoint;
    const std::size_t beyond = point.segment + 1;
    // A rigid clamp holds about the world's axes.
    const auto held = view_.rotations(half ? held_at(support, beyond) : support.held());
    if (std::none_of(held.begin(), held.begin() + kR, [](bool h) { return h; })) return;
    const auto rotation = view_.spin(vector(support.rotation));
    const auto add = [&](std::size_t segment, bool outer) {
      if (half) {
        add_ground_joint(index, history, segment, outer, held, rotation);
      } else {
        clamp_segment(index, history, segment, outer, held, rotation);
      }
    };
    add(point.segment, true);
    if (beyond >= layout_.size()) return;
    add(beyond, false);
    for (std::size_t k = 0; k < kR; ++k) {
      if (held[k]) build_.joints[beyond].active[k] = false;
    }
  }

  bool is_of_leg(const std::array<bool, 3>& held) const {
    return layout_.has_corners &&
           std::find(held.begin(), held.begin() + kR, false) == held.begin() + kR;
  }

  void add_ground_joint(std::size_t support, std::size_t history, std::size_t segment, bool outer,
                        const std::array<bool, 3>& held, const typename L::Spin& rotation) {
    const Segment<L>& shape = build_.chain.segments[segment];
    GroundJoint<L> joint;
    joint.support = support;
    joint.segment = segment;
    joint.node = outer ? segment + 1 : segment;
    joint.history = history;
    joint.joint = build_.joints.size();
    joint.outer = outer;
    // At a corner what holds all rotations is of one leg alone, and has its axes; what holds some
    // is about those of the joint between the legs.
    const bool of_leg = is_of_leg(held);
    if (!of_leg) joint.local = outer ? shape.outer : shape.inner;
    joint.ground = L::compose(build_.undeformed.frame[segment], joint.local);
    joint.motion = rotation;
    build_.chain.ground_joints.push_back(joint);
    JointPlan plan;
    const bool at_end = joint.node == layout_.size();
    plan.length.fill(at_end ? layout_.joint_length.back() : 0.5 * layout_.segment_length[segment]);
    // The one joint of an end segment whose other end is bare.
    for (std::size_t k = 0; k < 3; ++k) {
      if (outer && segment == 0) plan.length[k] += layout_.bare_half[0][k];
      if (!outer && segment + 1 == layout_.size()) plan.length[k] += layout_.bare_half[1][k];
    }
    if (outer) plan.before = plan.length;
    plan.active = held;
    plan.node = joint.node;
    if (layout_.has_corners && !of_leg) {
      plan.axes_a = plan.axes_b =
          axis_cosines(layout_.joint_frame[joint.node], layout_.segment_frame[segment]);
    }
    const SegmentRegions& regions = layout_.segment_regions[segment];
    plan.region_a = plan.region_b = outer ? regions.outer : regions.inner;
    build_.joints.push_back(plan);
  }

  void clamp_segment(std::size_t support, std::size_t history, std::size_t segment, bool outer,
                     const std::array<bool, 3>& held, const typename L::Spin& rotation) {
    for (std::size_t k = 0; k < kR; ++k) {
      if (!held[k]) continue;
      LoopConstraint<L> constraint;
      constraint.support = support;
      constraint.segment = segment;
      constraint.node = outer ? segment + 1 : segment;
      constraint.history = history;
      constraint.rotational = true;
      constraint.axis = unit_vector<typename L::Spin>(k);
      // The twist of a pin is about the beam.
      if constexpr (kR == 3) {
        const Support& of = scene_.supports[support];
        const bool twists = !held[0] && !held[1] && of.held() == traits_of(of).held;
        const auto& axes = layout_.joint_frame[constraint.node];
        if (twists) constraint.axis = view_.spin({{axes(0, k), axes(1, k), axes(2, k)}});
      }
      constraint.frame = build_.undeformed.frame[segment];
      constraint.motion = rotation[k];
      build_.chain.constraints.push_back(constraint);
    }
  }

  // What acts along a normal, and springs: builder_supports.hpp.
  void add_along_normal(const Support& support, std::size_t index, double fraction);
  void add_bed(const Support& support, std::size_t index, std::size_t history, double from,
               double to);
  void release_bending(double fraction);
  void add_springs(const Support& support, std::size_t index, std::size_t history, double fraction);

  // Loads: builder_loads.hpp.
  void add_load(const Load& load);
  void add_single_load(Load load, std::size_t history, double fraction);
  void hold_moment(Load& load, std::size_t history, double fraction);
  bool springs_here(const Support& support, double fraction) const;
  std::array<double, 3> springs_of_node(double fraction, std::size_t node) const;
  void hold_by_springs(Load& load, std::size_t history, double fraction, std::size_t node,
                       const std::array<double, 3>& springs, const NodeShares& shares);
  void add_point_load(const Load& load, std::size_t history, const SegmentPoint& point,
                      double size);
  void add_gravity();

  bool may_open(std::size_t joint) const {
    return joint < options_.may_open.size() && options_.may_open[joint];
  }
  /// Whether a force at a joint acts by parts on both of its segments: where it stretches and
  /// shears, has an axial force, or may let go.
  bool shares_forces(std::size_t joint) const {
    return options_.shifts || options_.sees_axial || may_open(joint);
  }

  /// Adds the constraint of a point, and its twin behind it where the joint there may let go.
  void add_with_twin(LoopConstraint<L> constraint) {
    build_.chain.constraints.push_back(constraint);
    const std::size_t beyond = constraint.segment + 1;
    if (constraint.node != beyond || !may_open(beyond)) return;
    constraint.segment = constraint.waits_for = beyond;
    constraint.arm = {};
    build_.chain.constraints.push_back(constraint);
  }

  LoopConstraint<L> constraint_at(std::size_t support, const SegmentPoint& point) const {
    LoopConstraint<L> constraint;
    constraint.support = support;
    constraint.segment = point.segment;
    constraint.arm = view_.point(point.arm);
    return constraint;
  }

  typename L::Point undeformed_point(const SegmentPoint& point) const {
    return build_.undeformed.point(point.segment, view_.point(point.arm));
  }

  static Vec<double, 3> vector(const std::array<double, 3>& v) { return {{v[0], v[1], v[2]}}; }
  static std::array<double, 6> six(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return {a[0], a[1], a[2], b[0], b[1], b[2]};
  }

  const Scene& scene_;
  const Layout& layout_;
  View<L> view_;
  BuildOptions options_;
  Build<L> build_;
  bool root_is_held_ = false;
};

template <class L>
Build<L> build_chain(const Scene& scene, const Layout& layout, const View<L>& view,
                     const BuildOptions& options) {
  return Builder<L>(scene, layout, view, options).build();
}

}  // namespace plastica::chain

#include "plastica/chain/builder_loads.hpp"
#include "plastica/chain/builder_supports.hpp"
