#include "plastica/io/toml_edit.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

#include "plastica/base/renamed.hpp"
#include "plastica/io/toml.hpp"
#include "plastica/io/toml_layout.hpp"
#include "plastica/io/toml_lines.hpp"
#include "plastica/io/toml_scan.hpp"

namespace plastica::io {
namespace {

/// One name of a path, with the element's number for "name[2]".
struct Step {
  std::string name;
  std::size_t element = 0;  // from 1; 0 for none
};

using Steps = std::vector<Step>;

/// Some steps as they are written in a path or as a dotted key.
std::string text_of(Steps::const_iterator first, Steps::const_iterator last) {
  std::string text;
  for (; first != last; ++first) {
    text = joined_path(std::move(text), first->name);
    if (first->element > 0) text = with_element(std::move(text), first->element);
  }
  return text;
}

Steps steps_of(std::string_view path) {
  const InputError error({}, path, "", "must be names with points between, beam.segments");
  Steps steps;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    std::string_view name = path.substr(begin, end - begin);
    Step step;
    if (name.ends_with(']')) {
      const std::size_t bracket = std::min(name.find('['), name.size() - 1);
      const char* last = name.data() + name.size() - 1;
      const auto read = std::from_chars(name.data() + bracket + 1, last, step.element);
      if (read.ec != std::errc() || read.ptr != last || step.element == 0) throw error;
      name = name.substr(0, bracket);
    }
    const auto bare = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
             c == '_' || c == '-';
    };
    if (name.empty() || !std::all_of(name.begin(), name.end(), bare)) throw error;
    step.name = name;
    steps.push_back(std::move(step));
    begin = end + 1;
  }
  return steps;
}

/// How far a path leads into the tree.
struct Descent {
  const toml::node* end = nullptr;      // the last node there is
  std::size_t steps = 0;                // that lead to it
  const toml::table* braces = nullptr;  // the innermost inline table on the way
  std::size_t steps_to_braces = 0;
};

Descent descend(const toml::table& root, const Steps& steps) {
  Descent found{&root};
  for (const Step& step : steps) {
    const auto so_far = [&] {
      return text_of(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(found.steps));
    };
    const toml::table* table = found.end->as_table();
    if (table == nullptr) {
      const bool list = found.end->is_array();
      throw InputError(
          {}, so_far(), "",
          list ? "is a list: name the element, " + with_element(so_far(), 1) : "is no table");
    }
    if (table->is_inline()) {
      found.braces = table;
      found.steps_to_braces = found.steps;
    }
    const toml::node* next = table->get(step.name);
    const std::string_view before = old_name(kRenamedWords, step.name);
    if (next == nullptr && !before.empty()) next = table->get(before);
    if (step.element > 0) {
      const toml::array* list = next == nullptr ? nullptr : next->as_array();
      if (list == nullptr || step.element > list->size()) {
        throw InputError({}, joined_path(so_far(), step.name), "",
                         "has no element " + std::to_string(step.element));
      }
      next = list->get(step.element - 1);
    }
    if (next == nullptr) break;
    found.end = next;
    ++found.steps;
  }
  return found;
}

/// Checks that a text is one TOML value and nothing more.
std::string checked_value(std::string_view value, std::string_view path) {
  const std::size_t first = value.find_first_not_of(" \t");
  if (first != std::string_view::npos) {
    value = value.substr(first, value.find_last_not_of(" \t") - first + 1);
  }
  const std::string line = "x = " + std::string(value);
  try {
    scan_toml(line, "");
    const toml::table table = toml::parse(line);
    const toml::node* node = table.get("x");
    if (table.size() == 1 && node != nullptr && TomlLines(line).piece(node->source()) == value) {
      return std::string(value);
    }
  } catch (const toml::parse_error&) {  // as any other that is no value
  } catch (const InputError&) {
  }
  throw InputError({}, path, value, "is not a TOML value");
}

/// Sets values in a text that is known to be TOML, without byte order mark.
class Editor {
 public:
  explicit Editor(std::string_view text)
      : text_(text),
        layout_(text),
        line_end_(text.find("\r\n") == std::string_view::npos ? "\n" : "\r\n") {}

  std::string set(const Steps& steps, const std::string& value) const {
    const Descent found = descend(layout_.root(), steps);
    if (found.steps == steps.size()) {
      if (!is_written_value(*found.end)) {
        throw InputError({}, text_of(steps.begin(), steps.end()), value,
                         "is a table and cannot become a value");
      }
      const toml::source_region& region = found.end->source();
      const std::size_t begin = layout_.lines().offset(region.begin);
      return replaced(begin, layout_.lines().offset(region.end) - begin, value);
    }
    const toml::table* table = found.end->as_table();
    if (table->is_inline()) return add_inside(*table, key_from(steps, found.steps), value);
    if (found.braces != nullptr) {
      return add_inside(*found.braces, key_from(steps, found.steps_to_braces), value);
    }
    return add_line(*table, steps, found.steps, value);
  }

 private:
  static std::string key_from(const Steps& steps, std::size_t first) {
    return text_of(steps.begin() + static_cast<std::ptrdiff_t>(first), steps.end());
  }

  std::string replaced(std::size_t begin, std::size_t size, std::string_view with) const {
    std::string text(text_);
    return text.replace(begin, size, with);
  }

  std::string add_inside(const toml::table& braces, const std::string& key,
                         const std::string& value) const {
    const std::size_t close = layout_.lines().offset(braces.source().end) - 1;
    const std::size_t last = text_.find_last_not_of(" \t", close - 1);
    const std::string entry = key + " = " + value;
    if (text_[last] == '{') return replaced(last + 1, close - last - 1, " " + entry + " ");
    return replaced(last + 1, 0, ", " + entry);
  }

  /// @param there  how many steps lead to the table
  std::string add_line(const toml::table& table, const Steps& steps, std::size_t there,
                       const std::string& value) const {
    const auto end = steps.begin() + static_cast<std::ptrdiff_t>(there);
    const std::string path = text_of(steps.begin(), end);
    const std::string line = key_from(steps, there) + " = " + value;
    const TomlSection* own = layout_.section_of(path);
    if (own == nullptr) {
      const TomlSection* above = layout_.section_above(table, path);
      if (above != nullptr) return below(*above, key_below(*above, steps) + " = " + value);
      return add_header(Steps(steps.begin(), end), *layout_.first_below(path), line);
    }
    // A header names no element of a list but the last one so far: there a dotted key it is.
    const bool in_list =
        std::any_of(steps.begin(), end, [](const Step& s) { return s.element > 0; });
    if (there + 1 == steps.size() || in_list) return below(*own, line);
    return add_table(text_of(steps.begin(), steps.end() - 1), steps.back().name + " = " + value);
  }

  /// The dotted key of a path that begins where a section's path ends.
  static std::string key_below(const TomlSection& section, const Steps& steps) {
    const std::string path = text_of(steps.begin(), steps.end());
    return path.substr(section.path.empty() ? 0 : section.path.size() + 1);
  }

  /// A line more behind a section's values.
  std::string below(const TomlSection& section, const std::string& line) const {
    if (!section.path.empty() || section.values_end > 1) {
      return inserted(section.values_end, section.indent + line + line_end_);
    }
    // Above all headers, and without a value to follow.
    if (layout_.sections().size() == 1) {
      return inserted(layout_.lines().count() + 1, line + line_end_);
    }
    return inserted(with_comment(layout_.sections()[1].first), line + line_end_ + line_end_);
  }

  /// A header for a table that has headers of its own tables alone, before the first of these.
  std::string add_header(Steps table, const TomlSection& before, const std::string& line) const {
    for (Step& step : table) step.element = 0;
    return inserted(with_comment(before.first), "[" + text_of(table.begin(), table.end()) + "]" +
                                                    line_end_ + line + line_end_ + line_end_);
  }

  /// The first line of the comment that stands right above a line.
  std::size_t with_comment(std::size_t number) const {
    while (number > 1 && layout_.lines().line(number - 1).starts_with('#')) --number;
    return number;
  }

  std::string add_table(const std::string& path, const std::string& line) const {
    const auto& sections = layout_.sections();
    const auto list = std::find_if(sections.begin(), sections.end(),
                                   [](const TomlSection& section) { return section.of_list; });
    const TomlSection& before = *std::prev(list);
    // The top holds comments alone where it has no values: the table follows them at the end.
    const bool empty_top = before.path.empty() && before.values_end == 1;
    const std::string lines = "[" + path + "]" + line_end_ + line + line_end_;
    if (!empty_top) return inserted(before.values_end, line_end_ + lines);
    if (list == sections.end()) {
      const bool blank = text_.find_first_not_of(" \t\r\n") == std::string_view::npos;
      return inserted(layout_.lines().count() + 1, (blank ? "" : line_end_) + lines);
    }
    return inserted(with_comment(list->first), lines + line_end_);
  }

  /// Whole lines before the line of a number.
  std::string inserted(std::size_t number, std::string lines) const {
    const std::size_t at = layout_.lines().start(number);
    // The last line may lack its end.
    if (at == text_.size() && at > 0 && text_.back() != '\n') lines.insert(0, line_end_);
    return replaced(at, 0, lines);
  }

  std::string_view text_;
  TomlLayout layout_;
  std::string line_end_;
};

/// @throws InputError if the text is not TOML
std::string_view checked_text(std::string_view text) {
  TomlDocument::parse(std::string(text), "");
  return without_byte_order_mark(text);
}

}  // namespace

bool has_toml_key(std::string_view text, std::string_view path) {
  const std::string_view checked = checked_text(text);
  const Steps steps = steps_of(path);
  const toml::table root = toml::parse(checked);
  const toml::node* node = &root;
  for (const Step& step : steps) {
    const toml::table* table = node->as_table();
    node = table == nullptr ? nullptr : table->get(step.name);
    if (node != nullptr && step.element > 0) {
      const toml::array* list = node->as_array();
      node = list == nullptr ? nullptr : list->get(step.element - 1);
    }
    if (node == nullptr) return false;
  }
  return true;
}

std::string set_toml_value(std::string_view text, std::string_view path, std::string_view value) {
  const Steps steps = steps_of(path);
  const std::string written = checked_value(value, path);
  const std::string_view checked = checked_text(text);
  const std::string mark(text.substr(0, text.size() - checked.size()));
  return mark + Editor(checked).set(steps, written);
}

}  // namespace plastica::io
