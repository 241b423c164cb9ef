#include "plastica/model/region.hpp"

#include <algorithm>

namespace plastica {
namespace {

bool is_of_part(std::string_view path) {
  return path.starts_with("section.") || path.starts_with("material.");
}

/// Whether anything of a part, "section", is a region's own.
bool owns_of(const Region& region, std::string_view part) {
  return std::ranges::any_of(region.own,
                             [&](const std::string& own) { return own.starts_with(part); });
}

}  // namespace

bool is_own(const Region& region, std::string_view path) {
  return std::ranges::any_of(region.own, [&](const std::string& own) {
    return path.starts_with(own) && (path.size() == own.size() || path[own.size()] == '.');
  });
}

bool stands_in_regions(const Scene& scene, const Field& field) {
  return is_of_part(field.path) && std::ranges::any_of(scene.regions, [&](const Region& region) {
           return !is_own(region, field.path);
         });
}

void follow_beam(Scene& scene) {
  if (scene.regions.empty()) return;
  Setup beam;
  beam.scene.section = scene.section;
  beam.scene.material = scene.material;
  for (Region& region : scene.regions) {
    Setup part;
    part.scene.section = region.section;
    part.scene.material = region.material;
    for (const Field& field : fields()) {
      if (is_of_part(field.path) && !is_own(region, field.path)) field.set(part, field.get(beam));
    }
    region.section = part.scene.section;
    region.material = part.scene.material;
    // A profile with other dimensions is no more the one that has a name.
    if (!owns_of(region, "section")) region.section.name = scene.section.name;
    if (!is_own(region, "material.name")) region.material.name = scene.material.name;
  }
}

void set_everywhere(Setup& setup, const Field& field, const FieldValue& value) {
  set_field(setup, field, value);
  follow_beam(setup.scene);
}

}  // namespace plastica
