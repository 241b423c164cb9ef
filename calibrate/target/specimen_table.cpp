#include "calibrate/target/specimen_table.hpp"

#include <cmath>
#include <utility>

#include "calibrate/target/named_column.hpp"
#include "calibrate/target/samples.hpp"

namespace plastica::calibrate {

SpecimenTable::SpecimenTable(const TargetSource& source)
    : source_(source),
      table_(io::CsvTable::read(source.table->file, source.table->csv)),
      key_(table_.find(source.table->key, source.table->where, "key")) {
  find_columns();
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    const auto [entry, is_new] = rows_.emplace(std::string(table_.cell(row, *key_)), row);
    if (!is_new) entry->second = kTwice;
  }
}

SpecimenTable::SpecimenTable(const TargetSource& source, io::CsvTable properties)
    : source_(source), table_(std::move(properties)) {
  find_columns();
}

void SpecimenTable::find_columns() {
  for (const std::string& name : source_.group) {
    groups_.push_back(table_.find(name, source_.where, "group"));
  }
  for (const auto& value : {source_.gauge_length, source_.area, source_.strain_rate}) {
    if (value && !value->value) table_.find(value->from, value->where, "from");
  }
}

std::size_t SpecimenTable::row_of(const Part& part) const {
  if (!key_) return 0;
  auto found = part.value.empty() ? rows_.end() : rows_.find(part.value);
  if (found == rows_.end()) found = rows_.find(part.stem);
  if (found == rows_.end() && !part.within.empty()) found = rows_.find(part.within);
  if (found == rows_.end() && !part.last.empty()) found = rows_.find(part.last);
  if (found != rows_.end() && found->second != kTwice) return found->second;
  throw InputError({table_.file(), 0}, source_.table->key,
                   part.value.empty() ? part.stem : part.value,
                   found == rows_.end() ? "has no row in the table" : "has more than one row");
}

double SpecimenTable::number(std::size_t row, const SpecimenValue& value, Dimension dimension,
                             const char* field, std::vector<std::string>& warnings) const {
  const io::FoundColumn column = io::find_column(table_, named(value, field), dimension);
  warn_of_unit(table_, column, warnings);
  const double si = column.to_si(table_.number(row, column.index));
  if (si > 0.0 && std::isfinite(si)) return si;
  throw InputError({table_.file(), table_.line_of_row(row)}, value.from,
                   table_.cell(row, column.index), "must be a positive number");
}

void SpecimenTable::add_groups(std::size_t row, Target& target) const {
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    target.group.emplace_back(source_.group[i], table_.cell(row, groups_[i]));
  }
}

}  // namespace plastica::calibrate
