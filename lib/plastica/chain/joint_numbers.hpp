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

/// The parts of a scene: its own, then its regions.
/// @param with_gauge  whether the level yields on one surface, if the scene's yield model has one
/// @param plane       what the level bends about
inline std::vector<PartForm> part_forms(const Scene& scene, bool with_gauge = false,
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
  add(scene.section, scene.material);
  for (const Region& region : scene.regions) add(region.section, region.material);
  return parts;
}

/// The numbers of a level's joints.
///
/// Where two parts meet, a joint has the law of the part that yields first in bending about x, and
/// in each component the stiffness of both halves in a row: l_k = K_k (l_a/K_ak + l_b/K_bk).
/// @param materials  numbers of each part (parts)
template <class L>
std::vector<SectionJoint<L>> joint_numbers(
    const Layout& layout, const std::vector<std::size_t>& part_of_segment,
    const std::vector<JointPlan>& plans, const std::vector<PartForm>& parts,
    const std::vector<MaterialValues<typename L::Scalar>>& materials, const View<L>& view) {
  using S = typename L::Scalar;
  std::vector<law::SectionForce<S>> stiffness;
  std::vector<S> yield;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    stiffness.push_back(law::elastic_section(parts[p].form, materials[p]).stiffness);
    yield.push_back(constant<S>(parts[p].form.modulus[law::kBendingX]) *
                    law::uniaxial_material(parts[p].form.axis[law::kBendingX], materials[p]).yield);
  }
  std::vector<SectionJoint<L>> joints;
  for (const JointPlan& plan : plans) {
    const std::size_t a = part_of_segment[plan.segment_a];
    const std::size_t b = part_of_segment[plan.segment_b];
    SectionJoint<L> joint;
    joint.law = any(yield[b] < yield[a]) ? b : a;
    const double whole =
        layout.segment_length[plan.segment_a] + layout.segment_length[plan.segment_b];
    const double share_a = layout.segment_length[plan.segment_a] / whole;
    for (std::size_t k = 0; k < law::kSectionAxes; ++k) {
      joint.stiffness[k] = stiffness[joint.law][k];
      const S part_a = constant<S>(share_a) * joint.stiffness[k] / stiffness[a][k];
      const S part_b = constant<S>(1.0 - share_a) * joint.stiffness[k] / stiffness[b][k];
      joint.length[k] = constant<S>(plan.length) * (a == b ? constant<S>(1) : part_a + part_b);
    }
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      joint.acting[k] = constant<S>(plan.acting[k] ? 1.0 : 0.0);
      joint.spring[k] = constant<S>(plan.spring[k]);
    }
    joint.axial_yield =
        constant<S>(parts[joint.law].form.modulus[law::kAxial]) *
        law::uniaxial_material(parts[joint.law].form.axis[law::kAxial], materials[joint.law]).yield;
    const SectionProperties& p = parts[joint.law].properties;
    const S shear_modulus =
        law::uniaxial_material(parts[joint.law].form.axis[law::kTorsion], materials[joint.law])
            .stiffness /
        constant<S>(parts[joint.law].form.axis[law::kTorsion].stiffness_factor);
    joint.shear_stiffness =
        shear_modulus *
        view.point({{p.shear_coefficient_x * p.area, p.shear_coefficient_y * p.area, 0.0}});
    joints.push_back(joint);
  }
  return joints;
}

}  // namespace plastica::chain
