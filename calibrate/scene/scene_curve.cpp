#include "calibrate/scene/scene_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace plastica::calibrate {
namespace {

/// The path may end short of the measured abscissa by this share of it: rounding of a motion that
/// is prescribed to end there.
constexpr double kRounding = 1e-9;

/// Whether a prepared chain takes a field's value at run time just as if the scene had it.
bool is_run_parameter(const Field& field, const Setup& setup) {
  if (!field.material) return false;
  switch (*field.material) {
    case MaterialField::YoungsModulus:
    case MaterialField::YieldStress:
    case MaterialField::KinematicShare:
    case MaterialField::SaturationStress:
    case MaterialField::SaturationRate: return true;
    // A chain asks the scene whether these are given.
    case MaterialField::ShearModulus: return setup.scene.material.shear_modulus.has_value();
    case MaterialField::ShearYieldStress:
      return setup.scene.material.shear_yield_stress.has_value();
    // … and how its strains spread, of which hardening at all decides.
    case MaterialField::TangentModulus: return setup.scene.material.hardening.tangent_modulus > 0.0;
    default: return false;
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

SceneCurve::SceneCurve(const Setup& setup, const SceneTarget& target,
                       std::vector<const Field*> fields)
    : setup_(setup), target_(target), fields_(std::move(fields)) {
  if (setup_.scene.is_coupon()) {
    throw InputError({}, "drive.strain", "",
                     "makes the scene a coupon: its curve is stress over strain, which "
                     "plastica calibrate fits");
  }
  abscissa_probe_ = probe_index(setup_.scene, target.abscissa_probe, "abscissa_probe");
  ordinate_probe_ = probe_index(setup_.scene, target.ordinate_probe, "ordinate_probe");
  take_limits_off(setup_.scene);
  setup_.solver.frames = 0;  // the permanent strain of every sample
  prepared_ = std::all_of(fields_.begin(), fields_.end(),
                          [&](const Field* field) { return is_run_parameter(*field, setup_); });
  prepare_model();
}

void SceneCurve::prepare_model() {
  std::vector<std::string> paths;
  if (prepared_) {
    for (const Field* field : fields_) paths.emplace_back(field->path);
  }
  // The program of the old model refers to it.
  workspace_ = {};
  model_ = prepare(setup_.scene, setup_.solver, paths);
  workspace_ = make_workspace(model_);
  response_ = make_response(model_);
}

bool SceneCurve::fail(std::string reason) {
  ++failed_runs_;
  reason_ = std::move(reason);
  return false;
}

bool SceneCurve::set_values(std::span<const double> values) {
  if (prepared_) return true;
  try {
    for (std::size_t i = 0; i < fields_.size(); ++i) set_field(setup_, *fields_[i], values[i]);
    prepare_model();
  } catch (const InputError& error) {
    return fail(error.what());
  }
  return true;
}

bool SceneCurve::run(std::span<const double> values) {
  ++runs_;
  turns_ = false;
  if (!set_values(values)) return false;
  response_.counters = {};
  plastica::run(model_, prepared_ ? values : ParameterValues{}, workspace_, response_);
  segment_iterations_ +=
      static_cast<std::int64_t>(setup_.scene.beam.segments) * response_.counters.iterations;
  if (!usable(response_.status)) {
    return fail(
        fmt::format("the scene ended {}: {}", name_of(response_.status), advice(response_.status)));
  }
  return take_path();
}

bool SceneCurve::take_path() {
  const std::size_t samples = response_.samples;
  const std::size_t joints = response_.chain.joints;
  path_.resize(samples);
  height_.resize(samples);
  strain_.resize(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    path_[i] = target_.abscissa_factor * response_.probes[abscissa_probe_][i] + 0.0;  // no -0
    height_[i] = target_.ordinate_factor * response_.probes[ordinate_probe_][i];
    const auto first =
        response_.chain.plastic_strain.begin() + static_cast<std::ptrdiff_t>(i * joints);
    strain_[i] = *std::max_element(first, first + static_cast<std::ptrdiff_t>(joints));
    if (i == 0 || path_[i] > path_[i - 1]) continue;
    turns_ = true;
    return fail(
        fmt::format("the probe {} must grow along the path (times {:g}), and does not at "
                    "sample {}",
                    target_.abscissa_probe, target_.abscissa_factor, i));
  }
  double least = target_.abscissa.front();
  double most = target_.abscissa.back();
  if (target_.broke) most = std::max(most, target_.broke->at);
  const double slack = kRounding * std::max(std::abs(least), std::abs(most));
  if (samples < 2 || path_.front() > least + slack || path_.back() < most - slack) {
    return fail(fmt::format("the path goes from {:g} to {:g}, and was measured from {:g} to {:g}",
                            samples > 0 ? path_.front() : 0.0, samples > 0 ? path_.back() : 0.0,
                            least, most));
  }
  ordinate_.resize(target_.abscissa.size());
  std::size_t k = 1;
  for (std::size_t i = 0; i < ordinate_.size(); ++i) {
    while (k + 1 < samples && path_[k] < target_.abscissa[i]) ++k;
    const double share = (target_.abscissa[i] - path_[k - 1]) / (path_[k] - path_[k - 1]);
    ordinate_[i] = height_[k - 1] + share * (height_[k] - height_[k - 1]);
  }
  permanent_strain_ =
      permanent_strain_at(target_.broke ? target_.broke->at : target_.abscissa.back())
          .value_or(0.0);
  return true;
}

std::optional<double> SceneCurve::permanent_strain_at(double abscissa) const {
  const double slack = kRounding * std::abs(abscissa);
  if (path_.size() < 2 || abscissa < path_.front() - slack || abscissa > path_.back() + slack) {
    return std::nullopt;
  }
  const auto above = std::lower_bound(path_.begin() + 1, path_.end() - 1, abscissa);
  const auto k = static_cast<std::size_t>(above - path_.begin());
  const double share = (abscissa - path_[k - 1]) / (path_[k] - path_[k - 1]);
  return strain_[k - 1] + share * (strain_[k] - strain_[k - 1]);
}

}  // namespace plastica::calibrate
