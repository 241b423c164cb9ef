#include "calibrate/guess/guess_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "calibrate/guess/choose_columns.hpp"
#include "calibrate/guess/column_numbers.hpp"
#include "calibrate/guess/geometry.hpp"
#include "calibrate/guess/specimens.hpp"
#include "calibrate/target/several_specimens.hpp"
#include "plastica/io/units.hpp"

namespace plastica::calibrate {
namespace {

using enum ColumnRole;
using Index = ColumnIndex;

class Guesser {
 public:
  Guesser(const io::CsvTable& table, const TargetSource& given)
      : table_(table),
        given_(given),
        is_nameless_(std::ranges::all_of(table.names(),
                                         [](const std::string& name) { return name.empty(); })) {
    for (std::size_t k = 0; k < table.columns(); ++k) {
      guess_.columns.push_back(meaning_of(table.names()[k], table.units()[k]));
    }
  }

  FileGuess result() {
    if (is_nameless_) take_by_place();
    const Index deformation = given_column(given_.strain, given_.elongation);
    const Index load = given_column(given_.stress, given_.force);
    ChosenColumns chosen = choose_columns(table_, guess_.columns, deformation, load);
    guess_.notes = std::move(chosen.notes);
    for (const auto& [strain, stress] : chosen.pairs) {
      guess_.blocks.push_back(block(strain, stress));
    }
    if (is_nameless_ && !(deformation && load)) {
      add_comment("strain", "the columns have no names: these are guessed from their order");
    }
    tell_specimens();
    return std::move(guess_);
  }

 private:
  Index given_column(const std::optional<ColumnSource>& first,
                     const std::optional<ColumnSource>& second) const {
    const std::optional<ColumnSource>& given = first ? first : second;
    if (!given || given->column.find('*') != std::string::npos) return std::nullopt;
    return table_.find(given->column);
  }

  void take_by_place() {
    std::size_t first = 0;
    if (table_.columns() > 2 && column_numbers(numbers_in(table_, 0)).is_clock) {
      guess_.columns[first++].role = Time;
    }
    for (std::size_t k = first; k < std::min(first + 2, table_.columns()); ++k) {
      guess_.columns[k].role = k == first ? Strain : Stress;
      guess_.columns[k].why = "place";
      if (!table_.units()[k].empty()) continue;
      guess_.columns[k].unit.reset();
    }
  }

  /// The name of a column, or its number where it has none of its own.
  std::string name_of(std::size_t column) const {
    const std::string& name = table_.names()[column];
    const bool is_only = table_.find(name) == column;
    return is_only ? name : std::to_string(column + 1);
  }

  void add_comment(const std::string& key, const std::string& text) {
    for (BlockGuess& block : guess_.blocks) {
      const auto found =
          std::ranges::find(block.comments, key, &std::pair<std::string, std::string>::first);
      if (found == block.comments.end()) {
        block.comments.emplace_back(key, text);
      } else {
        found->second += "; " + text;
      }
    }
  }

  BlockGuess block(Index deformation, Index load) {
    BlockGuess made;
    TargetSource& source = made.source;
    source = given_;
    source.files = {table_.file()};
    const auto comment = [&](const char* key, const std::string& text) {
      made.comments.emplace_back(key, text);
    };
    if (!source.strain && !source.elongation) {
      if (!deformation) {
        made.missing.emplace_back("strain");
      } else {
        take_deformation(*deformation, made);
      }
    }
    if (!source.stress && !source.force) {
      if (!load) {
        made.missing.emplace_back("stress");
      } else {
        take_load(*load, made);
      }
    }
    // One of two alone is told of.
    const bool is_true = deformation && load && guess_.columns[*deformation].is_true &&
                         guess_.columns[*load].is_true;
    if (is_true && !source.measure && source.may_be_true()) source.measure = Measure::True;
    const GivenGeometry geometry = find_geometry(table_);
    const auto value = [&](const char* key, const std::optional<GivenValue>& found,
                           const std::string& doubt, const char* unit,
                           std::optional<SpecimenValue>& into, const char* what) {
      if (into) return;
      if (found) {
        into.emplace();
        into->value = found->si;
        into->unit = unit;
        comment(key, found->from);
        return;
      }
      made.missing.emplace_back(key);
      const std::string& says = doubt.empty() ? geometry.without_unit : doubt;
      comment(key, std::string(what) + ": fill it in" +
                       (says.empty() ? std::string() : "; the file says " + says));
    };
    if (source.elongation) {
      value("gauge_length", geometry.gauge_length, geometry.doubt_of_length, "mm",
            source.gauge_length, "the length that the elongation is of");
    }
    if (source.force) {
      value("area", geometry.area, geometry.doubt_of_area, "mm^2", source.area,
            "the cross-section of the specimen");
    }
    return made;
  }

  ColumnSource column_source(std::size_t k, BlockGuess& made, const char* key,
                             const ColumnNumbers& range) {
    const ColumnMeaning& meaning = guess_.columns[k];
    ColumnSource column{name_of(k), meaning.unit, {}};
    if (range.is_negative) {
      column.factor = -1.0;
      made.comments.emplace_back(key, "negative in the file: turned, to be fitted as tension");
    }
    return column;
  }

  void take_deformation(std::size_t k, BlockGuess& made) {
    const ColumnMeaning& meaning = guess_.columns[k];
    const ColumnNumbers range = column_numbers(numbers_in(table_, k));
    const bool is_strain = meaning.role == Strain;
    const char* key = is_strain ? "strain" : "elongation";
    ColumnSource column = column_source(k, made, key, range);
    const bool may_be_percent = range.largest() > 1.0 || is_nameless_;
    if (!column.unit && (!is_strain || may_be_percent)) {
      made.missing.push_back(std::string(key) + ".unit");
      made.comments.emplace_back(
          key, fmt::format("the file gives no unit; its values reach {:.4g}", range.largest()));
    }
    if (meaning.is_travel) {
      made.comments.emplace_back(key,
                                 "crosshead travel: the machine gives way in it, so that E "
                                 "comes out too small");
    }
    if (meaning.is_weak) made.comments.emplace_back(key, "taken for it by its unit alone");
    (is_strain ? made.source.strain : made.source.elongation) = std::move(column);
  }

  void take_load(std::size_t k, BlockGuess& made) {
    const ColumnMeaning& meaning = guess_.columns[k];
    const ColumnNumbers range = column_numbers(numbers_in(table_, k));
    const bool is_stress = meaning.role == Stress;
    const char* key = is_stress ? "stress" : "force";
    ColumnSource column = column_source(k, made, key, range);
    if (!column.unit) {
      made.missing.push_back(std::string(key) + ".unit");
      made.comments.emplace_back(
          key, fmt::format("the file gives no unit; its values reach {:.4g}", range.largest()));
    }
    (is_stress ? made.source.stress : made.source.force) = std::move(column);
  }

  /// One specimen under the other.
  void tell_specimens() {
    for (BlockGuess& block : guess_.blocks) {
      const Index deformation = given_column(block.source.strain, block.source.elongation);
      const Index load = given_column(block.source.stress, block.source.force);
      if (!deformation || !block.source.split.empty()) continue;
      const std::vector<double> values = numbers_in(table_, *deformation);
      std::vector<std::size_t> taken{*deformation};
      if (load) taken.push_back(*load);
      const FoundSplit split = find_split(table_, values, taken);
      for (const std::size_t k : split.columns) block.source.split.push_back(name_of(k));
      if (!split.columns.empty()) {
        block.comments.emplace_back(
            "split", fmt::format("the rows are {} specimens, told apart by this{}", split.parts,
                                 split.tells_all()
                                     ? std::string()
                                     : fmt::format("; within them the strain begins anew {} more "
                                                   "times: loops, or several of one name",
                                                   split.untold)));
        continue;
      }
      if (load) {
        if (const auto next = find_next_specimen(values, numbers_in(table_, *load))) {
          guess_.notes.push_back(fmt::format(
              "another specimen begins in row {} of the numbers, and no column tells them apart: "
              "give each a file, or a column of its own value",
              *next + 1));
          continue;
        }
      }
      const std::size_t restarts = restarts_of(values).size();
      if (restarts < 2) continue;
      guess_.notes.push_back(
          fmt::format("the strain returns to its start {} times: it is taken for one specimen that "
                      "is unloaded or cycled; no column tells several apart",
                      restarts));
    }
  }

  const io::CsvTable& table_;
  const TargetSource& given_;
  bool is_nameless_;
  FileGuess guess_;
};

}  // namespace

FileGuess guess_file(const io::CsvTable& table, const TargetSource& given) {
  return Guesser(table, given).result();
}

}  // namespace plastica::calibrate
