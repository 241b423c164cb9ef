#include "calibrate/engine/fitted_scene.hpp"

#include <fmt/format.h>

#include "calibrate/report/format.hpp"

namespace plastica::calibrate {
namespace {

/// Sets a field of a material, where it has the value that the scene's material had.
void replace(const Field& field, const FieldValue& before, double value, Material& material) {
  Setup setup;
  setup.scene.material = material;
  if (field.get(setup) != before) return;
  set_field(setup, field, value);
  material = setup.scene.material;
}

bool same(const Hardening& a, const Hardening& b) {
  return a.law == b.law && a.tangent_modulus == b.tangent_modulus &&
         a.kinematic_share == b.kinematic_share && a.saturation_stress == b.saturation_stress &&
         a.saturation_rate == b.saturation_rate && a.backstress_modulus == b.backstress_modulus &&
         a.backstress_rate == b.backstress_rate;
}

/// "310.59 MPa ± 2.4 MPa".
std::string shown(const FittedParameter& parameter) {
  const report::DisplayUnit unit = report::display_unit(parameter);
  const double value = parameter.value / unit.scale;
  if (!parameter.standard_error) {
    return report::quantity(report::significant(value), unit.name);
  }
  return report::quantity(report::with_error(value, *parameter.standard_error / unit.scale),
                          unit.name);
}

}  // namespace

FittedScene fitted_scene(const Scene& scene, const FitRecord& record, const FitOptions& options) {
  if (record.result.status != FitStatus::Fitted) {
    throw InputError({}, "--case", record.target.name, "has no fit: " + report::reason_of(record));
  }
  FittedScene fitted{scene, {}};
  Scene& out = fitted.scene;
  fitted.notes.push_back("material fitted to " + record.target.name);

  for (Region& region : out.regions) {
    if (region.material.name == scene.material.name) region.material.name = record.target.name;
  }
  out.material.name = record.target.name;
  // The numbers of a law hold with that law.
  out.material.hardening = options.setup.scene.material.hardening;
  const Setup original{scene, {}};
  for (const FittedParameter& parameter : record.result.parameters) {
    const Field& field = find_field(parameter.path);
    if (parameter.role != ParameterRole::Fixed && !parameter.identified) {
      fitted.notes.push_back(
          fmt::format("{} is not identified by the fit: the scene's own stays", parameter.name));
      continue;
    }
    const FieldValue before = field.get(original);
    for (Region& region : out.regions) replace(field, before, parameter.value, region.material);
    Setup setup{out, {}};
    set_field(setup, field, parameter.value);
    out.material = setup.scene.material;
    fitted.notes.push_back(fmt::format(
        "{} = {}, {}{}", parameter.name, shown(parameter),
        parameter.role == ParameterRole::Free ? "fitted" : report::word_of(parameter.role),
        parameter.at_lower || parameter.at_upper ? ", at a bound of the fit" : ""));
  }
  for (Region& region : out.regions) {
    if (same(region.material.hardening, scene.material.hardening)) {
      region.material.hardening = out.material.hardening;
    }
  }
  const Scene& told = options.setup.scene;
  if (record.target.test != Test::Tension && told.yield_cap != scene.yield_cap) {
    fitted.notes.emplace_back(
        "the fit and the scene have different rules.yield_cap: the yield stress means another "
        "moment there");
  }
  return fitted;
}

}  // namespace plastica::calibrate
