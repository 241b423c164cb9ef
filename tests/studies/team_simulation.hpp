#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// What a team of processes would take for a run, by simulation of its events: for machines that
/// are not there.
namespace plastica::testing {

/// What a run costs beside its fits or cases [s], unless it says otherwise.
struct TeamCosts {
  double start = 0.0;  ///< of each process, all at once
  /// For each process to read all inputs, and the bytes of them, which each machine gets from one
  /// file server.
  double read = 0.0;
  double read_bytes = 0.0;
  std::size_t per_machine = 1;  ///< processes
  double server_rate = 1e300;   ///< of the file server [bytes/s]
  /// From a question to its answer where process 0 is not busy with others, and what it is busy for
  /// with each.
  double ask = 0.0;
  double answer = 0.0;
  double keep = 0.0;   ///< to write a result to the journal
  double open = 0.0;   ///< for process 0 to open another's journal
  double merge = 0.0;  ///< for process 0 to read a result, and to write it to the result file
};

/// How the numbers of fits or cases are handed out.
enum class Dealing {
  Guided,  ///< as the library does, see `GuidedParts`
  Single,  ///< one at a time
  Equal,   ///< as many to each process, once
};

struct TeamRun {
  double whole = 0.0;   ///< from start to result file [s]
  double shared = 0.0;  ///< of these, while fits or cases are handed out [s]
  std::size_t asked = 0;
};

/// @param seconds  that each fit or case takes, in the order in which they are handed out (n)
/// @param processes  >= 1
TeamRun simulate_team(std::span<const double> seconds, std::size_t processes, Dealing dealing,
                      const TeamCosts& costs);

/// The sum of seconds over processes times the run's: 1 if nothing but fits took time.
double efficiency(std::span<const double> seconds, std::size_t processes, double whole);

}  // namespace plastica::testing
