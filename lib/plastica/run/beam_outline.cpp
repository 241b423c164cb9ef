#include "plastica/run/beam_outline.hpp"

#include <algorithm>

#include "plastica/model/section_kind.hpp"
#include "plastica/run/scene_joints.hpp"

namespace plastica {
namespace {

template <class L>
std::vector<chain::JointModel> joints_of(const ChainModel& model, const chain::View<L>& view,
                                         const MaterialValues<double>& material) {
  const Scene& scene = model.scene;
  const auto build =
      chain::build_chain<L>(scene, model.layout, view, {model.options.rotary_inertia});
  return chain::joint_set(scene, model.layout, build, material, view).at_nodes;
}

}  // namespace

std::vector<chain::JointModel> scene_joints(const ChainModel& model,
                                            const MaterialValues<double>& material) {
  switch (model.level) {
    case Level::Twist: return joints_of<chain::Twist<double>>(model, {}, material);
    case Level::Planar: return joints_of<chain::Planar<double>>(model, {model.across}, material);
    default: return joints_of<chain::Spatial<double>>(model, {}, material);
  }
}

BeamOutline beam_outline(const Model& model) {
  BeamOutline outline;
  if (!model.chain) return outline;
  const ChainModel& chain = *model.chain;
  const chain::Layout& layout = chain.layout;
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
    const chain::BeamRegion& region = layout.regions[layout.segment_regions[i].middle];
    outline.width.push_back(2.0 * region.properties.outer_distance_y);
    outline.height.push_back(2.0 * region.properties.outer_distance_x);
    outline.round.push_back(section_kind(region.section).round() ? 1 : 0);
  }
  // An end without a joint stands for what the segment there does.
  for (const chain::JointModel& joint :
       scene_joints(chain, material_values(chain.scene.material))) {
    outline.joint_length.push_back(joint.own_length());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      outline.modulus.push_back(joint.modulus[axis]);
      outline.strain_per_angle.push_back(joint.strain_per_angle(axis));
    }
  }
  return outline;
}

}  // namespace plastica
