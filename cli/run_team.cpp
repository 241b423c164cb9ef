#include "cli/run_team.hpp"

#include <fcntl.h>
#include <sys/file.h>

#include <optional>
#include <utility>

#include "cli/exit_code.hpp"
#include "cli/launched.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "cli/terminal_line.hpp"
#include "plastica/base/check.hpp"
#include "plastica/io/case_journal.hpp"
#include "plastica/io/file_descriptor.hpp"

namespace plastica::cli {

namespace {

/// Whether process 0 has ended and this process is the first to see it, to which it holds for the
/// rest of its life.
bool takes_the_place_of_the_first(const std::string& journal) {
  static std::optional<io::FileDescriptor> held;
  held.emplace(::open(journal.c_str(), O_RDWR | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC));
  return held->get() >= 0 && ::flock(held->get(), LOCK_EX | LOCK_NB) == 0;
}

}  // namespace

Team* RunTeam::join() {
  const std::optional<Launched> process = launched();
  if (!process) return nullptr;
  const bool first = process->rank == 0;
  if (!first) be_silent(true);
  const auto refuse = [&](const std::string& rule) {
    if (!first) throw TeamLeft(true);
    throw InputError({}, "processes", std::to_string(process->count), rule);
  };
  std::unique_ptr<MpiWire> wire = join_mpi();
  if (wire == nullptr) {
    refuse(
        "were started, and plastica is built without MPI: give --shard auto and merge, or build "
        "with -DPLASTICA_MPI=ON");
  }
  if (wire->size() != process->count) {
    refuse(
        "were started and do not find one another: start them by the mpirun of the MPI that "
        "plastica is built with");
  }
  wire_ = wire.get();
  team_ = std::make_unique<Team>(std::move(wire));
  be_silent(!team_->leads());
  TerminalLine::set_style(team_->leads() ? TerminalLine::Style::Lines
                                         : TerminalLine::Style::Silent);
  return team_.get();
}

void RunTeam::watch(StopFlag stop, const std::string& output) {
  if (wire_ == nullptr) return;
  const auto say = [this, output] {
    if (team_->leads()) {
      tell_interrupted(output);
      return;
    }
    // Where the first was killed, it has let go of its journal: whoever gets that says so.
    if (!takes_the_place_of_the_first(io::journal_path(output))) return;
    be_silent(false);
    tell_interrupted(output);
  };
  wire_->watch({stop, say});
}

Team* join_team(RunTeam* launched, int& threads) {
  if (launched == nullptr) return nullptr;
  Team* team = launched->join();
  if (threads == 0) threads = launched->threads();
  return team;
}

int RunTeam::end(int code, const std::string& error) {
  const bool failed = !error.empty();
  if (team_ == nullptr) {
    if (failed) tell("plastica: {}\n", error);
    return code;
  }
  const bool leads = team_->leads();
  const std::string who =
      leads ? "" : "process " + std::to_string(team_->rank() + 1) + " of " +
                       std::to_string(team_->size()) + ": ";
  const bool says = team_->leave(failed);
  if (failed && says) {
    be_silent(false);
    tell("plastica: {}{}\n", who, error);
  }
  return leads || (failed && says) ? code : 0;
}

int RunTeam::end_after_another(bool failed) {
  if (team_ == nullptr) return kBadInput;  // they did not even find one another
  team_->leave(false);
  if (team_->has_shared()) {
    tell("plastica: what is finished is kept: --resume goes on\n");
  } else if (!failed) {
    tell("plastica: interrupted\n");
  }
  if (!team_->leads()) return kDone;
  return failed ? kMachineFailed : kInterrupted;
}

}  // namespace plastica::cli
