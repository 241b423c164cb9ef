#include "sweeps/plan/fit_plan.hpp"

#include <filesystem>
#include <limits>

#include "calibrate/config/read_parameters.hpp"
#include "calibrate/config/read_target.hpp"
#include "calibrate/store/scene_fit_digest.hpp"
#include "calibrate/trial/scene_drive.hpp"
#include "plastica/io/digest.hpp"
#include "plastica/io/read_input.hpp"

namespace plastica::sweeps {
namespace {

using io::TomlTable;
using io::TomlValue;

int integer_of(const TomlTable& fit, std::string_view key, int otherwise, int high) {
  const auto value = fit.find(key);
  return value ? static_cast<int>(value->integer(1, high)) : otherwise;
}

}  // namespace

FitPlan read_fit_plan(const TomlTable& fit, const std::string& path, const Scene& scene) {
  FitPlan plan;
  const TomlValue name = fit.at("target");
  const auto file = std::filesystem::path(path).parent_path() / name.string();
  if (!io::is_file(file)) {
    throw name.error("is not a file in the folder of " + path + io::why_no_file(file));
  }
  plan.file = file.lexically_normal().string();
  plan.text = io::read_input(plan.file, io::kMaxTableBytes);
  const TomlTable abscissa = fit.at("abscissa").table();
  const TomlTable ordinate = fit.at("ordinate").table();
  calibrate::SceneTarget wanted;
  wanted.name = file.stem().string();
  wanted.abscissa_probe = abscissa.at("probe").string();
  wanted.abscissa_where = abscissa.at("probe").where();
  wanted.ordinate_probe = ordinate.at("probe").string();
  wanted.ordinate_where = ordinate.at("probe").where();
  wanted.abscissa_factor = calibrate::read_factor(abscissa);
  wanted.ordinate_factor = calibrate::read_factor(ordinate);
  const Dimension measured = calibrate::ordinate_dimension(scene, wanted);
  calibrate::SceneTargetSource source;
  source.file = plan.file;
  source.abscissa = calibrate::read_column(
      abscissa, calibrate::abscissa_dimension(scene, wanted, wanted.abscissa_where));
  source.ordinate = calibrate::read_column(ordinate, measured);
  if (const auto noise = fit.find("noise")) {
    wanted.noise = noise->quantity(measured);
    if (!(*wanted.noise > 0.0)) throw noise->error("must be above 0");
  }
  plan.target = calibrate::read_scene_target(source, scene, std::move(wanted));
  (void)fit.at("parameters");
  plan.options.segments_error = false;  // a sweep over the segments shows it itself
  plan.options.parameters = calibrate::read_parameters(fit, calibrate::ParameterScope::Scene);
  plan.options.evaluations = integer_of(fit, "evaluations", plan.options.evaluations, 1'000'000);
  // A sweep varies a scene that is near its curve: more searches only if asked for.
  plan.options.starts = integer_of(fit, "starts", 1, 1000);
  if (const auto seed = fit.find("seed")) {
    plan.options.seed =
        static_cast<std::uint64_t>(seed->integer(0, std::numeric_limits<std::int64_t>::max()));
  }
  return plan;
}

std::uint64_t digest_of(const FitPlan& plan) {
  io::Digest digest;
  calibrate::add_to(digest, plan.target);
  calibrate::add_to(digest, plan.options);
  return digest.value();
}

}  // namespace plastica::sweeps
