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
    joint.stiffness = numbers[joint.law].stiffness;
    joint.axial_yield = numbers[joint.law].yield[law::kAxial];
    for (std::size_t k = 0; k < law::kSectionAxes; ++k) {
      joint.length[k] = a == b ? constant<S>(plan.length[k])
                               : in_a_row(k, joint.stiffness[k], numbers[a].stiffness[k],
                                          numbers[b].stiffness[k]);
    }
    for (std::size_t k = 0; k < L::kRotations; ++k) {
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
