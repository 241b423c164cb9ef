#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/described_commands.hpp"
#include "cli/exit_code.hpp"
#include "plastica/base/check.hpp"
#include "plastica/base/version.hpp"
#include "plastica/io/text_file.hpp"

namespace plastica::cli {
namespace {

int print_completion(const CLI::App& app, const std::string& shell) {
  fmt::print("{}", completion_for(shell, described_commands(app)));
  return kDone;
}

int print_man_page(const CLI::App& app, const std::string& name, const std::string& folder) {
  const std::vector<DescribedCommand> commands = described_commands(app);
  const std::string of(version());
  for (const DescribedCommand& command : commands) {
    if (folder.empty()) break;
    const auto path = std::filesystem::path(folder) / (man_title(command, commands) + ".1");
    io::write_text_file(path.string(), man_page(command, commands, of));
  }
  if (!folder.empty()) return kDone;
  for (const DescribedCommand& command : commands) {
    if (command.name != (name.empty() ? app.get_name() : name)) continue;
    fmt::print("{}", man_page(command, commands, of));
    return kDone;
  }
  throw InputError({}, "man", name, "is no command");
}

}  // namespace

void add_completion(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("completion", "Print a script that lets a shell complete");
  auto shell = std::make_shared<std::string>();
  sub->add_option("shell", *shell, "bash, zsh or fish")->required()->option_text("SHELL");
  sub->footer(
      "Examples:\n"
      "  source <(plastica completion bash)\n"
      "  plastica completion fish > ~/.config/fish/completions/plastica.fish");
  sub->callback(
      [&app, &action, shell] { action = [&app, shell] { return print_completion(app, *shell); }; });
}

void add_man(CLI::App& app, Action& action) {
  CLI::App* sub = app.add_subcommand("man", "Print the man page of a command");
  auto name = std::make_shared<std::string>();
  auto folder = std::make_shared<std::string>();
  sub->add_option("command", *name, "The command; none: the program")->option_text("COMMAND");
  sub->add_option("--all-to", *folder, "Write the pages of all commands into this folder")
      ->option_text("FOLDER");
  sub->footer(
      "Example:\n"
      "  plastica man calibrate | man -l -");
  sub->callback([&app, &action, name, folder] {
    action = [&app, name, folder] { return print_man_page(app, *name, *folder); };
  });
}

}  // namespace plastica::cli
