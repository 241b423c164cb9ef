#include "calibrate/config/read_target.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <limits>
#include <utility>

#include "calibrate/config/read_csv_options.hpp"
#include "calibrate/config/read_plausible.hpp"
#include "calibrate/config/read_target_options.hpp"
#include "plastica/io/read_input.hpp"
#include "plastica/io/units.hpp"

namespace plastica::calibrate {
namespace {

using io::TomlTable;
using io::TomlValue;

/// The key `unit` of a column's table, checked.
std::optional<std::string> read_unit(const TomlTable& table, Dimension dimension) {
  const auto unit = table.find("unit");
  if (!unit) return std::nullopt;
  io::unit_conversion(unit->string(), dimension, unit->where(), unit->key());
  return unit->string();
}

/// Whether a unit that is given goes before that of the file.
bool overrides(const TomlTable& table, const std::optional<std::string>& unit) {
  if (!table.is_set("override_unit")) return false;
  if (!unit) throw table.at("override_unit").error("is of no use without unit");
  return true;
}

/// A header or number, or { column = "Stress", unit = "MPa" }.
ColumnSource read_any_column(const TomlValue& value, Dimension dimension) {
  if (value.is_table()) {
    ColumnSource column = read_column(value.table(), dimension);
    column.factor = read_factor(value.table());
    return column;
  }
  if (!value.is_string() && !value.is_number()) {
    throw value.error("must be a column, { column = \"...\", unit = \"" +
                      std::string(si_unit(dimension)) + "\" }");
  }
  ColumnSource column;
  column.column = column_name(value);
  column.where = value.where();
  return column;
}

/// One column or several, by names or numbers.
std::vector<std::string> read_columns_of(const TomlValue& value) {
  if (value.is_string() || value.is_number()) return {column_name(value)};
  std::vector<std::string> columns;
  for (const TomlValue& each : value.array()) columns.push_back(column_name(each));
  if (columns.empty()) throw value.error("must name a column");
  return columns;
}

/// "50 mm" for all specimens, or { from = "Le_mm", unit = "mm" }.
SpecimenValue read_specimen_value(const TomlValue& value, Dimension dimension) {
  SpecimenValue specimen;
  specimen.where = value.where();
  if (value.is_table()) {
    const TomlTable table = value.table();
    specimen.unit = read_unit(table, dimension);
    specimen.override_unit = overrides(table, specimen.unit);
    specimen.from = column_name(table.at("from"));
    return specimen;
  }
  specimen.value = value.quantity(dimension);
  if (*specimen.value <= 0.0) {
    throw value.error("must be above 0 " + std::string(si_unit(dimension)));
  }
  return specimen;
}

TableSource read_table(const TomlValue& value, const std::string& folder) {
  const TomlTable table = value.table();
  const TomlValue file = table.at("file");
  const auto path = std::filesystem::path(folder) / file.string();
  if (!io::is_file(path)) {
    throw file.error("is not a file" + (folder.empty() ? "" : " in " + folder) +
                     io::why_no_file(path));
  }
  TableSource source;
  source.file = path.lexically_normal().string();
  source.key = column_name(table.at("key"));
  source.where = value.where();
  read_csv_options(table, source.csv);
  return source;
}

/// Of two ways to say the same, a table may use one; it replaces what the defaults say.
template <typename Source, typename Read>
void read_either(const TomlTable& table, const std::pair<std::string_view, Source*>& direct,
                 const std::pair<std::string_view, Source*>& indirect, const Read& read) {
  const auto first = table.find(direct.first);
  const auto second = table.find(indirect.first);
  if (first && second) {
    throw second->error("cannot go with " + std::string(direct.first));
  }
  if (first) {
    *direct.second = read(*first, true);
    indirect.second->reset();
  } else if (second) {
    *indirect.second = read(*second, false);
    direct.second->reset();
  }
}

void read_columns(const TomlTable& table, TargetSource& source) {
  using Column = std::optional<ColumnSource>;
  read_either<Column>(table, {"strain", &source.strain}, {"elongation", &source.elongation},
                      [](const TomlValue& value, bool direct) {
                        return read_any_column(value,
                                               direct ? Dimension::Strain : Dimension::Length);
                      });
  read_either<Column>(table, {"stress", &source.stress}, {"force", &source.force},
                      [](const TomlValue& value, bool direct) {
                        return read_any_column(value,
                                               direct ? Dimension::Stress : Dimension::Force);
                      });
  if (const auto value = table.find("gauge_length")) {
    source.gauge_length = read_specimen_value(*value, Dimension::Length);
  }
  if (const auto value = table.find("area")) {
    source.area = read_specimen_value(*value, Dimension::Area);
  }
  if (const auto value = table.find("strain_rate")) {
    source.strain_rate = read_specimen_value(*value, Dimension::StrainRate);
  }
}

}  // namespace

ColumnSource read_column(const TomlTable& table, Dimension dimension) {
  const TomlValue name = table.at("column");
  ColumnSource column;
  column.column = column_name(name);
  column.where = name.where();
  column.unit = read_unit(table, dimension);
  column.override_unit = overrides(table, column.unit);
  return column;
}

double read_factor(const TomlTable& table) {
  const auto value = table.find("factor");
  const double factor = value ? value->number() : 1.0;
  if (factor == 0.0) throw value->error("must not be 0");
  return factor;
}

void read_target(const TomlTable& table, const std::string& folder, TargetBlock& block) {
  static constexpr std::array<std::string_view, 3> kTests{"tension", "bending", "torsion"};
  static constexpr std::array<std::string_view, 2> kMeasures{"engineering", "true"};
  static constexpr std::array<std::string_view, 3> kLoadings{"monotonic", "cyclic", "auto"};
  TargetSource& source = block.source;
  TargetOptions& options = block.options;
  if (const auto value = table.find("test")) {
    source.test = options.test = static_cast<Test>(value->word(kTests));
  }
  if (const auto value = table.find("measure")) {
    options.measure = static_cast<Measure>(value->word(kMeasures));
    source.measure = options.measure;
  }
  if (const auto value = table.find("loading")) {
    const std::size_t word = value->word(kLoadings);
    options.loading.reset();
    if (word < 2) options.loading = static_cast<Loading>(word);
    source.loading = options.loading;
  }
  read_columns(table, source);
  const auto& strain = source.strain ? source.strain : source.elongation;
  options.is_compressed = strain && strain->factor < 0.0;
  if (const auto value = table.find("table")) source.table = read_table(*value, folder);
  if (const auto value = table.find("group")) source.group = value->strings();
  if (const auto value = table.find("split")) source.split = read_columns_of(*value);
  read_csv_options(table, source.csv);
  if (const auto corrections = table.find_table("corrections")) {
    read_corrections(*corrections, options);
  }
  if (const auto characteristics = table.find_table("characteristics")) {
    read_characteristics(*characteristics, options);
  }
  if (const auto plausible = table.find_table("plausible")) {
    read_plausible(*plausible, options);
  }
}

void check_target(const TomlTable& table, const TargetSource& source) {
  const auto refuse = [&](std::string_view key, std::string_view rule) {
    if (const auto value = table.find(key)) throw value->error(rule);
    throw InputError(table.where(), table.key() + "." + std::string(key), "", rule);
  };
  if (!source.strain && !source.elongation) {
    refuse("strain", "is missing: give strain, or elongation and gauge_length");
  }
  if (!source.stress && !source.force) {
    refuse("stress", "is missing: give stress, or force and area");
  }
  const std::string_view kTensionOnly =
      "goes with test = \"tension\" alone; bending and torsion take strain and stress of the "
      "outermost fibre";
  if (source.test != Test::Tension && source.elongation) refuse("elongation", kTensionOnly);
  if (source.test != Test::Tension && source.force) refuse("force", kTensionOnly);
  if (source.elongation && !source.gauge_length) {
    refuse("gauge_length", "is missing: elongation needs it");
  }
  if (source.force && !source.area) refuse("area", "is missing: force needs it");
  if (!source.elongation && source.gauge_length && table.contains("gauge_length")) {
    refuse("gauge_length", "is of no use without elongation");
  }
  if (!source.force && source.area && table.contains("area")) {
    refuse("area", "is of no use without force");
  }
  if (source.has_values()) return;
  const auto needs_table = [&](const std::optional<SpecimenValue>& value) {
    return value && !value->value;
  };
  constexpr std::string_view kNeedsTable =
      "needs `table`, the file that has this column, or HDF5 files with attributes";
  if (source.elongation && needs_table(source.gauge_length)) refuse("gauge_length", kNeedsTable);
  if (source.force && needs_table(source.area)) refuse("area", kNeedsTable);
  if (needs_table(source.strain_rate)) refuse("strain_rate", kNeedsTable);
  if (!source.group.empty()) refuse("group", kNeedsTable);
}

}  // namespace plastica::calibrate
