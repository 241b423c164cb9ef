#include "plastica/io/toml.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "plastica/io/nearest_word.hpp"
#include "plastica/io/toml_lines.hpp"
#include "plastica/io/units.hpp"

namespace plastica::io {

/// A value with all that an error line needs; toml++'s own tree does not outlive the parsing.
struct TomlNode {
  enum class Kind { Table, Array, String, Integer, Float, Boolean, Date };

  Kind kind = Kind::Table;
  std::shared_ptr<const std::string> file;
  int line = 0;
  std::string key;
  std::string written;  // empty for tables with a header
  std::string string;
  double number = 0.0;
  std::int64_t integer = 0;
  bool boolean = false;
  std::vector<std::shared_ptr<TomlNode>> items;                            // of an array
  std::vector<std::pair<std::string, std::shared_ptr<TomlNode>>> entries;  // of a table
  std::vector<std::string> known;                                          // keys asked for
};

namespace {

using Kind = TomlNode::Kind;

std::string joined(const std::string& table, std::string_view name) {
  return table.empty() ? std::string(name) : table + "." + std::string(name);
}

/// Makes our tree out of toml++'s.
class Builder {
 public:
  Builder(std::string_view text, std::string_view file)
      : lines_(text), file_(std::make_shared<const std::string>(file)) {}

  std::shared_ptr<TomlNode> build(const toml::node& from, std::string key, std::size_t line) const {
    auto node = std::make_shared<TomlNode>();
    node->file = file_;
    node->line = static_cast<int>(line);
    node->key = std::move(key);
    const std::string_view piece = lines_.piece(from.source());
    if (const auto* table = from.as_table()) {
      node->kind = Kind::Table;
      if (table->is_inline()) node->written = piece;
      fill(*node, *table);
    } else if (const auto* array = from.as_array()) {
      node->kind = Kind::Array;
      if (!array->is_array_of_tables() || piece.starts_with("[{")) node->written = piece;
      std::size_t number = 0;
      for (const toml::node& item : *array) {
        node->items.push_back(
            build(item, node->key + "[" + std::to_string(++number) + "]", line_of(item)));
      }
    } else {
      node->written = piece;
      fill_scalar(*node, from);
    }
    return node;
  }

 private:
  static std::size_t line_of(const toml::node& node) { return node.source().begin.line; }

  void fill(TomlNode& node, const toml::table& table) const {
    struct Entry {
      toml::source_position position;
      const toml::key* key;
      const toml::node* value;
    };
    std::vector<Entry> entries;
    for (const auto& [key, value] : table) entries.push_back({key.source().begin, &key, &value});
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.position < b.position; });
    for (const Entry& entry : entries) {
      const std::string name(entry.key->str());
      node.entries.emplace_back(name,
                                build(*entry.value, joined(node.key, name), entry.position.line));
    }
  }

  static void fill_scalar(TomlNode& node, const toml::node& from) {
    node.kind = Kind::Date;
    if (const auto* string = from.as_string()) {
      node.kind = Kind::String;
      node.string = string->get();
    } else if (const auto* integer = from.as_integer()) {
      node.kind = Kind::Integer;
      node.integer = integer->get();
      node.number = static_cast<double>(node.integer);
    } else if (const auto* number = from.as_floating_point()) {
      node.kind = Kind::Float;
      node.number = number->get();
    } else if (const auto* boolean = from.as_boolean()) {
      node.kind = Kind::Boolean;
      node.boolean = boolean->get();
    }
  }

  TomlLines lines_;
  std::shared_ptr<const std::string> file_;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

InputError parse_failure(const toml::parse_error& error, std::string_view text,
                         const std::string& name) {
  std::string why(error.description());
  constexpr std::string_view kPreface = "Error while parsing ";
  if (why.starts_with(kPreface)) why = why.substr(kPreface.size());
  for (char& c : why) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  const auto position = error.source().begin;
  std::string_view line = trimmed(TomlLines(without_byte_order_mark(text)).line(position.line));
  // What is not UTF-8 is not shown: the message must be text.
  if (why.find("utf-8") != std::string::npos) line = {};
  std::string rule = "is not TOML (column " + std::to_string(position.column) + "): " + why;
  if (why.find("expected a comment or whitespace") != std::string::npos) {
    rule += "; words and quantities stand in quotes, \"355 MPa\"";
  }
  return {{name, static_cast<int>(position.line)}, "", line, rule};
}

SourceLocation location(const TomlNode& node) { return {*node.file, node.line}; }

InputError wrong_kind(const TomlNode& node, std::string_view wanted) {
  return {location(node), node.key, node.written, "must be " + std::string(wanted)};
}

std::string text_of(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::shared_ptr<TomlNode> entry_of(const TomlNode& table, std::string_view name) {
  for (const auto& [key, node] : table.entries) {
    if (key == name) return node;
  }
  return nullptr;
}

bool knows(const TomlNode& table, std::string_view name) {
  return std::find(table.known.begin(), table.known.end(), name) != table.known.end();
}

void check_known(const TomlNode& node) {
  for (const auto& item : node.items) check_known(*item);
  for (const auto& [name, value] : node.entries) {
    if (knows(node, name)) {
      check_known(*value);
      continue;
    }
    std::string rule = "is not a key";
    if (!node.key.empty()) rule += " of " + node.key;
    if (const auto nearest = nearest_word(name, node.known)) {
      rule += "; did you mean " + *nearest + "?";
    } else if (!node.known.empty()) {
      rule += "; its keys are ";
      for (const std::string& known : node.known)
        rule += (&known == node.known.data() ? "" : ", ") + known;
    }
    throw InputError(location(*value), value->key, value->written, rule);
  }
}

}  // namespace

const std::string& TomlValue::key() const { return node_->key; }
SourceLocation TomlValue::where() const { return location(*node_); }
const std::string& TomlValue::written() const { return node_->written; }

bool TomlValue::is_string() const { return node_->kind == Kind::String; }
bool TomlValue::is_number() const {
  return node_->kind == Kind::Integer || node_->kind == Kind::Float;
}
bool TomlValue::is_whole() const { return node_->kind == Kind::Integer; }
bool TomlValue::is_boolean() const { return node_->kind == Kind::Boolean; }
bool TomlValue::is_array() const { return node_->kind == Kind::Array; }
bool TomlValue::is_table() const { return node_->kind == Kind::Table; }

const std::string& TomlValue::string() const {
  if (!is_string()) throw wrong_kind(*node_, "a text in quotes");
  if (node_->string.empty()) throw wrong_kind(*node_, "a text that is not empty");
  return node_->string;
}

bool TomlValue::boolean() const {
  if (!is_boolean()) throw wrong_kind(*node_, "true or false");
  return node_->boolean;
}

double TomlValue::number() const {
  if (!is_number()) throw wrong_kind(*node_, "a number without quotes");
  if (!std::isfinite(node_->number)) throw wrong_kind(*node_, "a finite number");
  return node_->number;
}

std::int64_t TomlValue::integer(std::int64_t low, std::int64_t high) const {
  const std::string rule =
      "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
  if (node_->kind != Kind::Integer || node_->integer < low || node_->integer > high) {
    throw wrong_kind(*node_, rule);
  }
  return node_->integer;
}

double TomlValue::number_within(double low, double high, bool closed) const {
  const double value = number();
  const bool inside = closed ? value >= low && value <= high : value > low && value < high;
  if (inside) return value;
  std::string rule;
  if (std::isfinite(low)) rule += (closed ? "at least " : "above ") + text_of(low);
  if (std::isfinite(low) && std::isfinite(high)) rule += " and ";
  if (std::isfinite(high)) rule += (closed ? "at most " : "below ") + text_of(high);
  throw wrong_kind(*node_, rule);
}

std::size_t TomlValue::word(std::span<const std::string_view> words) const {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (is_string() && node_->string == words[i]) return i;
    list += (i == 0 ? "\"" : ", \"") + std::string(words[i]) + "\"";
  }
  throw wrong_kind(*node_, (words.size() > 1 ? "one of " : "") + list);
}

double TomlValue::quantity(Dimension dimension) const {
  if (is_number()) return parse_quantity(text_of(number()), dimension, where(), key());
  if (!is_string()) {
    throw wrong_kind(*node_,
                     "a " + std::string(name_of(dimension)) +
                         (dimension == Dimension::None
                              ? ""
                              : " in quotes, \"1 " + std::string(si_unit(dimension)) + "\""));
  }
  return parse_quantity(string(), dimension, where(), key());
}

std::vector<TomlValue> TomlValue::array() const {
  if (!is_array()) throw wrong_kind(*node_, "a list in brackets");
  std::vector<TomlValue> values;
  values.reserve(node_->items.size());
  for (const auto& item : node_->items) values.emplace_back(item);
  return values;
}

std::vector<std::string> TomlValue::strings() const {
  if (is_string()) return {string()};
  if (!is_array() || node_->items.empty()) {
    throw wrong_kind(*node_, "a text in quotes, or a list of such");
  }
  std::vector<std::string> texts;
  for (const TomlValue& item : array()) texts.push_back(item.string());
  return texts;
}

TomlTable TomlValue::table() const {
  if (!is_table()) throw wrong_kind(*node_, "a table, { key = value, ... }");
  return TomlTable(node_);
}

InputError TomlValue::error(std::string_view rule) const {
  return {where(), key(), is_string() ? node_->string : written(), rule};
}

const std::string& TomlTable::key() const { return node_->key; }
SourceLocation TomlTable::where() const { return location(*node_); }

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> names;
  for (const auto& entry : node_->entries) names.push_back(entry.first);
  return names;
}

bool TomlTable::contains(std::string_view name) const { return entry_of(*node_, name) != nullptr; }

std::optional<TomlValue> TomlTable::find(std::string_view name) const {
  if (!knows(*node_, name)) node_->known.emplace_back(name);
  const auto node = entry_of(*node_, name);
  if (!node) return std::nullopt;
  return TomlValue(node);
}

TomlValue TomlTable::at(std::string_view name) const {
  if (const auto value = find(name)) return *value;
  std::string rule = "is missing";
  const std::vector<std::string> wanted{std::string(name)};
  for (const auto& [key, value] : node_->entries) {
    if (knows(*node_, key) || !nearest_word(key, wanted)) continue;
    rule += "; is it \"" + key + "\" on line " + std::to_string(value->line) + "?";
    break;
  }
  throw InputError(where(), joined(key(), name), "", rule);
}

std::optional<TomlTable> TomlTable::find_table(std::string_view name) const {
  const auto value = find(name);
  if (!value) return std::nullopt;
  if (!value->is_table()) throw value->error("must be a table, [" + value->key() + "]");
  return value->table();
}

std::vector<TomlTable> TomlTable::find_tables(std::string_view name) const {
  const auto value = find(name);
  if (!value) return {};
  const std::string rule =
      "must be a list of tables, each with the header [[" + value->key() + "]]";
  if (!value->is_array()) throw value->error(rule);
  std::vector<TomlTable> tables;
  for (const TomlValue& item : value->array()) {
    if (!item.is_table()) throw value->error(rule);
    tables.push_back(item.table());
  }
  return tables;
}

void TomlTable::check_unused() const { check_known(*node_); }

TomlDocument TomlDocument::read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const int code = errno;
  const bool folder = std::filesystem::is_directory(path);
  if (!file.is_open() || folder) {
    throw InputError({path, 0}, "", "",
                     std::string("cannot be read: ") + std::strerror(folder ? EISDIR : code));
  }
  return parse(std::string(std::istreambuf_iterator<char>(file), {}), path);
}

TomlDocument TomlDocument::parse(std::string text, std::string name) {
  try {
    const std::string_view body = without_byte_order_mark(text);
    const toml::table table = toml::parse(body, std::string_view(name));
    TomlTable root(Builder(body, name).build(table, "", 1));
    return {std::move(text), std::move(name), std::move(root)};
  } catch (const toml::parse_error& error) {
    throw parse_failure(error, text, name);
  }
}

}  // namespace plastica::io
