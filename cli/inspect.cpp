#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "calibrate/config/write_target.hpp"
#include "calibrate/target/import.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/tell.hpp"
#include "plastica/io/csv.hpp"

namespace plastica::cli {
namespace {

std::string_view name_of_separator(char separator) {
  switch (separator) {
    case ',': return "comma";
    case ';': return "semicolon";
    case '\t': return "tab";
    case ' ': return "blanks";
    default: return "other";
  }
}

void print_columns(const io::CsvTable& table) {
  constexpr std::size_t kShownColumns = 20;
  say("  {:<4} {:<28} {:<8} {:<16} {:<16}\n", "no.", "column", "unit", "first", "last");
  for (std::size_t c = 0; c < table.columns() && c < kShownColumns; ++c) {
    say("  {:<4} {:<28} {:<8} {:<16} {:<16}\n", c + 1, table.names()[c], table.units()[c],
        table.cell(0, c), table.cell(table.rows() - 1, c));
  }
  if (table.columns() > kShownColumns) say("  … {} columns in all\n", table.columns());
}

/// What an import by the guessed columns would repair and correct.
void print_specimens(const calibrate::TargetSource& source) {
  for (const calibrate::Target& target : calibrate::import_targets(source)) {
    say("\n{}: {} of {} samples, {}\n", target.name, target.corrected.size(), target.raw.size(),
        target.status == calibrate::TargetStatus::Ready ? "ready to fit" : target.reason);
    for (const auto& repair : target.repairs) say("  repair      {}\n", repair.text);
    for (const auto& correction : target.corrections) {
      say("  correction  {}: {}{}\n", correction.kind, correction.applied ? "" : "no, ",
          correction.text);
    }
    for (const auto& warning : target.warnings) say("  warning     {}\n", warning);
  }
}

void inspect_file(const std::string& path) {
  const io::CsvTable table = io::CsvTable::read(path);
  say("{}: {} rows, {} columns, separated by {}, decimal {}\n", path, table.rows(), table.columns(),
      name_of_separator(table.separator()), table.decimal() == ',' ? "comma" : "point");
  for (const std::string& line : table.preamble()) say("  metadata: {}\n", line);
  print_columns(table);

  calibrate::TargetSource source = calibrate::guess_source(table);
  source.files = {path};
  const bool strain = source.strain || (source.elongation && source.gauge_length);
  const bool stress = source.stress || (source.force && source.area);
  if (strain && stress) {
    print_specimens(source);
    say("\nto paste into a fit file:\n\n");
  } else {
    say("\nto paste into a fit file; say what is missing (strain, or elongation and "
        "gauge_length; stress, or force and area):\n\n");
  }
  say("{}", calibrate::target_text(source));
}

}  // namespace

void add_inspect(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand(
      "inspect", "Show columns, units and repairs of measured files, and the block to paste");
  auto files = std::make_shared<std::vector<std::string>>();
  sub->add_option("files", *files, "CSV files of curves")->required()->option_text("FILE.csv...");
  sub->footer("Example:\n  plastica inspect specimen.csv");
  sub->callback([&action, files] {
    action = [files] {
      for (std::size_t i = 0; i < files->size(); ++i) {
        if (i > 0) say("\n");
        inspect_file((*files)[i]);
      }
      return static_cast<int>(kDone);
    };
  });
}

}  // namespace plastica::cli
