#pragma once

#include <memory>
#include <string>

#include "cli/mpi_wire.hpp"
#include "plastica/base/stop_flag.hpp"
#include "plastica/base/team.hpp"

namespace plastica::cli {

/// The processes that compute a run together, as the command line sees them.
class RunTeam {
 public:
  RunTeam() = default;

  /// Finds the others that mpirun or srun has started; to be called once, by a command whose run
  /// can be shared. All but the one that leads are silent from now on.
  /// @return null where this process was started alone
  /// @throws InputError if they do not find one another, or the program is built without MPI
  /// @param command_line  must be that of all others
  Team* join(const std::string& command_line);
  /// How many threads this process may have where the command line says no number, see `MpiWire`;
  /// 0: as many as the machine has.
  int threads() const { return wire_ != nullptr ? wire_->threads() : 0; }
  /// Says that the run was interrupted while the processes wait for one another, which may be for
  /// ever where one was killed.
  /// @param journal  of the run
  /// @param output   see `tell_interrupted`
  void watch(StopFlag stop, const std::string& journal, const std::string& output);

  /// Ends the program's part in the team. @param error  what has failed; empty: nothing
  /// @return the exit code
  int end(int code, const std::string& error);
  /// The same where another process has left it. @param failed  see `TeamLeft`
  int end_after_another(bool failed);

 private:
  MpiWire* wire_ = nullptr;  ///< of the team
  std::unique_ptr<Team> team_;
};

/// Lets other processes join a run, if there are any.
/// @param launched  null: there are none
/// @param command_line  see `RunTeam::join`
/// @param threads   0: takes what is this process's part of the machine
Team* join_team(RunTeam* launched, const std::string& command_line, int& threads);

}  // namespace plastica::cli
