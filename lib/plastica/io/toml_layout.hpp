#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "plastica/io/toml_lines.hpp"

namespace plastica::io {

/// "table.name", or "name" for an empty table.
std::string joined_path(std::string table, std::string_view name);

/// "path[element]"; elements count from 1.
std::string with_element(std::string path, std::size_t element);

/// Whether a node is written as a value: not by headers or dotted keys.
bool is_written_value(const toml::node& node);

/// The lines of a TOML file from a header to the next one.
struct TomlSection {
  std::string path{};          ///< "support[2].spring"; empty for what is above all headers
  bool of_list = false;        ///< its header has double brackets
  std::size_t first = 1;       ///< line of the header; 1 at the top
  std::size_t values_end = 1;  ///< the line behind its last value; without one, behind its header
  std::string indent{};        ///< of the last value's line
};

/// A TOML text with what its editing needs to know of it.
class TomlLayout {
 public:
  /// @param text  that toml++ can parse; must outlive the layout
  explicit TomlLayout(std::string_view text);

  const toml::table& root() const { return root_; }
  const TomlLines& lines() const { return lines_; }
  const std::vector<TomlSection>& sections() const { return sections_; }  ///< the top is first

  /// The section with a header of this path; null if there is none.
  const TomlSection* section_of(std::string_view path) const;

  /// The first section of a table below the one of this path; null if there is none.
  const TomlSection* first_below(std::string_view path) const;

  /// The section further up that holds a value of a table, as dotted keys put it there; null if
  /// there is none.
  const TomlSection* section_above(const toml::table& table, std::string_view path) const;

 private:
  std::size_t section_at(std::size_t line) const;
  void find_sections(const std::vector<toml::source_region>& values);

  TomlLines lines_;
  toml::table root_;
  std::vector<TomlSection> sections_;
};

}  // namespace plastica::io
