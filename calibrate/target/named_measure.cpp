#include "calibrate/target/named_measure.hpp"

#include <fmt/format.h>

#include "calibrate/guess/column_role.hpp"
#include "plastica/base/check.hpp"
#include "plastica/model/field.hpp"

namespace plastica::calibrate {
namespace {

ColumnMeaning meaning_in(const io::CsvTable& table, std::size_t column) {
  return meaning_of(table.names()[column], table.units()[column]);
}

std::string_view word_of(Test test) {
  return find_field("drive.deformation").choices[static_cast<std::size_t>(test)];
}

}  // namespace

void check_named_measure(const TargetSource& source, const io::CsvTable& table, std::size_t strain,
                         std::size_t stress) {
  if (source.measure || !source.may_be_true()) return;
  if (!meaning_in(table, strain).is_true || !meaning_in(table, stress).is_true) return;
  throw InputError(
      source.where, "measure", "",
      fmt::format("is needed: \"{}\" and \"{}\" are true strain and stress by their "
                  "names; write measure = \"true\", or \"engineering\" if they are not",
                  table.names()[strain], table.names()[stress]));
}

void check_total_strain(const io::CsvTable& table, std::size_t strain, std::string_view way_out) {
  if (!meaning_in(table, strain).is_plastic) return;
  throw InputError({table.file(), 0}, "strain", table.names()[strain],
                   fmt::format("is plastic strain by its name: a fit needs the total strain, which "
                               "is stress/E more ({})",
                               way_out));
}

void warn_of_named_measure(const TargetSource& source, const io::CsvTable& table,
                           std::size_t strain, std::size_t stress,
                           std::vector<std::string>& warnings) {
  if (!source.may_be_true()) return;
  const bool as_true = source.measure == Measure::True;
  for (const std::size_t column : {strain, stress}) {
    const ColumnMeaning meaning = meaning_in(table, column);
    if (as_true ? !meaning.is_engineering : !meaning.is_true) continue;
    const std::string& name = table.names()[column];
    warnings.push_back(
        as_true ? fmt::format("\"{}\" is engineering by its name, and is taken for true, as the "
                              "measure says; corrections.measure = \"true\" converts engineering "
                              "columns",
                              name)
                : fmt::format("\"{}\" is true by its name, and is taken for engineering: if strain "
                              "and stress are both true, write measure = \"true\" (--measure true)",
                              name));
  }
}

void warn_of_named_test(const TargetSource& source, const io::CsvTable& table, std::size_t strain,
                        std::size_t stress, std::vector<std::string>& warnings) {
  for (const std::size_t column : {strain, stress}) {
    const std::optional<Test> test = meaning_in(table, column).test;
    if (!test || *test == source.test) continue;
    warnings.push_back(
        fmt::format("\"{0}\" is of {1} by its name, and is taken for {2}: if it is of "
                    "{1}, write test = \"{1}\" (--test {1})",
                    table.names()[column], word_of(*test), word_of(source.test)));
    return;  // one says it for both
  }
}

}  // namespace plastica::calibrate
