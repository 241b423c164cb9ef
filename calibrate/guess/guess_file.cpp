#include "calibrate/guess/guess_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include "calibrate/guess/geometry.hpp"
#include "calibrate/guess/specimens.hpp"
#include "plastica/io/units.hpp"

namespace plastica::calibrate {
namespace {

using enum ColumnRole;
using Index = std::optional<std::size_t>;

struct Range {
  double first = 0.0, low = 0.0, high = 0.0;
  double largest() const { return std::max(-low, high); }
  bool is_negative() const { return -low > 2.0 * std::max(high, 0.0) && low < 0.0; }
};

/// The numbers of a column, NaN where a cell has none or is a word.
std::vector<double> numbers_in(const io::CsvTable& table, std::size_t column) {
  std::vector<double> values(table.rows(), std::numeric_limits<double>::quiet_NaN());
  try {
    values = table.numbers(column);
  } catch (const InputError&) {
    values.assign(table.rows(), std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

Range range_of(const std::vector<double>& values) {
  Range range;
  bool any = false;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (!any) range.first = value;
    any = true;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  return range;
}

/// Whether numbers rise by equal steps, as time does.
bool is_clock(const std::vector<double>& values) {
  if (values.size() < 5) return false;
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (!(std::abs(values[i] - values[i - 1] - step) <= 1e-3 * std::abs(step))) return false;
  }
  return step > 0.0;
}

/// A name without its numbers: "Strain 2" and "Strain 1" are alike.
std::string without_numbers(std::string_view name) {
  std::string bare;
  for (const char c : lower_name(name)) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0 && c != ' ' && c != '.' && c != '_')
      bare += c;
  }
  return bare;
}

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
    const bool nameless =
        std::ranges::all_of(table_.names(), [](const std::string& name) { return name.empty(); });
    if (nameless) take_by_place();
    for (const auto& [strain, stress] : pairs()) guess_.blocks.push_back(block(strain, stress));
    if (is_nameless_) {
      add_comment("strain", "the columns have no names: these are guessed from their order");
    }
    tell_specimens();
    return std::move(guess_);
  }

 private:
  /// Columns of a role, true measures last; of travel those first that begin near zero.
  std::vector<std::size_t> columns_of(ColumnRole role) const {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < guess_.columns.size(); ++k) {
      if (guess_.columns[k].role == role) found.push_back(k);
    }
    const auto rank = [&](std::size_t k) {
      const ColumnMeaning& column = guess_.columns[k];
      bool is_far = false;
      if (role == Travel) {
        const Range range = range_of(numbers_in(table_, k));
        is_far = std::abs(range.first) > 0.1 * range.largest();
      }
      return 8 * column.is_weak + 4 * column.is_true + 2 * column.is_travel + (is_far ? 1 : 0);
    };
    std::ranges::stable_sort(found, {}, rank);
    return found;
  }

  /// The best column of one of two or three roles, best first.
  Index best_of(std::initializer_list<ColumnRole> roles) {
    for (const bool weak : {false, true}) {
      for (const ColumnRole role : roles) {
        const std::vector<std::size_t> found = columns_of(role);
        if (found.empty() || guess_.columns[found.front()].is_weak != weak) continue;
        return found.front();
      }
    }
    return std::nullopt;
  }

  /// Deformation and load of each specimen.
  std::vector<std::pair<Index, Index>> pairs() {
    const Index strain = given_column(given_.strain, given_.elongation);
    const Index stress = given_column(given_.stress, given_.force);
    Index deformation = strain ? strain : best_of({Strain, Elongation, Travel});
    Index load = stress ? stress : best_of({Stress, Force});
    const std::vector<std::size_t> deformations =
        strain ? std::vector<std::size_t>{} : alike(deformation);
    const std::vector<std::size_t> loads = stress ? std::vector<std::size_t>{} : alike(load);
    if (deformations.size() > 1 && deformations.size() == loads.size() &&
        alternate(deformations, loads)) {
      std::vector<std::pair<Index, Index>> all;
      for (std::size_t i = 0; i < loads.size(); ++i) all.emplace_back(deformations[i], loads[i]);
      return all;
    }
    tell_others(deformation, deformations, "strain");
    tell_others(load, loads, "stress");
    return {{deformation, load}};
  }

  Index given_column(const std::optional<ColumnSource>& first,
                     const std::optional<ColumnSource>& second) const {
    const std::optional<ColumnSource>& given = first ? first : second;
    if (!given || given->column.find('*') != std::string::npos) return std::nullopt;
    return table_.find(given->column);
  }

  /// Columns of the same role and name, but for numbers, as a chosen one; in their order.
  std::vector<std::size_t> alike(Index chosen) const {
    std::vector<std::size_t> found;
    if (!chosen) return found;
    const ColumnMeaning& meaning = guess_.columns[*chosen];
    const std::string name = without_numbers(table_.names()[*chosen]);
    for (std::size_t k = 0; k < guess_.columns.size(); ++k) {
      const ColumnMeaning& other = guess_.columns[k];
      if (other.role != meaning.role || other.is_true != meaning.is_true) continue;
      if (without_numbers(table_.names()[k]) == name) found.push_back(k);
    }
    return found;
  }

  static bool alternate(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if ((a[i] < b[i]) != (a[0] < b[0])) return false;
      if (i > 0 && std::min(a[i], b[i]) < std::max(a[i - 1], b[i - 1])) return false;
    }
    return true;
  }

  void tell_others(Index chosen, const std::vector<std::size_t>& others, std::string_view what) {
    std::string list;
    for (const std::size_t k : others) {
      if (k != *chosen)
        list +=
            fmt::format("{}\"{}\" (no. {})", list.empty() ? "" : ", ", table_.names()[k], k + 1);
    }
    if (list.empty()) return;
    guess_.notes.push_back(fmt::format("the {} is column {}, \"{}\"; it may be {} as well", what,
                                       *chosen + 1, table_.names()[*chosen], list));
  }

  void take_by_place() {
    std::size_t first = 0;
    if (table_.columns() > 2 && is_clock(numbers_in(table_, 0))) {
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

  ColumnSource column_source(std::size_t k, BlockGuess& made, const char* key, const Range& range) {
    const ColumnMeaning& meaning = guess_.columns[k];
    ColumnSource column{name_of(k), meaning.unit, {}};
    if (range.is_negative()) {
      column.factor = -1.0;
      made.comments.emplace_back(key, "negative in the file: turned, to be fitted as tension");
    }
    return column;
  }

  void take_deformation(std::size_t k, BlockGuess& made) {
    const ColumnMeaning& meaning = guess_.columns[k];
    const Range range = range_of(numbers_in(table_, k));
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
    if (meaning.is_true) made.source.measure = Measure::True;
  }

  void take_load(std::size_t k, BlockGuess& made) {
    const ColumnMeaning& meaning = guess_.columns[k];
    const Range range = range_of(numbers_in(table_, k));
    const bool is_stress = meaning.role == Stress;
    const char* key = is_stress ? "stress" : "force";
    ColumnSource column = column_source(k, made, key, range);
    if (!column.unit) {
      made.missing.push_back(std::string(key) + ".unit");
      made.comments.emplace_back(
          key, fmt::format("the file gives no unit; its values reach {:.4g}", range.largest()));
    }
    (is_stress ? made.source.stress : made.source.force) = std::move(column);
    if (meaning.is_true) made.source.measure = Measure::True;
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
      const std::vector<std::size_t> split = find_split(table_, values, taken);
      for (const std::size_t k : split) block.source.split.push_back(name_of(k));
      if (!split.empty()) {
        block.comments.emplace_back("split", "the rows are several specimens, told apart by this");
        continue;
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
