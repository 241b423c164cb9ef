#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace plastica::testing {

/// What a program left behind.
struct CommandResult {
  int code = 0;     ///< exit code; 128 + signal if a signal ended it
  std::string out;  ///< what it wrote to its standard output
  std::string err;  ///< what it wrote to its standard error
};

/// A command that runs in the background.
class RunningCommand {
 public:
  RunningCommand(pid_t process, std::filesystem::path streams);
  /// Kills the process if it still runs.
  ~RunningCommand();
  RunningCommand(const RunningCommand&) = delete;
  RunningCommand& operator=(const RunningCommand&) = delete;

  void send(int signal) const;
  /// Whether it has set a handler for a signal.
  bool catches(int signal) const;
  /// Whether it still runs, so that its end has not been seen.
  bool runs();
  /// Waits for its end.
  CommandResult wait();

 private:
  pid_t process_;
  std::filesystem::path streams_;
  int status_ = 0;
  bool ended_ = false;
};

/// A fresh folder in which a test runs the command `plastica`; deleted at the end.
class Workplace {
 public:
  Workplace();
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  /// Path of a file in the folder.
  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& content) const;
  std::string read(const std::string& name) const;
  bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
  /// Every file and folder with its bytes, by its path; a folder has none.
  std::map<std::string, std::string> contents() const;

  /// Runs `plastica ARGUMENTS…` in the folder to its end.
  CommandResult run(std::vector<std::string> arguments) const;
  /// Runs it with another environment, such as {"PATH="}.
  CommandResult run(std::vector<std::string> arguments, std::vector<std::string> environment) const;
  /// Runs some other program.
  CommandResult run_program(const std::string& program, std::vector<std::string> arguments) const;
  /// Begins `plastica ARGUMENTS…` in the folder.
  RunningCommand start(std::vector<std::string> arguments) const;
  /// Runs it, and ends it by a signal once its journal has grown by so many bytes.
  CommandResult interrupt(std::vector<std::string> arguments, const std::string& journal,
                          int signal, std::uintmax_t growth) const;

 private:
  RunningCommand spawn(const std::string& program, std::vector<std::string> arguments,
                       std::vector<std::string> environment) const;

  std::filesystem::path root_;
  std::filesystem::path folder_;  ///< in the root, beside the files of the standard streams
};

/// How many lines a text has; one without its line end counts.
std::size_t lines_of(const std::string& text);

}  // namespace plastica::testing
