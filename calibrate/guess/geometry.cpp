#include "calibrate/guess/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <span>
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

/// Whether a name has one of the words in it.
bool has(const std::string& name, std::span<const std::string_view> words) {
  return std::ranges::any_of(
      words, [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

std::vector<Entry> entries_of(const io::CsvTable& table) {
  std::vector<Entry> entries;
  for (const io::HeaderEntry& entry : io::header_entries(table)) {
    entries.push_back({lower_name(entry.name), entry.name, entry.value, entry.unit});
  }
  add_columns(table, entries);
  std::erase_if(entries, [](const Entry& entry) {
    // After the test: not what a stress or strain is based on.
    constexpr std::array<std::string_view, 14> kAfter{
        "final",    "after",   "nach",     "bruch", "end ",    "fracture", "finale",
        "at break", "rupture", "ultimate", "après", "después", "dopo",     "reduced area"};
    // Of another thing than the measured part of the specimen.
    constexpr std::array<std::string_view, 20> kOther{
        "piston",   "kolben", "oberfl", "surface", "focal",   "wave",   "thread",
        "gewinde",  "crack",  "riss",   "total",   "overall", "gesamt", "grip",
        "einspann", "head",   "kopf",   "notch",   "kerb",    "pin "};
    return !(entry.value > 0.0) || has(entry.name, kAfter) || has(entry.name, kOther);
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

/// The last part of "specimen properties : width", the first of "L0 - standard travel", without
/// what says that it is the initial one.
std::string bare_name(std::string name) {
  while (!name.empty() && (name.back() == ':' || name.back() == '=' || name.back() == ' ')) {
    name.pop_back();
  }
  if (const std::size_t colon = name.rfind(':'); colon != std::string::npos) {
    name.erase(0, colon + 1);
  }
  if (const std::size_t dash = name.find(" -"); dash != std::string::npos) name.erase(dash);
  for (const std::string_view word :
       {"initial", "original", "specimen", "sample", "anfangs", "0"}) {
    if (const std::size_t at = name.find(word); at != std::string::npos && name.size() > 2) {
      name.erase(at, word.size());
    }
  }
  std::erase(name, ' ');
  return name;
}

/// What gives a dimension: one entry, or several that contradict each other.
struct Found {
  const Entry* entry = nullptr;
  const Entry* other = nullptr;
  bool is_clear() const { return entry != nullptr && other == nullptr; }
};

double si_of(const Entry& entry, Dimension dimension) {
  return io::unit_conversion(entry.unit, dimension)(entry.value);
}

/// The entries whose unit fits and whose name is one of the words, else those that have one of them
/// in it.
/// @param whole  short words, that only count as a whole name
Found find(const std::vector<Entry>& entries, WordList within, WordList whole,
           Dimension dimension) {
  std::vector<const Entry*> exact, near;
  for (const Entry& entry : entries) {
    if (!is_of(entry.unit, dimension)) continue;
    const std::string name = bare_name(entry.name);
    const auto is_name = [&](std::string_view word) {
      std::string bare(word);
      std::erase(bare, ' ');
      return name == bare || bare_name(std::string(word)) == name || entry.name == word;
    };
    if (std::ranges::any_of(within, is_name) || std::ranges::any_of(whole, is_name)) {
      exact.push_back(&entry);
    } else if (has(entry.name, {within.begin(), within.size()})) {
      near.push_back(&entry);
    }
  }
  const std::vector<const Entry*>& best = exact.empty() ? near : exact;
  Found found;
  for (const Entry* entry : best) {
    if (found.entry == nullptr) {
      found.entry = entry;
    } else if (si_of(*entry, dimension) != si_of(*found.entry, dimension)) {
      found.other = entry;
      break;
    }
  }
  return found;
}

std::string shown(const Entry& entry) {
  return fmt::format("\"{}\" = {:g} {}", entry.shown, entry.value, entry.unit);
}

}  // namespace

GivenGeometry find_geometry(const io::CsvTable& table) {
  const std::vector<Entry> entries = entries_of(table);
  GivenGeometry given;
  const auto note = [](std::string& into, const Found& found) {
    into = shown(*found.entry) + " and " + shown(*found.other);
  };
  Found length =
      find(entries,
           {"gauge length", "gage length", "gaugelength", "messlänge", "original length",
            "initial length", "longueur initiale", "longueur de base", "extensometer length"},
           {"l0", "lo", "le"}, Dimension::Length);
  std::string doubt;
  if (length.entry == nullptr) {
    length = find(entries, {"parallel length", "versuchslänge"},
                  {"length", "länge", "longueur", "longitud", "lunghezza"}, Dimension::Length);
    doubt = ", which may be another length";
  }
  // Which of two gauge lengths an elongation is of depends on what measured it.
  for (const Entry& entry : entries) {
    const bool is_sensors = entry.name.find("extensom") != std::string::npos;
    if (!length.is_clear() || !is_sensors || !is_of(entry.unit, Dimension::Length)) continue;
    if (entry.value > 0.0 &&
        si_of(entry, Dimension::Length) != si_of(*length.entry, Dimension::Length)) {
      length.other = &entry;
    }
  }
  if (length.is_clear()) {
    given.gauge_length = {si_of(*length.entry, Dimension::Length), shown(*length.entry) + doubt};
  } else if (length.entry != nullptr) {
    note(given.doubt_of_length, length);
  }

  const auto dimension = [&](WordList within, WordList whole) {
    return find(entries, within, whole, Dimension::Length);
  };
  const Found area = find(entries, {"area", "querschnitt", "section", "fläche", "aire", "sezione"},
                          {"s0", "a0"}, Dimension::Area);
  const Found diameter = dimension({"diamet", "durchmess", "diamèt", "diámet", "ø"}, {"d0", "d"});
  const Found width = dimension({"width", "breite", "largeur", "ancho", "larghezza"}, {"b0", "b"});
  const Found thickness =
      dimension({"thickness", "dicke", "épaisseur", "epaisseur", "espesor", "spessore"}, {"a0"});
  constexpr std::array<std::string_view, 6> kTube{"inner", "innen", "intérieur",
                                                  "wall",  "wand",  "paroi"};
  const bool is_tube =
      std::ranges::any_of(entries, [&](const Entry& entry) { return has(entry.name, kTube); });
  const auto si = [](const Found& found) { return si_of(*found.entry, Dimension::Length); };
  if (area.is_clear()) {
    given.area = {si_of(*area.entry, Dimension::Area), shown(*area.entry)};
  } else if (area.entry != nullptr) {
    note(given.doubt_of_area, area);
  } else if (is_tube) {
    given.doubt_of_area = "a tube, whose ring is to be worked out";
  } else if (width.is_clear() && thickness.is_clear() && width.entry != thickness.entry) {
    given.area = {si(width) * si(thickness),
                  shown(*width.entry) + " by " + shown(*thickness.entry)};
  } else if (diameter.is_clear() && width.entry == nullptr) {
    given.area = {std::numbers::pi / 4.0 * si(diameter) * si(diameter),
                  "pi/4 d^2 of " + shown(*diameter.entry)};
  } else {
    for (const Found& found : {width, thickness, diameter}) {
      if (found.other != nullptr) note(given.doubt_of_area, found);
    }
  }
  for (const Entry& entry : entries) {
    constexpr std::array<std::string_view, 6> kWanted{"area",         "querschnitt", "section",
                                                      "gauge length", "gage length", "messlänge"};
    if (!entry.unit.empty() || !has(entry.name, kWanted)) continue;
    given.without_unit = fmt::format("\"{}\" = {:g}", entry.shown, entry.value);
    break;
  }
  return given;
}

}  // namespace plastica::calibrate
