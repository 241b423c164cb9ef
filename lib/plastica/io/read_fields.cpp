#include "plastica/io/read_fields.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "plastica/model/material_table.hpp"
#include "plastica/model/profile_table.hpp"
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

/// The entry of a path's first part, "support[2]", and of that the item.
std::optional<TomlValue> entry(const TomlTable& table, std::string_view part) {
  const std::size_t bracket = part.find('[');
  auto value = table.find(part.substr(0, bracket));
  if (!value || bracket == std::string_view::npos || !value->is_array()) return value;
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

void read_material(const TomlValue& value, Setup& setup) {
  const auto name = value.is_string() ? value : value.table().find("name");
  if (name) {
    setup.scene.material = named_material(name->string(), name->where(), name->key()).material;
  }
  if (!value.is_string()) read_part(value.table(), "material.", setup);
}

namespace {

/// Refuses dimensions that another shape has: a forgotten `shape` would make a tube a solid bar.
void refuse_other_dimensions(const TomlTable& table, const SectionKind& kind) {
  const auto own = kind.dimensions();
  for (const SectionKind* other : section_kinds()) {
    for (const Field& field : other->dimensions()) {
      const std::string_view key = field.path.substr(field.path.find('.') + 1);
      const bool known =
          std::any_of(own.begin(), own.end(), [&](const Field& f) { return f.path == field.path; });
      if (known || !table.contains(key)) continue;
      throw table.at(key).error("is of shape = \"" + std::string(other->word()) +
                                "\", and not of shape = \"" + std::string(kind.word()) + "\"");
    }
  }
}

}  // namespace

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
    const std::string_view key = field.path.substr(field.path.find('.') + 1);
    if (!table.contains(key)) continue;
    if (profile) {
      throw table.at(key).error("does not go with profile, which has all dimensions: leave one");
    }
    section.name.clear();
  }
  const SectionKind& kind = section_kind(section);
  refuse_other_dimensions(table, kind);
  if (&kind == &before) return;
  for (const Field& field : kind.dimensions()) {
    const std::string_view key = field.path.substr(field.path.find('.') + 1);
    if (table.contains(key) || !kind.needs(field)) continue;
    throw InputError(value.where(), "section." + std::string(key), "",
                     "is missing: shape = \"" + std::string(kind.word()) + "\" needs it");
  }
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
