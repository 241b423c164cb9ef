#include "calibrate/guess/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string_view>
#include <vector>

#include "calibrate/guess/column_role.hpp"
#include "plastica/io/csv_header.hpp"
#include "plastica/io/units.hpp"

namespace plastica::calibrate {
namespace {

using WordList = std::initializer_list<std::string_view>;

struct Entry {
  std::string name;  ///< in lower case
  std::string shown;
  double value = 0.0;
  std::string unit;
};

/// Columns with one number, in their first rows or in all of them.
void add_columns(const io::CsvTable& table, std::vector<Entry>& entries) {
  for (std::size_t k = 0; k < table.columns(); ++k) {
    if (meaning_of(table.names()[k], table.units()[k]).role != ColumnRole::Geometry) continue;
    std::optional<double> only;
    bool is_one = true;
    for (std::size_t row = 0; row < table.rows() && is_one; ++row) {
      double value = 0.0;
      try {
        value = table.number(row, k);
      } catch (const InputError&) {
        is_one = false;
      }
      if (std::isnan(value)) continue;
      is_one = is_one && (!only || *only == value);
      only = value;
    }
    if (!only || !is_one) continue;
    const std::string& name = table.names()[k];
    entries.push_back({lower_name(name), name, *only, table.units()[k]});
  }
}

std::vector<Entry> entries_of(const io::CsvTable& table) {
  std::vector<Entry> entries;
  for (const io::HeaderEntry& entry : io::header_entries(table)) {
    entries.push_back({lower_name(entry.name), entry.name, entry.value, entry.unit});
  }
  add_columns(table, entries);
  // After the test: not what a stress or strain is based on.
  std::erase_if(entries, [](const Entry& entry) {
    constexpr std::array<std::string_view, 7> kAfter{"final", "after",    "nach",  "bruch",
                                                     "end ",  "fracture", "finale"};
    return !(entry.value > 0.0) || std::ranges::any_of(kAfter, [&](auto word) {
      return entry.name.find(word) != std::string::npos;
    });
  });
  return entries;
}

bool is_of(const std::string& unit, Dimension dimension) {
  try {
    return !unit.empty() && io::unit_conversion(unit, dimension)(1.0) > 0.0;
  } catch (const InputError&) {
    return false;
  }
}

/// The first entry that has one of the words in its name, or is one of short ones, and whose unit
/// fits; the words in the order of their weight.
const Entry* find(const std::vector<Entry>& entries, WordList within, WordList whole,
                  Dimension dimension) {
  const auto is_whole = [&](const Entry& entry, std::string_view word) {
    if (!entry.name.starts_with(word)) return entry.name.ends_with(" " + std::string(word));
    return entry.name.size() == word.size() || entry.name[word.size()] == ' ';
  };
  for (const std::string_view word : within) {
    for (const Entry& entry : entries) {
      if (entry.name.find(word) != std::string::npos && is_of(entry.unit, dimension)) return &entry;
    }
  }
  for (const std::string_view word : whole) {
    for (const Entry& entry : entries) {
      if (is_whole(entry, word) && is_of(entry.unit, dimension)) return &entry;
    }
  }
  return nullptr;
}

double si_of(const Entry& entry, Dimension dimension) {
  return io::unit_conversion(entry.unit, dimension)(entry.value);
}

std::string shown(const Entry& entry) {
  return fmt::format("\"{}\" = {:g} {}", entry.shown, entry.value, entry.unit);
}

}  // namespace

GivenGeometry find_geometry(const io::CsvTable& table) {
  const std::vector<Entry> entries = entries_of(table);
  GivenGeometry given;
  const Entry* length =
      find(entries,
           {"gauge length", "gage length", "gaugelength", "messlänge", "original length",
            "initial length", "longueur initiale", "longueur de base", "extensometer length"},
           {"l0", "lo", "le"}, Dimension::Length);
  if (length == nullptr)
    length = find(entries, {"length", "länge", "longueur", "longitud", "lunghezza"}, {},
                  Dimension::Length);
  if (length != nullptr) given.gauge_length = {si_of(*length, Dimension::Length), shown(*length)};

  const auto dimension = [&](WordList within, WordList whole) {
    return find(entries, within, whole, Dimension::Length);
  };
  const Entry* area = find(entries, {"area", "querschnitt", "section", "fläche", "aire", "sezione"},
                           {"s0"}, Dimension::Area);
  const Entry* diameter = dimension({"diamet", "durchmess", "diamèt", "diámet", "ø"}, {"d0", "d"});
  const Entry* width = dimension({"width", "breite", "largeur", "ancho", "larghezza"}, {"b0", "b"});
  const Entry* thickness =
      dimension({"thickness", "dicke", "épaisseur", "epaisseur", "espesor", "spessore"}, {"a0"});
  if (area != nullptr) {
    given.area = {si_of(*area, Dimension::Area), shown(*area)};
  } else if (width != nullptr && thickness != nullptr) {
    given.area = {si_of(*width, Dimension::Length) * si_of(*thickness, Dimension::Length),
                  shown(*width) + " by " + shown(*thickness)};
  } else if (diameter != nullptr) {
    const double d = si_of(*diameter, Dimension::Length);
    given.area = {std::numbers::pi / 4.0 * d * d, "pi/4 d^2 of " + shown(*diameter)};
  }
  for (const Entry& entry : entries) {
    constexpr std::array<std::string_view, 6> kWanted{"area",         "querschnitt", "section",
                                                      "gauge length", "gage length", "messlänge"};
    const bool would_do = std::ranges::any_of(
        kWanted, [&](auto word) { return entry.name.find(word) != std::string::npos; });
    if (!entry.unit.empty() || !would_do) continue;
    given.without_unit = fmt::format("\"{}\" = {:g}", entry.shown, entry.value);
    break;
  }
  return given;
}

}  // namespace plastica::calibrate
