#include "plastica/model/region.hpp"

#include <algorithm>
#include <variant>

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

void follow_beginning(Region& region) {
  Setup from, to;
  from.scene.section = region.section;
  to.scene.section = *region.to_section;
  for (const Field& field : fields()) {
    if (!field.path.starts_with("section.")) continue;
    if (!is_own(region, "to_" + std::string(field.path))) field.set(to, field.get(from));
  }
  region.to_section = to.scene.section;
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
    if (region.to_section) follow_beginning(region);
    // A profile with other dimensions is no more the one that has a name.
    if (!owns_of(region, "section")) region.section.name = scene.section.name;
    if (!is_own(region, "material.name")) region.material.name = scene.material.name;
  }
}

Section tapered_section(const Region& region, double fraction) {
  Setup from, to;
  from.scene.section = region.section;
  to.scene.section = region.to_section.value_or(region.section);
  Setup between = from;
  between.scene.section.name.clear();
  for (const Field& field : fields()) {
    if (!field.path.starts_with("section.")) continue;
    const FieldValue values[] = {field.get(from), field.get(to)};
    const auto* a = std::get_if<double>(&values[0]);
    const auto* b = std::get_if<double>(&values[1]);
    if (a != nullptr && b != nullptr) field.set(between, (1.0 - fraction) * *a + fraction * *b);
  }
  return between.scene.section;
}

void set_everywhere(Setup& setup, const Field& field, const FieldValue& value) {
  set_field(setup, field, value);
  follow_beam(setup.scene);
}

}  // namespace plastica
