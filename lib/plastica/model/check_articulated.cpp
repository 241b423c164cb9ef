#include <string>
#include <string_view>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/support_kind.hpp"

namespace plastica::model_detail {
namespace {

[[noreturn]] void refuse(std::string_view field, std::string_view value, std::string_view rule) {
  throw InputError({}, field, value, rule);
}

/// The one support: what else holds the beam would need equations of its own.
void check_support(const Scene& scene, Ends ends) {
  constexpr std::string_view kRule =
      "an articulated scheme is of a beam that a clamp or a pin holds at its start, and nothing "
      "else; \"linearly_implicit_midpoint\" takes all supports";
  if (scene.supports.empty()) refuse("support", "", kRule);
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    const Support& support = scene.supports[i];
    const SupportTraits& kind = traits_of(support);
    const bool holds = !kind.springs && !kind.normal && !kind.releases;
    const bool at_start = fraction_of(support.at, ends) == 0.0;
    if (i > 0 || !holds || !at_start) refuse(item_name("support", i), "", kRule);
    const HeldFreedoms held = support.held();
    if (!held[0] || !held[1] || !held[2]) {
      refuse(item_name("support", i, ".hold"), "",
             "must hold x, y and z with an articulated scheme");
    }
    if (support.moves()) {
      refuse(item_name("support", i), "", "must not move with an articulated scheme");
    }
  }
}

/// What only the spatial kernels do not hold.
void check_space(const Scene& scene) {
  if (scene.beam.shape != BeamShape::Straight) {
    refuse("beam.shape", "", "must be straight with an articulated scheme in space");
  }
  const HeldFreedoms held = scene.supports[0].held();
  if (!(held[3] && held[4] && held[5]) && !has_half_joints(scene)) {
    refuse("rules.end_rule", "",
           "must be half_joint with an articulated scheme in space, where the start may turn");
  }
  if (scene.yield_model == YieldModel::Interaction ||
      scene.yield_model == YieldModel::Conservative) {
    refuse("rules.yield_model",
           scene.yield_model == YieldModel::Interaction ? "interaction" : "conservative",
           "must be elastic or per_axis with an articulated scheme in space");
  }
}

/// The field that lets joints break; empty if none does.
std::string break_field(const Scene& scene) {
  if (scene.yield_model == YieldModel::Elastic) return {};  // nothing flows
  if (scene.material.break_strain) return "material.break_strain";
  if (scene.material.break_shear_strain) return "material.break_shear_strain";
  if (scene.break_limit_x) return "rules.break_limit_x";
  if (scene.break_limit_y) return "rules.break_limit_y";
  if (scene.break_limit_z) return "rules.break_limit_z";
  for (std::size_t i = 0; i < scene.regions.size(); ++i) {
    const Material& material = scene.regions[i].material;
    if (material.break_strain) return item_name("region", i, ".material.break_strain");
    if (material.break_shear_strain) return item_name("region", i, ".material.break_shear_strain");
  }
  return {};
}

}  // namespace

void check_articulated(const Scene& scene, const SolverOptions& options, const LevelChoice& level,
                       Ends ends) {
  if (options.analysis != Analysis::Dynamics || !is_articulated(options.scheme)) return;
  static_cast<void>(resolved(options.isa));
  check_support(scene, ends);
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    if (scene.loads[i].follows) {
      refuse(item_name("load", i, ".follows"), "true",
             "articulated schemes have loads that keep their direction");
    }
  }
  if (level.level == Level::Twist) {
    refuse("solver.level", level.reason, "must be planar or spatial with an articulated scheme");
  }
  if (level.level == Level::Spatial) check_space(scene);
  if (options.translation == JointTranslation::Elastic) {
    refuse("solver.translation", "elastic", "must be rigid with an articulated scheme");
  }
  if (options.step_error > 0.0) {
    refuse("solver.step_error", "", "articulated schemes have steps of one length");
  }
  if (options.damping == Damping::Relaxation) {
    refuse("solver.damping", "relaxation", "must be none or stiffness with an articulated scheme");
  }
  if (!scene.cuts.empty()) {
    refuse(item_name("cut", 0), "", "articulated schemes know no cuts");
  }
  if (const std::string field = break_field(scene); !field.empty()) {
    refuse(field, "",
           "articulated schemes know no breaks: leave it away, or take "
           "\"linearly_implicit_midpoint\"");
  }
  const bool yields = scene.yield_model != YieldModel::Elastic;
  bool ideal = scene.material.hardening.law == HardeningLaw::Ideal;
  for (const Region& region : scene.regions) {
    ideal = ideal && region.material.hardening.law == HardeningLaw::Ideal;
  }
  if (yields && (!ideal || scene.yield_model == YieldModel::Fibre)) {
    refuse("rules.yield_model", scene.yield_model == YieldModel::Fibre ? "fibre" : "",
           "articulated schemes have elastic or ideally plastic joints");
  }
}

}  // namespace plastica::model_detail
