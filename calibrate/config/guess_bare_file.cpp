#include "calibrate/config/guess_bare_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "calibrate/config/check_unit.hpp"
#include "calibrate/config/write_target.hpp"
#include "calibrate/guess/guess_file.hpp"
#include "plastica/io/csv.hpp"
#include "plastica/io/hdf5_tables.hpp"
#include "plastica/io/read_input.hpp"

namespace plastica::calibrate {
namespace {

std::string names_of(const io::CsvTable& table) {
  std::string names;
  for (const std::string& name : table.names()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

void add_notes(const std::string& file, const FileGuess& guess, std::vector<GuessNote>& notes) {
  std::vector<std::string> all = guess.notes;
  for (const auto& [key, words] : guess.blocks.front().comments) {
    const bool is_unknown =
        std::ranges::find(guess.blocks.front().missing, key) != guess.blocks.front().missing.end();
    if (!is_unknown) all.push_back(fmt::format("{}: {}", key, words));
  }
  for (const std::string& words : all) add_note({words, file}, notes);
}

/// Completes what the options say by what the columns of a file are called.
void complete(const io::CsvTable& table, TargetSource& source, std::vector<GuessNote>& notes) {
  const bool gauge_length_given = source.gauge_length.has_value();
  const bool area_given = source.area.has_value();
  const FileGuess all = guess_file(table, source);
  if (all.blocks.size() > 1) {
    throw InputError({table.file(), 0}, "", "",
                     fmt::format("holds {} specimens side by side: put the blocks that `plastica "
                                 "inspect` prints into a fit file",
                                 all.blocks.size()));
  }
  add_notes(table.file(), all, notes);
  const TargetSource& guess = all.blocks.front().source;
  if (source.split.empty()) source.split = guess.split;
  const auto missing = [&](std::string_view option, std::string_view what) {
    return InputError({table.file(), 0}, option, "",
                      fmt::format("no column is known for the {}; it has {}: give {}", what,
                                  names_of(table), option));
  };
  if (!source.strain && !source.elongation) {
    source.strain = guess.strain;
    source.elongation = guess.elongation;
  }
  if (!source.stress && !source.force) {
    source.stress = guess.stress;
    source.force = guess.force;
  }
  source.measure = guess.measure;
  // What the header lines of the file say of the specimen.
  if (!source.gauge_length) source.gauge_length = guess.gauge_length;
  if (!source.area) source.area = guess.area;
  if (!source.strain && !source.elongation) throw missing("--strain", "strain");
  if (!source.stress && !source.force) throw missing("--stress", "stress");
  if (source.strain) check_unit(table, *source.strain, Dimension::Strain, "--strain");
  if (source.stress) check_unit(table, *source.stress, Dimension::Stress, "--stress");
  const auto need = [&](const auto& column, const auto& value, Dimension dimension,
                        std::string_view option, std::string_view other, std::string_view of) {
    if (!column) return;
    check_unit(table, *column, dimension, option);
    if (value) return;
    throw InputError(
        {table.file(), 0}, other, "",
        fmt::format("is missing: by it the column \"{}\", {}, becomes a {}", column->column,
                    dimension == Dimension::Force ? "a load" : "a length", of));
  };
  need(source.elongation, source.gauge_length, Dimension::Length, "--elongation", "--gauge-length",
       "strain");
  need(source.force, source.area, Dimension::Force, "--load", "--area", "stress");
  const auto is_of_no_use = [&](bool given, std::string_view option, std::string_view what,
                                const auto& column, std::string_view instead) {
    if (!given) return;
    add_note({fmt::format("{} is of no use: the {} is read from \"{}\"; {} names the column that "
                          "it divides",
                          option, what, column->column, instead),
              table.file()},
             notes);
  };
  if (!source.elongation) {
    is_of_no_use(gauge_length_given, "--gauge-length", "strain", source.strain, "--elongation");
  }
  if (!source.force) is_of_no_use(area_given, "--area", "stress", source.stress, "--load");
  // Of use to other files only.
  if (!source.elongation) source.gauge_length.reset();
  if (!source.force) source.area.reset();
}

/// What the tables of an HDF5 file are taken for: all alike, since one block reads them. Those that
/// are no curves, their import rejects.
/// @throws InputError if they are not alike, or none is a curve
GuessedFile guess_tables(const io::Hdf5Tables& tables, const TargetSource& given) {
  std::optional<GuessedFile> all;
  std::string first;
  std::optional<InputError> why_none;
  for (const std::string& path : tables.matching(given.csv.path)) {
    GuessedFile one{given, {}, {}, {}};
    try {
      complete(io::CsvTable::read(tables, path), one.source, one.notes);
    } catch (const InputError& error) {
      if (!why_none) why_none = error;
      continue;
    }
    if (!all) {
      all = std::move(one);
      first = path;
    } else if (target_text(one.source) != target_text(all->source)) {
      throw InputError({tables.file(), 0}, "path", "",
                       fmt::format("is needed: the tables {} and {} have unlike columns, so that "
                                   "each kind needs a block of its own in a fit file",
                                   first, path));
    }
  }
  if (!all) throw InputError(*why_none);
  return *all;
}

}  // namespace

void add_note(const GuessNote& note, std::vector<GuessNote>& notes) {
  const auto known = std::ranges::find(notes, note.words, &GuessNote::words);
  if (known == notes.end()) {
    notes.push_back(note);
  } else {
    known->files += note.files;
  }
}

GuessedFile guess_bare_file(const std::string& file, const TargetSource& given, KeptTables& kept) {
  GuessedFile guessed{given, {}, {}, {}};
  std::optional<io::CsvTable> table;
  try {
    // The fit file that is stored with the results must be UTF-8.
    if (!io::is_utf8(file)) {
      throw InputError({file, 0}, "", "", "has a name that is not UTF-8 text; rename it");
    }
    if (io::hdf5_origin(file) == io::Hdf5Origin::Others && !given.csv.sheet) {
      return guess_tables(io::Hdf5Tables(file), given);
    }
    try {
      table.emplace(io::CsvTable::read(file, given.csv));
    } catch (const InputError& error) {
      if (!io::is_file(file)) throw;
      guessed.unreadable = error;
      return guessed;
    }
    complete(*table, guessed.source, guessed.notes);
    kept.keep(given.csv, std::move(*table));
  } catch (const InputError& error) {
    guessed.wrong = error;
  }
  return guessed;
}

}  // namespace plastica::calibrate
