#include "calibrate/scene/set_everywhere.hpp"

#include <algorithm>
#include <utility>

namespace plastica::calibrate {
namespace {

Setup setup_of(const Material& material) {
  Setup setup;
  setup.scene.material = material;
  return setup;
}

bool has_the_scenes(const Setup& original, const Field& field, const Region& region) {
  return field.material && field.get(setup_of(region.material)) == field.get(original);
}

}  // namespace

void set_everywhere(const Setup& original, const Field& field, double value, Setup& setup) {
  for (std::size_t i = 0; i < original.scene.regions.size(); ++i) {
    if (!has_the_scenes(original, field, original.scene.regions[i])) continue;
    Setup of_region = setup_of(setup.scene.regions[i].material);
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
