#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "plastica/chain/build.hpp"

namespace plastica::chain {

/// Whether a region owns a joint with another one, rather than the other way round: the one that
/// yields first about the axes of the level, by the product of its moments there; of equally strong
/// ones the softer, of equally soft ones the first. It does not depend on which of them is before
/// the joint.
/// @param numbers  of each region (regions)
template <class L, class S = typename L::Scalar>
bool owns_joint(std::size_t region, std::size_t other, const std::vector<RegionNumbers<S>>& numbers,
                const View<L>& view) {
  const auto product = [&](const law::SectionForce<S>& of) {
    S all = constant<S>(1);
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      all = all * of[view.section_axes().rotation(k)];
    }
    return all;
  };
  const S less = constant<S>(1.0 - 1e-9);
  for (const auto values : {&RegionNumbers<S>::yield, &RegionNumbers<S>::stiffness}) {
    const S own = product(numbers[region].*values);
    const S others = product(numbers[other].*values);
    if (any(own < less * others)) return true;
    if (any(others < less * own)) return false;
  }
  return region <= other;
}

/// The compliance of a joint beside a node that a rotational spring k holds, once the node is
/// condensed out: two half joints of compliances a and b and the spring meet in it (a star), and
/// between their other ends are three joints (a delta),
///   both segments: a + b + k a b,   segment and ground: a + 1/k + a/(b k), or with a and b
///   swapped.
/// For k = 0 the first is the joint as it was, for k at infinity the others are half joints to the
/// ground. Exact while nothing yields; the caps are those of the halves.
/// @param halves  a and b [rad/(N m)]
template <class S>
S node_compliance(const JointPlan& plan, const S& spring, const std::array<S, 2>& halves) {
  const auto& [a, b] = halves;
  if (!plan.half_of_node) return a + b + spring * a * b;
  // About an axis without a spring the half joint does nothing.
  const S own = plan.is_before ? a : b;
  const S other = plan.is_before ? b : a;
  const S one = constant<S>(1);
  const S acts = select(spring > constant<S>(0), spring, one);
  return own + (one + own / other) / acts;
}

/// kappa_x G A, kappa_y G A and EA of a region [N]
template <class S>
std::array<S, 3> shift_stiffness(const BeamRegion& region, const RegionNumbers<S>& numbers) {
  const SectionProperties& p = region.properties;
  return {numbers.shear_modulus * constant<S>(p.shear_coefficient_x * p.area),
          numbers.shear_modulus * constant<S>(p.shear_coefficient_y * p.area),
          numbers.stiffness[law::kAxial]};
}

/// Sets a joint's axial length and its stiffness across the beam.
/// @param stiffness  `shift_stiffness` of each region (regions)
template <class L, class S = typename L::Scalar>
void set_shifts(const JointPlan& plan, const std::vector<std::array<S, 3>>& stiffness,
                const View<L>& view, SectionJoint<L>& joint) {
  constexpr std::size_t kAlong = 2;
  const auto& of_a = stiffness[plan.region_a];
  const auto& of_b = stiffness[plan.region_b];
  const auto shears = [&](std::size_t axis) {
    return any(of_a[axis] > constant<S>(0)) && any(of_b[axis] > constant<S>(0));
  };
  JointPlan shifts = plan;
  // A section that is given by its numbers may not shear.
  if (!shears(0) || !shears(1)) shifts.axes_a = shifts.axes_b = kSameAxes;
  const bool alike =
      plan.region_a == plan.region_b && joint.law == plan.region_a && !shifts.turns(kAlong);
  const auto give = [&](std::size_t axis) {
    const auto parts = part_compliances(shifts, axis, axis, kLengthsOfShifts, of_a, of_b);
    return parts[0] + parts[1];
  };
  if (!alike) joint.length[law::kAxial] = joint.stiffness[law::kAxial] * give(kAlong);
  joint.shear_stiffness = {};
  for (std::size_t k = 0; k < L::kTranslations; ++k) {
    const std::size_t axis = view.section_axes().translation(k);
    if (axis == kAlong) continue;
    joint.shear_stiffness[k] = alike || !shears(axis) ? stiffness[joint.law][axis]
                                                      : joint.length[law::kAxial] / give(axis);
  }
}

/// The numbers of a level's joints.
///
/// Where two regions meet, one of them owns the joint (`owns_joint`): the joint has its law, lever
/// and break limits. In each component it gives way as both parts do in a row
/// (`part_compliances`): l_k = K_k (c_ak + c_bk), l_a + l_b where both are alike and in line.
/// @param materials  numbers of each region (regions)
template <class L>
std::vector<SectionJoint<L>> joint_numbers(
    const std::vector<JointPlan>& plans, const std::vector<BeamRegion>& regions,
    const std::vector<MaterialValues<typename L::Scalar>>& materials, const View<L>& view) {
  using S = typename L::Scalar;
  using Numbers = std::array<S, 3>;
  std::vector<RegionNumbers<S>> numbers;
  std::vector<Numbers> rotational, shifting;
  for (std::size_t p = 0; p < regions.size(); ++p) {
    const RegionNumbers<S>& own = numbers.emplace_back(region_numbers(regions[p], materials[p]));
    rotational.push_back({own.stiffness[0], own.stiffness[1], own.stiffness[2]});
    shifting.push_back(shift_stiffness(regions[p], own));
  }
  std::vector<SectionJoint<L>> joints;
  joints.reserve(plans.size());
  for (const JointPlan& plan : plans) {
    const std::size_t a = plan.region_a;
    const std::size_t b = plan.region_b;
    SectionJoint<L> joint;
    joint.stretches = plan.stretches;
    joint.law = owns_joint(a, b, numbers, view) ? a : b;
    for (const auto& beyond : plan.beyond_ends) {
      if (beyond && owns_joint(*beyond, joint.law, numbers, view)) joint.law = *beyond;
    }
    // A half joint has the law of its own region.
    if (plan.half_of_node) joint.law = plan.is_before ? a : b;
    joint.stiffness = numbers[joint.law].stiffness;
    joint.axial_yield = numbers[joint.law].yield[law::kAxial];
    // The length of the owner's region that gives way as much.
    for (std::size_t k = 0; k < law::kSectionAxes; ++k) {
      joint.length[k] = constant<S>(plan.length[k]);
    }
    for (std::size_t axis = 0; axis < law::kAxial; ++axis) {
      if (a == b && joint.law == a && !plan.turns(axis)) continue;
      const auto parts =
          part_compliances(plan, axis, axis, kLengthsOfRotations, rotational[a], rotational[b]);
      joint.length[axis] = joint.stiffness[axis] * (parts[0] + parts[1]);
    }
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      const std::size_t axis = view.section_axes().rotation(k);
      if (plan.half_of_node || plan.node_spring[k] > 0.0) {
        const auto parts =
            part_compliances(plan, axis, axis, kLengthsOfRotations, rotational[a], rotational[b]);
        joint.length[axis] =
            joint.stiffness[axis] * node_compliance(plan, constant<S>(plan.node_spring[k]), parts);
      }
      joint.active[k] = constant<S>(plan.active[k] ? 1.0 : 0.0);
      joint.spring[k] = constant<S>(plan.spring[k]);
    }
    set_shifts(plan, shifting, view, joint);
    joints.push_back(joint);
  }
  return joints;
}

/// What constraints hold with beside their own equation: a hundred times the stiffness of the
/// beam's tip, of its largest section.
/// @param length  of the beam [m]
template <class L>
void set_constraint_stiffness(const std::vector<SectionJoint<L>>& joints, double length,
                              Chain<L>& chain) {
  double bending = 0.0;
  for (const SectionJoint<L>& joint : joints) {
    for (std::size_t k = 0; k < 3; ++k) bending = std::max<double>(bending, joint.stiffness[k]);
  }
  using S = typename L::Scalar;
  chain.constraint_stiffness = constant<S>(100.0 * bending / (length * length * length));
  chain.constraint_rotational_stiffness = constant<S>(100.0 * bending / length);
}

}  // namespace plastica::chain
