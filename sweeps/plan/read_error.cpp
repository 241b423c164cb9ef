#include <algorithm>
#include <filesystem>

#include "plastica/io/csv_column.hpp"
#include "plastica/io/read_input.hpp"
#include "plastica/io/units.hpp"
#include "sweeps/plan/read_axes.hpp"
#include "sweeps/plan/refining.hpp"

namespace plastica::sweeps {
namespace {

using io::TomlTable;
using io::TomlValue;

std::size_t find_probe(const TomlValue& name, const Scene& scene) {
  std::string all;
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    if (scene.probes[i].name == name.string()) return i;
    all += (i == 0 ? "" : ", ") + scene.probes[i].name;
  }
  throw name.error("is not a probe of the scene; it has " + (all.empty() ? "none" : all));
}

void refuse(const std::optional<TomlValue>& value, std::string_view rule) {
  if (value) throw value->error(rule);
}

Quantity read_probe(const TomlTable& table, const TomlValue& probe, const Scene& scene) {
  Quantity quantity;
  quantity.probe = find_probe(probe, scene);
  const Probe& of = scene.probes[quantity.probe];
  if (const auto take = table.find("take")) quantity.take = static_cast<Take>(take->word(kTakes));
  quantity.name = of.name + ", " + std::string(kTakes[static_cast<std::size_t>(quantity.take)]);
  quantity.dimension = dimension_of(of.quantity, scene.drive.deformation);
  if (quantity.take == Take::Frequency) quantity.dimension = Dimension::Frequency;
  quantity.unit = si_unit(quantity.dimension);
  return quantity;
}

Quantity read_kind(const TomlTable& table, const TomlValue& word, const Scene& scene) {
  Quantity quantity;
  quantity.kind = static_cast<QuantityKind>(word.word(kQuantityKinds));
  quantity.name = kQuantityKinds[static_cast<std::size_t>(quantity.kind)];
  switch (quantity.kind) {
    case QuantityKind::Probe: throw word.error("is meant by probe = NAME");
    case QuantityKind::NaturalFrequency:
    case QuantityKind::LoadedFrequency:
    case QuantityKind::BucklingFactor:
      if (const auto mode = table.find("mode")) {
        quantity.mode = static_cast<int>(mode->integer(1, 1000));
      }
      quantity.name += " " + std::to_string(quantity.mode);
      if (quantity.kind != QuantityKind::BucklingFactor) quantity.dimension = Dimension::Frequency;
      break;
    case QuantityKind::BreakLoad:
      if (!scene.is_coupon()) break;
      quantity.dimension = Dimension::Stress;
      break;
    case QuantityKind::BreakTime: quantity.dimension = Dimension::Time; break;
    case QuantityKind::Fit: {
      const TomlValue name = table.at("parameter");
      const Field& field = find_field(name.string(), name.where());
      quantity.parameter = field.path;
      quantity.name = "fitted " + quantity.parameter;
      quantity.dimension = field.dimension;
      break;
    }
    case QuantityKind::LimitLoad:
    case QuantityKind::BreakStrain:
    case QuantityKind::BreakPlace:
    case QuantityKind::EnergyBalanceError: break;
  }
  quantity.unit = si_unit(quantity.dimension);
  return quantity;
}

Quantity read_quantity(const TomlTable& table, const Scene& scene) {
  const auto probe = table.find("probe");
  const auto word = table.find("quantity");
  if (probe && word) throw word->error("does not go with probe");
  if (!probe && !word) {
    throw InputError(table.where(), table.key(), "", "needs a probe or a quantity");
  }
  Quantity quantity = probe ? read_probe(table, *probe, scene) : read_kind(table, *word, scene);
  if (!probe) refuse(table.find("take"), "goes with a probe");
  if (!has_modes(quantity.kind)) {
    refuse(table.find("mode"),
           "goes with quantity = \"natural_frequency\", \"loaded_frequency\" or "
           "\"buckling_factor\"");
  }
  if (quantity.kind != QuantityKind::Fit) {
    refuse(table.find("parameter"), "goes with quantity = \"fit\"");
  }
  return quantity;
}

void read_curve(const TomlTable& table, const TomlValue& value, const std::string& file,
                Sweep& sweep) {
  if (sweep.quantity.kind != QuantityKind::Probe) {
    throw value.error("is a curve over time: it goes with a probe");
  }
  const auto path = std::filesystem::path(sweep.path).parent_path() / file;
  if (!io::is_file(path)) {
    throw value.error("is not a file in the folder of " + sweep.path + io::why_no_file(path));
  }
  const io::CsvTable csv = io::CsvTable::read(path.string());
  const TomlValue columns = table.at("columns");
  const auto names = columns.array();
  if (names.size() != 2) {
    throw columns.error("must be two columns, [\"TIME:UNIT\", \"VALUE:UNIT\"]");
  }
  const auto read = [&](const TomlValue& name, Dimension dimension) {
    io::NamedColumn column = io::named_column(name.string(), name.where(), name.key());
    column.override_unit = table.is_set("override_unit");
    return io::read_column(csv, column, dimension);
  };
  const Probe& probe = sweep.setup.scene.probes[sweep.quantity.probe];
  sweep.against.time = read(names[0], Dimension::Time);
  sweep.against.curve =
      read(names[1], dimension_of(probe.quantity, sweep.setup.scene.drive.deformation));
  if (const auto factor = table.find("factor")) {
    for (double& number : sweep.against.curve) number *= factor->number();
  }
  if (!std::is_sorted(sweep.against.time.begin(), sweep.against.time.end())) {
    throw names[0].error("must rise from row to row");
  }
  sweep.against.name = file;
  sweep.inputs.push_back(
      {path.filename().string(), io::read_input(path.string(), io::kMaxTableBytes)});
}

void read_against(const TomlTable& table, Sweep& sweep) {
  const auto value = table.find("against");
  if (!value) return;
  const std::string& words = value->string();
  const std::size_t colon = words.find(':');
  const std::string kind = words.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : words.substr(colon + 1);
  Against& against = sweep.against;
  if (kind == "finest" && rest.empty()) {
    against.kind = AgainstKind::Finest;
  } else if (kind == "richardson" && rest.empty()) {
    against.kind = AgainstKind::Richardson;
    if (sweep.quantity.is_curve()) throw value->error("is for numbers, not for curves");
  } else if (kind == "theory" && !rest.empty()) {
    against.kind = AgainstKind::Theory;
    against.name = rest;
  } else if (kind == "value" && !rest.empty()) {
    against.kind = AgainstKind::Value;
    against.value =
        io::parse_quantity(rest, sweep.quantity.dimension, value->where(), value->key());
    if (sweep.quantity.is_curve()) throw value->error("is for numbers, not for curves");
  } else if (kind == "reference" && !rest.empty()) {
    against.kind = AgainstKind::File;
    read_curve(table, *value, rest, sweep);
  } else {
    throw value->error("must be theory:NAME, reference:FILE, value:NUMBER, finest or richardson");
  }
  if (against.kind == AgainstKind::File) return;
  refuse(table.find("columns"), "goes with reference:FILE");
  refuse(table.find("factor"), "goes with reference:FILE");
}

/// The axes whose values have a reference each though their fields refine.
void read_apart(const TomlTable& table, Sweep& sweep) {
  const auto list = table.find("apart");
  if (!list) return;
  const AgainstKind kind = sweep.against.kind;
  if (kind != AgainstKind::Finest && kind != AgainstKind::Richardson) {
    throw list->error("goes with against = \"finest\" or \"richardson\"");
  }
  for (const TomlValue& name : list->array()) {
    const std::string path = name.new_path(name.string());
    const auto axis = std::find_if(sweep.axes.begin(), sweep.axes.end(),
                                   [&](const Axis& a) { return a.field->path == path; });
    if (axis == sweep.axes.end()) throw name.error("is not the field of an axis");
    const AxisRole role = role_of(*axis->field);
    if (role != AxisRole::Number && role != AxisRole::Word) {
      throw name.error("does not refine: each of its values has a reference of its own anyway");
    }
    axis->apart = true;
  }
}

/// The axis that refines: as named, or the first that can.
void read_refined(const TomlTable& table, Sweep& sweep) {
  const auto named = table.find("along");
  for (std::size_t a = 0; a < sweep.axes.size() && !sweep.refined; ++a) {
    const Field& field = *sweep.axes[a].field;
    const Axis& axis = sweep.axes[a];
    const bool varies = axis.values.size() > 1 && !axis.sampled && !axis.apart;
    if (named ? field.path == named->new_path(named->string())
              : varies && refinement_of(field) != Refinement::None) {
      sweep.refined = a;
    }
  }
  if (named && !sweep.refined) throw named->error("is not the field of an axis");
  if (named && sweep.axes[*sweep.refined].sampled) {
    throw named->error("is sampled: cases that differ by it alone there are none");
  }
  if (named && refinement_of(*sweep.axes[*sweep.refined].field) == Refinement::None) {
    throw named->error("is no measure of how fine a discretization is");
  }
  if (named && sweep.axes[*sweep.refined].apart) throw named->error("is named in apart, too");
  const AgainstKind kind = sweep.against.kind;
  if ((kind == AgainstKind::Finest || kind == AgainstKind::Richardson) && !sweep.refined) {
    throw table.at("against").error("needs an axis that refines, such as beam.segments");
  }
}

}  // namespace

void read_error(const TomlTable& root, Sweep& sweep) {
  const auto table = root.find_table("error");
  if (!table) {
    throw InputError({root.where().file, 0}, "error", "",
                     "is missing: it names the probe or quantity that is looked at");
  }
  read_compared(*table, sweep);
}

void read_compared(const TomlTable& table, Sweep& sweep) {
  sweep.quantity = read_quantity(table, sweep.setup.scene);
  read_against(table, sweep);
  read_apart(table, sweep);
  read_refined(table, sweep);
  const auto scale = table.find("scale");
  if (!scale) return;
  sweep.error_scale = scale->is_string()
                          ? io::parse_quantity(scale->string(), sweep.quantity.dimension,
                                               scale->where(), scale->key())
                          : scale->number();
  if (!(*sweep.error_scale > 0.0)) throw scale->error("must be above 0");
}

}  // namespace plastica::sweeps
