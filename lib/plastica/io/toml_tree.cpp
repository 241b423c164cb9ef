#include "plastica/io/toml_tree.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <utility>

#include "plastica/io/toml_lines.hpp"

namespace plastica::io {
namespace {

using Kind = TomlNode::Kind;

/// Makes our tree out of toml++'s.
class Builder {
 public:
  explicit Builder(TomlTree& tree) : tree_(tree), lines_(tree.text) {}

  TomlNode& build(const toml::node& from, const TomlNode* above, std::size_t line) {
    TomlNode& node = tree_.nodes.emplace_back();
    node.tree = &tree_;
    node.line = static_cast<int>(line);
    node.above = above;
    const std::string_view piece = lines_.piece(from.source());
    if (const auto* table = from.as_table()) {
      node.kind = Kind::Table;
      if (table->is_inline()) node.written = piece;
      fill(node, *table);
    } else if (const auto* array = from.as_array()) {
      node.kind = Kind::Array;
      if (!array->is_array_of_tables() || piece.starts_with("[{")) node.written = piece;
      node.items.reserve(array->size());
      for (const toml::node& item : *array) {
        TomlNode& built = build(item, &node, item.source().begin.line);
        node.items.push_back(&built);
        built.number = node.items.size();
      }
    } else {
      node.written = piece;
      fill_scalar(node, from);
    }
    return node;
  }

 private:
  void fill(TomlNode& node, const toml::table& table) {
    struct Entry {
      toml::source_position position;
      const toml::key* key;
      const toml::node* value;
    };
    std::vector<Entry> entries;
    entries.reserve(table.size());
    for (const auto& [key, value] : table) entries.push_back({key.source().begin, &key, &value});
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.position < b.position; });
    node.items.reserve(entries.size());
    for (const Entry& entry : entries) {
      TomlNode& built = build(*entry.value, &node, entry.position.line);
      built.name = entry.key->str();
      node.items.push_back(&built);
    }
    node.by_name = node.items;
    std::sort(node.by_name.begin(), node.by_name.end(),
              [](const TomlNode* a, const TomlNode* b) { return a->name < b->name; });
  }

  static void fill_scalar(TomlNode& node, const toml::node& from) {
    node.kind = Kind::Date;
    if (const auto* string = from.as_string()) {
      node.kind = Kind::String;
      node.string = string->get();
    } else if (const auto* integer = from.as_integer()) {
      node.kind = Kind::Integer;
      node.integer = integer->get();
      node.real = static_cast<double>(node.integer);
    } else if (const auto* number = from.as_floating_point()) {
      node.kind = Kind::Float;
      node.real = number->get();
    } else if (const auto* boolean = from.as_boolean()) {
      node.kind = Kind::Boolean;
      node.boolean = boolean->get();
    }
  }

  TomlTree& tree_;
  TomlLines lines_;
};

std::string full_key(const TomlNode& node) {
  if (node.above == nullptr) return {};
  const std::string above = full_key(*node.above);
  if (node.above->kind == Kind::Array) return above + "[" + std::to_string(node.number) + "]";
  return joined_key(above, node.name);
}

}  // namespace

std::shared_ptr<TomlNode> toml_tree(std::string_view text, const std::string& file) {
  const auto tree = std::make_shared<TomlTree>(TomlTree{file, std::string(text), {}, {}});
  const toml::table table = toml::parse(tree->text, std::string_view(file));
  TomlNode& top = Builder(*tree).build(table, nullptr, 1);
  return {tree, &top};
}

const TomlNode::Shown& shown_of(TomlNode& node) {
  if (!node.shown) {
    node.shown = std::make_unique<TomlNode::Shown>(
        TomlNode::Shown{full_key(node), std::string(node.written)});
  }
  return *node.shown;
}

TomlNode* entry_of(const TomlNode& table, std::string_view name) {
  if (table.kind != Kind::Table) return nullptr;
  const auto found =
      std::lower_bound(table.by_name.begin(), table.by_name.end(), name,
                       [](const TomlNode* node, std::string_view n) { return node->name < n; });
  return found != table.by_name.end() && (*found)->name == name ? *found : nullptr;
}

std::string joined_key(const std::string& table, std::string_view name) {
  // A quoted key may be empty: an error line shows its quotes.
  const std::string shown = name.empty() ? "\"\"" : std::string(name);
  return table.empty() ? shown : table + "." + shown;
}

}  // namespace plastica::io
