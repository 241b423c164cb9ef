#pragma once

#include <vector>

#include "calibrate/target/import.hpp"
#include "plastica/base/quantity.hpp"
#include "plastica/io/csv_column.hpp"

/// Which columns of its files a block names; not installed.
namespace plastica::calibrate {

/// The checked block: strain and stress columns and what they are divided by.
struct ImportPlan {
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

/// @throws InputError for a block that contradicts itself, or lacks something
ImportPlan plan_of(const TargetSource& source);

/// Checks the units that the block itself gives, once, as an error of the block. @throws InputError
void check_units(const ImportPlan& plan);

struct ImportColumns {
  io::FoundColumn strain;
  std::vector<io::FoundColumn> stress;
};

/// @throws InputError if the file lacks a column or its unit, or has one that does not fit
ImportColumns columns_of(const ImportPlan& plan, const io::CsvTable& table);

}  // namespace plastica::calibrate
