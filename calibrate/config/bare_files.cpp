#include "calibrate/config/bare_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "calibrate/config/fixed_parameters.hpp"
#include "calibrate/config/guess_bare_file.hpp"
#include "calibrate/config/write_target.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/io/content_digest.hpp"
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

/// "50 mm", or a column of the table or an attribute of an HDF5 file, as COLUMN or COLUMN:UNIT.
std::optional<SpecimenValue> specimen_value_of(const Text& given, Dimension dimension,
                                               std::string_view option, bool has_values) {
  if (!given) return std::nullopt;
  SpecimenValue value;
  if (has_values && given->find_first_of("0123456789.") != 0) {
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

}  // namespace

TargetSource source_of(const BareFiles& bare) {
  refuse_both(bare.strain, "--strain", bare.elongation, "--elongation");
  refuse_both(bare.stress, "--stress", bare.force, "--load");
  refuse_both(bare.strain, "--strain", bare.gauge_length, "--gauge-length");
  refuse_both(bare.stress, "--stress", bare.area, "--area");
  TargetSource source;
  set_word(bare.test, "--test", {"tension", "bending", "torsion"}, source.test);
  if (bare.measure) {
    set_word(bare.measure, "--measure", {"engineering", "true"}, source.measure.emplace());
  }
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
  source.csv.path = bare.path;
  const bool has_table = bare.table.has_value();
  // An HDF5 file has attributes.
  const bool has_values = has_table || std::ranges::any_of(bare.files, io::begins_as_result);
  source.gauge_length =
      specimen_value_of(bare.gauge_length, Dimension::Length, "--gauge-length", has_values);
  source.area = specimen_value_of(bare.area, Dimension::Area, "--area", has_values);
  if (has_table) {
    const auto [file, key] = split_last(*bare.table, ':');
    if (file.empty() || !key || key->empty()) {
      throw InputError({}, "--table", *bare.table, "must be FILE:KEY, the key being a column");
    }
    source.table.emplace();
    source.table->file = file;
    source.table->key = *key;
  }
  if (!bare.group.empty() && !has_values) {
    throw InputError({}, "--group", bare.group.front(),
                     "needs --table, which has this column, or HDF5 files with attributes");
  }
  source.group = bare.group;
  return source;
}

FitFile fit_of_bare_files(const BareFiles& bare, int threads) {
  if (bare.files.empty()) throw InputError({}, "FILE", "", "give at least one file");
  const TargetSource given = source_of(bare);
  std::string text = bare.says.empty() ? parameters_text(bare.fixed) : bare.says;
  // Blocks by what they say, in the order of their first files.
  std::vector<std::pair<std::string, TargetSource>> blocks;
  std::vector<std::string> unreadable;
  std::vector<GuessNote> notes;
  std::optional<InputError> first_error;
  std::vector<GuessedFile> guessed(bare.files.size());
  const auto kept = std::make_shared<KeptTables>();
  parallel_for(guessed.size(), {threads, nullptr}, [&](std::size_t i, int) {
    guessed[i] = guess_bare_file(bare.files[i], given, *kept);
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
