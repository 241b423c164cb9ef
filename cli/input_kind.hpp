#pragma once

#include <initializer_list>
#include <optional>
#include <string>

namespace plastica::cli {

/// What a file is that a command is given, as far as it can be told from what stands in it.
enum class InputKind { Scene, Sweep, Check, Fit, Result, Curves, Shard };

/// Never `Curves`, which may look like anything. Nothing: keys of two kinds, or of none; a file
/// that cannot be read, or one that is no TOML and no HDF5; whoever reads it says so.
std::optional<InputKind> kind_of_input(const std::string& path);

/// The command that takes a file: "simulate"; empty for one that is not there, or of no known kind.
std::string command_for(const std::string& path);

/// Refuses a file that is of another kind than a command takes, saying what it is and which command
/// takes it. Others pass. @throws InputError
void expect_input(const std::string& path, std::initializer_list<InputKind> taken);

}  // namespace plastica::cli
