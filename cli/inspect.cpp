#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "calibrate/config/bare_files.hpp"
#include "calibrate/config/write_target.hpp"
#include "calibrate/guess/guess_file.hpp"
#include "calibrate/target/import.hpp"
#include "cli/column_options.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/input_kind.hpp"
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

/// A cell in at most ten characters, if it is a number.
std::string shown_cell(const io::CsvTable& table, std::size_t row, std::size_t column) {
  try {
    const double value = table.number(row, column);
    return std::isnan(value) ? std::string() : fmt::format("{:.5g}", value);
  } catch (const InputError&) {
    constexpr std::size_t kMost = 10;
    const std::string cell = table.cell(row, column);
    return cell.size() <= kMost ? cell : "(text)";
  }
}

void print_columns(const io::CsvTable& table, const calibrate::FileGuess& guess) {
  constexpr std::size_t kShownColumns = 20;
  say("  {:<3} {:<26} {:<6} {:<9} {:<9} {}\n", "no.", "column", "unit", "first", "last",
      "taken for (by its)");
  for (std::size_t c = 0; c < table.columns() && c < kShownColumns; ++c) {
    const calibrate::ColumnMeaning& meaning = guess.columns[c];
    std::string taken(calibrate::words_of(meaning.role));
    if (meaning.is_true) taken.insert(0, "true ");
    if (!meaning.why.empty()) taken += fmt::format(" ({})", meaning.why);
    say("  {:<3} {:<26} {:<6} {:<9} {:<9} {}\n", c + 1, table.names()[c], table.units()[c],
        shown_cell(table, 0, c), shown_cell(table, table.rows() - 1, c), taken);
  }
  if (table.columns() > kShownColumns) say("  … {} columns in all\n", table.columns());
}

/// What an import by the guessed columns would repair and correct.
void print_specimens(const calibrate::TargetSource& source) {
  constexpr std::size_t kMostSpecimens = 20;
  const std::vector<calibrate::Target> targets = calibrate::import_targets(source);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (i == kMostSpecimens) {
      say("\n… {} specimens in all\n", targets.size());
      break;
    }
    const calibrate::Target& target = targets[i];
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

std::string layout_of(const io::CsvTable& table) {
  if (!table.sheet().empty()) return fmt::format("of the sheet {}", table.sheet());
  if (!table.path().empty()) return fmt::format("of its table {}", table.path());
  return fmt::format("separated by {}", name_of_separator(table.separator()));
}

void inspect_file(const std::string& path, const calibrate::TargetSource& given) {
  expect_input(path, {InputKind::Curves});
  const io::CsvTable table = io::first_table(path, given.csv);
  const std::string layout = layout_of(table);
  say("{}: {} rows, {} columns, {}, decimal {}\n", path, table.rows(), table.columns(), layout,
      table.decimal() == ',' ? "comma" : "point");
  for (const std::string& line : table.preamble()) say("  metadata: {}\n", line);
  const calibrate::FileGuess guess = calibrate::guess_file(table, given);
  print_columns(table, guess);
  for (const std::string& note : guess.notes) say("  note: {}\n", note);
  bool is_complete = true;
  for (const calibrate::BlockGuess& block : guess.blocks) {
    is_complete = is_complete && block.missing.empty();
    if (block.missing.empty()) print_specimens(block.source);
  }
  say("\nto paste into a fit file{}:\n",
      is_complete ? "" : "; put what only you know in place of each \"?\"");
  for (const calibrate::BlockGuess& block : guess.blocks) {
    say("\n{}", calibrate::target_text(block));
  }
}

}  // namespace

void add_inspect(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand(
      "inspect", "Show columns, units and repairs of measured files, and the block to paste");
  auto bare = std::make_shared<calibrate::BareFiles>();
  sub->add_option("files", bare->files, "Files of curves: CSV, workbooks (.xlsx), HDF5")
      ->required()
      ->option_text("FILE.csv...");
  add_column_options(*sub, *bare, "Columns, in place of those that are guessed");
  sub->footer(
      "Examples:\n"
      "  plastica inspect specimen.csv\n"
      "  plastica inspect specimen.csv --strain Strain:% --load 3:kN --area \"120 mm^2\"");
  sub->callback([&action, bare] {
    action = [bare] {
      const calibrate::TargetSource given = calibrate::source_of(*bare);
      for (std::size_t i = 0; i < bare->files.size(); ++i) {
        if (i > 0) say("\n");
        inspect_file(bare->files[i], given);
      }
      return static_cast<int>(kDone);
    };
  });
}

}  // namespace plastica::cli
