#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace plastica::io {
struct MergedShards;
}

namespace plastica::cli {

class RunTeam;

/// What the chosen subcommand does; returns the exit code. May throw: `main` turns an InputError
/// into exit code 2 and anything else into 3, each with one line.
using Action = std::function<int()>;
/// With what the program was started.
struct Invocation {
  std::string command_line;
  /// All cases of a run, in place of computing them: `plastica merge` runs the program again.
  const io::MergedShards* merged = nullptr;
  /// The processes that a launcher has started; those that share a run join it.
  RunTeam* team = nullptr;
};

/// Runs the program again with other words, the command first. @return the exit code
/// Throws as an action.
using RunAgain = std::function<int(const std::vector<std::string>&, const io::MergedShards&)>;

// Each adds its subcommand to the program and, when the command line chooses it, sets `action`.
void add_calibrate(CLI::App& app, const Invocation& invocation, Action& action);
void add_inspect(CLI::App& app, Action& action);
void add_init(CLI::App& app, Action& action);
void add_simulate(CLI::App& app, const Invocation& invocation, Action& action);
void add_sweep(CLI::App& app, const Invocation& invocation, Action& action);
void add_check(CLI::App& app, const Invocation& invocation, Action& action);
void add_recommend(CLI::App& app, Action& action);
void add_advise(CLI::App& app, Action& action);
void add_stability(CLI::App& app, const Invocation& invocation, Action& action);
void add_diff(CLI::App& app, Action& action);
void add_merge(CLI::App& app, const RunAgain& run, Action& action);
void add_show(CLI::App& app, Action& action);
void add_plot(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_export(CLI::App& app, Action& action);
void add_fields(CLI::App& app, Action& action);
void add_completion(CLI::App& app, Action& action);
void add_man(CLI::App& app, Action& action);

}  // namespace plastica::cli
