#include "plastica/run/beam_outline.hpp"

#include <algorithm>

#include "plastica/chain/joint_model.hpp"
#include "plastica/model/section_kind.hpp"
#include "plastica/run/chain_model.hpp"

namespace plastica {
namespace {

/// What the joints of a level stand for; an end without a joint, what the segment there does.
template <class L>
void add_joints(const ChainModel& model, const std::vector<chain::PartForm>& parts,
                const chain::View<L>& view, BeamOutline& outline) {
  const chain::Layout& layout = model.layout;
  const chain::Build<L> build =
      chain::Builder<L>(model.scene, layout, view, model.options.rotary_inertia).build();
  std::vector<MaterialValues<double>> materials;
  materials.reserve(parts.size());
  for (const chain::PartForm& part : parts) materials.push_back(material_values(*part.material));
  const auto joints = chain::joint_numbers(build.joints, parts, materials, view);
  for (const chain::JointModel& joint :
       chain::joint_models(model.scene, layout, build, parts, materials, joints, view)) {
    outline.joint_length.push_back(joint.own_length());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      outline.modulus.push_back(joint.modulus[axis]);
      outline.strain_per_angle.push_back(joint.strain_per_angle(axis));
    }
  }
}

}  // namespace

BeamOutline beam_outline(const Model& model) {
  BeamOutline outline;
  if (!model.chain) return outline;
  const ChainModel& chain = *model.chain;
  const chain::Layout& layout = chain.layout;
  const std::vector<chain::PartForm> parts = chain::part_forms(chain.scene, layout);
  const std::size_t n = layout.size();
  outline.ends = layout.ends;
  for (const auto& node : layout.node) {
    outline.node.insert(outline.node.end(), node.at.begin(), node.at.end());
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t k = 0; k < 3; ++k) {
        outline.axes.push_back(layout.segment_frame[i](k, axis));
      }
    }
    const chain::PartForm& part = parts[layout.segment_part[i].middle];
    outline.width.push_back(2.0 * part.properties.outer_distance_y);
    outline.height.push_back(2.0 * part.properties.outer_distance_x);
    outline.round.push_back(section_kind(*part.section).round() ? 1 : 0);
  }
  switch (chain.level) {
    case Level::Twist: add_joints<chain::Twist<double>>(chain, parts, {}, outline); break;
    case Level::Planar:
      add_joints<chain::Planar<double>>(chain, parts, {chain.across}, outline);
      break;
    default: add_joints<chain::Spatial<double>>(chain, parts, {}, outline);
  }
  return outline;
}

}  // namespace plastica
