#include "calibrate/target/import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "calibrate/guess/column_role.hpp"
#include "calibrate/target/curve_spool.hpp"
#include "calibrate/target/import_plan.hpp"
#include "calibrate/target/kept_tables.hpp"
#include "calibrate/target/make.hpp"
#include "calibrate/target/named_measure.hpp"
#include "calibrate/target/samples.hpp"
#include "calibrate/target/specimen_table.hpp"
#include "calibrate/target/tables_of_files.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/io/content_digest.hpp"
#include "plastica/io/hdf5_tables.hpp"
#include "plastica/io/read_input.hpp"
#include "plastica/io/units.hpp"

namespace plastica::calibrate {
namespace {

using io::CsvTable;

/// What tells the specimen of a row from others of its file.
/// @throws InputError if it says nothing
std::string split_value(const CsvTable& table, std::span<const std::size_t> columns,
                        std::size_t row) {
  std::string value;
  for (const std::size_t column : columns) {
    const std::string cell = table.cell(row, column);
    if (cell.empty()) {
      throw InputError({table.file(), table.line_of_row(row)}, table.label(column), "",
                       "is empty: split needs a value in each row");
    }
    value += (value.empty() ? "" : ":") + cell;
  }
  return value;
}

/// The specimens of a file, in the order in which they come up first.
std::vector<Part> parts_of(const TargetSource& source, const CsvTable& table, const Part& whole) {
  if (source.split.empty()) {
    Part all = whole;
    all.rows = {{0, table.rows()}};
    return {all};
  }
  std::vector<std::size_t> columns;
  for (const std::string& name : source.split) {
    columns.push_back(table.find(name, source.where, "split"));
  }
  std::vector<Part> parts;
  std::map<std::string, std::size_t> known;
  std::size_t last = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::string value = split_value(table, columns, row);
    if (parts.empty() || parts[last].value != value) {
      const auto [at, is_new] = known.emplace(std::move(value), parts.size());
      if (is_new) parts.push_back({whole.stem, at->first, {}, whole.within, whole.last});
      last = at->second;
    }
    parts[last].add(row);
  }
  return parts;
}

void reject(Target& target, std::string reason) {
  target.status = TargetStatus::Rejected;
  target.reason = std::move(reason);
}

/// Raw curve of one specimen, in SI.
void read_curve(const ImportPlan& plan, const CsvTable& table, const io::FoundColumn& strain,
                const io::FoundColumn& stress, const SpecimenTable* specimens, const Part& part,
                Target& target) {
  double gauge_length = 1.0;
  double area = 1.0;
  const auto value_of = [&](const SpecimenValue& value, Dimension dimension, const char* field) {
    const double si = value.value ? *value.value
                                  : specimens->number(specimens->row_of(part), value, dimension,
                                                      field, target.warnings);
    target.properties.emplace_back(field, si);
    return si;
  };
  if (plan.gauge_length)
    gauge_length = value_of(*plan.gauge_length, Dimension::Length, "gauge_length");
  if (plan.area) area = value_of(*plan.area, Dimension::Area, "area");
  if (plan.strain_rate) value_of(*plan.strain_rate, Dimension::StrainRate, "strain_rate");
  Curve raw{io::numbers_of(table, strain, part.rows), io::numbers_of(table, stress, part.rows)};
  for (double& value : raw.strain) value /= gauge_length * plan.strain->factor;
  for (double& value : raw.stress) value /= area * plan.stress->factor;
  target.raw = std::move(raw);  // both columns or none
}

/// Crosshead travel is more than the specimen's deformation.
void warn_of_travel(std::string_view name, std::string_view unit,
                    std::vector<std::string>& warnings) {
  if (!meaning_of(name, unit).is_travel) return;
  warnings.push_back("\"" + std::string(name) +
                     "\" is crosshead travel by its name: the machine gives way in it, so that "
                     "Young's modulus comes out too small and strains too large");
}

/// Alike names get their folder before them, and a number if that does not tell them apart.
void make_names_unique(std::vector<Target>& targets) {
  std::map<std::string, std::size_t> count;
  for (const Target& target : targets) ++count[target.name];
  std::map<std::string, std::size_t> seen;
  for (Target& target : targets) {
    if (count[target.name] > 1) {
      const auto folder = std::filesystem::path(target.file).parent_path().filename().string();
      if (!folder.empty()) target.name = folder + "/" + target.name;
    }
    const std::size_t number = ++seen[target.name];
    if (number > 1) target.name += " (" + std::to_string(number) + ")";
  }
}

/// What all files of a block are read by.
struct Block {
  const TargetSource& source;
  const ImportPlan plan;
  const TargetOptions options;
  const std::optional<SpecimenTable> specimens;
  const std::shared_ptr<CurveSpool>& spool;  ///< null: curves stay in memory
};

/// The specimens of a table.
struct Imported {
  std::vector<Target> targets;
  std::shared_ptr<const InputError> lacking;  ///< where it has not the columns of the block
  std::shared_ptr<const InputError> no_row;   ///< where a specimen is not in the block's table
  bool has_row = false;                       ///< whether one is
  bool was_unreadable = false;
};

/// Looks for a specimen in the block's table.
void find_row(const Block& block, const Part& part, Imported& imported) {
  try {
    (void)block.specimens->row_of(part);
    imported.has_row = true;
  } catch (const InputError& error) {
    if (!imported.no_row) imported.no_row = std::make_shared<const InputError>(error);
  }
}

Target rejected(Target target, const InputError& error) {
  reject(target, error.what());
  return target;
}

/// One specimen of a file, from its raw curve on.
/// @param specimens  null: the block asks for no values of specimens
Target import_curve(const Block& block, const SpecimenTable* specimens, const CsvTable& table,
                    const io::FoundColumn& strain, const io::FoundColumn& stress, const Part& part,
                    Target target) {
  if (part.rows.back().end == table.rows()) report_torn_row(table, target.repairs);
  try {
    if (block.specimens && !block.source.split.empty()) {
      specimens->add_groups(specimens->row_of(part), target);
    }
    read_curve(block.plan, table, strain, stress, specimens, part, target);
  } catch (const InputError& error) {
    return rejected(std::move(target), error);
  }
  warn_of_named_measure(block.source, table, strain.index, stress.index, target.warnings);
  warn_of_named_test(block.source, table, strain.index, stress.index, target.warnings);
  warn_of_unit(table, strain, target.warnings);
  warn_of_unit(table, stress, target.warnings);
  if (target.test == Test::Tension) {
    warn_of_percent(strain, target.raw.strain, target.warnings);
    warn_of_travel(table.names()[strain.index], table.units()[strain.index], target.warnings);
  }
  process_target(target, block.options);
  if (block.spool) put_aside(target, block.spool);
  return target;
}

/// Values of a specimen that no table beside the curves says: of an HDF5 file.
/// @param tables  of that file; null: it is none
/// @throws InputError if it says none
SpecimenTable properties_of(const TargetSource& source, const TableOfFile& from,
                            const io::Hdf5Tables* tables) {
  std::optional<CsvTable> properties;
  if (tables != nullptr) properties = CsvTable::read_properties(*tables, from.path);
  if (properties) return {source, std::move(*properties)};
  throw InputError({from.file, 0}, "", "",
                   (tables != nullptr ? from.path + " has no attributes of a number or text"
                                      : std::string("is no HDF5 file")) +
                       ": needs `table`, the file of what is said of each specimen");
}

/// @param threads  that share its specimens
Imported import_table(const Block& block, const TableOfFile& from, int threads) {
  const TargetSource& source = block.source;
  Imported imported;
  Target first;
  first.file = from.file;
  first.test = source.test;
  first.measure = source.measure.value_or(Measure::Engineering);
  Part whole{std::filesystem::path(from.file).stem().string(), "", {}, "", ""};
  // Sheets of a workbook and tables of a file are specimens of their own.
  const std::string within = source.csv.sheet.value_or(from.within);
  if (!within.empty()) whole.stem += ":" + within;
  whole.within = source.csv.sheet.value_or(from.key);
  whole.last = from.last;
  first.name = whole.stem;
  if (from.lacking) {
    imported.lacking = from.lacking;
    imported.targets.push_back(rejected(std::move(first), *from.lacking));
    return imported;
  }
  const bool is_one = source.split.empty();
  if (block.specimens && is_one) find_row(block, whole, imported);
  std::shared_ptr<const io::Hdf5Tables> tables;
  std::optional<CsvTable> table;
  try {
    if (block.specimens && is_one) {
      block.specimens->add_groups(block.specimens->row_of(whole), first);
    }
    if (!from.path.empty()) {
      tables = from.tables ? from.tables : std::make_shared<const io::Hdf5Tables>(from.file);
      table.emplace(CsvTable::read(*tables, from.path, source.csv.decimal));
    } else if (source.kept) {
      table = source.kept->take(from.file, source.csv);
    }
    if (!table) table.emplace(CsvTable::read(from.file, source.csv));
  } catch (const InputError& error) {
    imported.was_unreadable = true;
    imported.targets.push_back(rejected(std::move(first), error));
    return imported;
  }
  ImportColumns columns;
  std::vector<Part> parts;
  std::optional<SpecimenTable> properties;
  try {
    columns = columns_of(block.plan, *table);
    for (const io::FoundColumn& stress : columns.stress) {
      check_named_measure(source, *table, columns.strain.index, stress.index);
    }
    if (!block.options.accept) {
      check_total_strain(*table, columns.strain.index,
                         "--accept, or plausible.accept = true, takes it as it is");
    }
    parts = parts_of(source, *table, whole);
    if (!block.specimens && source.asks_for_values()) {
      properties.emplace(properties_of(source, from, tables.get()));
      properties->add_groups(0, first);
    }
  } catch (const InputError& error) {
    imported.lacking = std::make_shared<const InputError>(error);
    imported.targets.push_back(rejected(std::move(first), error));
    return imported;
  }
  const SpecimenTable* specimens = block.specimens ? &*block.specimens
                                   : properties    ? &*properties
                                                   : nullptr;
  const bool pattern = block.plan.stress->column.find('*') != std::string::npos;
  if (block.specimens && !is_one) {
    for (const Part& part : parts) find_row(block, part, imported);
  }
  const std::size_t curves = columns.stress.size();
  imported.targets.resize(parts.size() * curves);
  parallel_for(imported.targets.size(), {threads, nullptr}, [&](std::size_t i, int) {
    const Part& part = parts[i / curves];
    const io::FoundColumn& column = columns.stress[i % curves];
    Target target = first;
    if (!part.value.empty()) target.name += ":" + part.value;
    if (pattern) target.name += ":" + table->names()[column.index];
    imported.targets[i] =
        import_curve(block, specimens, *table, columns.strain, column, part, std::move(target));
  });
  return imported;
}

}  // namespace

bool TargetSource::has_values() const {
  return table || std::ranges::any_of(files, io::begins_as_result);
}

bool TargetSource::asks_for_values() const {
  const auto is_asked = [](const std::optional<SpecimenValue>& value) {
    return value && !value->value;
  };
  return !group.empty() || is_asked(gauge_length) || is_asked(area) || is_asked(strain_rate);
}

std::vector<Target> import_targets(const TargetSource& source, const TargetOptions& options,
                                   int threads, const std::shared_ptr<CurveSpool>& spool) {
  const ImportPlan plan = plan_of(source);
  check_units(plan);
  TargetOptions used = options;
  used.test = source.test;
  used.measure = source.measure.value_or(Measure::Engineering);
  if (source.loading) used.loading = source.loading;
  for (const std::string& file : source.files) {
    // A link that leads nowhere is one bad file among others: its reading says why.
    if (!io::is_file(file) && !io::is_broken_link(file)) {
      throw InputError(source.where, "files", file,
                       "is not a file that can be read" + io::why_no_file(file));
    }
  }
  const Block block{
      source, plan, used,
      source.table ? std::optional<SpecimenTable>(std::in_place, source) : std::nullopt, spool};
  const std::vector<TableOfFile> tables = tables_of(source);
  std::vector<Imported> all(tables.size());
  // Tables side by side, or the specimens of one.
  const bool is_one = tables.size() == 1;
  parallel_for(all.size(), {is_one ? 1 : threads, nullptr}, [&](std::size_t i, int) {
    all[i] = import_table(block, tables[i], is_one ? threads : 1);
  });
  const auto lacks = [](const Imported& one) { return one.lacking != nullptr; };
  const auto first = std::ranges::find_if(all, lacks);
  const auto has_columns = [](const Imported& one) { return !one.lacking && !one.was_unreadable; };
  // Then the block is wrong, not the files.
  if (first != all.end() && std::ranges::none_of(all, has_columns)) throw *first->lacking;
  const auto no_row =
      std::ranges::find_if(all, [](const Imported& one) { return one.no_row != nullptr; });
  if (no_row != all.end() && std::ranges::none_of(all, &Imported::has_row)) {
    throw *no_row->no_row;
  }
  std::size_t count = 0;
  for (const Imported& one : all) count += one.targets.size();
  std::vector<Target> targets;
  targets.reserve(count);
  for (Imported& one : all) {
    std::ranges::move(one.targets, std::back_inserter(targets));
    one = {};  // many of them take memory
  }
  make_names_unique(targets);
  return targets;
}

}  // namespace plastica::calibrate
