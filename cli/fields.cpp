#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "cli/command.hpp"
#include "cli/exit_code.hpp"
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

void print_field(const Field& field) {
  const bool word = field.kind == FieldKind::Choice;
  fmt::print("{:<44} {:<7} {:<17} {}; {}{}\n", field.path, word ? "" : si_unit(field.dimension),
             default_text(field), allowed(field), field.doc,
             field.material ? " [fit parameter]" : "");
}

int list_fields() {
  fmt::print("{:<44} {:<7} {:<17} {}\n", "field", "unit", "default", "allowed; meaning");
  for (const Field& field : fields()) print_field(field);
  fmt::print("\nAn axis of a sweep may also move what is derived of them:\n");
  for (const Field& field : sweeps::derived_fields()) print_field(field);
  fmt::print("\nClosed forms that a sweep may be compared with, against = \"theory:NAME\":\n");
  for (const sweeps::ClosedForm& form : sweeps::closed_forms()) {
    fmt::print("{:<44} {}\n", form.name, form.doc);
  }
  return kDone;
}

}  // namespace

void add_fields(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand(
      "fields", "List every name that a file may use, with unit, range and default");
  sub->footer(
      "Example:\n"
      "  plastica fields | grep break\n"
      "Defaults and limits are in the unit shown; files give theirs:\n"
      "yield_stress = \"355 MPa\".");
  sub->callback([&action] { action = list_fields; });
}

}  // namespace plastica::cli
