#pragma once

#include <cstddef>
#include <vector>

#include "plastica/chain/build.hpp"
#include "plastica/law/gauge_form.hpp"
#include "plastica/law/per_axis.hpp"
#include "plastica/model/material_field.hpp"

namespace plastica::chain {

/// What a part of a beam (the scene's own section and material, or a region's) says of its joints.
struct PartForm {
  const Section* section = nullptr;
  const Material* material = nullptr;
  SectionProperties properties{};
  law::SectionForm form{};
  law::GaugeForm gauge{};  ///< of a yield model with one surface
};

/// The parts of a beam, in the order of the layout, which they point into.
/// @param with_gauge  whether the level yields on one surface, if the scene's yield model has one
/// @param plane       what the level bends about
inline std::vector<PartForm> part_forms(const Scene& scene, const Layout& layout,
                                        bool with_gauge = false,
                                        law::GaugePlane plane = law::GaugePlane::Both) {
  std::vector<PartForm> parts;
  const bool one_surface =
      scene.yield_model == YieldModel::Interaction || scene.yield_model == YieldModel::Conservative;
  const auto add = [&](const Section& section, const Material& material) {
    PartForm part{&section, &material, section_properties(section, material.poisson_ratio), {}, {}};
    if (with_gauge && one_surface) {
      // Of a rectangle it takes milliseconds, and does not depend on the material: once a chain.
      part.gauge =
          law::gauge_form(section, scene.yield_model, scene.yield_cap, scene.formulas, plane);
    }
    part.form =
        law::section_form(section, part.properties, material, scene.yield_cap, scene.formulas);
    parts.push_back(part);
  };
  for (const BeamPart& part : layout.parts) add(part.section, part.material);
  return parts;
}

/// Whether a part owns a joint with another one, rather than the other way round: the one that
/// yields first about the axes of the level, by the product of its moments there; of equally strong
/// ones the softer, of equally soft ones the first. It does not depend on which of them is before
/// the joint.
/// @param yield      moments at which the parts yield [N m]
/// @param stiffness  EI_x, EI_y, GJ of the parts [N m^2]
template <class L>
bool owns_joint(std::size_t part, std::size_t other,
                const std::vector<law::SectionForce<typename L::Scalar>>& yield,
                const std::vector<law::SectionForce<typename L::Scalar>>& stiffness,
                const View<L>& view) {
  using S = typename L::Scalar;
  const auto product = [&](const law::SectionForce<S>& of) {
    S all = constant<S>(1);
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      all = all * of[view.section_axes().rotation(k)];
    }
    return all;
  };
  const S less = constant<S>(1.0 - 1e-9);
  for (const auto* values : {&yield, &stiffness}) {
    const S own = product((*values)[part]);
    const S others = product((*values)[other]);
    if (any(own < less * others)) return true;
    if (any(others < less * own)) return false;
  }
  return part <= other;
}

/// The numbers of a level's joints.
///
/// Where two parts meet, one of them owns the joint (`owns_joint`): the joint has its law, lever
/// and break limits, and in each component the stiffness of both lengths in a row:
/// l_k = K_k (l_a/K_ak + l_b/K_bk).
/// @param materials  numbers of each part (parts)
template <class L>
std::vector<SectionJoint<L>> joint_numbers(
    const std::vector<JointPlan>& plans, const std::vector<PartForm>& parts,
    const std::vector<MaterialValues<typename L::Scalar>>& materials, const View<L>& view) {
  using S = typename L::Scalar;
  std::vector<law::SectionForce<S>> stiffness;
  std::vector<law::SectionForce<S>> yield;
  std::vector<typename L::Point> shear;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    stiffness.push_back(law::elastic_section(parts[p].form, materials[p]).stiffness);
    law::SectionForce<S> moment;
    for (std::size_t k = 0; k < law::kSectionAxes; ++k) {
      moment[k] = constant<S>(parts[p].form.modulus[k]) *
                  law::uniaxial_material(parts[p].form.axis[k], materials[p]).yield;
    }
    yield.push_back(moment);
    const SectionProperties& properties = parts[p].properties;
    const law::UniaxialForm& torsion = parts[p].form.axis[law::kTorsion];
    const S shear_modulus = law::uniaxial_material(torsion, materials[p]).stiffness /
                            constant<S>(torsion.stiffness_factor);
    shear.push_back(shear_modulus *
                    view.point({{properties.shear_coefficient_x * properties.area,
                                 properties.shear_coefficient_y * properties.area, 0.0}}));
  }
  std::vector<SectionJoint<L>> joints;
  for (const JointPlan& plan : plans) {
    const std::size_t a = plan.part_a;
    const std::size_t b = plan.part_b;
    SectionJoint<L> joint;
    joint.stretches = plan.stretches;
    joint.law = owns_joint(a, b, yield, stiffness, view) ? a : b;
    // The length of the owner's part that has the compliance of both.
    const auto in_a_row = [&](std::size_t k, const S& own, const S& of_a, const S& of_b) {
      return constant<S>(plan.before[k]) * own / of_a +
             constant<S>(plan.length[k] - plan.before[k]) * own / of_b;
    };
    for (std::size_t k = 0; k < law::kSectionAxes; ++k) {
      joint.stiffness[k] = stiffness[joint.law][k];
      joint.length[k] = a == b ? constant<S>(plan.length[k])
                               : in_a_row(k, joint.stiffness[k], stiffness[a][k], stiffness[b][k]);
    }
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      joint.acting[k] = constant<S>(plan.acting[k] ? 1.0 : 0.0);
      joint.spring[k] = constant<S>(plan.spring[k]);
    }
    joint.axial_yield =
        constant<S>(parts[joint.law].form.modulus[law::kAxial]) *
        law::uniaxial_material(parts[joint.law].form.axis[law::kAxial], materials[joint.law]).yield;
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

}  // namespace plastica::chain
