#include "calibrate/guess/choose_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <set>
#include <string_view>
#include <tuple>

namespace plastica::calibrate {
namespace {

using enum ColumnRole;
using Indices = std::vector<std::size_t>;

/// A name without its numbers: "Strain 2" and "Strain 1" are alike.
std::string without_numbers(std::string_view name) {
  std::string bare;
  for (const char c : lower_name(name)) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0 && c != ' ' && c != '.' && c != '_')
      bare += c;
  }
  return bare;
}

std::set<std::string> words_in(std::string_view name) {
  std::set<std::string> words;
  std::string word;
  for (const char c : lower_name(name) + " ") {
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x80 || std::isalnum(code) != 0) {
      word += c;
    } else if (!word.empty()) {
      words.insert(std::move(word));
      word.clear();
    }
  }
  return words;
}

/// Of each name the words that not all of them have: "a" and "b" of "Strain A" and "Strain B".
std::vector<std::string> own_words(const std::vector<std::string>& names) {
  std::vector<std::set<std::string>> all;
  all.reserve(names.size());
  for (const std::string& name : names) all.push_back(words_in(name));
  std::vector<std::string> own;
  for (const std::set<std::string>& words : all) {
    std::string text;
    for (const std::string& word : words) {
      const bool is_common =
          std::ranges::all_of(all, [&](const auto& other) { return other.contains(word); });
      if (!is_common) text += word + " ";
    }
    own.push_back(std::move(text));
  }
  return own;
}

/// Whether columns stand in pairs, one of each list after the other.
bool alternate(const Indices& a, const Indices& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if ((a[i] < b[i]) != (a[0] < b[0])) return false;
    if (i > 0 && std::min(a[i], b[i]) < std::max(a[i - 1], b[i - 1])) return false;
  }
  return true;
}

class Chooser {
 public:
  Chooser(const io::CsvTable& table, const std::vector<ColumnMeaning>& columns)
      : table_(table), columns_(columns), numbers_(columns.size()) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k].role == Other || columns[k].role == Geometry) continue;
      numbers_[k] = column_numbers(numbers_in(table, k));
    }
  }

  ChosenColumns choose(ColumnIndex deformation, ColumnIndex load) {
    const bool chooses_deformation = !deformation;
    const bool chooses_load = !load;
    if (chooses_load) load = best_of({Stress, Force}, false, false);
    const bool is_turned = load && numbers_[*load].is_negative;
    if (chooses_deformation) deformation = best_of({Strain, Elongation, Travel}, is_turned, false);
    const bool is_true = deformation && columns_[*deformation].is_true;
    if (chooses_load) load = best_of({Stress, Force}, is_turned, is_true);
    ChosenColumns chosen;
    if (chooses_deformation && chooses_load && deformation && load) {
      chosen.pairs = side_by_side(*deformation, *load);
      if (!chosen.pairs.empty()) return chosen;
    }
    chosen.pairs = {{deformation, load}};
    if (chooses_deformation) tell_others(deformation, "strain", chosen.notes);
    if (chooses_load) tell_others(load, "stress", chosen.notes);
    if (deformation && load) tell_mismatch(*deformation, *load, chosen.notes);
    return chosen;
  }

 private:
  /// The best column of some roles, which are in the order of their worth.
  ColumnIndex best_of(std::initializer_list<ColumnRole> roles, bool is_negative,
                      bool is_true) const {
    ColumnIndex best;
    const auto rank = [&](std::size_t k) {
      const ColumnMeaning& column = columns_[k];
      const ColumnNumbers& numbers = numbers_[k];
      // Travel is counted from anywhere.
      const bool is_far =
          column.role == Travel && std::abs(numbers.first) > 0.1 * numbers.largest();
      return std::tuple(numbers.is_constant, column.is_lesser, column.is_weak,
                        std::ranges::find(roles, column.role) - roles.begin(),
                        numbers.is_negative != is_negative, column.is_true != is_true,
                        column.is_travel, is_far);
    };
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (std::ranges::find(roles, columns_[k].role) == roles.end()) continue;
      if (!best || rank(k) < rank(*best)) best = k;
    }
    return best;
  }

  /// Columns that vary, of the same role, unit and measure as a chosen one, which is among them.
  Indices like(std::size_t chosen, bool with_unit) const {
    Indices found;
    const ColumnMeaning& meaning = columns_[chosen];
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const ColumnMeaning& other = columns_[k];
      if (other.role != meaning.role || other.is_true != meaning.is_true) continue;
      if (with_unit && (other.unit != meaning.unit || other.is_lesser)) continue;
      if (k == chosen || !numbers_[k].is_constant) found.push_back(k);
    }
    return found;
  }

  std::vector<std::string> names_of(const Indices& columns) const {
    std::vector<std::string> names;
    for (const std::size_t k : columns) names.push_back(table_.names()[k]);
    return names;
  }

  /// Pairs that their names, but for a number, or the words that tell them apart, hold together.
  std::vector<std::pair<ColumnIndex, ColumnIndex>> side_by_side(std::size_t deformation,
                                                                std::size_t load) const {
    const auto alike = [&](std::size_t chosen) {
      Indices found = like(chosen, false);
      const std::string name = without_numbers(table_.names()[chosen]);
      std::erase_if(found,
                    [&](std::size_t k) { return without_numbers(table_.names()[k]) != name; });
      return found;
    };
    Indices deformations = alike(deformation);
    Indices loads = alike(load);
    const auto are_pairs = [&] {
      return deformations.size() > 1 && deformations.size() == loads.size() &&
             alternate(deformations, loads);
    };
    if (!are_pairs()) {
      deformations = like(deformation, true);
      loads = like(load, true);
      if (!are_pairs() || own_words(names_of(deformations)) != own_words(names_of(loads))) {
        return {};
      }
    }
    std::vector<std::pair<ColumnIndex, ColumnIndex>> pairs;
    for (std::size_t i = 0; i < loads.size(); ++i) pairs.emplace_back(deformations[i], loads[i]);
    return pairs;
  }

  void tell_others(ColumnIndex chosen, std::string_view what,
                   std::vector<std::string>& notes) const {
    if (!chosen) return;
    std::string list;
    for (const std::size_t k : like(*chosen, false)) {
      if (k == *chosen) continue;
      list += fmt::format("{}\"{}\" (no. {})", list.empty() ? "" : ", ", table_.names()[k], k + 1);
    }
    if (list.empty()) return;
    notes.push_back(fmt::format("the {} is column {}, \"{}\"; it may be {} as well", what,
                                *chosen + 1, table_.names()[*chosen], list));
  }

  void tell_mismatch(std::size_t deformation, std::size_t load,
                     std::vector<std::string>& notes) const {
    const std::string pair =
        fmt::format("\"{}\" and \"{}\"", table_.names()[deformation], table_.names()[load]);
    if (numbers_[deformation].is_negative != numbers_[load].is_negative &&
        !numbers_[deformation].is_constant && !numbers_[load].is_constant) {
      notes.push_back(pair + " have opposite signs: is the strain a transverse one?");
    }
  }

  const io::CsvTable& table_;
  const std::vector<ColumnMeaning>& columns_;
  std::vector<ColumnNumbers> numbers_;
};

}  // namespace

ChosenColumns choose_columns(const io::CsvTable& table, const std::vector<ColumnMeaning>& columns,
                             ColumnIndex deformation, ColumnIndex load) {
  return Chooser(table, columns).choose(deformation, load);
}

}  // namespace plastica::calibrate
