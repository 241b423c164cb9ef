#include "plastica/io/gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "plastica/base/machine_error.hpp"

namespace plastica::io {
namespace {

[[noreturn]] void fail(const std::string& what, int error) {
  throw MachineError(what + ": " + std::strerror(error));
}

/// A file in memory that one of the child's standard streams is. Files, not pipes: they take all
/// that is written, so that neither side ever waits for the other.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("gnuplot", MFD_CLOEXEC)) {
    if (descriptor_ < 0) fail("cannot make a file in memory", errno);
    // The child's streams are 0, 1 and 2: a descriptor below 3 (a caller that has closed its own)
    // would be overwritten before it is used.
    while (descriptor_ < 3) {
      const int higher = fcntl(descriptor_, F_DUPFD_CLOEXEC, 3);
      const int error = errno;
      close(descriptor_);
      descriptor_ = higher;
      if (descriptor_ < 0) fail("cannot make a file in memory", error);
    }
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return descriptor_; }

  void write_all(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = write(descriptor_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) fail("cannot hand the script to gnuplot", errno);
      text.remove_prefix(static_cast<std::size_t>(written));
    }
    rewind();
  }

  std::string read_all() {
    rewind();
    std::string text;
    std::array<char, 65536> buffer{};
    while (true) {
      const ssize_t got = read(descriptor_, buffer.data(), buffer.size());
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) fail("cannot read what gnuplot wrote", errno);
      if (got == 0) return text;
      text.append(buffer.data(), static_cast<std::size_t>(got));
    }
  }

 private:
  void rewind() {
    if (lseek(descriptor_, 0, SEEK_SET) < 0) fail("cannot rewind a file in memory", errno);
  }

  int descriptor_;
};

/// First line of a text that says something; gnuplot marks the column with a line of its own.
std::string first_message(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    if (line.find_first_not_of(" ^\t\r") != std::string::npos) return line;
    at = end + 1;
  }
  return "no message";
}

/// Runs the program to its end. @return its wait status
int run_to_end(const std::string& program, const MemoryFile& in, const MemoryFile& out,
               const MemoryFile& err) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.descriptor(), STDERR_FILENO);
  std::string name = program;
  std::string defaults = "--default-settings";
  std::string from_input = "-";
  std::array<char*, 4> arguments = {name.data(), defaults.data(), from_input.data(), nullptr};
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) {
    throw MachineError("cannot draw: there is no program '" + program +
                       "' on the PATH; install gnuplot-nox, or write the script with -o FILE.gp");
  }
  if (error != 0) fail("cannot start " + program, error);
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) fail("lost the process of " + program, errno);
  }
  return status;
}

}  // namespace

std::string run_gnuplot(std::string_view script, const std::string& program) {
  MemoryFile in;
  MemoryFile out;
  MemoryFile err;
  in.write_all(script);
  const int status = run_to_end(program, in, out, err);
  std::string picture = out.read_all();
  if (WIFSIGNALED(status)) {
    throw MachineError(program + " was ended by signal " + std::to_string(WTERMSIG(status)));
  }
  if (WEXITSTATUS(status) != 0 || picture.empty()) {
    throw MachineError(program + " drew nothing: " + first_message(err.read_all()));
  }
  return picture;
}

std::string gnuplot_string(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\'') quoted += '\'';
    quoted += byte < 0x20U || byte == 0x7FU ? ' ' : c;
  }
  return quoted + "'";
}

}  // namespace plastica::io
