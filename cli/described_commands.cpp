#include "cli/described_commands.hpp"

#include <CLI/CLI.hpp>
#include <utility>

namespace plastica::cli {
namespace {

DescribedCommand described(const CLI::App& app) {
  DescribedCommand command{app.get_name(), app.get_description()};
  for (const CLI::Option* option : app.get_options()) {
    DescribedOption one;
    one.takes = option->get_option_text();
    one.meaning = option->get_description();
    one.group = option->get_group();
    one.required = option->get_required();
    if (one.group.empty()) continue;  // kept from the help, too
    if (option->get_positional()) {
      one.names = {one.takes};
      command.arguments.push_back(std::move(one));
      continue;
    }
    for (const std::string& letter : option->get_snames()) one.names.push_back("-" + letter);
    for (const std::string& word : option->get_lnames()) one.names.push_back("--" + word);
    command.options.push_back(std::move(one));
  }
  command.footer = app.get_footer();
  return command;
}

}  // namespace

std::vector<DescribedCommand> described_commands(const CLI::App& app) {
  std::vector<DescribedCommand> commands{described(app)};
  for (const CLI::App* sub : app.get_subcommands({})) commands.push_back(described(*sub));
  return commands;
}

}  // namespace plastica::cli
