#include "sweeps/plan/derived_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "plastica/model/field_table.hpp"
#include "plastica/model/material_table.hpp"
#include "plastica/model/section.hpp"

namespace plastica::sweeps {
namespace {

constexpr Range kPositive{0.0, std::numeric_limits<double>::infinity(), true, false};

double number_of(const FieldValue& value) { return std::get<double>(value); }

/// The section's size in the plane of bending about x [m].
double depth(const Setup& setup) {
  return 2.0 * section_properties(setup.scene.section, setup.scene.material.poisson_ratio)
                   .outer_distance_x;
}

void scale(std::array<double, 3>& vector, double factor) {
  for (double& component : vector) component *= factor;
}

void scale_loads(Setup& setup, const FieldValue& value) {
  for (Load& load : setup.scene.loads) {
    scale(load.force, number_of(value));
    scale(load.moment, number_of(value));
  }
}

void scale_motions(Setup& setup, const FieldValue& value) {
  for (Support& support : setup.scene.supports) {
    scale(support.translation, number_of(value));
    scale(support.rotation, number_of(value));
  }
  for (InitialMotion& motion : setup.scene.initial_motions) {
    scale(motion.velocity, number_of(value));
    scale(motion.spin, number_of(value));
  }
  for (double& strain : setup.scene.drive.strain) strain *= number_of(value);
  scale(setup.solver.control_motion, number_of(value));
}

/// What a value of this dimension grows by when all lengths do.
double size_factor(Dimension dimension, double factor) {
  switch (dimension) {
    case Dimension::Length: return factor;
    case Dimension::Area: return factor * factor;
    case Dimension::SectionModulus: return std::pow(factor, 3);
    case Dimension::SecondMoment: return std::pow(factor, 4);
    default: return 1.0;
  }
}

void scale_section(Section& section, double factor) {
  Setup setup;
  setup.scene.section = section;
  // Of all shapes, since another axis may choose one later.
  for (const Field& field : fields()) {
    if (!field.path.starts_with("section.")) continue;
    const FieldValue value = field.get(setup);
    const double* number = std::get_if<double>(&value);
    if (number != nullptr) field.set(setup, *number * size_factor(field.dimension, factor));
  }
  section = setup.scene.section;
  section.name.clear();
}

void scale_size(Setup& setup, const FieldValue& value) {
  const double factor = number_of(value);
  Scene& scene = setup.scene;
  scene.beam.length *= factor;
  for (double& length : scene.beam.joint_lengths) length *= factor;
  for (auto& point : scene.beam.points) scale(point, factor);
  scale_section(scene.section, factor);
  for (Region& region : scene.regions) {
    scale_section(region.section, factor);
    if (region.to_section) scale_section(*region.to_section, factor);
  }
  for (Support& support : scene.supports) {
    support.gap *= factor;
    scale(support.translation, factor);
  }
  if (scene.hinge_length) *scene.hinge_length *= factor;
  scale(setup.solver.control_motion, factor);
}

FieldValue one(const Setup& /*setup*/) { return 1.0; }

FieldValue get_slenderness(const Setup& setup) { return setup.scene.beam.length / depth(setup); }
void set_slenderness(Setup& setup, const FieldValue& value) {
  setup.scene.beam.length = number_of(value) * depth(setup);
}

FieldValue get_segment_depth(const Setup& setup) {
  return setup.scene.beam.length / setup.scene.beam.segments / depth(setup);
}
void set_segment_depth(Setup& setup, const FieldValue& value) {
  const double segments = setup.scene.beam.length / (number_of(value) * depth(setup));
  setup.scene.beam.segments = static_cast<int>(std::clamp(std::round(segments), 1.0, 1e7));
}

FieldValue get_material(const Setup& setup) { return setup.scene.material.name; }
void set_material(Setup& setup, const FieldValue& value) {
  setup.scene.material = named_material(std::get<std::string>(value)).material;
}

std::span<const std::string_view> material_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const NamedMaterial& entry : material_table()) all.push_back(entry.material.name);
    return all;
  }();
  return names;
}

Field derived(std::string_view path, Range range, std::string_view doc,
              FieldValue (*get)(const Setup&), void (*set)(Setup&, const FieldValue&)) {
  return {path, FieldKind::Number, Dimension::None, range, {}, doc, {}, get, set};
}

}  // namespace

std::span<const Field> derived_fields() {
  static const std::vector<Field> table{
      derived("scale.loads", {}, "factor on the forces and moments of all loads", one, scale_loads),
      derived("scale.motions", {},
              "factor on prescribed motions, initial velocities and a coupon's strains", one,
              scale_motions),
      derived("scale.size", kPositive,
              "factor on every length of the scene, sections included; point masses keep their "
              "mass and "
              "inertia",
              one, scale_size),
      derived("beam.slenderness", kPositive, "length over depth; moves the length", get_slenderness,
              set_slenderness),
      derived("beam.segment_depth", kPositive,
              "segment length over depth; moves the number of segments, to the nearest integer",
              get_segment_depth, set_segment_depth),
      {"material.name",
       FieldKind::Choice,
       Dimension::None,
       {},
       material_names(),
       "a named material, all of its values",
       {},
       get_material,
       set_material},
  };
  return table;
}

bool set_one_number(const Field& a, const Field& b) {
  constexpr std::array<std::array<std::string_view, 2>, 2> kPairs{
      {{"beam.slenderness", "beam.length"}, {"beam.segment_depth", "beam.segments"}}};
  return std::ranges::any_of(kPairs, [&](const auto& pair) {
    return (a.path == pair[0] && b.path == pair[1]) || (a.path == pair[1] && b.path == pair[0]);
  });
}

const Field& find_axis_field(std::string_view name, const SourceLocation& where) {
  for (const Field& field : derived_fields()) {
    if (field.path == name) return field;
  }
  return find_field(name, where);
}

}  // namespace plastica::sweeps
