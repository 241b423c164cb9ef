#include "sweeps/plan/section_axes.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "plastica/model/section_kind.hpp"

namespace plastica::sweeps {
namespace {

bool has_dimension(const SectionKind& kind, const Field& field) {
  const auto own = kind.dimensions();
  return std::any_of(own.begin(), own.end(), [&](const Field& f) { return f.path == field.path; });
}

/// Shapes of the cases' sections.
std::vector<const SectionKind*> shapes_of(const Sweep& sweep) {
  std::vector<const SectionKind*> kinds;
  for (const Axis& axis : sweep.axes) {
    if (axis.field->path != "section.shape") continue;
    for (const FieldValue& value : axis.values) {
      Setup setup = sweep.setup;
      axis.field->set(setup, value);
      kinds.push_back(&section_kind(setup.scene.section));
    }
  }
  if (kinds.empty()) kinds.push_back(&section_kind(sweep.setup.scene.section));
  return kinds;
}

}  // namespace

bool is_section_dimension(const Field& field) {
  const auto kinds = section_kinds();
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](const SectionKind* kind) { return has_dimension(*kind, field); });
}

void check_section_axes(const Sweep& sweep) {
  const std::vector<const SectionKind*> shapes = shapes_of(sweep);
  for (const Axis& axis : sweep.axes) {
    if (!is_section_dimension(*axis.field)) continue;
    const bool moves = std::any_of(shapes.begin(), shapes.end(), [&](const SectionKind* kind) {
      return has_dimension(*kind, *axis.field);
    });
    if (moves) continue;
    throw InputError(axis.where, std::string(axis.field->path), "",
                     "moves nothing: section.shape is " + std::string(shapes.front()->word()) +
                         (shapes.size() > 1 ? " and others" : "") + ", without that dimension");
  }
  const SectionKind& base = section_kind(sweep.setup.scene.section);
  for (const Axis& axis : sweep.axes) {
    if (axis.field->path != "section.shape") continue;
    for (const SectionKind* kind : shapes) {
      for (const Field& field : kind->dimensions()) {
        if (has_dimension(base, field) || !kind->needs(field)) continue;
        const bool given = std::any_of(sweep.axes.begin(), sweep.axes.end(),
                                       [&](const Axis& a) { return a.field->path == field.path; });
        if (given) continue;
        throw InputError(axis.where, "section.shape", std::string(kind->word()),
                         "needs " + std::string(field.path) + ", in [set] or as an axis");
      }
    }
  }
}

}  // namespace plastica::sweeps
