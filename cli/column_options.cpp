#include <CLI/CLI.hpp>

#include "cli/column_options.hpp"

namespace plastica::cli {

void add_column_options(CLI::App& sub, calibrate::BareFiles& bare, const char* group) {
  const auto add = [&](const char* name, auto& value, const char* takes, const char* text) {
    sub.add_option(name, value, text)->option_text(takes)->group(group);
  };
  add("--strain", bare.strain, "COLUMN[:UNIT]", "Take strains from a column, by name or number");
  add("--elongation", bare.elongation, "COLUMN[:UNIT]",
      "Take elongations from a column, with --gauge-length");
  add("--gauge-length", bare.gauge_length, "LENGTH",
      "\"50 mm\", or a column of --table or an attribute of HDF5");
  add("--stress", bare.stress, "COLUMN[:UNIT]", "Take stresses from a column, by name or number");
  add("--load", bare.force, "COLUMN[:UNIT]", "Take forces from a column, with --area");
  add("--area", bare.area, "AREA", "\"120 mm^2\", or a column of --table or an attribute of HDF5");
  add("--sheet", bare.sheet, "NAME", "Read this sheet of a workbook (.xlsx)");
  add("--path", bare.path, "PATTERN", "Read these tables of an HDF5 file: \"batch 1/*\"; else all");
  add("--decimal", bare.decimal, "MARK", "\".\" or \",\", where the numbers do not show it");
  sub.add_flag("--override-unit", bare.override_unit,
               "Let a UNIT go before another one that the file says")
      ->group(group);
}

}  // namespace plastica::cli
