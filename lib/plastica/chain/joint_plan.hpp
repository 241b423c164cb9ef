#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "plastica/chain/region_numbers.hpp"
#include "plastica/model/material_field.hpp"

namespace plastica::chain {

/// How the axes of a segment lie to those of a joint: cosines, the joint's axis first.
using AxisCosines = std::array<std::array<double, 3>, 3>;
inline constexpr AxisCosines kSameAxes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

/// What a joint stands for; its law and numbers follow from the regions of the beam beside it.
struct JointPlan {
  /// Tributary length of bending about x and y, twist, and stretch with shear [m].
  std::array<double, 4> length{};
  std::array<double, 4> before{};  ///< what of it lies in region a, if that is not b [m]
  std::array<bool, 3> active{};    ///< rotations of the level that the section resists
  std::array<double, 3> spring{};  ///< beside it, of a rotational spring [N m/rad]
  /// A rotational spring to the ground at the node between the joint's two halves [N m/rad].
  std::array<double, 3> node_spring{};
  /// The joint is to the ground, of one half and that spring; lengths and regions are of both.
  bool half_of_node = false;
  bool is_before = false;          ///< which half: that in region a
  bool stretches = false;          ///< where joints do: whether this one stretches and shears
  AxisCosines axes_a = kSameAxes;  ///< of the segment before a corner
  AxisCosines axes_b = kSameAxes;  ///< of the segment beyond it
  std::size_t node = 0;            ///< where it is
  std::size_t region_a = 0;        ///< the regions that it joins
  std::size_t region_b = 0;
  /// The regions at the start and at the end of the beam, whose half segments it stands for
  /// (`Layout::bears`): where one is weaker, the joint has its law, and gives way as before.
  std::array<std::optional<std::size_t>, 2> beyond_ends{};

  /// Whether this axis of the joint is none of a segment beside it.
  bool turns(std::size_t axis) const {
    return axes_a[axis] != kSameAxes[axis] || axes_b[axis] != kSameAxes[axis];
  }
};

/// @param joint, segment  frames, columns x, y, z
inline AxisCosines axis_cosines(const Mat<double, 3, 3>& joint, const Mat<double, 3, 3>& segment) {
  constexpr double kSame = 1e-12;  // rounding of the frames
  const Mat<double, 3, 3> between = transpose(joint) * segment;
  AxisCosines cosines{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t m = 0; m < 3; ++m) cosines[k][m] = between(k, m);
    // The axis that they turn about.
    if (cosines[k][k] > 1.0 - kSame) cosines[k] = kSameAxes[k];
  }
  return cosines;
}

/// Which of a plan's lengths the parts about x, y, z have, and those along x, y, z.
inline constexpr std::array<std::size_t, 3> kLengthsOfRotations{0, 1, 2};
inline constexpr std::array<std::size_t, 3> kLengthsOfShifts{3, 3, 3};

/// What the parts of a joint before and beyond its node give way by about or along axis k of the
/// joint, per moment about or force along its axis j [rad/(N m)], [m/N]. At a corner each part
/// bends and twists about its own axes: sum_m c_km c_jm l_m/K_m, c the cosines between these and
/// the joint's. In the sum of two parts of one length and section the coupling of unlike axes is of
/// opposite sign, and cancels.
/// @param of_a, of_b  stiffness per length of the regions of both, about or along x, y, z
template <class S>
std::array<S, 2> part_compliances(const JointPlan& plan, std::size_t k, std::size_t j,
                                  const std::array<std::size_t, 3>& lengths,
                                  const std::array<S, 3>& of_a, const std::array<S, 3>& of_b) {
  const auto before = [&](std::size_t m) { return constant<S>(plan.before[lengths[m]]) / of_a[m]; };
  const auto beyond = [&](std::size_t m) {
    return constant<S>(plan.length[lengths[m]] - plan.before[lengths[m]]) / of_b[m];
  };
  std::array<S, 2> sum{constant<S>(0), constant<S>(0)};
  if (!plan.turns(k)) {
    if (k == j) sum = {before(k), beyond(k)};
    return sum;
  }
  for (std::size_t m = 0; m < 3; ++m) {
    sum[0] = sum[0] + constant<S>(plan.axes_a[k][m] * plan.axes_a[j][m]) * before(m);
    sum[1] = sum[1] + constant<S>(plan.axes_b[k][m] * plan.axes_b[j][m]) * beyond(m);
  }
  return sum;
}

/// The tributary lengths of the joint at the inner end of a segment.
inline JointPlan joint_plan(const Layout& layout, std::size_t i) {
  const std::size_t n = layout.size();
  const bool first = i == 1;
  const bool last = i + 1 == n;
  JointPlan joint;
  joint.node = i;
  joint.region_b = layout.segment_regions[i].inner;
  joint.region_a = i == 0 ? joint.region_b : layout.segment_regions[i - 1].outer;
  if (first && layout.bears[0]) joint.beyond_ends[0] = layout.segment_regions[0].inner;
  if (last && i > 0 && layout.bears[1]) joint.beyond_ends[1] = layout.segment_regions[i].outer;
  joint.active.fill(i > 0);
  joint.stretches = i > 0;
  joint.length.fill(layout.joint_length[i]);
  if (i > 0) joint.before.fill(layout.length_before[i]);
  if (i > 0 && layout.has_corners) {
    joint.axes_a = axis_cosines(layout.joint_frame[i], layout.segment_frame[i - 1]);
    joint.axes_b = axis_cosines(layout.joint_frame[i], layout.segment_frame[i]);
  }
  joint.length[3] = layout.shift_before[i] + layout.shift_beyond[i];
  joint.before[3] = i > 0 ? layout.shift_before[i] : 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (first) joint.length[k] += layout.bare_half[0][k];
    if (first) joint.before[k] += layout.bare_half[0][k];
    if (last) joint.length[k] += layout.bare_half[1][k];
  }
  return joint;
}

/// What of a moment and of a force at a node acts on the segment beyond it, as matrices in the
/// joint's axes, and what of a moment goes into a rotational spring there [1]; of the scene's own
/// materials, whatever is fitted.
struct NodeShares {
  Mat<double, 3, 3> rotational{};
  Mat<double, 3, 3> shifting{};
  std::array<double, 3> spring{};  ///< about x, about y, and about z
};

/// A node between two half joints of compliances a and b that a rotational spring k holds is
/// condensed out (`node_compliance`). A moment there is carried as by three springs side by side:
/// 1/a to the segment before, 1/b to the one beyond, k to the ground. Of a force likewise, without
/// a spring.
/// @param plan    `joint_plan` of the node
/// @param spring  about x, y, z of the joint there [N m/rad]
inline NodeShares node_shares(const Layout& layout, const JointPlan& plan,
                              const std::array<double, 3>& spring) {
  using Numbers = std::array<double, 3>;
  const auto stiffness = [&](std::size_t number) -> std::array<Numbers, 2> {
    const BeamRegion& region = layout.regions[number];
    const auto of = region_numbers(region, material_values(region.material));
    const double shear = of.shear_modulus * region.properties.area;
    return {Numbers{of.stiffness[0], of.stiffness[1], of.stiffness[2]},
            Numbers{shear * region.properties.shear_coefficient_x,
                    shear * region.properties.shear_coefficient_y, of.stiffness[3]}};
  };
  const bool springs = spring != std::array<double, 3>{};
  // Of one region in a row only the lengths count.
  const Numbers one{1.0, 1.0, 1.0};
  std::array<Numbers, 2> a{one, one};
  std::array<Numbers, 2> b = a;
  if (plan.region_a != plan.region_b || springs || layout.has_corners) {
    a = stiffness(plan.region_a);
    b = stiffness(plan.region_b);
  }
  NodeShares shares;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [before, beyond] = part_compliances(plan, k, k, kLengthsOfRotations, a[0], b[0]);
    const double held = spring[k] * before * beyond;
    const double all = before + beyond + held;
    shares.spring[k] = held / all;
    const auto [shift, shift_beyond] = part_compliances(plan, k, k, kLengthsOfShifts, a[1], b[1]);
    for (std::size_t j = 0; j < 3; ++j) {
      if (j != k && !plan.turns(k)) continue;
      // The part before carries it alone, with its coupling of axes.
      const double turned = part_compliances(plan, k, j, kLengthsOfRotations, a[0], b[0])[0];
      const double shifted = part_compliances(plan, k, j, kLengthsOfShifts, a[1], b[1])[0];
      shares.rotational(k, j) = turned / all;
      shares.shifting(k, j) = shifted / (shift + shift_beyond);
    }
  }
  return shares;
}

}  // namespace plastica::chain
