#include "calibrate/config/bare_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "calibrate/config/check_unit.hpp"
#include "calibrate/config/fixed_parameters.hpp"
#include "calibrate/config/write_target.hpp"
#include "calibrate/guess/guess_file.hpp"
#include "calibrate/target/kept_tables.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/io/csv.hpp"
#include "plastica/io/read_input.hpp"
#include "plastica/io/units.hpp"

namespace plastica::calibrate {
namespace {

using Text = std::optional<std::string>;

/// Splits at the last occurrence of a character; the second part is empty if there is none.
std::pair<std::string, Text> split_last(const std::string& text, char mark) {
  const std::size_t at = text.rfind(mark);
  if (at == std::string::npos) return {text, std::nullopt};
  return {text.substr(0, at), text.substr(at + 1)};
}

std::optional<ColumnSource> column_of(const Text& given, Dimension dimension,
                                      std::string_view option) {
  if (!given) return std::nullopt;
  auto [column, unit] = split_last(*given, ':');
  if (column.empty()) throw InputError({}, option, *given, "must be COLUMN or COLUMN:UNIT");
  if (unit && unit->empty()) unit.reset();
  if (unit) {
    try {
      io::unit_conversion(*unit, dimension);
    } catch (const InputError& error) {
      throw InputError({}, option, *given, "\"" + *unit + "\" " + error.rule());
    }
  }
  ColumnSource source;
  source.column = column;
  source.unit = unit;
  return source;
}

/// "50 mm", or a column of the table, as COLUMN or COLUMN:UNIT.
std::optional<SpecimenValue> specimen_value_of(const Text& given, Dimension dimension,
                                               std::string_view option, bool has_table) {
  if (!given) return std::nullopt;
  SpecimenValue value;
  if (has_table && given->find_first_of("0123456789.") != 0) {
    const auto column = column_of(given, dimension, option);
    value.from = column->column;
    value.unit = column->unit;
    return value;
  }
  value.value = io::parse_quantity(*given, dimension, {}, option);
  if (*value.value <= 0.0) throw InputError({}, option, *given, "must be positive");
  return value;
}

template <typename Enum>
void set_word(const Text& given, std::string_view option,
              std::initializer_list<std::string_view> words, Enum& target) {
  if (!given) return;
  const auto* found = std::find(words.begin(), words.end(), *given);
  if (found == words.end()) {
    throw InputError({}, option, *given,
                     fmt::format("must be one of {}", fmt::join(words.begin(), words.end(), ", ")));
  }
  target = static_cast<Enum>(found - words.begin());
}

void refuse_both(const Text& first, std::string_view first_option, const Text& second,
                 std::string_view second_option) {
  if (!first || !second) return;
  throw InputError({}, second_option, *second, "cannot go with " + std::string(first_option));
}

std::string names_of(const io::CsvTable& table) {
  std::string names;
  for (const std::string& name : table.names()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

/// What a user must not overlook of guesses, and of which files.
struct GuessNote {
  std::string words;
  std::string file;  ///< the first
  std::size_t files = 1;
};

/// Adds a note; one that is known already counts its files.
void add_note(const GuessNote& note, std::vector<GuessNote>& notes) {
  const auto known = std::ranges::find(notes, note.words, &GuessNote::words);
  if (known == notes.end()) {
    notes.push_back(note);
  } else {
    known->files += note.files;
  }
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
void complete(const io::CsvTable& table, TargetSource& source, bool measure_given,
              std::vector<GuessNote>& notes) {
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
    if (!measure_given) source.measure = guess.measure;
  }
  if (!source.stress && !source.force) {
    source.stress = guess.stress;
    source.force = guess.force;
    if (!measure_given) source.measure = guess.measure;
  }
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

}  // namespace

TargetSource source_of(const BareFiles& bare) {
  refuse_both(bare.strain, "--strain", bare.elongation, "--elongation");
  refuse_both(bare.stress, "--stress", bare.force, "--load");
  refuse_both(bare.strain, "--strain", bare.gauge_length, "--gauge-length");
  refuse_both(bare.stress, "--stress", bare.area, "--area");
  TargetSource source;
  set_word(bare.test, "--test", {"tension", "bending", "torsion"}, source.test);
  set_word(bare.measure, "--measure", {"engineering", "true"}, source.measure);
  source.strain = column_of(bare.strain, Dimension::Strain, "--strain");
  source.elongation = column_of(bare.elongation, Dimension::Length, "--elongation");
  source.stress = column_of(bare.stress, Dimension::Stress, "--stress");
  source.force = column_of(bare.force, Dimension::Force, "--load");
  for (auto* column : {&source.strain, &source.elongation, &source.stress, &source.force}) {
    if (*column) (*column)->override_unit = bare.override_unit && (*column)->unit;
  }
  if (bare.decimal) {
    std::size_t mark = 0;
    set_word(bare.decimal, "--decimal", {".", ","}, mark);
    source.csv.decimal = ".,"[mark];
  }
  source.csv.sheet = bare.sheet;
  const bool has_table = bare.table.has_value();
  source.gauge_length =
      specimen_value_of(bare.gauge_length, Dimension::Length, "--gauge-length", has_table);
  source.area = specimen_value_of(bare.area, Dimension::Area, "--area", has_table);
  if (has_table) {
    const auto [file, key] = split_last(*bare.table, ':');
    if (file.empty() || !key || key->empty()) {
      throw InputError({}, "--table", *bare.table, "must be FILE:KEY, the key being a column");
    }
    source.table.emplace();
    source.table->file = file;
    source.table->key = *key;
  }
  if (!bare.group.empty() && !has_table) {
    throw InputError({}, "--group", bare.group.front(), "needs --table, which has this column");
  }
  source.group = bare.group;
  return source;
}

namespace {

/// What a file is taken for, or why not.
struct GuessedFile {
  TargetSource source;
  std::vector<GuessNote> notes;
  std::optional<InputError> unreadable;  ///< its import rejects it
  std::optional<InputError> wrong;       ///< no fit can begin
};

GuessedFile guess_bare_file(const std::string& file, const TargetSource& given, bool measure_given,
                            KeptTables& kept) {
  GuessedFile guessed{given, {}, {}, {}};
  std::optional<io::CsvTable> table;
  try {
    // The fit file that is stored with the results must be UTF-8.
    if (!io::is_utf8(file)) {
      throw InputError({file, 0}, "", "", "has a name that is not UTF-8 text; rename it");
    }
    try {
      table.emplace(io::CsvTable::read(file, given.csv));
    } catch (const InputError& error) {
      if (!io::is_file(file)) throw;
      guessed.unreadable = error;
      return guessed;
    }
    complete(*table, guessed.source, measure_given, guessed.notes);
    kept.keep(given.csv, std::move(*table));
  } catch (const InputError& error) {
    guessed.wrong = error;
  }
  return guessed;
}

}  // namespace

FitFile fit_of_bare_files(const BareFiles& bare, int threads) {
  if (bare.files.empty()) throw InputError({}, "FILE", "", "give at least one file");
  const TargetSource given = source_of(bare);
  std::string text = parameters_text(bare.fixed);
  // Blocks by what they say, in the order of their first files.
  std::vector<std::pair<std::string, TargetSource>> blocks;
  std::vector<std::string> unreadable;
  std::vector<GuessNote> notes;
  std::optional<InputError> first_error;
  std::vector<GuessedFile> guessed(bare.files.size());
  const auto kept = std::make_shared<KeptTables>();
  parallel_for(guessed.size(), {threads, nullptr}, [&](std::size_t i, int) {
    guessed[i] = guess_bare_file(bare.files[i], given, bare.measure.has_value(), *kept);
  });
  for (std::size_t i = 0; i < guessed.size(); ++i) {
    const std::string& file = bare.files[i];
    if (guessed[i].wrong) throw InputError(*guessed[i].wrong);
    if (guessed[i].unreadable) {
      if (!first_error) first_error = guessed[i].unreadable;
      unreadable.push_back(file);
      continue;
    }
    for (const GuessNote& note : guessed[i].notes) add_note(note, notes);
    TargetSource source = std::move(guessed[i].source);
    const std::string columns = target_text(source);
    auto block = std::find_if(blocks.begin(), blocks.end(),
                              [&](const auto& other) { return other.first == columns; });
    if (block == blocks.end()) block = blocks.emplace(blocks.end(), columns, std::move(source));
    block->second.files.push_back(file);
  }
  if (blocks.empty()) throw InputError(*first_error);
  // Their import rejects them, with the reason, and no specimen beside them.
  for (std::string& file : unreadable) blocks.front().second.files.push_back(std::move(file));
  for (const auto& [columns, source] : blocks) text += "\n" + target_text(source);
  if (!io::is_utf8(text)) {
    throw InputError({}, "", "", "an option is not UTF-8 text");
  }
  try {
    FitFile file = parse_fit_file(std::move(text), "");
    for (TargetBlock& block : file.targets) block.source.kept = kept;
    for (const GuessNote& note : notes) {
      file.notes.push_back(note.file + ": " + note.words);
      if (note.files > 1) file.notes.back() += fmt::format(" ({} files)", note.files);
    }
    return file;
  } catch (const InputError& error) {
    // Lines of a text that the user has not written would only confuse.
    throw InputError({}, error.field(), error.value(), error.rule());
  }
}

}  // namespace plastica::calibrate
