#include "plastica/io/read_fields.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "plastica/model/hardening_kind.hpp"
#include "plastica/model/material_table.hpp"
#include "plastica/model/profile_table.hpp"
#include "plastica/model/rate_kind.hpp"
#include "plastica/model/section_kind.hpp"

namespace plastica::io {
namespace {

/// The value at a dotted path, if the table has it. All keys on the way become known.
std::optional<TomlValue> value_at(TomlTable table, std::string_view path) {
  for (std::size_t dot = path.find('.'); dot != std::string_view::npos; dot = path.find('.')) {
    const auto next = table.find_table(path.substr(0, dot));
    if (!next) return std::nullopt;
    table = *next;
    path.remove_prefix(dot + 1);
  }
  return table.find(path);
}

/// The list "flow_stress" that stands for "flow_stress_2".
std::optional<TomlValue> list_of_row(const TomlTable& table, std::string_view part) {
  const std::size_t end = part.find_last_not_of("0123456789");
  const bool has_number = end != std::string_view::npos && end + 1 < part.size();
  if (!has_number || part[end] != '_') return std::nullopt;
  return table.find(part.substr(0, end));
}

/// The entry of a path's first part, "support[2]", and of that the item.
std::optional<TomlValue> entry(const TomlTable& table, std::string_view part) {
  const std::size_t bracket = part.find('[');
  auto value = table.find(part.substr(0, bracket));
  if (!value) return list_of_row(table, part);
  if (bracket == std::string_view::npos || !value->is_array()) return value;
  std::size_t number = 0;
  std::from_chars(part.data() + bracket + 1, part.data() + part.size(), number);
  const auto items = value->array();
  return number >= 1 && number <= items.size() ? items[number - 1] : value;
}

/// Sets a field of a setup. Errors name the key as the file has it.
void set_from(Setup& setup, const Field& field, const TomlValue& value) {
  try {
    if (field.kind == FieldKind::Choice) {
      set_field(setup, field, value.string(), value.where(), value.string());
      return;
    }
    const double number =
        field.kind == FieldKind::Integer ? value.number() : value.quantity(field.dimension);
    set_field(setup, field, number, value.where(),
              value.is_string() ? value.string() : value.written());
  } catch (const InputError& error) {
    throw InputError(error.where(), value.key(), error.value(), error.rule());
  }
}

}  // namespace

void read_field(const TomlTable& table, std::string_view path, const Field& field, Setup& setup) {
  if (const auto value = value_at(table, path)) set_from(setup, field, *value);
}

void read_part(const TomlTable& table, std::string_view prefix, Setup& setup) {
  for (const Field& field : fields()) {
    if (!field.path.starts_with(prefix)) continue;
    read_field(table, field.path.substr(prefix.size()), field, setup);
  }
}

namespace {

std::string_view key_of(const Field& field) { return field.path.substr(field.path.rfind('.') + 1); }

/// "plastic_strain_" of "plastic_strain_3"; a key without a number is its own.
std::string_view stem_of(const Field& field) {
  const std::string_view key = key_of(field);
  return key.substr(0, key.find_last_not_of("0123456789") + 1);
}

/// The key that says a field, which may be that of a list.
std::optional<std::string_view> said_key(const TomlTable& table, const Field& field) {
  if (table.contains(key_of(field))) return key_of(field);
  const std::string_view stem = stem_of(field);
  const std::string_view list = stem.substr(0, stem.size() - 1);
  return stem.ends_with('_') && table.contains(list) ? std::optional(list) : std::nullopt;
}

/// Refuses fields that are of another kind: a forgotten `shape` would make a tube a solid bar, a
/// forgotten `law` hardening ideal plasticity.
/// @param word       the key that says the kind
/// @param fields_of  what belongs to a kind
template <class Kinds, class Kind, class FieldsOf>
void refuse_others(const TomlTable& table, std::string_view word, const Kinds& kinds,
                   const Kind& kind, const FieldsOf& fields_of) {
  const auto own = fields_of(kind);
  for (const Kind* other : kinds) {
    for (const Field& field : fields_of(*other)) {
      const bool known =
          std::any_of(own.begin(), own.end(), [&](const Field& f) { return f.path == field.path; });
      const auto key = known ? std::nullopt : said_key(table, field);
      if (!key) continue;
      const auto equals = [&](const Kind& k) {
        return std::string(word) + " = \"" + std::string(k.word()) + "\"";
      };
      throw table.at(*key).error("is of " + equals(*other) + ", and not of " + equals(kind));
    }
  }
}

/// Sets fields "strain_1", "strain_2" … from a list "strain", and those that it has no number for
/// to 0: a region's list has nothing of the beam's.
/// @return the list
std::optional<TomlValue> read_row(const TomlTable& table, std::span<const Field> row,
                                  Setup& setup) {
  const std::string_view stem = stem_of(row.front());
  auto list = table.find(stem.substr(0, stem.size() - 1));
  if (!list) return std::nullopt;
  const auto items = list->array();
  if (items.size() > row.size()) {
    throw list->error("has " + std::to_string(items.size()) + " numbers: there is room for " +
                      std::to_string(row.size()));
  }
  for (const Field& field : row) {
    if (!table.contains(key_of(field))) continue;
    throw table.at(key_of(field)).error("is given twice: there is a list, too");
  }
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i < items.size()) {
      set_from(setup, row[i], items[i]);
    } else {
      set_field(setup, row[i], 0.0);
    }
  }
  return list;
}

void read_hardening(const TomlTable& table, Setup& setup) {
  const HardeningKind& kind = hardening_kind(setup.scene.material.hardening.law);
  refuse_others(table, "law", hardening_kinds(), kind,
                [](const HardeningKind& k) { return k.parameters(); });
  std::optional<TomlValue> before;
  for (auto rest = kind.parameters(); !rest.empty();) {
    std::size_t length = 1;
    while (length < rest.size() && stem_of(rest[length]) == stem_of(rest[0])) ++length;
    const auto list = length > 1 ? read_row(table, rest.first(length), setup) : std::nullopt;
    if (list && before && list->array().size() != before->array().size()) {
      throw list->error("must have as many numbers as " + std::string(before->key()) + ", " +
                        std::to_string(before->array().size()));
    }
    if (list) before = list;
    rest = rest.subspan(length);
  }
}

}  // namespace

void read_material(const TomlValue& value, Setup& setup) {
  const auto name = value.is_string() ? value : value.table().find("name");
  if (name) {
    setup.scene.material = named_material(name->string(), name->where(), name->key()).material;
  }
  if (value.is_string()) return;
  read_part(value.table(), "material.", setup);
  if (const auto table = value.table().find_table("hardening")) read_hardening(*table, setup);
  if (const auto table = value.table().find_table("rate")) {
    refuse_others(*table, "law", rate_kinds(), rate_kind(setup.scene.material.rate.law),
                  [](const RateKind& kind) { return kind.parameters(); });
  }
}

void refuse_missing_dimensions(const TomlValue& section, const Section& read) {
  const SectionKind& kind = section_kind(read);
  const TomlTable table = section.table();
  for (const Field& field : kind.dimensions()) {
    if (table.contains(key_of(field)) || !must_be_said(kind, field)) continue;
    throw InputError(section.where(), std::string(field.path), "",
                     "is missing: shape = \"" + std::string(kind.word()) + "\" needs it");
  }
}

void read_section(const TomlValue& value, Setup& setup) {
  Section& section = setup.scene.section;
  const auto profile = value.is_string() ? value : value.table().find("profile");
  if (profile) section = named_profile(profile->string(), profile->where(), profile->key());
  if (value.is_string()) return;
  const TomlTable& table = value.table();
  const SectionKind& before = section_kind(section);
  read_part(table, "section.", setup);
  for (const Field& field : fields()) {
    if (!field.path.starts_with("section.") || field.path == "section.shear_coefficient") continue;
    const std::string_view key = key_of(field);
    if (!table.contains(key)) continue;
    if (profile) {
      throw table.at(key).error("does not go with profile, which has all dimensions: leave one");
    }
    section.name.clear();
  }
  const SectionKind& kind = section_kind(section);
  refuse_others(table, "shape", section_kinds(), kind,
                [](const SectionKind& k) { return k.dimensions(); });
  if (&kind != &before) refuse_missing_dimensions(value, section);
}

std::vector<std::string> paths_said(const TomlValue& value, const std::string& part) {
  if (value.is_string()) return {part};
  const TomlTable table = value.table();
  if (table.contains("name") || table.contains("profile")) return {part};
  std::vector<std::string> paths;
  for (const Field& field : fields()) {
    if (!field.path.starts_with(part + ".")) continue;
    // "hardening" of material.hardening.law; nothing of material.density.
    const std::string_view below = field.path.substr(part.size() + 1);
    const std::size_t dot = below.find('.');
    const bool deeper = dot != std::string_view::npos;
    const auto of = deeper ? table.find_table(below.substr(0, dot)) : std::optional(table);
    const std::string_view stem = stem_of(field);
    const bool says =
        of && (of->contains(key_of(field)) ||
               (stem.ends_with('_') && of->contains(stem.substr(0, stem.size() - 1))));
    if (says) paths.emplace_back(field.path);
  }
  return paths;
}

std::optional<TomlValue> part_of_beam(const TomlTable& root, std::string_view name) {
  const auto of_file = root.find(name);
  const auto beam = root.find_table("beam");
  const auto of_beam = beam ? beam->find(name) : std::nullopt;
  if (of_file && of_beam) {
    throw of_beam->error("is given twice: the file has [" + std::string(name) + "], too");
  }
  return of_beam ? of_beam : of_file;
}

std::array<double, 3> read_vector(const TomlValue& list, Dimension dimension) {
  const auto items = list.array();
  if (items.size() != 3) throw list.error("must have three components: x, y and z");
  return {items[0].quantity(dimension), items[1].quantity(dimension), items[2].quantity(dimension)};
}

std::array<double, 3> read_direction(const TomlValue& value) {
  if (value.is_string()) {
    constexpr std::array<std::string_view, 6> kWords{"x", "y", "z", "-x", "-y", "-z"};
    const std::size_t word = value.word(kWords);
    std::array<double, 3> direction{};
    direction[word % 3] = word < 3 ? 1.0 : -1.0;
    return direction;
  }
  if (!value.is_array()) throw value.error("must be \"x\", \"-y\", … or a list of x, y and z");
  std::array<double, 3> direction = read_vector(value, Dimension::None);
  const double size = std::hypot(direction[0], direction[1], direction[2]);
  if (size == 0.0) throw value.error("has no direction");
  for (double& component : direction) component /= size;
  return direction;
}

std::vector<double> read_quantities(const TomlValue& list, Dimension dimension) {
  std::vector<double> values;
  for (const TomlValue& item : list.array()) values.push_back(item.quantity(dimension));
  if (values.empty()) throw list.error("must not be empty");
  return values;
}

SourceLocation locate(const TomlTable& root, std::string_view field) {
  TomlTable table = root;
  SourceLocation where{root.where().file, 0};
  // The beam's section and material may stand in [beam], while errors name them without it.
  const bool of_beam = field.starts_with("section") || field.starts_with("material");
  if (const auto beam = root.find_table("beam"); of_beam && beam) {
    if (beam->contains(field.substr(0, field.find('.')))) table = *beam;
  }
  while (!field.empty()) {
    const std::size_t dot = field.find('.');
    const auto value = entry(table, field.substr(0, dot));
    if (!value) break;
    where = value->where();
    if (dot == std::string_view::npos || !value->is_table()) break;
    table = value->table();
    field.remove_prefix(dot + 1);
  }
  return where;
}

}  // namespace plastica::io
