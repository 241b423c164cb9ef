#include "plastica/io/region_store.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>

#include "plastica/io/value_rule.hpp"
#include "plastica/model/field.hpp"

namespace plastica::io {
namespace {

constexpr std::array kRegionRules{ValueRule{"regions/from", kFraction},
                                  ValueRule{"regions/to", kFraction}};

bool is_of_region(const Field& field) {
  return field.path.starts_with("material.") || field.path.starts_with("section.");
}

std::string column_of(const Field& field) {
  std::string path(field.path);
  std::replace(path.begin(), path.end(), '.', '/');
  return path;
}

Setup setup_of(const Region& region) {
  Setup setup;
  setup.scene.section = region.section;
  setup.scene.material = region.material;
  return setup;
}

/// Paths with spaces between them.
std::string joined(const std::vector<std::string>& paths) {
  std::string text;
  for (const std::string& path : paths) text += (text.empty() ? "" : " ") + path;
  return text;
}
std::vector<std::string> split(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

template <class T>
std::vector<T> checked(const Hdf5Group& group, const std::string& path, std::vector<T> values,
                       std::size_t rows) {
  if (values.size() == rows) return values;
  throw InputError({group.file(), 0}, group.path() + "/" + path, "",
                   "has other rows than the rest of its table");
}

constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();

/// The ends of tapers: `to_section/` with the keys of `section/`, of other regions empty.
void write_tapers(Hdf5Group& group, const std::vector<Region>& regions) {
  const auto tapers = [](const Region& region) { return region.to_section.has_value(); };
  if (std::none_of(regions.begin(), regions.end(), tapers)) return;
  std::vector<std::string> names;
  names.reserve(regions.size());
  for (const Region& region : regions) {
    names.push_back(region.to_section ? region.to_section->name : "");
  }
  group.write_texts("to_section/name", names);
  for (const Field& field : fields()) {
    if (!field.path.starts_with("section.")) continue;
    std::vector<std::string> words;
    std::vector<double> numbers;
    for (const Region& region : regions) {
      Setup setup;
      setup.scene.section = region.to_section.value_or(Section{});
      const FieldValue value = field.get(setup);
      const auto* word = std::get_if<std::string>(&value);
      const auto* number = std::get_if<double>(&value);
      words.push_back(word != nullptr && region.to_section ? *word : "");
      numbers.push_back(number != nullptr && region.to_section ? *number : kUnset);
    }
    if (field.kind == FieldKind::Choice) {
      group.write_texts("to_" + column_of(field), words);
    } else {
      group.write("to_" + column_of(field), numbers, {si_unit(field.dimension)});
    }
  }
}

void read_tapers(const Hdf5Group& group, std::vector<Region>& regions) {
  if (!group.exists("to_section/name")) return;
  const std::size_t rows = regions.size();
  const SourceLocation where{group.file(), 0};
  const auto shapes =
      checked(group, "to_section/shape", group.read_texts("to_section/shape"), rows);
  const auto names = checked(group, "to_section/name", group.read_texts("to_section/name"), rows);
  for (std::size_t i = 0; i < rows; ++i) {
    if (!shapes[i].empty()) regions[i].to_section = Section{.name = names[i]};
  }
  for (const Field& field : fields()) {
    const std::string path = "to_" + column_of(field);
    if (!field.path.starts_with("section.") || !group.exists(path)) continue;
    std::vector<double> numbers(rows, kUnset);
    if (field.kind != FieldKind::Choice) {
      numbers = checked(group, path, group.read<double>(path), rows);
    }
    for (std::size_t i = 0; i < rows; ++i) {
      if (!regions[i].to_section) continue;
      Setup setup;
      setup.scene.section = *regions[i].to_section;
      const FieldValue number = std::isnan(numbers[i]) ? FieldValue() : FieldValue(numbers[i]);
      set_field(setup, field, field.kind == FieldKind::Choice ? FieldValue(shapes[i]) : number,
                where);
      regions[i].to_section = setup.scene.section;
    }
  }
}

}  // namespace

void write_regions(Hdf5Group& group, const std::vector<Region>& regions) {
  std::vector<double> from;
  std::vector<double> to;
  std::vector<std::string> names;
  std::vector<std::string> profiles;
  std::vector<std::string> own;
  for (const Region& region : regions) {
    from.push_back(region.from.fraction);
    to.push_back(region.to.fraction);
    names.push_back(region.material.name);
    profiles.push_back(region.section.name);
    own.push_back(joined(region.own));
  }
  group.write("from", from, {"1"});
  group.write("to", to, {"1"});
  group.write_texts("material/name", names);
  group.write_texts("section/name", profiles);
  group.write_texts("own", own);
  write_tapers(group, regions);
  for (const Field& field : fields()) {
    if (!is_of_region(field)) continue;
    std::vector<std::string> words;
    std::vector<double> numbers;
    for (const Region& region : regions) {
      const FieldValue value = field.get(setup_of(region));
      if (const auto* word = std::get_if<std::string>(&value)) {
        words.push_back(*word);
      } else {
        const auto* number = std::get_if<double>(&value);
        numbers.push_back(number != nullptr ? *number : kUnset);
      }
    }
    if (field.kind == FieldKind::Choice) {
      group.write_texts(column_of(field), words);
    } else {
      group.write(column_of(field), numbers, {si_unit(field.dimension)});
    }
  }
}

std::vector<Region> read_regions(const Hdf5Group& group) {
  const auto from = read_numbers<double>(group, "from", kRegionRules);
  const auto to =
      checked(group, "to", read_numbers<double>(group, "to", kRegionRules), from.size());
  const auto names =
      checked(group, "material/name", group.read_texts("material/name"), from.size());
  std::vector<std::string> profiles(from.size());
  if (group.exists("section/name")) {
    profiles = checked(group, "section/name", group.read_texts("section/name"), from.size());
  }
  std::vector<std::string> own;
  if (group.exists("own")) own = checked(group, "own", group.read_texts("own"), from.size());
  std::vector<Setup> setups(from.size());
  const SourceLocation where{group.file(), 0};
  for (const Field& field : fields()) {
    const std::string path = column_of(field);
    // What an older version did not know has its default, which is how that version ran.
    if (!is_of_region(field) || !group.exists(path)) continue;
    if (field.kind == FieldKind::Choice) {
      const auto words = checked(group, path, group.read_texts(path), from.size());
      for (std::size_t i = 0; i < words.size(); ++i) set_field(setups[i], field, words[i], where);
    } else {
      const auto numbers = checked(group, path, group.read<double>(path), from.size());
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        const bool set = !std::isnan(numbers[i]);
        set_field(setups[i], field, set ? FieldValue(numbers[i]) : FieldValue(), where);
      }
    }
  }
  std::vector<Region> regions;
  for (std::size_t i = 0; i < from.size(); ++i) {
    setups[i].scene.material.name = names[i];
    setups[i].scene.section.name = profiles[i];
    regions.push_back(
        {{from[i], {}}, {to[i], {}}, setups[i].scene.section, setups[i].scene.material});
    if (!own.empty()) regions.back().own = split(own[i]);
  }
  read_tapers(group, regions);
  return regions;
}

}  // namespace plastica::io
