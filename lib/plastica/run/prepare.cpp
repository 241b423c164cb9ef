#include <algorithm>

#include "plastica/run/simulate.hpp"

namespace plastica {

Model prepare(const Scene& scene, const SolverOptions& options,
              std::span<const std::string> parameters) {
  check_scene(scene, options);

  Model model;
  model.level = Level::Coupon;
  model.level_reason = options.level == Level::Auto
                           ? "a strain history drives all joints alike: one stands for all"
                           : "as the scene asks";
  model.coupon = coupon::coupon_shape(scene);
  model.material = material_values(scene.material);
  model.drive = scene.drive.strain;
  model.on_break = scene.on_break;
  for (const Probe& probe : scene.probes) model.probes.push_back(probe.quantity);

  for (const std::string& path : parameters) {
    const Field& field = find_field(path);
    if (!field.material) {
      throw InputError({}, field.path, "", "cannot be a parameter of a coupon");
    }
    if (std::find(model.parameters.begin(), model.parameters.end(), &field) !=
        model.parameters.end()) {
      throw InputError({}, field.path, "", "is a parameter twice");
    }
    // A parameter is given, even if the scene leaves the field to its default.
    switch (*field.material) {
      case MaterialField::ShearModulus: model.coupon.shear_modulus_given = true; break;
      case MaterialField::ShearYieldStress: model.coupon.shear_yield_given = true; break;
      case MaterialField::BreakStrain: model.coupon.break_given = true; break;
      case MaterialField::BreakShearStrain: model.coupon.break_shear_given = true; break;
      default: break;
    }
    model.parameters.push_back(&field);
  }
  return model;
}

Response make_response(const Model& model) {
  Response response;
  response.probes.assign(model.probes.size(), std::vector<double>(model.drive.size()));
  return response;
}

Sensitivity make_sensitivity(const Model& model) {
  Sensitivity sensitivity;
  sensitivity.stress.resize(model.drive.size() * model.parameters.size());
  sensitivity.permanent_strain.resize(model.parameters.size());
  return sensitivity;
}

Workspace make_workspace(const Model& /*model*/) { return {}; }

Response simulate(const Scene& scene, const SolverOptions& options) {
  const Model model = prepare(scene, options);
  Response response = make_response(model);
  Workspace workspace = make_workspace(model);
  run(model, {}, workspace, response);
  return response;
}

}  // namespace plastica
