#include "calibrate/target/import.hpp"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

#include "calibrate/guess/column_role.hpp"
#include "calibrate/target/column_pattern.hpp"
#include "calibrate/target/make.hpp"
#include "calibrate/target/named_column.hpp"
#include "calibrate/target/samples.hpp"
#include "plastica/io/read_input.hpp"
#include "plastica/io/units.hpp"

namespace plastica::calibrate {
namespace {

using io::CsvTable;

/// The checked block: strain and stress columns and what they are divided by.
struct Plan {
  const ColumnSource* strain = nullptr;
  const SpecimenValue* gauge_length = nullptr;
  const SpecimenValue* strain_rate = nullptr;
  const ColumnSource* stress = nullptr;
  const SpecimenValue* area = nullptr;
  const char* strain_field = "strain";
  const char* stress_field = "stress";

  Dimension strain_is() const { return gauge_length ? Dimension::Length : Dimension::Strain; }
  Dimension stress_is() const { return area ? Dimension::Force : Dimension::Stress; }
};

void check_value(const TargetSource& source, const SpecimenValue& value, const char* field) {
  if (value.value) {
    if (value.value.value() > 0.0) return;
    throw InputError(value.where, field, std::to_string(*value.value), "must be positive");
  }
  if (value.from.empty()) {
    throw InputError(value.where, field, "", "must be a quantity or a column of the table");
  }
  if (!source.table) throw InputError(value.where, field, value.from, "needs a table to come from");
}

Plan plan_of(const TargetSource& source) {
  const SourceLocation& where = source.where;
  if (source.files.empty()) throw InputError(where, "files", "", "must name at least one file");
  if (source.strain.has_value() == source.elongation.has_value()) {
    throw InputError(where, "strain", "", "either strain or elongation must be given, not both");
  }
  if (source.stress.has_value() == source.force.has_value()) {
    throw InputError(where, "stress", "", "either stress or force must be given, not both");
  }
  const bool divided = source.elongation || source.force;
  if (divided && source.test != Test::Tension) {
    throw InputError(where, "test", source.test == Test::Bending ? "bending" : "torsion",
                     "elongation and force are for tension; give strain and stress");
  }
  Plan plan;
  plan.strain = source.strain ? &*source.strain : &*source.elongation;
  plan.stress = source.stress ? &*source.stress : &*source.force;
  if (source.elongation) {
    if (!source.gauge_length) {
      throw InputError(where, "gauge_length", "", "is required with elongation");
    }
    check_value(source, *source.gauge_length, "gauge_length");
    plan.gauge_length = &*source.gauge_length;
    plan.strain_field = "elongation";
  }
  if (source.force) {
    if (!source.area) throw InputError(where, "area", "", "is required with force");
    check_value(source, *source.area, "area");
    plan.area = &*source.area;
    plan.stress_field = "force";
  }
  if (source.strain_rate) {
    check_value(source, *source.strain_rate, "strain_rate");
    plan.strain_rate = &*source.strain_rate;
  }
  if (plan.strain->column.find('*') != std::string::npos) {
    throw InputError(plan.strain->where, plan.strain_field, plan.strain->column,
                     "must name one column; only stress or force may be a pattern");
  }
  if (!source.group.empty() && !source.table) {
    throw InputError(where, "group", source.group.front(), "needs a table to come from");
  }
  return plan;
}

/// The rows of a file that are one specimen.
struct Part {
  std::string stem;   ///< of the file
  std::string value;  ///< of the columns that split it; empty: all rows
  std::vector<std::size_t> rows;

  std::vector<double> of(std::vector<double> values) const {
    if (value.empty()) return values;
    std::vector<double> own;
    own.reserve(rows.size());
    for (const std::size_t row : rows) own.push_back(values[row]);
    return own;
  }
};

/// The specimens of a file, in the order in which they come up first.
std::vector<Part> parts_of(const TargetSource& source, const CsvTable& table,
                           const std::string& stem) {
  if (source.split.empty()) return {{stem, "", {}}};
  std::vector<std::size_t> columns;
  for (const std::string& name : source.split) {
    columns.push_back(table.find(name, source.where, "split"));
  }
  std::vector<Part> parts;
  std::map<std::string, std::size_t> known;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::string value;
    for (const std::size_t column : columns) {
      const std::string_view cell = table.cell(row, column);
      if (cell.empty()) {
        throw InputError({table.file(), table.line_of_row(row)}, table.label(column), "",
                         "is empty: split needs a value in each row");
      }
      value += (value.empty() ? "" : ":") + std::string(cell);
    }
    const auto [at, is_new] = known.emplace(value, parts.size());
    if (is_new) parts.push_back({stem, value, {}});
    parts[at->second].rows.push_back(row);
  }
  return parts;
}

/// The table beside the curves, with the columns that the block asks for.
class Specimens {
 public:
  explicit Specimens(const TargetSource& source)
      : source_(source),
        table_(CsvTable::read(source.table->file, source.table->csv)),
        key_(table_.find(source.table->key, source.table->where, "key")) {
    for (const std::string& name : source.group) {
      groups_.push_back(table_.find(name, source.where, "group"));
    }
    for (const auto& value : {source.gauge_length, source.area, source.strain_rate}) {
      if (value && !value->value) table_.find(value->from, value->where, "from");
    }
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      const auto [entry, is_new] = rows_.emplace(std::string(table_.cell(row, key_)), row);
      if (!is_new) entry->second = kTwice;
    }
  }

  /// The row of a file's stem, or of the value that splits it.
  /// @throws InputError if there is not exactly one row
  std::size_t row_of(const Part& part) const {
    auto found = part.value.empty() ? rows_.end() : rows_.find(part.value);
    if (found == rows_.end()) found = rows_.find(part.stem);
    if (found != rows_.end() && found->second != kTwice) return found->second;
    throw InputError({table_.file(), 0}, source_.table->key,
                     part.value.empty() ? part.stem : part.value,
                     found == rows_.end() ? "has no row in the table" : "has more than one row");
  }

  double number(std::size_t row, const SpecimenValue& value, Dimension dimension, const char* field,
                std::vector<std::string>& warnings) const {
    const io::FoundColumn column = io::find_column(table_, named(value, field), dimension);
    warn_of_unit(table_, column, warnings);
    const double si = column.to_si(table_.number(row, column.index));
    if (si > 0.0 && std::isfinite(si)) return si;
    throw InputError({table_.file(), table_.line_of_row(row)}, value.from,
                     table_.cell(row, column.index), "must be a positive number");
  }

  void add_groups(std::size_t row, Target& target) const {
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      target.group.emplace_back(source_.group[i], table_.cell(row, groups_[i]));
    }
  }

 private:
  static constexpr std::size_t kTwice = static_cast<std::size_t>(-1);
  const TargetSource& source_;
  CsvTable table_;
  std::size_t key_;
  std::vector<std::size_t> groups_;
  std::map<std::string, std::size_t> rows_;
};

void reject(Target& target, std::string reason) {
  target.status = TargetStatus::Rejected;
  target.reason = std::move(reason);
}

std::vector<io::FoundColumn> stress_columns(const CsvTable& table, const io::NamedColumn& asked,
                                            Dimension dimension) {
  if (asked.name.find('*') == std::string::npos) {
    return {io::find_column(table, asked, dimension)};
  }
  std::vector<io::FoundColumn> columns;
  for (std::size_t i = 0; i < table.columns(); ++i) {
    if (!matches_column(asked.name, table.names()[i])) continue;
    columns.push_back(io::column_at(table, i, asked, dimension));
  }
  if (columns.empty()) {
    throw InputError(asked.where, asked.key, asked.name, "matches no column of " + table.file());
  }
  return columns;
}

struct Columns {
  io::FoundColumn strain;
  std::vector<io::FoundColumn> stress;
};

/// @throws InputError if the file lacks a column or its unit, or has one that does not fit
Columns columns_of(const Plan& plan, const CsvTable& table) {
  return {io::find_column(table, named(*plan.strain, plan.strain_field), plan.strain_is()),
          stress_columns(table, named(*plan.stress, plan.stress_field), plan.stress_is())};
}

/// Raw curve of one specimen, in SI.
void read_curve(const Plan& plan, const CsvTable& table, const io::FoundColumn& strain,
                const io::FoundColumn& stress, const Specimens* specimens, const Part& part,
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
  Curve raw{part.of(io::numbers_of(table, strain)), part.of(io::numbers_of(table, stress))};
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

/// Units that the block itself gives, checked once, as an error of the block.
void check_units(const Plan& plan) {
  const auto check = [](const auto& asked, Dimension dimension, const char* field) {
    if (asked->unit) io::unit_conversion(*asked->unit, dimension, asked->where, field);
  };
  check(plan.strain, plan.strain_is(), plan.strain_field);
  check(plan.stress, plan.stress_is(), plan.stress_field);
  if (plan.gauge_length) check(plan.gauge_length, Dimension::Length, "gauge_length");
  if (plan.area) check(plan.area, Dimension::Area, "area");
  if (plan.strain_rate) check(plan.strain_rate, Dimension::StrainRate, "strain_rate");
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

}  // namespace

std::vector<Target> import_targets(const TargetSource& source, const TargetOptions& options) {
  const Plan plan = plan_of(source);
  check_units(plan);
  TargetOptions used = options;
  used.test = source.test;
  used.measure = source.measure;
  if (source.loading) used.loading = source.loading;
  std::optional<Specimens> specimens;
  if (source.table) specimens.emplace(source);
  std::vector<Target> targets;
  std::optional<InputError> lacking;  // the first file without the columns
  bool any_has_columns = false;
  for (const std::string& file : source.files) {
    // A link that leads nowhere is one bad file among others: its reading says why.
    if (!io::is_file(file) && !io::is_broken_link(file)) {
      throw InputError(source.where, "files", file,
                       "is not a file that can be read" + io::why_no_file(file));
    }
    Target first;
    first.file = file;
    first.test = source.test;
    first.measure = source.measure;
    const std::string stem = std::filesystem::path(file).stem().string();
    first.name = stem;
    const auto refuse = [&](const InputError& error) {
      Target refused = first;
      reject(refused, error.what());
      targets.push_back(std::move(refused));
    };
    std::optional<CsvTable> table;
    Columns columns;
    std::vector<Part> parts;
    try {
      if (specimens && source.split.empty()) {
        specimens->add_groups(specimens->row_of({stem, "", {}}), first);
      }
      table.emplace(CsvTable::read(file, source.csv));
    } catch (const InputError& error) {
      refuse(error);
      continue;
    }
    try {
      columns = columns_of(plan, *table);
      parts = parts_of(source, *table, stem);
      any_has_columns = true;
    } catch (const InputError& error) {
      if (!lacking) lacking = error;
      refuse(error);
      continue;
    }
    const bool pattern = plan.stress->column.find('*') != std::string::npos;
    for (const Part& part : parts) {
      for (const io::FoundColumn& column : columns.stress) {
        Target target = first;
        if (!part.value.empty()) target.name += ":" + part.value;
        if (pattern) target.name += ":" + table->names()[column.index];
        report_torn_row(*table, target.repairs);
        try {
          if (specimens && !source.split.empty()) {
            specimens->add_groups(specimens->row_of(part), target);
          }
          read_curve(plan, *table, columns.strain, column, specimens ? &*specimens : nullptr, part,
                     target);
        } catch (const InputError& error) {
          reject(target, error.what());
          targets.push_back(std::move(target));
          continue;
        }
        warn_of_unit(*table, columns.strain, target.warnings);
        warn_of_unit(*table, column, target.warnings);
        if (target.test == Test::Tension) {
          warn_of_percent(columns.strain, target.raw.strain, target.warnings);
          warn_of_travel(table->names()[columns.strain.index], table->units()[columns.strain.index],
                         target.warnings);
        }
        process_target(target, used);
        targets.push_back(std::move(target));
      }
    }
  }
  if (lacking && !any_has_columns) throw *lacking;  // the block is wrong, not the files
  make_names_unique(targets);
  return targets;
}

}  // namespace plastica::calibrate
