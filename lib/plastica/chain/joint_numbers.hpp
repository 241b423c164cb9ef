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

/// The numbers of a level's joints.
///
/// Where two regions meet, one of them owns the joint (`owns_joint`): the joint has its law, lever
/// and break limits, and in each component the stiffness of both lengths in a row:
/// l_k = K_k (l_a/K_ak + l_b/K_bk).
/// @param materials  numbers of each region (regions)
template <class L>
std::vector<SectionJoint<L>> joint_numbers(
    const std::vector<JointPlan>& plans, const std::vector<BeamRegion>& regions,
    const std::vector<MaterialValues<typename L::Scalar>>& materials, const View<L>& view) {
  using S = typename L::Scalar;
  std::vector<RegionNumbers<S>> numbers;
  std::vector<typename L::Point> shear;
  for (std::size_t p = 0; p < regions.size(); ++p) {
    numbers.push_back(region_numbers(regions[p], materials[p]));
    const SectionProperties& properties = regions[p].properties;
    shear.push_back(numbers[p].shear_modulus *
                    view.point({{properties.shear_coefficient_x * properties.area,
                                 properties.shear_coefficient_y * properties.area, 0.0}}));
  }
  std::vector<SectionJoint<L>> joints;
  for (const JointPlan& plan : plans) {
    const std::size_t a = plan.region_a;
    const std::size_t b = plan.region_b;
    SectionJoint<L> joint;
    joint.stretches = plan.stretches;
    joint.law = owns_joint(a, b, numbers, view) ? a : b;
    // The length of the owner's region that has the compliance of both.
    const auto in_a_row = [&](std::size_t k, const S& own, const S& of_a, const S& of_b) {
      return constant<S>(plan.before[k]) * own / of_a +
             constant<S>(plan.length[k] - plan.before[k]) * own / of_b;
    };
    // A half joint has the law of its own region.
    if (plan.half_of_node) joint.law = plan.is_before ? a : b;
    joint.stiffness = numbers[joint.law].stiffness;
    joint.axial_yield = numbers[joint.law].yield[law::kAxial];
    for (std::size_t k = 0; k < law::kSectionAxes; ++k) {
      joint.length[k] = a == b ? constant<S>(plan.length[k])
                               : in_a_row(k, joint.stiffness[k], numbers[a].stiffness[k],
                                          numbers[b].stiffness[k]);
    }
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      const std::size_t axis = view.section_axes().rotation(k);
      const auto halves = std::array{
          constant<S>(plan.before[axis]) / numbers[a].stiffness[axis],
          constant<S>(plan.length[axis] - plan.before[axis]) / numbers[b].stiffness[axis]};
      if (plan.half_of_node || plan.node_spring[k] > 0.0) {
        joint.length[axis] =
            joint.stiffness[axis] * node_compliance(plan, constant<S>(plan.node_spring[k]), halves);
      }
      joint.active[k] = constant<S>(plan.active[k] ? 1.0 : 0.0);
      joint.spring[k] = constant<S>(plan.spring[k]);
    }
    joint.shear_stiffness = shear[joint.law];
    if (a != b) {
      for (std::size_t k = 0; k < L::kTranslations; ++k) {
        const S own = joint.shear_stiffness[k];
        if (!any(own > constant<S>(0))) continue;  // along the beam
        const S length = in_a_row(law::kAxial, own, shear[a][k], shear[b][k]);
        joint.shear_stiffness[k] = own * joint.length[law::kAxial] / length;
      }
    }
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
