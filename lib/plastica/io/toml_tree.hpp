#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace plastica::io {

struct TomlTree;

/// A value of a TOML file with all that an error line needs. It lives as long as its tree.
struct TomlNode {
  enum class Kind { Table, Array, String, Integer, Float, Boolean, Date };

  /// What is shown of a value, made when it is first asked for: the keys of a large file in full
  /// would take more room than the file itself.
  struct Shown {
    std::string key;
    std::string written;
  };

  Kind kind = Kind::Table;
  int line = 0;
  TomlTree* tree = nullptr;
  const TomlNode* above = nullptr;  // the table or array; null at the top of the file
  std::string name = {};            // in the table above
  std::size_t number = 0;           // in the array above, from 1
  std::string_view written = {};    // empty for tables with a header
  std::string string = {};
  double real = 0.0;
  std::int64_t integer = 0;
  bool boolean = false;
  bool is_known = false;                   // somebody asked for it
  std::vector<TomlNode*> items = {};       // of an array; of a table, in the order of the file
  std::vector<TomlNode*> by_name = {};     // a table's, sorted
  std::vector<std::string> known = {};     // keys asked for
  std::unique_ptr<Shown> shown = nullptr;  // see shown_of()
};

/// All values of a TOML text.
struct TomlTree {
  std::string file;
  std::string text;  // without byte order mark
  std::deque<TomlNode> nodes;
  std::vector<std::string> notes = {};  // old names that were read, a line each
};

/// Parses a text into a tree; the node at its top holds the tree.
/// @param text  without byte order mark, not nested deeper than scan_toml() allows
/// @throws toml::parse_error if it is not TOML
std::shared_ptr<TomlNode> toml_tree(std::string_view text, const std::string& file);

/// Key in full and text as written, both of one node.
const TomlNode::Shown& shown_of(TomlNode& node);

/// The entry of a table; null if it has none of that name.
TomlNode* entry_of(const TomlNode& table, std::string_view name);

/// "table.name", or "name" at the top of the file.
std::string joined_key(const std::string& table, std::string_view name);

}  // namespace plastica::io
