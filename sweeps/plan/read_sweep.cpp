#include <algorithm>
#include <filesystem>
#include <utility>

#include "plastica/io/read_input.hpp"
#include "plastica/io/toml.hpp"
#include "plastica/model/numbered_place.hpp"
#include "sweeps/plan/derived_fields.hpp"
#include "sweeps/plan/kind_axes.hpp"
#include "sweeps/plan/read_axes.hpp"
#include "sweeps/plan/sweep.hpp"

namespace plastica::sweeps {
namespace {

using io::TomlDocument;
using io::TomlTable;
using io::TomlValue;

/// Axes of one value, from a table of fields by their paths and the tables in it.
void read_settings(const TomlTable& table, const std::string& prefix, Sweep& sweep) {
  for (const std::string& key : table.keys()) {
    const TomlValue value = table.at(key);
    if (value.is_table()) {
      read_settings(value.table(), prefix + key + ".", sweep);
      continue;
    }
    Axis axis{.where = value.where()};
    try {
      axis.field = &find_axis_field(value.new_path(prefix + key), value.where());
    } catch (const InputError& error) {
      throw value.error(error.rule());
    }
    axis.values.push_back(read_field_value(value, *axis.field, sweep.setup));
    sweep.axes.push_back(std::move(axis));
  }
}

io::SceneFile read_scene(const TomlTable& root, const std::string& sweep_path) {
  const TomlValue name = root.at("scene");
  const auto path = std::filesystem::path(sweep_path).parent_path() / name.string();
  if (!io::is_file(path)) {
    throw name.error("is not a file in the folder of " + sweep_path + io::why_no_file(path));
  }
  return io::read_scene_file(path.lexically_normal().string());
}

io::InputText input_of(const std::string& path, std::string text) {
  return {std::filesystem::path(path).filename().string(), std::move(text)};
}

/// [fit], where the quantity is a fitted parameter, which must be free there.
void read_fit(const TomlTable& root, Sweep& sweep) {
  const auto fit = root.find_table("fit");
  const bool wanted = sweep.quantity.kind == QuantityKind::Fit;
  if (wanted != fit.has_value()) {
    throw InputError(fit ? fit->where() : SourceLocation{sweep.path, 0}, "fit", "",
                     wanted ? "is missing: error.quantity is one of a fit"
                            : "goes with error.quantity = \"fit\"");
  }
  if (!wanted) return;
  sweep.fit = read_fit_plan(*fit, sweep.path, sweep.setup.scene);
  const auto& parameters = sweep.fit->options.parameters;
  const bool is_free = std::any_of(parameters.begin(), parameters.end(), [&](const auto& p) {
    return p.field->path == sweep.quantity.parameter && p.role == calibrate::ParameterRole::Free;
  });
  if (!is_free) {
    throw InputError(fit->where(), "error.parameter", sweep.quantity.parameter,
                     "is not a free parameter of [fit]");
  }
  sweep.inputs.push_back(input_of(sweep.fit->file, sweep.fit->text));
}

/// A place that moves with the number of segments would make each case another problem.
void check_places(const Sweep& sweep) {
  const auto place = numbered_place(sweep.setup.scene, sweep.setup.solver);
  if (!place) return;
  for (const Axis& axis : sweep.axes) {
    if (!axis.field->path.starts_with("beam.segment")) continue;
    const bool is_one = axis.values.size() == 1;
    if (is_one && axis.values.front() == axis.field->get(sweep.setup)) continue;
    throw InputError(axis.where, axis.field->path,
                     is_one ? "another value" : std::to_string(axis.values.size()) + " values",
                     std::string(is_one ? "moves" : "move") + " the scene's " +
                         std::string(*place) +
                         ", the end of a segment by its number: give it as a fraction");
  }
}

/// Lengths of joints that the scene gives would stay those of its own beam, and the beam would be
/// as stiff as before.
void check_joint_lengths(const Sweep& sweep) {
  const Beam& own = sweep.scene.setup.scene.beam;
  if (own.joint_lengths.empty()) return;
  const auto stay = [&](const Beam& beam) {
    return beam.length != own.length && beam.joint_lengths == own.joint_lengths;
  };
  for (const Axis& axis : sweep.axes) {
    const bool moves = std::ranges::any_of(axis.values, [&](const FieldValue& value) {
      Setup setup = sweep.scene.setup;
      axis.field->set(setup, value);
      return stay(setup.scene.beam);
    });
    if (!moves) continue;
    throw InputError(axis.where, axis.field->path, "",
                     "changes the beam's length, and the scene's beam.joint_lengths stay: leave "
                     "these out, or vary scale.size");
  }
}

Sweep read_document(const TomlDocument& document) {
  const TomlTable& root = document.root();
  Sweep sweep;
  sweep.path = document.name();
  const auto title = root.find("name");
  sweep.name = title ? title->string() : std::filesystem::path(sweep.path).stem().string();
  sweep.scene = read_scene(root, sweep.path);
  sweep.setup = sweep.scene.setup;
  sweep.inputs.push_back(input_of(sweep.path, document.text()));
  sweep.inputs.push_back(input_of(sweep.scene.path, sweep.scene.text));
  if (const auto set = root.find_table("set")) read_settings(*set, "", sweep);
  read_axes(root, sweep);
  check_kind_axes(sweep);
  check_places(sweep);
  check_joint_lengths(sweep);
  read_error(root, sweep);
  read_fit(root, sweep);
  if (const auto cost = root.find_table("cost")) {
    sweep.timed_runs = static_cast<int>(cost->at("timed_runs").integer(0, 1000));
  }
  if (sweep.timed_runs > 0 && !is_simulated(sweep.quantity.kind)) {
    throw InputError(root.find_table("cost")->where(), "cost.timed_runs",
                     std::to_string(sweep.timed_runs),
                     "times runs of a scene; this quantity is none of a run");
  }
  root.check_unused();
  sweep.notes = sweep.scene.notes;
  sweep.notes.insert(sweep.notes.end(), root.notes().begin(), root.notes().end());
  if (sweep.fit) {
    for (const calibrate::Repair& repair : sweep.fit->target.repairs) {
      sweep.notes.push_back(sweep.fit->file + ": " + repair.text);
    }
    for (const std::string& warning : sweep.fit->target.warnings) {
      sweep.notes.push_back(sweep.fit->file + ": " + warning);
    }
  }
  return sweep;
}

}  // namespace

Sweep parse_sweep(std::string text, std::string name) {
  return read_document(TomlDocument::parse(std::move(text), std::move(name)));
}

Sweep read_sweep_file(const std::string& path) { return read_document(TomlDocument::read(path)); }

}  // namespace plastica::sweeps
