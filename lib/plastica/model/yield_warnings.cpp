#include "plastica/model/yield_warnings.hpp"

#include <algorithm>
#include <array>

#include "plastica/model/hardening_kind.hpp"
#include "plastica/model/scene_actions.hpp"
#include "plastica/model/section_kind.hpp"

namespace plastica::model_detail {
namespace {

/// Whether anything bends the beam about x, and about y.
std::array<bool, 2> bent_axes(const Scene& scene) {
  std::array<bool, 2> bent{};
  for (const SceneAction& action : actions_of(scene)) {
    const bool rotates = action.sense == VectorSense::Rotate;
    bent[0] = bent[0] || action.vector[rotates ? 0 : 1] != 0.0;
    bent[1] = bent[1] || action.vector[rotates ? 1 : 0] != 0.0;
  }
  return bent;
}

/// Whether anything twists the beam: about its axis, or by its shape.
bool twisted(const Scene& scene, const LevelChoice& level) {
  const bool curved = scene.beam.shape != BeamShape::Straight;
  return level.level == Level::Spatial &&
         (curved ||
          std::any_of(scene.loads.begin(), scene.loads.end(),
                      [](const Load& load) { return load.moment[2] != 0.0; }) ||
          std::any_of(scene.supports.begin(), scene.supports.end(),
                      [](const Support& support) { return support.rotation[2] != 0.0; }) ||
          std::any_of(scene.initial_motions.begin(), scene.initial_motions.end(),
                      [](const InitialMotion& motion) { return motion.spin[2] != 0.0; }));
}

/// Whether something is true of the section and material of any part of the beam.
template <class Is>
bool of_any_part(const Scene& scene, const Is& is) {
  return is(scene.section, scene.material) ||
         std::any_of(scene.regions.begin(), scene.regions.end(),
                     [&](const Region& region) { return is(region.section, region.material); });
}

bool any_warps(const Scene& scene, SectionWarping warping) {
  return of_any_part(scene, [&](const Section& section, const Material&) {
    return section_kind(section).warping() == warping;
  });
}

}  // namespace

std::optional<std::string> per_axis_warning(const Scene& scene, const LevelChoice& level) {
  if (scene.yield_model != YieldModel::PerAxis) return std::nullopt;
  const auto bent = bent_axes(scene);
  if ((bent[0] || bent[1]) && !(bent[0] && bent[1]) && twisted(scene, level)) {
    // The corner (1, 1) against m^2 + t^2 = 1.
    return "rules.yield_model = \"per_axis\" with bending and torsion: the joint carries up to "
           "41 % more than the section; \"interaction\" and \"fibre\" do not";
  }
  if (!bent[0] || !bent[1]) return std::nullopt;
  const bool plastic = scene.yield_cap == YieldCap::FullyPlastic;
  const std::string beyond(section_kind(scene.section).beyond_caps(plastic));
  return "rules.yield_model = \"per_axis\" with bending about both axes: the joint carries up to " +
         beyond + " more than the section, with torsion still more; \"interaction\" does not";
}

std::optional<std::string> warping_warning(const Scene& scene, const LevelChoice& level) {
  if (level.level != Level::Twist && !twisted(scene, level)) return std::nullopt;
  if (any_warps(scene, SectionWarping::Much)) {
    return "the beam twists, and its section is open: torsion is Saint-Venant's alone. Where "
           "warping is held (a clamped end, a torque along the way) the true beam is stiffer and "
           "stronger";
  }
  if (!any_warps(scene, SectionWarping::Unknown)) return std::nullopt;
  return "the beam twists, and of its section only the numbers are known: torsion is "
         "Saint-Venant's alone. If the section is open, the true beam is stiffer and stronger "
         "where warping is held (a clamped end, a torque along the way)";
}

std::optional<std::string> tipping_warning(const Scene& scene) {
  const auto bent = bent_axes(scene);
  if (!bent[0] && !bent[1]) return std::nullopt;
  const bool open = any_warps(scene, SectionWarping::Much);
  if (!open && !any_warps(scene, SectionWarping::Unknown)) return std::nullopt;
  return std::string("the beam leaves its plane, and ") +
         (open ? "its section is open" : "of its section only the numbers are known") +
         ": torsion is Saint-Venant's alone. An open section that warps tips out at a higher load";
}

std::optional<std::string> softening_warning(const Scene& scene) {
  const auto softens = [](const Section&, const Material& material) {
    return hardening_kind(material.hardening.law).softens(material);
  };
  if (scene.yield_model == YieldModel::Elastic || !of_any_part(scene, softens)) return {};
  return "the table of material.hardening falls: where it does, yielding gathers in one joint, and "
         "the path depends on the joint's length, which beam.segments sets";
}

}  // namespace plastica::model_detail
