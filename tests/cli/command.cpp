#include "tests/cli/command.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

namespace plastica::testing {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

[[noreturn]] void fail(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

std::vector<std::string> own_environment() {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) all.emplace_back(*entry);
  return all;
}

}  // namespace

RunningCommand::RunningCommand(pid_t process, fs::path streams)
    : process_(process), streams_(std::move(streams)) {}

RunningCommand::~RunningCommand() {
  if (ended_) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, &status_, 0);
}

void RunningCommand::send(int signal) const {
  if (::kill(process_, signal) != 0) fail(errno, "kill");
}

bool RunningCommand::catches(int signal) const {
  std::ifstream status("/proc/" + std::to_string(process_) + "/status");
  const std::string key = "SigCgt:";
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with(key)) continue;
    return (std::stoull(line.substr(key.size()), nullptr, 16) >> (signal - 1) & 1U) != 0;
  }
  return false;
}

bool RunningCommand::runs() {
  if (!ended_) ended_ = ::waitpid(process_, &status_, WNOHANG) == process_;
  return !ended_;
}

CommandResult RunningCommand::wait() {
  if (!ended_ && ::waitpid(process_, &status_, 0) != process_) fail(errno, "waitpid");
  ended_ = true;
  const int code = WIFSIGNALED(status_) ? 128 + WTERMSIG(status_) : WEXITSTATUS(status_);
  return {code, bytes_of(streams_ / "stdout"), bytes_of(streams_ / "stderr")};
}

Workplace::Workplace() {
  std::string name = (fs::temp_directory_path() / "plastica-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) fail(errno, name);
  root_ = name;
  folder_ = root_ / "work";
  fs::create_directory(folder_);
}

Workplace::~Workplace() {
  std::error_code ignored;
  fs::remove_all(root_, ignored);
}

void Workplace::write(const std::string& name, const std::string& content) const {
  fs::create_directories(path(name).parent_path());
  std::ofstream out(path(name), std::ios::binary);
  out << content;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + name);
}

std::string Workplace::read(const std::string& name) const { return bytes_of(path(name)); }

std::map<std::string, std::string> Workplace::contents() const {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    const std::string name = fs::relative(entry.path(), folder_).string();
    all[name] = entry.is_regular_file() ? bytes_of(entry.path()) : "";
  }
  return all;
}

CommandResult Workplace::run(std::vector<std::string> arguments) const {
  return start(std::move(arguments)).wait();
}

CommandResult Workplace::run(std::vector<std::string> arguments,
                             std::vector<std::string> environment) const {
  return spawn(PLASTICA_COMMAND, std::move(arguments), std::move(environment)).wait();
}

CommandResult Workplace::run_program(const std::string& program,
                                     std::vector<std::string> arguments) const {
  return spawn(program, std::move(arguments), own_environment()).wait();
}

RunningCommand Workplace::start(std::vector<std::string> arguments) const {
  return spawn(PLASTICA_COMMAND, std::move(arguments), own_environment());
}

RunningCommand Workplace::spawn(const std::string& program, std::vector<std::string> arguments,
                                std::vector<std::string> environment) const {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const std::string out = root_ / "stdout";
  const std::string err = root_ / "stderr";
  constexpr int kFlags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), kFlags, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), kFlags, 0600);
  posix_spawn_file_actions_addchdir_np(&actions, folder_.c_str());
  arguments.insert(arguments.begin(), program);
  pid_t process = 0;
  const int error = posix_spawn(&process, program.c_str(), &actions, nullptr,
                                pointers(arguments).data(), pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) fail(error, program);
  return {process, root_};
}

CommandResult Workplace::interrupt(std::vector<std::string> arguments, const std::string& journal,
                                   int signal, std::uintmax_t growth) const {
  const auto size = [&]() -> std::uintmax_t {
    std::error_code absent;
    const auto bytes = fs::file_size(path(journal), absent);
    return absent ? 0 : bytes;
  };
  const std::uintmax_t enough = size() + growth;
  RunningCommand running = start(std::move(arguments));
  while (running.runs() && size() < enough) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (running.runs()) running.send(signal);
  return running.wait();
}

std::size_t lines_of(const std::string& text) {
  const auto ends = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  return ends + (text.empty() || text.back() == '\n' ? 0 : 1);
}

}  // namespace plastica::testing
