#include "calibrate/scene/set_everywhere.hpp"

#include <algorithm>
#include <utility>

namespace plastica::calibrate {
namespace {

Setup setup_with(const Material& material) {
  Setup setup;
  setup.scene.material = material;
  return setup;
}

bool is_the_scenes_material(const Setup& setup, const Setup& of_region) {
  return std::ranges::all_of(fields(), [&](const Field& field) {
    return !field.path.starts_with("material.") || field.get(of_region) == field.get(setup);
  });
}

bool is_unset_limit(const Field& field, const Setup& setup) {
  const bool limit = field.material == MaterialField::BreakStrain ||
                     field.material == MaterialField::BreakShearStrain;
  return limit && std::holds_alternative<std::monostate>(field.get(setup));
}

}  // namespace

bool has_the_scenes(const Setup& setup, const Field& field, const Region& region) {
  if (!field.material) return false;
  const Setup of_region = setup_with(region.material);
  if (field.get(of_region) != field.get(setup)) return false;
  return !is_unset_limit(field, setup) || is_the_scenes_material(setup, of_region);
}

void set_everywhere(const Setup& original, const Field& field, double value, Setup& setup) {
  for (std::size_t i = 0; i < original.scene.regions.size(); ++i) {
    if (!has_the_scenes(original, field, original.scene.regions[i])) continue;
    Setup of_region = setup_with(setup.scene.regions[i].material);
    set_field(of_region, field, value);
    setup.scene.regions[i].material = std::move(of_region.scene.material);
  }
  set_field(setup, field, value);
}

bool stands_in_regions(const Setup& setup, const Field& field) {
  const auto& regions = setup.scene.regions;
  return std::any_of(regions.begin(), regions.end(),
                     [&](const Region& region) { return has_the_scenes(setup, field, region); });
}

}  // namespace plastica::calibrate
