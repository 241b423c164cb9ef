#include <fmt/format.h>

#include <sstream>
#include <string>
#include <vector>

#include "cli/described_commands.hpp"

namespace plastica::cli {
namespace {

/// Text that troff prints as it is.
std::string troff(const std::string& text) {
  std::string all;
  for (const char c : text) {
    const bool begins_line = all.empty() || all.back() == '\n';
    if (begins_line && (c == '.' || c == '\'')) all += "\\&";
    if (c == '\\') {
      all += "\\e";
    } else if (c == '-') {
      all += "\\-";  // else a typesetter makes a hyphen of it, which no shell takes
    } else {
      all += c;
    }
  }
  return all;
}

std::string bold(const std::string& text) { return "\\fB" + troff(text) + "\\fR"; }
std::string slanted(const std::string& text) { return "\\fI" + troff(text) + "\\fR"; }

std::string option_text(const DescribedOption& option) {
  std::string names;
  for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + bold(name);
  if (!option.takes.empty()) names += " " + slanted(option.takes);
  return fmt::format(".TP\n{}\n{}.\n", names, troff(option.meaning));
}

std::string options_text(const DescribedCommand& command) {
  std::string text;
  std::string group;
  for (const DescribedOption& option : command.options) {
    if (option.group != group && option.group != "Options") {
      text += fmt::format(".SS {}\n", troff(option.group));
    } else if (text.empty()) {
      text += ".SH OPTIONS\n";
    }
    group = option.group;
    text += option_text(option);
  }
  return text;
}

/// What stands behind the options in the help: examples keep their lines.
std::string footer_text(const std::string& footer) {
  if (footer.empty()) return {};
  std::string text = ".SH NOTES\n";
  std::istringstream lines(footer);
  bool in_example = false;
  for (std::string line; std::getline(lines, line);) {
    const bool example = line.starts_with("  ");
    if (example != in_example) text += example ? ".PP\n.nf\n" : ".fi\n.PP\n";
    in_example = example;
    text += troff(line) + '\n';
  }
  return text + (in_example ? ".fi\n" : "");
}

std::string arguments_text(const DescribedCommand& command) {
  std::string text;
  for (const DescribedOption& argument : command.arguments) {
    text +=
        argument.required ? " " + slanted(argument.takes) : " [" + slanted(argument.takes) + "]";
  }
  return text;
}

}  // namespace

std::string man_title(const DescribedCommand& command,
                      const std::vector<DescribedCommand>& commands) {
  const std::string& program = commands.front().name;
  return command.name == program ? program : program + "-" + command.name;
}

std::string man_page(const DescribedCommand& command, const std::vector<DescribedCommand>& commands,
                     const std::string& version) {
  const DescribedCommand& program = commands.front();
  const bool whole = &command == &program;
  std::string title = man_title(command, commands);
  for (char& c : title) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  std::string text =
      fmt::format(".TH {} 1 \"\" \"plastica {}\" \"Plastica\"\n", troff(title), version);
  text += fmt::format(".SH NAME\n{} \\- {}\n", troff(man_title(command, commands)),
                      troff(command.meaning));
  text +=
      fmt::format(".SH SYNOPSIS\n{}{}{} [\\fIOPTION\\fR...]\n", bold(program.name),
                  whole ? " \\fICOMMAND\\fR" : " " + bold(command.name), arguments_text(command));
  if (!command.arguments.empty()) text += ".SH ARGUMENTS\n";
  for (const DescribedOption& argument : command.arguments) {
    text += fmt::format(".TP\n{}\n{}.\n", slanted(argument.takes), troff(argument.meaning));
  }
  text += options_text(command);
  if (whole) {
    text += ".SH COMMANDS\n";
    for (std::size_t i = 1; i < commands.size(); ++i) {
      text += fmt::format(".TP\n{}\n{}.\n", bold(commands[i].name), troff(commands[i].meaning));
    }
  }
  text += footer_text(command.footer);
  text += ".SH SEE ALSO\n";
  if (whole) {
    for (std::size_t i = 1; i < commands.size(); ++i) {
      text += fmt::format(".BR {} (1){}\n", troff(man_title(commands[i], commands)),
                          i + 1 < commands.size() ? "," : "");
    }
  } else {
    text += fmt::format(".BR {} (1)\n", program.name);
  }
  return text;
}

}  // namespace plastica::cli
