#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "plastica/model/scene.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): of the library CLI11
class App;
}

namespace plastica::cli {

/// Has the help show these options of a command under a heading of their own.
void group_options(CLI::App& sub, const std::string& heading,
                   std::initializer_list<std::string> names);

// Options that several commands have, each said once.
void add_json_option(CLI::App& sub, std::string& path);
/// @param idle  what 0 stands for
void add_threads_option(CLI::App& sub, int& threads,
                        const std::string& idle = "as many as the machine has");
void add_dry_run_option(CLI::App& sub, bool& dry_run);
/// @param what  it overwrites
void add_force_option(CLI::App& sub, bool& force, const std::string& what);
/// @param what  it leaves out
void add_quiet_option(CLI::App& sub, bool& quiet, const std::string& what);
/// Adds `--width`, of pictures for print [mm].
void add_width_option(CLI::App& sub, std::optional<double>& width);
/// @throws InputError if a width is given for a picture of characters
void check_width(const std::optional<double>& width, const std::string& output);
/// The words of a command line, the command first, with the new names of options and of their
/// values that had others in the last version; says so on stderr.
std::vector<std::string> with_new_names(std::vector<std::string> words);
/// Adds `--isa`.
void add_isa_option(CLI::App& sub, std::string& isa);

/// Lets `--isa`, if it was given, take the place of what the file says.
/// @throws InputError if this processor does not have it
void take_isa(const std::string& isa, SolverOptions& options);

}  // namespace plastica::cli
