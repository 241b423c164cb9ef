#include "plastica/io/toml_layout.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace plastica::io {
namespace {

/// The written values of a node and of all below it.
void collect_values(const toml::node& node, std::vector<toml::source_region>& values) {
  if (is_written_value(node)) {
    values.push_back(node.source());
  } else if (const toml::table* table = node.as_table()) {
    for (const auto& entry : *table) collect_values(entry.second, values);
  } else {
    for (const toml::node& element : *node.as_array()) collect_values(element, values);
  }
}

/// Reads a header; alone, it makes a tree of one branch.
/// @param lists  how many elements each list of tables has so far
void read_header(std::string_view line, TomlSection& section,
                 std::map<std::string, std::size_t>& lists) {
  const toml::table branch = toml::parse(line);
  for (const toml::table* table = &branch; !table->empty();) {
    const auto only = table->cbegin();  // what it refers to lives in it
    section.path = joined_path(std::move(section.path), only->first.str());
    table = only->second.as_table();
    if (table == nullptr) {
      section.of_list = true;
      const std::size_t element = ++lists[section.path];
      section.path = with_element(std::move(section.path), element);
      return;
    }
    if (const auto list = lists.find(section.path); list != lists.end()) {
      section.path = with_element(std::move(section.path), list->second);
    }
  }
}

}  // namespace

std::string joined_path(std::string table, std::string_view name) {
  if (!table.empty()) table += '.';
  return table.append(name);
}

std::string with_element(std::string path, std::size_t element) {
  return std::move(path) + "[" + std::to_string(element) + "]";
}

bool is_written_value(const toml::node& node) {
  if (const toml::table* table = node.as_table()) return table->is_inline();
  if (const toml::array* array = node.as_array()) {
    return !array->is_array_of_tables() || array->get(0)->as_table()->is_inline();
  }
  return true;
}

TomlLayout::TomlLayout(std::string_view text) : lines_(text), root_(toml::parse(text)) {
  std::vector<toml::source_region> values;
  collect_values(root_, values);
  find_sections(values);
}

void TomlLayout::find_sections(const std::vector<toml::source_region>& values) {
  std::vector<bool> continues(lines_.count() + 1);  // whether a line begins within a value
  for (const auto& value : values) {
    for (auto line = value.begin.line + 1; line <= value.end.line; ++line) continues[line] = true;
  }
  sections_.emplace_back();
  std::map<std::string, std::size_t> lists;
  for (std::size_t number = 1; number <= lines_.count(); ++number) {
    const std::string_view line = lines_.line(number);
    const std::size_t begin = line.find_first_not_of(" \t");
    if (continues[number] || begin == std::string_view::npos || line[begin] != '[') continue;
    TomlSection section;
    section.first = number;
    section.values_end = number + 1;
    read_header(line, section, lists);
    sections_.push_back(std::move(section));
  }
  for (const auto& value : values) {
    TomlSection& section = sections_[section_at(value.begin.line)];
    if (value.end.line < section.values_end) continue;
    section.values_end = value.end.line + 1;
    const std::string_view line = lines_.line(value.begin.line);
    section.indent = line.substr(0, line.find_first_not_of(" \t"));
  }
}

std::size_t TomlLayout::section_at(std::size_t line) const {
  const auto after =
      std::upper_bound(sections_.begin() + 1, sections_.end(), line,
                       [](std::size_t l, const TomlSection& section) { return l < section.first; });
  return static_cast<std::size_t>(std::distance(sections_.begin(), after)) - 1;
}

const TomlSection* TomlLayout::section_of(std::string_view path) const {
  for (const TomlSection& section : sections_) {
    if (section.path == path) return &section;
  }
  return nullptr;
}

const TomlSection* TomlLayout::first_below(std::string_view path) const {
  for (const TomlSection& section : sections_) {
    if (section.path.starts_with(joined_path(std::string(path), ""))) return &section;
  }
  return nullptr;
}

const TomlSection* TomlLayout::section_above(const toml::table& table,
                                             std::string_view path) const {
  std::vector<toml::source_region> values;
  collect_values(table, values);
  for (const toml::source_region& value : values) {
    const TomlSection& section = sections_[section_at(value.begin.line)];
    if (section.path.size() < path.size()) return &section;
  }
  return nullptr;
}

}  // namespace plastica::io
