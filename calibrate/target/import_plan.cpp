#include "calibrate/target/import_plan.hpp"

#include <fmt/format.h>

#include <string>

#include "calibrate/target/named_column.hpp"
#include "plastica/base/star_pattern.hpp"
#include "plastica/io/units.hpp"

namespace plastica::calibrate {
namespace {

using io::CsvTable;

void check_value(const TargetSource& source, const SpecimenValue& value, const char* field) {
  if (value.value) {
    if (value.value.value() > 0.0) return;
    throw InputError(value.where, field, std::to_string(*value.value), "must be positive");
  }
  if (value.from.empty()) {
    throw InputError(value.where, field, "", "must be a quantity or a column of the table");
  }
  if (!source.has_values()) {
    throw InputError(value.where, field, value.from, "needs a table to come from");
  }
}

std::vector<io::FoundColumn> stress_columns(const CsvTable& table, const io::NamedColumn& asked,
                                            Dimension dimension) {
  if (asked.name.find('*') == std::string::npos) {
    return {io::find_column(table, asked, dimension)};
  }
  std::vector<io::FoundColumn> columns;
  for (std::size_t i = 0; i < table.columns(); ++i) {
    if (!matches_stars(asked.name, table.names()[i])) continue;
    columns.push_back(io::column_at(table, i, asked, dimension));
  }
  if (columns.empty()) {
    throw InputError(asked.where, asked.key, asked.name, "matches no column of " + table.file());
  }
  return columns;
}

/// Another unit may go before a file's, but not where the file's are those of each other's column.
void refuse_swapped(const CsvTable& table, const ImportPlan& plan, const ImportColumns& columns) {
  const io::FoundColumn& strain = columns.strain;
  for (const io::FoundColumn& stress : columns.stress) {
    if (strain.overridden.empty() || stress.overridden.empty()) continue;
    if (!io::is_unit_of(strain.overridden, plan.stress_is()) ||
        !io::is_unit_of(stress.overridden, plan.strain_is())) {
      continue;
    }
    throw InputError(
        {table.file(), 0}, plan.strain_field, table.names()[strain.index],
        fmt::format("is in {} in the file, and \"{}\" for the {} in {}: the columns are swapped",
                    strain.overridden, table.names()[stress.index], plan.stress_field,
                    stress.overridden));
  }
}

}  // namespace

ImportPlan plan_of(const TargetSource& source) {
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
  if (source.measure == Measure::True && !source.may_be_true()) {
    throw InputError(where, "measure", "true",
                     divided ? "is not that of force over area and of elongation over gauge "
                               "length: corrections.measure = \"true\" converts them"
                             : "goes with test = \"tension\" alone");
  }
  ImportPlan plan;
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
  if (!source.group.empty() && !source.has_values()) {
    throw InputError(where, "group", source.group.front(), "needs a table to come from");
  }
  return plan;
}

void check_units(const ImportPlan& plan) {
  const auto check = [](const auto& asked, Dimension dimension, const char* field) {
    if (asked->unit) io::unit_conversion(*asked->unit, dimension, asked->where, field);
  };
  check(plan.strain, plan.strain_is(), plan.strain_field);
  check(plan.stress, plan.stress_is(), plan.stress_field);
  if (plan.gauge_length) check(plan.gauge_length, Dimension::Length, "gauge_length");
  if (plan.area) check(plan.area, Dimension::Area, "area");
  if (plan.strain_rate) check(plan.strain_rate, Dimension::StrainRate, "strain_rate");
}

ImportColumns columns_of(const ImportPlan& plan, const CsvTable& table) {
  ImportColumns columns{
      io::find_column(table, named(*plan.strain, plan.strain_field), plan.strain_is()),
      stress_columns(table, named(*plan.stress, plan.stress_field), plan.stress_is())};
  refuse_swapped(table, plan, columns);
  return columns;
}

}  // namespace plastica::calibrate
