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

  void place_undeformed() {
    const std::size_t n = layout_.size();
    Coordinates<L> q;
    q.angle.resize(n);
    q.open.resize(n);
    undeformed_.resize(n);
    place<false>(build_.chain, q, 0.0, undeformed_);
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
    const auto held = view_.rotations(support.held());
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
      build_.chain.constraints.push_back(constraint);
    }
    hold_rotation(support, index, history, point);
  }

  /// A rotation that is held at a segment's end: half joints to the ground on both sides, where
  /// there is a segment, in place of the joint between; a rigid clamp holds the segments
  /// themselves.
  void hold_rotation(const Support& support, std::size_t index, std::size_t history,
                     const SegmentPoint& point) {
    const auto held = view_.rotations(support.held());
    if (std::none_of(held.begin(), held.begin() + kR, [](bool h) { return h; })) return;
    const bool half = layout_.end_rule == EndRule::HalfJoint;
    const std::size_t beyond = point.segment + 1;
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
    joint.local = outer ? shape.outer : shape.inner;
    joint.ground = L::compose(undeformed_.frame[segment], joint.local);
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
      constraint.frame = undeformed_.frame[segment];
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

  void add_load(const Load& load) {
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
  /// a M + b (M - M_0), so it passes on M - M_0 b/(a + b).
  void add_single_load(Load load, std::size_t history, double fraction) {
    hold_moment(load, history, fraction);
    const SegmentPoint point = segment_point(layout_, fraction);
    const std::size_t beyond = point.segment + 1;
    const bool at_joint =
        beyond < layout_.size() && std::abs(fraction - layout_.ends[beyond]) < kSamePlace;
    const bool has_moment = load.moment != std::array<double, 3>{};
    // A follower's direction is then the mean of both segments', that of the axis at the joint.
    const bool halves = options_.sees_axial || load.follows;
    if (!at_joint || (!has_moment && !options_.shifts && !halves)) {
      add_point_load(load, history, point, 1.0);
      return;
    }
    const ComplianceBefore fraction_before = compliance_before(layout_, beyond);
    const auto outer_part = [&](const std::array<double, 3>& whole,
                                const std::array<double, 3>& fractions) {
      const auto& frame = layout_.joint_frame[beyond];
      if (fractions[0] == fractions[1] && fractions[1] == fractions[2])
        return (fractions[0] * vector(whole)).at;
      Vec<double, 3> own = transpose(frame) * vector(whole);
      for (std::size_t k = 0; k < 3; ++k) own[k] *= fractions[k];
      return (frame * own).at;
    };
    Load outer = load;
    outer.moment = outer_part(load.moment, fraction_before.rotational);
    // A force does so where the joint stretches and shears; where it has an axial force, or the
    // load follows, half of it acts on each segment, so that start and end are alike.
    const std::array<double, 3> none{};
    const std::array<double, 3> half{0.5, 0.5, 0.5};
    outer.force = outer_part(load.force, options_.shifts ? fraction_before.shifting
                                         : halves        ? half
                                                         : none);
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
  void hold_moment(Load& load, std::size_t history, double fraction) {
    if (load.moment == std::array<double, 3>{} || layout_.end_rule != EndRule::HalfJoint) return;
    for (std::size_t s = 0; s < scene_.supports.size(); ++s) {
      const Support& support = scene_.supports[s];
      const bool here =
          !support.to && std::abs(fraction_of(support.at, layout_.ends) - fraction) < kSamePlace;
      if (!here || traits_of(support).releases) continue;
      const HeldFreedoms holds = support.held();
      const std::size_t node =
          fraction < kSamePlace ? 0 : segment_point(layout_, fraction).segment + 1;
      const auto& frame = layout_.joint_frame[node];
      Vec<double, 3> held = transpose(frame) * vector(load.moment);
      for (std::size_t k = 0; k < 3; ++k) held[k] = holds[3 + k] ? held[k] : 0.0;
      if (dot(held, held) == 0.0) continue;
      held = frame * held;
      build_.held_moments.push_back({s, history, view_.spin(held)});
      for (std::size_t k = 0; k < 3; ++k) load.moment[k] -= held[k];
    }
  }

  void add_point_load(const Load& load, std::size_t history, const SegmentPoint& point,
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

  void add_gravity() {
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

  LoopConstraint<L> constraint_at(std::size_t support, const SegmentPoint& point) const {
    LoopConstraint<L> constraint;
    constraint.support = support;
    constraint.segment = point.segment;
    constraint.arm = view_.point(point.arm);
    return constraint;
  }

  typename L::Point undeformed_point(const SegmentPoint& point) const {
    return undeformed_.point(point.segment, view_.point(point.arm));
  }

  static Vec<double, 3> vector(const std::array<double, 3>& v) { return {{v[0], v[1], v[2]}}; }
  static std::array<double, 6> six(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return {a[0], a[1], a[2], b[0], b[1], b[2]};
  }

  const Scene& scene_;
  const Layout& layout_;
  View<L> view_;
  BuildOptions options_;
  Placement<L> undeformed_;
  Build<L> build_;
  bool root_is_held_ = false;
};

template <class L>
Build<L> build_chain(const Scene& scene, const Layout& layout, const View<L>& view,
                     const BuildOptions& options) {
  return Builder<L>(scene, layout, view, options).build();
}

}  // namespace plastica::chain

#include "plastica/chain/builder_supports.hpp"
