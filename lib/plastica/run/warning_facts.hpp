#pragma once

#include <algorithm>

#include "plastica/model/choose_level.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/model.hpp"

/// What warnings need to know of a scene; not installed.
namespace plastica::run_detail {

/// What the warnings need to know of a scene.
struct Facts {
  explicit Facts(const Model& of)
      : model(of),
        scene(of.chain->scene),
        options(of.chain->options),
        layout(of.chain->layout),
        section(layout.regions[0].properties),
        level{of.level, of.chain->across == 1 ? BendingAxis::X : BendingAxis::Y, {}} {}

  const Model& model;
  const Scene& scene;
  const SolverOptions& options;
  const chain::Layout& layout;
  const SectionProperties& section;  ///< of the scene's own
  LevelChoice level;
};

inline bool bends_about_x(const LevelChoice& level) {
  return level.level == Level::Spatial ||
         (level.level == Level::Planar && level.bending == BendingAxis::X);
}
inline bool bends_about_y(const LevelChoice& level) {
  return level.level == Level::Spatial ||
         (level.level == Level::Planar && level.bending == BendingAxis::Y);
}

/// Calls `use` with each segment's length [m] and the region of the beam that it is of.
template <class Use>
void for_each_segment(const Facts& facts, const Use& use) {
  const chain::Layout& layout = facts.layout;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    use(layout.segment_length[i], layout.regions[layout.segment_regions[i].middle]);
  }
}

/// Depth in bending about an axis, the mean over the beam [m].
inline double depth_of(const Facts& facts, bool about_x) {
  double sum = 0.0;
  double length = 0.0;
  for_each_segment(facts, [&](double along, const chain::BeamRegion& region) {
    const SectionProperties& section = region.properties;
    sum += along * 2.0 * (about_x ? section.outer_distance_x : section.outer_distance_y);
    length += along;
  });
  return sum / length;
}

/// Fully plastic moment (or torque) over that at first yield, of the scene's own section.
/// In space the larger one of both axes.
inline double shape_factor(const Facts& facts) {
  const SectionProperties& section = facts.section;
  const double about_x = section.plastic_section_modulus_x / section.section_modulus_x;
  const double about_y = section.plastic_section_modulus_y / section.section_modulus_y;
  if (facts.level.level == Level::Spatial) return std::max(about_x, about_y);
  if (bends_about_x(facts.level)) return about_x;
  if (bends_about_y(facts.level)) return about_y;
  return section.plastic_torsion_modulus / section.torsion_modulus;
}

/// Whether yielding gathers in one joint: no hardening, and not a section of fibres.
inline bool is_ideal(const Scene& scene) {
  return scene.yield_model != YieldModel::Fibre &&
         scene.material.hardening.law == HardeningLaw::Ideal;
}

}  // namespace plastica::run_detail
