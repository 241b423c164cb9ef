#include "cli/run_team.hpp"

#include <fcntl.h>
#include <sys/file.h>

#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "cli/exit_code.hpp"
#include "cli/launched.hpp"
#include "cli/run_files.hpp"
#include "cli/tell.hpp"
#include "cli/terminal_line.hpp"
#include "plastica/base/check.hpp"
#include "plastica/io/case_journal.hpp"
#include "plastica/io/digest.hpp"
#include "plastica/io/file_descriptor.hpp"
#include "plastica/io/team_journals.hpp"

namespace plastica::cli {

namespace {

/// Whether process 0 has ended, and this process has its lock now, which it keeps: of several that
/// see it one alone says so.
class PlaceOfTheFirst {
 public:
  /// To be asked again and again while process 0 is waited for: where it ends in order, it lets go
  /// of its journal a moment before this process hears of it.
  bool is_taken(const std::string& journal) {
    constexpr std::chrono::milliseconds kMoment{300};
    if (!since_) {
      held_.emplace(::open(journal.c_str(), O_RDWR | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC));
      if (held_->get() < 0 || ::flock(held_->get(), LOCK_EX | LOCK_NB) != 0) return false;
      since_ = std::chrono::steady_clock::now();
    }
    return std::chrono::steady_clock::now() - *since_ >= kMoment;
  }

 private:
  std::optional<io::FileDescriptor> held_;
  std::optional<std::chrono::steady_clock::time_point> since_;
};

}  // namespace

Team* RunTeam::join(const std::string& command_line) {
  const std::optional<Launched> process = launched();
  if (!process) return nullptr;
  const bool first = process->rank == 0;
  if (!first) be_silent(true);
  const auto refuse = [&](const std::string& rule) {
    if (!first) throw TeamLeft(true);
    throw InputError({}, "processes", std::to_string(process->count), rule);
  };
  std::unique_ptr<MpiWire> wire;
#ifdef PLASTICA_HAS_MPI
  wire = join_mpi();
#endif
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
  team_->agree(io::Digest().text(command_line).value(),
               "command line: they are parts of one run; a run that is to be alone must not see "
               "the launcher's variables (env -u OMPI_COMM_WORLD_SIZE -u PMI_SIZE)");
  TerminalLine::set_style(team_->leads() ? TerminalLine::Style::Lines
                                         : TerminalLine::Style::Silent);
  return team_.get();
}

void RunTeam::watch(StopFlag stop, const std::string& journal, const std::string& output) {
  if (wire_ == nullptr) return;
  const auto say = [this, journal, output, place = std::make_shared<PlaceOfTheFirst>()] {
    // Where the first was killed, it has let go of its journal: whoever gets that says so. Before
    // this process has a journal, the first may not have its own.
    if (!team_->leads()) {
      if (!io::is_in_use(io::team_journal_path(journal, team_->rank()))) return false;
      if (!place->is_taken(journal)) return false;
      be_silent(false);
    }
    tell_interrupted(output);
    return true;
  };
  wire_->watch({stop, say});
}

Team* join_team(RunTeam* launched, const std::string& command_line, int& threads) {
  if (launched == nullptr) return nullptr;
  Team* team = launched->join(command_line);
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
  const std::string who = leads ? "" : "process " + std::to_string(team_->rank()) + ": ";
  wire_->watch({});  // the first lets go of its journal, and lives
  const bool says = team_->leave(failed);
  if (failed && says) {
    be_silent(false);
    tell("plastica: {}{}\n", who, error);
  }
  return leads || (failed && says) ? code : 0;
}

int RunTeam::end_after_another(bool failed) {
  if (team_ == nullptr) return kBadInput;  // they did not even find one another
  wire_->watch({});
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
