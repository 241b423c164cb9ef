#include "plastica/io/scene_file.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "plastica/io/csv.hpp"
#include "plastica/io/units.hpp"
#include "plastica/model/material_table.hpp"

namespace plastica::io {
namespace {

void set_from(Setup& setup, const Field& field, const TomlValue& value) {
  if (field.kind == FieldKind::Choice) {
    set_field(setup, field, value.string(), value.where(), value.string());
    return;
  }
  const double number =
      field.kind == FieldKind::Integer ? value.number() : value.quantity(field.dimension);
  set_field(setup, field, number, value.where(),
            value.is_string() ? value.string() : value.written());
}

/// The value at a dotted path, if the file has it. All keys on the way become known.
std::optional<TomlValue> value_at(const TomlTable& root, std::string_view path) {
  TomlTable table = root;
  for (std::size_t dot = path.find('.'); dot != std::string_view::npos; dot = path.find('.')) {
    const auto next = table.find_table(path.substr(0, dot));
    if (!next) return std::nullopt;
    table = *next;
    path.remove_prefix(dot + 1);
  }
  return table.find(path);
}

/// @return whether `material` is a name and no table
bool read_named_material(const TomlTable& root, Setup& setup) {
  const auto material = root.find("material");
  if (!material) return false;
  const bool is_name = material->is_string();
  const auto name = is_name ? material : material->table().find("name");
  if (name)
    setup.scene.material = named_material(name->string(), name->where(), name->key()).material;
  return is_name;
}

std::vector<double> listed_strain(const TomlValue& list) {
  std::vector<double> strain;
  for (const TomlValue& item : list.array()) strain.push_back(item.quantity(Dimension::Strain));
  if (strain.empty()) throw list.error("must have at least one sample");
  return strain;
}

std::vector<double> tabled_strain(const TomlTable& table, const std::string& file) {
  const TomlValue name = table.at("table");
  const TomlValue column = table.at("column");
  const auto unit = table.find("unit");
  const auto path = std::filesystem::path(file).parent_path() / name.string();
  if (!std::filesystem::is_regular_file(path)) {
    throw name.error("is not a file in the folder of " + file);
  }
  const CsvTable csv = CsvTable::read(path.string());
  const std::string header =
      column.is_string() ? column.string() : std::to_string(column.integer(1, 1'000'000));
  const std::size_t index = csv.find(header, column.where(), column.key());
  const UnitConversion to_si =
      unit ? unit_conversion(unit->string(), Dimension::Strain, unit->where(), unit->key())
           : unit_conversion(csv.units()[index], Dimension::Strain, {csv.file(), 0},
                             "unit of " + header);
  std::vector<double> strain = csv.numbers(index);
  for (std::size_t row = 0; row < strain.size(); ++row) {
    if (!std::isfinite(strain[row])) {
      throw InputError({csv.file(), csv.line_of_row(row)}, header,
                       std::string(csv.cell(row, index)), "must be a number in a drive");
    }
    strain[row] = to_si(strain[row]);
  }
  return strain;
}

std::vector<double> programmed_strain(const TomlTable& table) {
  const std::vector<double> turns = listed_strain(table.at("turning_points"));
  const auto given = table.find("points_between");
  const auto between = given ? given->integer(0, 1'000'000) : 50;
  const auto steps = static_cast<double>(between + 1);
  std::vector<double> strain{0.0};
  for (const double turn : turns) {
    const double from = strain.back();
    if (turn == from) continue;
    for (std::int64_t i = 1; i <= between; ++i) {
      strain.push_back(from + (turn - from) * (static_cast<double>(i) / steps));
    }
    strain.push_back(turn);
  }
  return strain;
}

std::vector<double> read_strain(const TomlTable& root, const std::string& file) {
  const auto drive = root.find_table("drive");
  if (!drive) throw InputError({file, 0}, "drive", "", "is missing: a scene needs [drive]");
  const TomlValue strain = drive->at("strain");
  if (strain.is_array()) return listed_strain(strain);
  if (!strain.is_table()) {
    throw strain.error("must be a list of strains, { table, column } or { turning_points }");
  }
  const TomlTable how = strain.table();
  const bool by_table = how.find("table").has_value();
  const bool by_turns = how.find("turning_points").has_value();
  if (by_table == by_turns) {
    how.check_unused();
    throw strain.error("must have either table and column, or turning_points");
  }
  if (by_turns) return programmed_strain(how);
  return tabled_strain(how, file);
}

std::vector<Probe> read_probes(const TomlTable& root) {
  std::vector<Probe> probes;
  for (const TomlTable& table : root.find_tables("probe")) {
    const TomlValue quantity = table.at("quantity");
    const std::size_t which = quantity.word(probe_quantities());
    const auto name = table.find("name");
    probes.push_back(
        {name ? name->string() : quantity.string(), static_cast<ProbeQuantity>(which)});
    for (std::size_t i = 0; i + 1 < probes.size(); ++i) {
      if (probes[i].name != probes.back().name) continue;
      throw name.value_or(quantity).error("is the name of another probe, too");
    }
  }
  return probes;
}

}  // namespace

std::span<const std::string_view> probe_quantities() {
  static constexpr std::array<std::string_view, 6> kWords{
      "strain", "stress", "plastic_strain", "accumulated_strain", "load", "dissipation"};
  return kWords;
}

void read_setup(const TomlTable& root, Setup& setup) {
  const bool named_only = read_named_material(root, setup);
  for (const Field& field : fields()) {
    if (field.path.starts_with("drive.")) continue;
    if (named_only && field.path.starts_with("material.")) continue;
    if (const auto value = value_at(root, field.path)) set_from(setup, field, *value);
  }
  const auto where = [&](std::string_view name) {
    const auto table = root.find(name);
    return table ? table->where() : root.where();
  };
  check_material(setup.scene.material, where("material"));
  check_section(setup.scene.section, where("section"));
}

SceneFile parse_scene_file(std::string text, std::string name) {
  const TomlDocument document = TomlDocument::parse(std::move(text), std::move(name));
  const TomlTable& root = document.root();
  SceneFile file{document.name(), document.text(), {}};
  Scene& scene = file.setup.scene;
  const auto title = root.find("name");
  scene.name = title ? title->string() : std::filesystem::path(file.path).stem().string();
  read_setup(root, file.setup);
  for (const Field& field : fields()) {
    if (!field.path.starts_with("drive.")) continue;
    if (const auto value = value_at(root, field.path)) set_from(file.setup, field, *value);
  }
  scene.drive.strain = read_strain(root, file.path);
  if (std::vector<Probe> probes = read_probes(root); !probes.empty()) {
    scene.probes = std::move(probes);
  }
  root.check_unused();
  try {
    check_scene(scene, file.setup.solver);
  } catch (const InputError& error) {
    if (!error.where().file.empty()) throw;
    throw InputError({file.path, 0}, error.field(), error.value(), error.rule());
  }
  return file;
}

SceneFile read_scene_file(const std::string& path) {
  const TomlDocument document = TomlDocument::read(path);
  return parse_scene_file(document.text(), path);
}

}  // namespace plastica::io
