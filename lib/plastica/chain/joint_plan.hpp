#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "plastica/chain/region_numbers.hpp"
#include "plastica/model/material_field.hpp"

namespace plastica::chain {

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
  bool is_before = false;    ///< which half: that in region a
  bool stretches = false;    ///< where joints do: whether this one stretches and shears
  std::size_t node = 0;      ///< where it is
  std::size_t region_a = 0;  ///< the regions that it joins
  std::size_t region_b = 0;
};

/// The tributary lengths of the joint at the inner end of a segment.
inline JointPlan joint_plan(const Layout& layout, std::size_t i) {
  const std::size_t n = layout.size();
  const bool first = i == 1;
  const bool last = i + 1 == n;
  JointPlan joint;
  joint.node = i;
  joint.region_b = layout.segment_regions[i].inner;
  joint.region_a = i == 0 ? joint.region_b : layout.segment_regions[i - 1].outer;
  joint.active.fill(i > 0);
  joint.stretches = i > 0;
  joint.length.fill(layout.joint_length[i]);
  if (i > 0) joint.before.fill(layout.length_before[i]);
  for (std::size_t k = 0; k < joint.length.size(); ++k) {
    if (first) joint.length[k] += layout.bare_half[0][k];
    if (first) joint.before[k] += layout.bare_half[0][k];
    if (last) joint.length[k] += layout.bare_half[1][k];
  }
  return joint;
}

/// What of a moment and of a force at a node acts on the segment beyond it, and what of a moment
/// goes into a rotational spring there [1]; of the scene's own materials, whatever is fitted.
struct NodeShares {
  std::array<double, 3> rotational{};  ///< about x, about y, and about z
  std::array<double, 3> shifting{};    ///< along x, along y, and along z
  std::array<double, 3> spring{};      ///< about x, about y, and about z
};

/// A node between two half joints of compliances a and b that a rotational spring k holds is
/// condensed out (`node_compliance`). A moment there is carried as by three springs side by side:
/// 1/a to the segment before, 1/b to the one beyond, k to the ground. Of a force likewise, without
/// a spring.
/// @param spring  about x, y, z of the joint there [N m/rad]
inline NodeShares node_shares(const Layout& layout, std::size_t node,
                              const std::array<double, 3>& spring) {
  const JointPlan plan = joint_plan(layout, node);
  const auto stiffness = [&](std::size_t number) -> std::array<double, 6> {
    const BeamRegion& region = layout.regions[number];
    const auto of = region_numbers(region, material_values(region.material));
    const double shear = of.shear_modulus * region.properties.area;
    return {of.stiffness[0],
            of.stiffness[1],
            of.stiffness[2],
            shear * region.properties.shear_coefficient_x,
            shear * region.properties.shear_coefficient_y,
            of.stiffness[3]};
  };
  const bool springs = spring != std::array<double, 3>{};
  std::array<double, 6> a{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  std::array<double, 6> b = a;
  if (plan.region_a != plan.region_b || springs) {
    a = stiffness(plan.region_a);
    b = stiffness(plan.region_b);
  }
  NodeShares shares;
  for (std::size_t k = 0; k < 6; ++k) {
    const std::size_t length = std::min<std::size_t>(k, 3);
    const double before = plan.before[length] / a[k];
    const double behind = (plan.length[length] - plan.before[length]) / b[k];
    const double held = k < 3 ? spring[k] * before * behind : 0.0;
    const double all = before + behind + held;
    (k < 3 ? shares.rotational[k] : shares.shifting[k - 3]) = before / all;
    if (k < 3) shares.spring[k] = held / all;
  }
  return shares;
}

}  // namespace plastica::chain
