#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>
#include <string>
#include <vector>

#include "cli/described_commands.hpp"
#include "plastica/base/check.hpp"

namespace plastica::cli {
namespace {

std::vector<std::string> names_of(std::span<const DescribedCommand> commands) {
  std::vector<std::string> names{"help"};
  for (const DescribedCommand& command : commands) names.push_back(command.name);
  return names;
}

std::vector<std::string> options_of(const DescribedCommand& command) {
  std::vector<std::string> all;
  for (const DescribedOption& option : command.options) {
    all.insert(all.end(), option.names.begin(), option.names.end());
  }
  return all;
}

/// In single quotes, as all three shells take it.
std::string quoted(const std::string& text) {
  std::string all = "'";
  for (const char c : text) all += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return all + "'";
}

std::string for_bash(const DescribedCommand& program, std::span<const DescribedCommand> commands) {
  std::string cases;
  for (const DescribedCommand& command : commands) {
    cases +=
        fmt::format("    {}) options='{}' ;;\n", command.name, fmt::join(options_of(command), " "));
  }
  const std::string names = fmt::format("{}", fmt::join(names_of(commands), " "));
  return fmt::format(
      R"(# Completion of plastica for bash: source it, or put it where bash-completion looks.
_plastica() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} options=
  local commands='{}'
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W "$commands {}" -- "$word")
    return
  fi
  case ${{COMP_WORDS[1]}} in
    help) options=$commands ;;
{}  esac
  if [ "${{COMP_WORDS[1]}}" = help ] || [ "${{word#-}}" != "$word" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  else
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}}
complete -F _plastica plastica
)",
      names, fmt::join(options_of(program), " "), cases);
}

/// What _arguments of zsh takes of an option.
std::string zsh_option(const DescribedOption& option) {
  std::string meaning;
  for (const char c : option.meaning) {
    if (c == '[' || c == ']' || c == ':') meaning += '\\';
    meaning += c;
  }
  const std::string takes = option.takes.empty() ? "" : ":" + option.takes + ":_files";
  std::string text;
  for (const std::string& name : option.names) {
    text += fmt::format(" \\\n        {}", quoted(fmt::format("{}[{}]{}", name, meaning, takes)));
  }
  return text;
}

std::string for_zsh(std::span<const DescribedCommand> commands) {
  std::string names;
  std::string cases;
  for (const DescribedCommand& command : commands) {
    names += fmt::format("    {}\n", quoted(command.name + ":" + command.meaning));
    cases += fmt::format("    {})\n      _arguments -S", command.name);
    for (const DescribedOption& option : command.options) cases += zsh_option(option);
    cases += " \\\n        '*:file:_files' ;;\n";
  }
  return fmt::format(R"(#compdef plastica
# Completion of plastica for zsh: put it as _plastica into a folder of fpath.
_plastica() {{
  local -a commands
  commands=(
    'help:Print the help of a command'
{})
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  local command=$words[2]
  (( CURRENT-- ))
  shift words
  case $command in
    help) _describe command commands ;;
{}  esac
}}
_plastica "$@"
)",
                     names, cases);
}

std::string for_fish(std::span<const DescribedCommand> commands) {
  std::string text =
      "# Completion of plastica for fish: put it into ~/.config/fish/completions.\n"
      "complete -c plastica -n __fish_use_subcommand -f -a help -d 'Print the help of a command'\n";
  for (const DescribedCommand& command : commands) {
    text += fmt::format("complete -c plastica -n __fish_use_subcommand -f -a {} -d {}\n",
                        command.name, quoted(command.meaning));
    for (const DescribedOption& option : command.options) {
      text += fmt::format("complete -c plastica -n '__fish_seen_subcommand_from {}'", command.name);
      for (const std::string& name : option.names) {
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      }
      text += fmt::format("{} -d {}\n", option.takes.empty() ? "" : " -r", quoted(option.meaning));
    }
  }
  return text;
}

}  // namespace

std::string completion_for(const std::string& shell, const std::vector<DescribedCommand>& all) {
  const std::span<const DescribedCommand> commands = std::span(all).subspan(1);
  if (shell == "bash") return for_bash(all.front(), commands);
  if (shell == "zsh") return for_zsh(commands);
  if (shell == "fish") return for_fish(commands);
  throw InputError({}, "completion", shell, "must be bash, zsh or fish");
}

}  // namespace plastica::cli
