#include "plastica/run/beam_outline.hpp"

#include <algorithm>

#include "plastica/chain/joint_numbers.hpp"
#include "plastica/run/chain_model.hpp"

namespace plastica {
namespace {

bool is_round(const Section& section) {
  return section.shape == SectionShape::Circle || section.shape == SectionShape::RoundTube;
}

}  // namespace

BeamOutline beam_outline(const Model& model) {
  BeamOutline outline;
  if (!model.chain) return outline;
  const ChainModel& chain = *model.chain;
  const chain::Layout& layout = chain.layout;
  const std::vector<chain::PartForm> parts = chain::part_forms(chain.scene);
  const std::size_t n = layout.size();
  outline.ends = layout.ends;
  outline.joint_length = layout.joint_length;
  for (const auto& node : layout.node) {
    outline.node.insert(outline.node.end(), node.at.begin(), node.at.end());
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t k = 0; k < 3; ++k) {
        outline.axes.push_back(layout.segment_frame[i](k, axis));
      }
    }
    const chain::PartForm& part = parts[chain.part_of_segment[i]];
    outline.width.push_back(2.0 * part.properties.outer_distance_y);
    outline.height.push_back(2.0 * part.properties.outer_distance_x);
    outline.round.push_back(is_round(*part.section) ? 1 : 0);
  }
  for (std::size_t i = 0; i <= n; ++i) {
    // A joint has the section of the segment behind it, the last one that of the last segment.
    const law::SectionForm& form = parts[chain.part_of_segment[std::min(i, n - 1)]].form;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      outline.modulus.push_back(form.modulus[axis]);
      outline.strain_per_angle.push_back(form.lever[axis] / layout.joint_length[i]);
    }
  }
  return outline;
}

}  // namespace plastica
