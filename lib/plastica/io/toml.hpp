#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/base/quantity.hpp"

/// TOML files with errors that name file, line, key, value and rule. Keys are shown in full, from
/// the top of the file: "fit.parameters.yield_stress.bounds", "target[2].files" (the second
/// [[target]]).
namespace plastica::io {

struct TomlNode;
class TomlTable;

/// One value of a TOML file. Copies share the value; they outlive the document.
class TomlValue {
 public:
  explicit TomlValue(std::shared_ptr<TomlNode> node) : node_(std::move(node)) {}

  const std::string& key() const;  ///< in full
  SourceLocation where() const;
  /// The value as the file has it, quotes included.
  const std::string& written() const;

  bool is_string() const;
  bool is_number() const;   ///< an integer or a real number
  bool is_integer() const;  ///< a number without point and exponent
  bool is_boolean() const;
  bool is_array() const;
  bool is_table() const;

  // Each getter throws InputError if the value is of another kind or breaks the rule.
  const std::string& string() const;  ///< not empty
  bool boolean() const;
  double number() const;  ///< finite
  /// An integer from low to high.
  std::int64_t integer(std::int64_t low, std::int64_t high) const;
  /// A number for which low < value < high, the ends included where `closed`.
  double number_within(double low, double high, bool closed) const;
  /// One of some words; an old word (`kRenamedWords`) is read, too, and noted. @return its index
  std::size_t word(std::span<const std::string_view> words) const;
  /// The path of a field that this value is, or is the value of, with the new name of one that was
  /// renamed; notes an old one.
  std::string new_path(std::string_view path) const;
  /// "355 MPa" in SI; numbers without quotes where the dimension needs no unit.
  double quantity(Dimension dimension) const;
  std::vector<TomlValue> array() const;
  /// A string, or an array of strings that is not empty.
  std::vector<std::string> strings() const;
  TomlTable table() const;

  /// The error that says that this value breaks a rule, to be thrown.
  InputError error(std::string_view rule) const;

 private:
  std::shared_ptr<TomlNode> node_;
};

/// A table of a TOML file; knows which of its keys were asked for.
class TomlTable {
 public:
  explicit TomlTable(std::shared_ptr<TomlNode> node) : node_(std::move(node)) {}

  const std::string& key() const;         ///< in full; empty for the top of the file
  SourceLocation where() const;           ///< line of its header or brace
  std::vector<std::string> keys() const;  ///< in the order of the file

  /// The value of a key; the key counts as known from now on, whether it is there or not. One under
  /// its old name (`kRenamedWords`) is found, too, and noted.
  std::optional<TomlValue> find(std::string_view name) const;
  /// @throws InputError if it is not there
  TomlValue at(std::string_view name) const;
  /// Whether a key is there and true. @throws InputError if it is neither true nor false
  bool is_set(std::string_view name) const;
  /// @throws InputError if it is there and no table
  std::optional<TomlTable> find_table(std::string_view name) const;
  /// An array of tables; empty if it is not there. @throws InputError if it is anything else
  std::vector<TomlTable> find_tables(std::string_view name) const;

  /// Whether the key is there; does not make it known.
  bool contains(std::string_view name) const;

  /// Refuses every key, here and in all tables below, that nobody asked for.
  /// @throws InputError that names the first and the nearest known one
  void check_unused() const;

  /// Old names that were read in this file so far, each with the new one:
  /// "check.toml:3: most_work is now max_work".
  const std::vector<std::string>& notes() const;

 private:
  std::shared_ptr<TomlNode> node_;
};

/// A TOML file.
class TomlDocument {
 public:
  /// @throws InputError if the file cannot be read or is not TOML
  static TomlDocument read(const std::string& path);
  /// @param name  what stands for the file in errors
  static TomlDocument parse(std::string text, std::string name);

  const std::string& text() const { return text_; }
  const std::string& name() const { return name_; }
  const TomlTable& root() const { return root_; }

 private:
  TomlDocument(std::string text, std::string name, TomlTable root)
      : text_(std::move(text)), name_(std::move(name)), root_(std::move(root)) {}

  std::string text_;
  std::string name_;
  TomlTable root_;
};

}  // namespace plastica::io
