#include "calibrate/trial/scene_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibrate/trial/scene_drive.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/region.hpp"
#include "plastica/model/shared_moments.hpp"
#include "plastica/run/run_warnings.hpp"
#include "plastica/run/scene_joints.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::calibrate {
namespace {

/// Whether a prepared model takes a field's value at run time just as if the scene had it.
bool is_run_parameter(const Field& field, const Setup& setup) {
  if (!field.material) return false;
  switch (*field.material) {
    case MaterialField::YoungsModulus:
    case MaterialField::YieldStress:
    case MaterialField::KinematicFraction:
    case MaterialField::SaturationStress:
    case MaterialField::SaturationRate:
    case MaterialField::ReferenceRate:
    case MaterialField::RateExponent:
    case MaterialField::RateCoefficient: return true;
    // A chain asks the scene whether these are given.
    case MaterialField::ShearModulus: return setup.scene.material.shear_modulus.has_value();
    case MaterialField::ShearYieldStress:
      return setup.scene.material.shear_yield_stress.has_value();
    // … and how its strains spread, of which hardening at all decides.
    case MaterialField::TangentModulus: return setup.scene.material.hardening.tangent_modulus > 0.0;
    default: return is_flow_stress(*field.material);
  }
}

void take_limits_off(Scene& scene) {
  const auto take_off = [](Material& material) {
    material.break_strain.reset();
    material.break_shear_strain.reset();
  };
  take_off(scene.material);
  for (Region& region : scene.regions) take_off(region.material);
  scene.break_limit_x.reset();
  scene.break_limit_y.reset();
  scene.break_limit_z.reset();
}

/// Which regions take a limit of the scene's material, the beam beside them first.
std::vector<bool> regions_of_the_limit(const Setup& setup, Level level) {
  const Field& field =
      find_field(level == Level::Twist ? "material.break_shear_strain" : "material.break_strain");
  std::vector<bool> regions{true};
  for (const Region& region : setup.scene.regions) {
    regions.push_back(!is_own(region, field.path));
  }
  return regions;
}

void check_kind(const Scene& scene, const SceneTarget& target) {
  if (scene.is_coupon() == (target.kind == Abscissa::Strain)) return;
  if (scene.is_coupon()) {
    throw InputError(target.abscissa_where, "drive.strain", "",
                     "makes the scene a coupon, which follows a measured strain");
  }
  throw InputError(target.abscissa_where, "abscissa.drive", "strain",
                   "needs a coupon: a scene with drive.strain");
}

/// @return its number
std::size_t add_strain_probe(Scene& scene) {
  Probe probe{.name = "permanent", .quantity = ProbeQuantity::LargestPlasticStrain};
  if (scene.is_coupon()) {
    const bool net = scene.break_measure == BreakMeasure::Net;
    probe.quantity = net ? ProbeQuantity::PlasticStrain : ProbeQuantity::AccumulatedStrain;
  }
  // The scene's own have names of their own.
  while (std::ranges::find(scene.probes, probe.name, &Probe::name) != scene.probes.end()) {
    probe.name += '_';
  }
  scene.probes.push_back(probe);
  return scene.probes.size() - 1;
}

std::string how_it_ended(Status status, const Setup& setup) {
  const bool in_motion = setup.solver.analysis == Analysis::Dynamics;
  return fmt::format("the scene ended {}: {}", name_of(status), advice(status, in_motion));
}

}  // namespace

std::size_t probe_index(const Scene& scene, const std::string& name, std::string_view field,
                        const SourceLocation& where) {
  std::string names;
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    if (scene.probes[i].name == name) return i;
    names += (names.empty() ? "" : ", ") + scene.probes[i].name;
  }
  throw InputError(
      where, field, name,
      names.empty() ? "the scene has no probes" : "is not one of the scene's probes: " + names);
}

SceneModel::SceneModel(const Setup& setup, const SceneTarget& target,
                       std::vector<const Field*> fields)
    : setup_(setup), target_(target), fields_(std::move(fields)) {
  check_kind(setup_.scene, target);
  if (is_driven(target.kind)) setup_ = driven_setup(setup, target);
  Scene& scene = setup_.scene;
  if (target.kind == Abscissa::Probe) {
    abscissa_probe_ =
        probe_index(scene, target.abscissa_probe, "abscissa.probe", target.abscissa_where);
  }
  ordinate_probe_ =
      probe_index(scene, target.ordinate_probe, "ordinate.probe", target.ordinate_where);
  const Setup limited = setup_;
  take_limits_off(scene);
  // The permanent strain of every sample: that of some regions' joints by all shapes.
  const bool of_all = scene.is_coupon() || scene.regions.empty();
  if (of_all) strain_probe_ = add_strain_probe(scene);
  setup_.solver.frames = of_all ? 1 : 0;
  // Laid out anew, a scene shares its moments by the stiffness that it has.
  const bool shares =
      !scene.is_coupon() && model_detail::shares_moments(scene, segment_ends(scene));
  prepared_ = !shares && std::all_of(fields_.begin(), fields_.end(), [&](const Field* field) {
    return is_run_parameter(*field, setup_) && !stands_in_regions(setup_.scene, *field);
  });
  std::vector<std::string> paths;
  if (prepared_) {
    for (const Field* field : fields_) paths.emplace_back(field->path);
  }
  model_ = prepare(scene, setup_.solver, paths);
  if (model_.chain) limited_ = regions_of_the_limit(limited, model_.level);
  if (target.kind == Abscissa::Probe) extended_setup_ = extended_setup(setup_, kMaxTimes);
  if (extended_setup_) extended_ = prepare(extended_setup_->scene, extended_setup_->solver, paths);
}

Setup SceneModel::setup_at(const Setup& base, std::span<const double> values) const {
  Setup setup = base;
  for (std::size_t i = 0; i < fields_.size(); ++i) set_everywhere(setup, *fields_[i], values[i]);
  return setup;
}

std::vector<std::string> SceneModel::warnings(std::span<const double> values) const {
  const Setup at = setup_at(setup_, values);
  try {
    const Model model = prepare(at.scene, at.solver);
    Workspace workspace = make_workspace(model);
    Response response = make_response(model);
    plastica::run(model, {}, workspace, response);
    return run_warnings(at.scene, at.solver, model, response);
  } catch (const InputError&) {  // has no curve, which is said elsewhere
    return {};
  }
}

bool SceneModel::takes_a_limit() const {
  if (!model_.chain) return true;
  const chain::Layout& layout = model_.chain->layout;
  return std::ranges::any_of(layout.segment_regions, [&](const auto& of) {
    return limited_[layout.regions[of.middle].scene_region];
  });
}

std::vector<bool> SceneModel::joints_of_the_limit(const Setup& setup, const Model& model,
                                                  std::span<const double> values) const {
  if (!model.chain) return {};
  // Without regions all joints are the scene's.
  if (setup.scene.regions.empty()) return std::vector<bool>(model.chain->layout.size() + 1, true);
  const Setup at = setup_at(setup, values);
  std::optional<Model> own;
  if (!prepared_) own = prepare(at.scene, at.solver);
  const ChainModel& chain = own ? *own->chain : *model.chain;
  std::vector<bool> joints;
  for (const auto& joint : scene_joints(chain, material_values(at.scene.material))) {
    joints.push_back(limited_[chain.layout.regions[joint.owner].scene_region]);
  }
  return joints;
}

SceneCurve SceneModel::curve_of(const Response& response, const std::vector<bool>& limited,
                                bool is_extended) const {
  SceneCurve curve;
  curve.is_extended = is_extended;
  curve.segment_iterations =
      static_cast<std::int64_t>(setup_.scene.beam.segments) * response.counters.iterations;
  // A longer path may fail beyond what was measured.
  const bool complete = usable(response.status);
  if (!complete && !(is_extended && response.status == Status::NotConverged)) {
    curve.reason = how_it_ended(response.status, setup_);
    return curve;
  }
  std::vector<double> path;
  if (!place(response, path, curve)) {
    if (!complete) curve.reason = how_it_ended(response.status, setup_);
    return curve;
  }
  curve.usable = true;
  set_ordinate(response, path, curve);
  set_strain(response, path, limited, curve);
  return curve;
}

/// Where the response's samples are: on the abscissa, or their numbers if it was driven.
/// @return whether they reach over all that was measured
bool SceneModel::place(const Response& response, std::vector<double>& path,
                       SceneCurve& curve) const {
  const std::size_t samples = response.samples;
  path.resize(samples);
  if (is_driven(target_.kind)) {
    // A chain's first sample is the beam at rest.
    const double first = target_.kind == Abscissa::Strain ? 0.0 : -1.0;
    for (std::size_t i = 0; i < samples; ++i) path[i] = first + static_cast<double>(i);
    const double last = static_cast<double>(target_.abscissa.size() - 1);
    if (samples > 0 && path.back() >= last) return true;
    curve.reason = fmt::format("the path ends after {} of {} measured samples",
                               samples > 0 ? path.back() + 1.0 : 0.0, target_.abscissa.size());
    return false;
  }
  const std::vector<double>& from =
      target_.kind == Abscissa::Time ? response.chain.time : response.probes[abscissa_probe_];
  for (std::size_t i = 0; i < samples; ++i) {
    path[i] = target_.abscissa_factor * from[i] + 0.0;  // no -0
    if (i == 0 || path[i] > path[i - 1]) continue;
    curve.reverses = true;
    curve.reason = fmt::format(
        "the probe {} must grow along the path (times {:g}), and does not at sample {}; a scene "
        "whose drive follows what was measured may turn",
        target_.abscissa_probe, target_.abscissa_factor, i);
    if (path[i] < path.front()) {
      curve.reason += fmt::format("; if the machine counts the other way: abscissa.factor = {:g}",
                                  -target_.abscissa_factor);
    }
    return false;
  }
  const double least = target_.abscissa.front();
  double most = target_.abscissa.back();
  if (target_.broke) most = std::max(most, target_.broke->at);
  const double slack = kRounding * std::max(std::abs(least), std::abs(most));
  if (samples >= 2 && path.front() <= least + slack && path.back() >= most - slack) return true;
  // A limit load, or a path that begins late, is no better for going on.
  curve.ends_early =
      response.status == Status::Completed && samples >= 2 && path.front() <= least + slack;
  curve.reason =
      fmt::format("the path goes from {:g} to {:g}, and was measured from {:g} to {:g}",
                  samples > 0 ? path.front() : 0.0, samples > 0 ? path.back() : 0.0, least, most);
  return false;
}

void SceneModel::set_ordinate(const Response& response, const std::vector<double>& path,
                              SceneCurve& curve) const {
  const std::vector<double>& height = response.probes[ordinate_probe_];
  const std::size_t n = target_.abscissa.size();
  curve.ordinate.resize(n);
  if (is_driven(target_.kind)) {
    const auto first = static_cast<std::size_t>(-path.front());
    for (std::size_t i = 0; i < n; ++i) {
      curve.ordinate[i] = target_.ordinate_factor * height[first + i];
    }
    return;
  }
  std::size_t k = 1;
  for (std::size_t i = 0; i < n; ++i) {
    while (k + 1 < path.size() && path[k] < target_.abscissa[i]) ++k;
    const double fraction = (target_.abscissa[i] - path[k - 1]) / (path[k] - path[k - 1]);
    curve.ordinate[i] =
        target_.ordinate_factor * (height[k - 1] + fraction * (height[k] - height[k - 1]));
  }
}

}  // namespace plastica::calibrate
