#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/help_format.hpp"
#include "cli/input_kind.hpp"
#include "cli/run_team.hpp"
#include "cli/tell.hpp"
#include "cli/terminal.hpp"
#include "plastica/base/check.hpp"
#include "plastica/base/keep_freed_memory.hpp"
#include "plastica/base/team.hpp"
#include "plastica/base/version.hpp"
#include "plastica/io/nearest_word.hpp"

namespace {

using plastica::cli::Action;

constexpr const char* kFooter =
    "Examples:\n"
    "  plastica inspect specimen.csv          what is in the file; the block to paste\n"
    "  plastica init fit                      a commented fit file that runs as it is\n"
    "  plastica calibrate fit.toml -o fit.h5  fit every target\n"
    "  plastica show fit.h5                   the report\n"
    "  plastica plot fit.h5 -o fit.svg        the picture\n"
    "  plastica simulate scene.toml -o s.h5   what a beam does under its loads\n"
    "  plastica advise scene.toml --within \"1 %\"\n"
    "                                         how fine it must be, and its cost\n"
    "  plastica sweep sweep.toml -o sweep.h5  vary a scene: what accuracy costs\n"
    "  plastica recommend sweep.h5 --within \"1 %\"\n"
    "  plastica check check.toml              check claims on accuracy, for CI\n"
    "  plastica diff a.h5 b.h5 --within 1e-6  compare two results\n"
    "Exit codes: 0 done; 1 a target has no usable fit, a scene no equilibrium or\n"
    "balance, a claim does not hold, or results differ; 2 bad input; 3 the machine\n"
    "failed; 130 interrupted by Ctrl-C (what was finished is kept).\n"
    "`plastica help COMMAND` says more.";

void add_commands(CLI::App& app, const plastica::cli::Invocation& invocation,
                  const plastica::cli::RunAgain& run, Action& action) {
  plastica::cli::add_calibrate(app, invocation, action);
  plastica::cli::add_inspect(app, action);
  plastica::cli::add_init(app, action);
  plastica::cli::add_simulate(app, invocation, action);
  plastica::cli::add_sweep(app, invocation, action);
  plastica::cli::add_merge(app, run, action);
  plastica::cli::add_check(app, invocation, action);
  plastica::cli::add_advise(app, action);
  plastica::cli::add_recommend(app, action);
  plastica::cli::add_stability(app, invocation, action);
  plastica::cli::add_diff(app, action);
  plastica::cli::add_show(app, action);
  plastica::cli::add_plot(app, action);
  plastica::cli::add_report(app, action);
  plastica::cli::add_export(app, action);
  plastica::cli::add_fields(app, action);
  plastica::cli::add_completion(app, action);
  plastica::cli::add_man(app, action);
}

/// One line, whatever a file is called.
std::string in_one_line(std::string what) {
  std::replace(what.begin(), what.end(), '\n', ' ');
  return what;
}

int complain(const std::string& what, int code) {
  plastica::cli::tell("plastica: {}\n", in_one_line(what));
  return code;
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands({})) names.push_back(sub->get_name());
  return names;
}

/// What is wrong with a first word that should be a command; empty: nothing.
std::string wrong_command(const CLI::App& app, std::string_view first) {
  if (first.empty() || first.front() == '-') return {};
  const std::vector<std::string> names = names_of_commands(app);
  if (std::find(names.begin(), names.end(), first) != names.end()) return {};
  if (const std::string command = plastica::cli::command_for(std::string(first));
      !command.empty()) {
    return fmt::format("{0}: is a file, and no command: plastica {1} {0}", first, command);
  }
  const auto nearest = plastica::io::nearest_word(first, names);
  return fmt::format("{}: is not a command; {}", first,
                     nearest ? "did you mean " + *nearest + "?"
                             : fmt::format("there are {}", fmt::join(names, ", ")));
}

/// `plastica` and `plastica help` as `plastica --help`, `plastica help plot` as `plastica plot
/// --help`.
std::vector<std::string> with_help_as_option(std::vector<std::string> words) {
  if (words.empty()) return {"--help"};
  if (words.front() != "help") return words;
  words.erase(words.begin());
  words.emplace_back("--help");
  return words;
}

/// What is wrong where an argument is empty, as a shell makes of a variable that is not set; empty:
/// none is.
std::string empty_argument(const std::vector<std::string>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word.starts_with("--") && word.ends_with('=')) {
      return word.substr(0, word.size() - 1) + ": is empty";
    }
    if (!word.empty()) continue;
    const std::string behind = i > 0 ? ", behind " + words[i - 1] : "";
    return fmt::format("argument {}{}: is empty", i + 1, behind);
  }
  return {};
}

/// What is wrong with the command line, in a line. @param first  a command, an option, or nothing
std::string rule_of(const CLI::ParseError& error, std::string_view first) {
  const bool named = !first.empty() && first.front() != '-';
  return fmt::format("{} (see plastica {}--help)", error.what(),
                     named ? std::string(first) + " " : "");
}

/// A full disk shows no earlier than when the last byte is written.
int finish_output(int code) {
  std::cout.flush();
  const bool failed = std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout;
  return failed ? complain("standard output: cannot be written", plastica::cli::kMachineFailed)
                : code;
}

/// @param words   of the command line, the command first
/// @param merged, team  see `Invocation`
int run(std::vector<std::string> words, const plastica::io::MergedShards* merged,
        plastica::cli::RunTeam* team) {
  CLI::App app{"Fit lumped beams of rigid segments to measured curves, and simulate them",
               "plastica"};
  app.set_version_flag("-V,--version", std::string(plastica::version()), "Print the version");
  app.require_subcommand(1);
  app.formatter(std::make_shared<plastica::cli::HelpFormat>());
  app.get_formatter()->label("Positionals", "Arguments");
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.set_help_flag("-h,--help", "Print this help");
  app.footer(kFooter);
  const plastica::cli::Invocation invocation{fmt::format("plastica {}", fmt::join(words, " ")),
                                             merged, team};
  const plastica::cli::RunAgain run_again = [](const std::vector<std::string>& others,
                                               const plastica::io::MergedShards& shards) {
    return run(others, &shards, nullptr);
  };
  Action action;
  add_commands(app, invocation, run_again, action);
  const std::string empty = empty_argument(words);
  words = plastica::cli::with_new_names(with_help_as_option(std::move(words)));
  const std::string first = words.empty() ? std::string() : words.front();
  // Before help for it is asked for.
  for (const std::string& wrong : {empty, wrong_command(app, first)}) {
    if (!wrong.empty()) return complain(wrong, plastica::cli::kBadInput);
  }
  try {
    std::reverse(words.begin(), words.end());  // as the parser takes them
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return finish_output(app.exit(error));  // --help, --version
    return complain(rule_of(error, first), plastica::cli::kBadInput);
  }
  return finish_output(action());
}

}  // namespace

int main(int argc, char** argv) {
  plastica::cli::open_closed_streams();
  plastica::cli::tell_of_full_files();
  plastica::keep_freed_memory();
  plastica::cli::RunTeam team;
  int code = plastica::cli::kMachineFailed;
  std::string what;  // has failed
  try {
    plastica::cli::write_what_terminals_can_show();
    code = run({argv + 1, argv + argc}, nullptr, &team);
  } catch (const plastica::TeamLeft& left) {
    return team.end_after_another(left.failed());
  } catch (const plastica::InputError& error) {
    code = plastica::cli::kBadInput;
    what = error.what();
  } catch (const std::bad_alloc&) {
    what = "out of memory";
  } catch (const std::exception& error) {
    what = error.what();
  }
  return team.end(code, in_one_line(what));
}
