#include "plastica/io/toml.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "plastica/base/renamed.hpp"
#include "plastica/io/nearest_word.hpp"
#include "plastica/io/read_input.hpp"
#include "plastica/io/toml_lines.hpp"
#include "plastica/io/toml_scan.hpp"
#include "plastica/io/toml_tree.hpp"
#include "plastica/io/units.hpp"

namespace plastica::io {

namespace {

using Kind = TomlNode::Kind;

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

SourceLocation location(const TomlNode& node) { return {node.tree->file, node.line}; }

InputError wrong_kind(TomlNode& node, std::string_view wanted) {
  return {location(node), shown_of(node).key, node.written, "must be " + std::string(wanted)};
}

std::string text_of(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

/// A node of the tree that another one holds.
std::shared_ptr<TomlNode> held_by(const std::shared_ptr<TomlNode>& holder, TomlNode* node) {
  return {holder, node};
}

/// Notes an old name that was read, for the user.
void note_renamed(const TomlNode& node, std::string_view before, std::string_view now) {
  std::string line = node.tree->file + ':' + std::to_string(node.line) + ": ";
  line.append(before).append(" is now ").append(now);
  std::vector<std::string>& notes = node.tree->notes;
  if (std::find(notes.begin(), notes.end(), line) == notes.end()) notes.push_back(std::move(line));
}

/// The entry of a table under its name, or under the name that it had before.
TomlNode* entry_now_or_before(const TomlNode& table, std::string_view name) {
  TomlNode* entry = entry_of(table, name);
  const std::string_view before = old_name(kRenamedWords, name);
  TomlNode* old = before.empty() ? nullptr : entry_of(table, before);
  if (old == nullptr) return entry;
  if (entry != nullptr) {
    throw InputError(location(*old), shown_of(*old).key, old->written,
                     "is the old name of " + std::string(name) + ", which is there, too");
  }
  note_renamed(*old, before, name);
  return old;
}

void check_known(TomlNode& node) {
  for (TomlNode* item : node.items) {
    if (node.kind == Kind::Array || item->is_known) {
      check_known(*item);
      continue;
    }
    const std::string& key = shown_of(node).key;
    std::string rule = "is not a key";
    if (!key.empty()) rule += " of " + key;
    if (const auto nearest = nearest_word(item->name, node.known)) {
      rule += "; did you mean " + *nearest + "?";
    } else if (!node.known.empty()) {
      rule += "; its keys are ";
      for (const std::string& known : node.known)
        rule += (&known == node.known.data() ? "" : ", ") + known;
    }
    throw InputError(location(*item), shown_of(*item).key, item->written, rule);
  }
}

}  // namespace

const std::string& TomlValue::key() const { return shown_of(*node_).key; }
SourceLocation TomlValue::where() const { return location(*node_); }
const std::string& TomlValue::written() const { return shown_of(*node_).written; }

bool TomlValue::is_string() const { return node_->kind == Kind::String; }
bool TomlValue::is_number() const {
  return node_->kind == Kind::Integer || node_->kind == Kind::Float;
}
bool TomlValue::is_integer() const { return node_->kind == Kind::Integer; }
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
  if (!std::isfinite(node_->real)) throw wrong_kind(*node_, "a finite number");
  return node_->real;
}

std::int64_t TomlValue::integer(std::int64_t low, std::int64_t high) const {
  const std::string rule = "an integer from " + std::to_string(low) + " to " + std::to_string(high);
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
  if (is_string()) {
    const std::string_view now = new_name(kRenamedWords, node_->string);
    const auto renamed = std::find(words.begin(), words.end(), now);
    if (now != node_->string && renamed != words.end()) {
      note_renamed(*node_, node_->string, now);
      return static_cast<std::size_t>(renamed - words.begin());
    }
  }
  throw wrong_kind(*node_, (words.size() > 1 ? "one of " : "") + list);
}

std::string TomlValue::new_path(std::string_view path) const {
  std::string now = plastica::new_path(path);
  if (now != path) note_renamed(*node_, path, now);
  return now;
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
  for (TomlNode* item : node_->items) values.emplace_back(held_by(node_, item));
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
  return {where(), key(), is_string() ? std::string_view(node_->string) : node_->written, rule};
}

const std::string& TomlTable::key() const { return shown_of(*node_).key; }
SourceLocation TomlTable::where() const { return location(*node_); }

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> names;
  names.reserve(node_->items.size());
  for (const TomlNode* item : node_->items) names.push_back(item->name);
  return names;
}

bool TomlTable::contains(std::string_view name) const {
  return entry_now_or_before(*node_, name) != nullptr;
}

std::optional<TomlValue> TomlTable::find(std::string_view name) const {
  TomlNode* entry = entry_now_or_before(*node_, name);
  std::vector<std::string>& known = node_->known;
  const bool is_known = entry != nullptr
                            ? std::exchange(entry->is_known, true)
                            : std::find(known.begin(), known.end(), name) != known.end();
  if (!is_known) known.emplace_back(name);
  if (entry == nullptr) return std::nullopt;
  return TomlValue(held_by(node_, entry));
}

TomlValue TomlTable::at(std::string_view name) const {
  if (const auto value = find(name)) return *value;
  std::string rule = "is missing";
  const std::vector<std::string> wanted{std::string(name)};
  for (const TomlNode* item : node_->items) {
    if (item->is_known || !nearest_word(item->name, wanted)) continue;
    rule += "; is it \"" + item->name + "\" on line " + std::to_string(item->line) + "?";
    break;
  }
  throw InputError(where(), joined_key(key(), name), "", rule);
}

bool TomlTable::is_set(std::string_view name) const {
  const auto value = find(name);
  return value && value->boolean();
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

const std::vector<std::string>& TomlTable::notes() const { return node_->tree->notes; }

TomlDocument TomlDocument::read(const std::string& path) {
  return parse(read_input(path, kMaxTomlBytes), path);
}

TomlDocument TomlDocument::parse(std::string text, std::string name) {
  refuse_binary(text, name);
  const std::string_view body = without_byte_order_mark(text);
  scan_toml(body, name);
  try {
    TomlTable root(toml_tree(body, name));
    return {std::move(text), std::move(name), std::move(root)};
  } catch (const toml::parse_error& error) {
    throw parse_failure(error, text, name);
  }
}

}  // namespace plastica::io
