#include "sweeps/trade/written_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <variant>

#include "calibrate/config/write_target.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/io/toml.hpp"
#include "plastica/io/toml_edit.hpp"
#include "sweeps/plan/sweep.hpp"

namespace plastica::sweeps {
namespace {

/// Where a file may have the value of a field: [section] and [material] may stand in [beam].
std::string path_in_file(const std::string& text, const Field& field) {
  const std::string path(field.path);
  const std::string part = path.substr(0, path.find('.'));
  const bool of_beam = part == "section" || part == "material";
  return of_beam && io::has_toml_key(text, "beam." + part) ? "beam." + path : path;
}

std::string written(const Field& field, const FieldValue& value) {
  if (const auto* word = std::get_if<std::string>(&value)) return fmt::format("\"{}\"", *word);
  const double number = std::get<double>(value);
  const std::string_view unit = si_unit(field.dimension);
  return unit == "1" ? fmt::format("{}", number) : fmt::format("\"{} {}\"", number, unit);
}

/// `material = "S355"` becomes a table that further values can join.
std::string with_table_of_material(const std::string& text, const std::string& path,
                                   const std::string& file) {
  const std::string part = path.substr(0, path.rfind('.'));
  if (!part.ends_with("material") || !io::has_toml_key(text, part)) return text;
  if (io::has_toml_key(text, part + ".name") || io::has_toml_key(text, path)) return text;
  const std::string name = io::parse_scene_file(text, file).setup.scene.material.name;
  try {
    return io::set_toml_value(text, part, fmt::format("{{ name = \"{}\" }}", name));
  } catch (const InputError&) {
    return text;  // it is a table already, one without a name
  }
}

/// How a table that a file names is named from another folder.
std::string renamed(const std::string& table, const std::filesystem::path& from,
                    const std::filesystem::path& to) {
  const std::filesystem::path path(table);
  if (path.is_absolute()) return table;
  const auto there = std::filesystem::absolute(from / path).lexically_normal();
  const auto folder = std::filesystem::absolute(to / ".").lexically_normal();
  return there.lexically_relative(folder).string();
}

/// Histories that are columns of a table beside the scene's file stay those of that table.
std::string with_tables_from(std::string text, const std::string& file, const std::string& output) {
  const auto from = std::filesystem::path(file).parent_path();
  const auto to = std::filesystem::path(output).parent_path();
  if (from == to) return text;
  const auto document = io::TomlDocument::parse(text, file);
  const auto rename = [&](const io::TomlTable& owner, const std::string& path) {
    const auto history = owner.find("history");
    if (!history || !history->is_table()) return;
    const auto table = history->table().find("table");
    if (!table) return;
    text = io::set_toml_value(text, path + ".history.table",
                              calibrate::toml_string(renamed(table->string(), from, to)));
  };
  for (const std::string list : {"load", "support"}) {
    std::size_t number = 0;
    for (const io::TomlTable& one : document.root().find_tables(list)) {
      rename(one, fmt::format("{}[{}]", list, ++number));
    }
  }
  const auto gravity = document.root().find("gravity");
  if (gravity && gravity->is_table()) rename(gravity->table(), "gravity");
  return text;
}

bool same_histories(const Scene& a, const Scene& b) {
  const auto same = [](const auto& one, const auto& other) { return one.history == other.history; };
  return std::ranges::equal(a.loads, b.loads, same) &&
         std::ranges::equal(a.supports, b.supports, same) && a.gravity_history == b.gravity_history;
}

}  // namespace

void refuse_to_write(const Field& field, const FieldValue& value) {
  throw InputError({}, field.path, value_text(field, value),
                   "cannot be written into the scene's file: do it by hand");
}

std::string scene_with_values(const std::string& text,
                              const std::vector<std::pair<const Field*, FieldValue>>& values,
                              const Setup& wanted, const std::string& file,
                              const std::string& output) {
  std::string filled = text;
  for (const auto& [field, value] : values) {
    const std::string path = path_in_file(filled, *field);
    if (std::holds_alternative<std::monostate>(value)) {
      if (io::has_toml_key(filled, path)) refuse_to_write(*field, value);
      continue;
    }
    try {
      filled = with_table_of_material(filled, path, file);
      filled = io::set_toml_value(filled, path, written(*field, value));
    } catch (const InputError&) {
      refuse_to_write(*field, value);
    }
  }
  // Whatever the file looks like: it must now say what was wanted.
  filled = with_tables_from(std::move(filled), file, output);
  const Setup after = io::parse_scene_file(filled, output).setup;
  if (!same_histories(after.scene, wanted.scene)) {
    throw InputError({}, "history.table", "",
                     "is another table from the output's folder: write the scene beside its own");
  }
  for (const Field& field : fields()) {
    if (field.get(after) != field.get(wanted)) refuse_to_write(field, field.get(wanted));
  }
  return filled;
}

}  // namespace plastica::sweeps
