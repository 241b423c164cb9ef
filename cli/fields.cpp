#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "plastica/base/check.hpp"
#include "plastica/model/field.hpp"
#include "sweeps/compare/closed_forms.hpp"
#include "sweeps/plan/derived_fields.hpp"

namespace plastica::cli {
namespace {

std::string allowed(const Field& field) {
  if (field.kind == FieldKind::Choice) {
    std::string words;
    for (const auto& choice : field.choices) {
      words += (words.empty() ? "" : "|") + std::string(choice);
    }
    return words;
  }
  const std::string rule = field.range.rule();
  return rule.starts_with("must be ") ? rule.substr(8) : rule;
}

std::string line_of(const Field& field) {
  const bool word = field.kind == FieldKind::Choice;
  return fmt::format("{:<44} {:<7} {:<17} {}; {}{}", field.path,
                     word ? "" : si_unit(field.dimension), default_text(field), allowed(field),
                     field.doc, field.material ? " [fit parameter]" : "");
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  std::ranges::transform(small, small.begin(), [](unsigned char c) { return std::tolower(c); });
  return small;
}

/// Lines under a head, of which those are printed that hold all of the words.
class Search {
 public:
  explicit Search(const std::vector<std::string>& words) {
    for (const std::string& word : words) words_.push_back(in_small_letters(word));
  }

  void begin(std::string head) { head_ = std::move(head); }
  void add(const std::string& line) {
    const std::string small = in_small_letters(line);
    if (!std::ranges::all_of(words_, [&](const auto& w) { return small.find(w) != small.npos; })) {
      return;
    }
    if (!head_.empty()) fmt::print("{}{}\n", found_ > 0 ? "\n" : "", std::exchange(head_, {}));
    fmt::print("{}\n", line);
    ++found_;
  }
  bool has_found() const { return found_ > 0; }

 private:
  std::vector<std::string> words_;
  std::string head_;
  std::size_t found_ = 0;
};

int list_fields(const std::vector<std::string>& words) {
  Search search(words);
  search.begin(
      fmt::format("{:<44} {:<7} {:<17} {}", "field", "unit", "default", "allowed; meaning"));
  for (const Field& field : fields()) search.add(line_of(field));
  search.begin("An axis of a sweep may also move what is derived of them:");
  for (const Field& field : sweeps::derived_fields()) search.add(line_of(field));
  search.begin("Closed forms that a sweep may be compared with, against = \"theory:NAME\":");
  for (const sweeps::ClosedForm& form : sweeps::closed_forms()) {
    search.add(fmt::format("{:<44} {}", form.name, form.doc));
  }
  if (!search.has_found()) {
    throw InputError({}, "fields", fmt::format("{}", fmt::join(words, " ")),
                     "is in no line: `plastica fields` lists all");
  }
  return kDone;
}

}  // namespace

void add_fields(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand(
      "fields", "List every number and word of scenes, with unit, range and default");
  auto words = std::make_shared<std::vector<std::string>>();
  sub->add_option("words", *words, "List those lines alone that have all of these words")
      ->option_text("WORD...");
  sub->footer(
      "Example:\n"
      "  plastica fields break limit\n"
      "Defaults and limits are in the unit shown; files give theirs:\n"
      "yield_stress = \"355 MPa\".");
  sub->callback([&action, words] { action = [words] { return list_fields(*words); }; });
}

}  // namespace plastica::cli
