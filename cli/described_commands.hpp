#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): of the library CLI11
class App;
}

/// What the parser of the command line knows of the commands, as `--help` shows it: completions and
/// man pages are made of it.
namespace plastica::cli {

struct DescribedOption {
  std::vector<std::string> names;  ///< "-o", "--output"; of an argument what it takes
  std::string takes{};             ///< "FILE"; empty: nothing
  std::string meaning{};
  std::string group{};  ///< the heading under which it stands
  bool required = false;
};

struct DescribedCommand {
  std::string name;  ///< "calibrate"; of the program itself "plastica"
  std::string meaning{};
  std::vector<DescribedOption> arguments{};  ///< without a name of their own
  std::vector<DescribedOption> options{};
  std::string footer{};  ///< examples, exit codes
};

/// The program, then its commands.
std::vector<DescribedCommand> described_commands(const CLI::App& app);

/// A script that completes commands, options and names of files. @param shell  bash, zsh or fish
/// @throws InputError for another
std::string completion_for(const std::string& shell, const std::vector<DescribedCommand>& commands);

/// "plastica-calibrate", of the program "plastica": what the page of a command is called.
std::string man_title(const DescribedCommand& command,
                      const std::vector<DescribedCommand>& commands);

/// The man page of a command, in troff with the macros of man(7).
/// @param commands  all of them, the program first
/// @param version   of the program
std::string man_page(const DescribedCommand& command, const std::vector<DescribedCommand>& commands,
                     const std::string& version);

}  // namespace plastica::cli
