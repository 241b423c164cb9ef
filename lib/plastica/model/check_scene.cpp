#include <cmath>

#include "plastica/base/check.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/model/checked_scene.hpp"
#include "plastica/model/choose_level.hpp"
#include "plastica/model/field.hpp"
#include "plastica/model/free_motion.hpp"
#include "plastica/model/section_kind.hpp"

namespace plastica {
namespace {

/// The ranges of the field table. Materials and sections have checks of their own, which know what
/// a law or a shape leaves out.
void check_ranges(const Setup& setup) {
  static const std::vector<const Field*> kOthers = [] {
    std::vector<const Field*> others;
    for (const Field& field : fields()) {
      if (field.path.starts_with("material.") || field.path.starts_with("section.")) continue;
      others.push_back(&field);
    }
    return others;
  }();
  for (const Field* field : kOthers) {
    const FieldValue value = field->get(setup);
    if (const double* number = std::get_if<double>(&value)) check_field(*field, *number);
  }
}

/// What Wendelius' report has formulas for, in coupons and chains.
void check_report(const Scene& scene) {
  if (scene.formulas != Formulas::Report) return;
  const auto refuse_others = [](const Section& section) {
    const SectionKind& kind = section_kind(section);
    if (kind.in_report()) return;
    throw InputError({}, "rules.formulas", "report",
                     "Wendelius' report has formulas for rectangles and circles, none for " +
                         std::string(kind.word()));
  };
  refuse_others(scene.section);
  for (const Region& region : scene.regions) refuse_others(region.section);
  if (scene.yield_cap == YieldCap::FullyPlastic) {
    throw InputError({}, "rules.yield_cap", "fully_plastic", "Wendelius' caps are at first yield");
  }
}

/// What cannot be done with a section of which only the numbers are known.
void check_known(const Scene& scene, const SolverOptions& options) {
  const auto check = [&](const Section& section) {
    const SectionKind& kind = section_kind(section);
    if (kind.has_fibres()) return;
    const std::string shape = "section.shape = \"" + std::string(kind.word()) + "\"";
    if (scene.yield_model == YieldModel::Fibre) {
      throw InputError({}, "rules.yield_model", "fibre",
                       "needs the places of the fibres, which " + shape + " does not tell");
    }
    if (options.translation == JointTranslation::Elastic && !section.shear_coefficient) {
      throw InputError({}, "section.shear_coefficient", "",
                       "is missing: solver.translation = \"elastic\" shears, and " + shape +
                           " does not tell how stiffly");
    }
  };
  check(scene.section);
  for (const Region& region : scene.regions) check(region.section);
}

/// Where no point of a material has a rate of its own.
void check_rates(const Scene& scene, const SolverOptions& options) {
  std::string why;
  if (options.analysis == Analysis::Statics) {
    why = "a scene at rest, or a coupon, knows no time";
  } else if (is_articulated(options.scheme)) {
    why = "an articulated scheme has no rates of joints";
  } else if (options.precision == Precision::Float) {
    why = "solver.precision = \"float\" has no rates of joints";
  } else {
    return;
  }
  const auto check = [&](const Material& material, const std::string& of) {
    if (!has_own_rates(material)) return;
    throw InputError({}, of + "material.rate.strain_rate", "",
                     "is missing: " + why + "; the rate law needs a rate that all has");
  };
  check(scene.material, "");
  for (std::size_t i = 0; i < scene.regions.size(); ++i) {
    check(scene.regions[i].material, "region[" + std::to_string(i + 1) + "].");
  }
}

void check_coupon(const Setup& setup) {
  const auto& [scene, options] = setup;
  if (scene.beam.shape != BeamShape::Straight) {
    throw InputError({}, "beam.shape", "", "must be straight in a scene with a drive");
  }
  for (const double strain : scene.drive.strain) {
    if (!std::isfinite(strain)) {
      throw InputError({}, "drive.strain", std::to_string(strain), "must be finite");
    }
  }
  if (!scene.supports.empty() || !scene.loads.empty() || !scene.regions.empty() ||
      !scene.masses.empty() || scene.gravity != std::array<double, 3>{} ||
      !scene.initial_motions.empty() || !scene.cuts.empty()) {
    throw InputError({}, "drive.strain", "",
                     "does not go with supports, loads, masses, regions, gravity, initial motions "
                     "or cuts: a scene is a coupon or a chain");
  }
  model_detail::check_coupon_rules(setup);
  if (options.analysis == Analysis::Dynamics) {
    throw InputError({}, "solver.analysis", "dynamics",
                     "must be statics in a scene with a drive, which is at rest at each strain");
  }
  model_detail::check_statics(scene, options);
}

/// @return where its segments end
std::vector<double> check_chain(const Scene& scene, const SolverOptions& options) {
  const bool statics = options.analysis == Analysis::Statics;
  if (scene.supports.empty() && statics) {
    throw InputError({}, "support", "",
                     "is missing: a scene at rest has supports, or a drive; free flight needs "
                     "solver.analysis = \"dynamics\"");
  }
  std::vector<double> ends = model_detail::check_beam(scene);
  model_detail::check_rules(scene);
  model_detail::check_supports(scene, ends);
  model_detail::check_masses(scene);
  if (statics) {
    model_detail::check_statics(scene, options);
  } else {
    model_detail::check_dynamics(scene, options, ends);
  }
  model_detail::check_actions(scene, options.analysis, ends);
  model_detail::check_solver(scene, options);
  return ends;
}

}  // namespace

model_detail::CheckedScene model_detail::checked_scene(const Scene& scene,
                                                       const SolverOptions& options) {
  check_material(scene.material);
  check_section(scene.section);
  const Setup setup{scene, options};
  check_ranges(setup);
  check_report(scene);
  check_known(scene, options);
  check_rates(scene, options);
  std::vector<double> ends;
  if (scene.is_coupon()) {
    check_coupon(setup);
  } else {
    ends = check_chain(scene, options);
  }
  model_detail::check_precision(scene, options);
  model_detail::check_probes(scene, options.analysis, ends);
  if (!scene.is_coupon()) model_detail::check_hinges(scene, ends);
  LevelChoice level = choose_level(scene, options);
  model_detail::check_modes(scene, options, level);
  if (scene.is_coupon()) return {std::move(level), {}, {}};
  std::vector<int> cuts = model_detail::check_cuts(scene, level, ends);
  model_detail::check_articulated(scene, options, level, ends);
  if (options.analysis == Analysis::Dynamics) {
    return {std::move(level), std::move(ends), std::move(cuts)};
  }
  if (const auto free = model_detail::free_motion(scene, level, ends)) {
    const std::string name = level.reason.substr(0, level.reason.find(':'));
    throw InputError(
        {}, "support", "",
        "the supports together leave the beam free to " + *free + " (level " + name + ")");
  }
  return {std::move(level), std::move(ends), std::move(cuts)};
}

void check_scene(const Scene& scene, const SolverOptions& options) {
  (void)model_detail::checked_scene(scene, options);
}

}  // namespace plastica
