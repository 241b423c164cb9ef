#include "sweeps/plan/fit_plan.hpp"

#include <filesystem>
#include <limits>

#include "calibrate/config/read_parameters.hpp"
#include "calibrate/store/scene_fit_digest.hpp"
#include "plastica/io/digest.hpp"
#include "plastica/io/read_input.hpp"

namespace plastica::sweeps {
namespace {

using io::TomlTable;
using io::TomlValue;

/// One of the two columns and the probe that it is held against.
struct Side {
  std::string probe;
  calibrate::ColumnSource column;
  double factor = 1.0;
};

Side read_side(const TomlTable& fit, std::string_view name) {
  const TomlValue value = fit.at(name);
  const TomlTable table = value.table();
  Side side;
  side.probe = table.at("probe").string();
  const TomlValue column = table.at("column");
  side.column.column =
      column.is_string() ? column.string() : std::to_string(column.integer(1, 1'000'000));
  side.column.where = column.where();
  if (const auto unit = table.find("unit")) side.column.unit = unit->string();
  if (const auto factor = table.find("factor")) {
    side.factor = factor->number();
    if (side.factor == 0.0) throw factor->error("must not be 0");
  }
  return side;
}

Dimension dimension_of_probe(const Scene& scene, const std::string& name) {
  for (const Probe& probe : scene.probes) {
    if (probe.name == name) return dimension_of(probe.quantity, scene.drive.deformation);
  }
  return Dimension::None;
}

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
  const Side abscissa = read_side(fit, "abscissa");
  const Side ordinate = read_side(fit, "ordinate");
  calibrate::SceneTarget wanted;
  wanted.name = file.stem().string();
  wanted.abscissa_probe = abscissa.probe;
  wanted.ordinate_probe = ordinate.probe;
  wanted.abscissa_factor = abscissa.factor;
  wanted.ordinate_factor = ordinate.factor;
  if (const auto noise = fit.find("noise")) {
    wanted.noise = noise->quantity(dimension_of_probe(scene, ordinate.probe));
    if (!(*wanted.noise > 0.0)) throw noise->error("must be above 0");
  }
  calibrate::SceneTargetSource source;
  source.file = plan.file;
  source.abscissa = abscissa.column;
  source.ordinate = ordinate.column;
  source.where = source.abscissa_unit = source.ordinate_unit = fit.where();
  wanted.abscissa_where = wanted.ordinate_where = fit.where();
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
