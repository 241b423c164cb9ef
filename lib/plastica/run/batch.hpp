#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "plastica/base/next_index.hpp"
#include "plastica/base/stop_flag.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica {

/// A scene of its own in a batch.
struct BatchCase {
  std::string id;  ///< unique in the batch
  Scene scene;
  SolverOptions options;
  BreakListener on_break{};  ///< called in the thread that runs the case; may be empty
  /// How often the case is run again after the first time, >= 0. `Response::seconds` is the least
  /// of these times, or that of the only run: CPU time of the thread, whatever else runs.
  int timed_runs = 0;
};

/// What became of a case. A case that cannot be run is a row too, and the others go on.
struct BatchRow {
  std::string id;
  /// For a case whose input was rejected the error line; for one that memory did not suffice for,
  /// with status NotRun, what happened.
  std::string reason;
  Response response;  ///< status Rejected for such a case, NotRun for one that was not begun
  Level level = Level::Auto;  ///< that was chosen; Auto for a rejected case
  bool in_motion = false;     ///< whether it ran in time, see `is_motion`
};

struct BatchOptions {
  int threads = 0;  ///< 0: as many as the machine has
  /// Once raised, no further case is begun, and those under way end within a step of theirs and
  /// count as not begun. May be null.
  StopFlag stop = nullptr;
  /// Called after each case with the number finished, from any thread, one call at a time.
  std::function<void(std::size_t finished)> progress{};
  /// Which cases are to be run, see `ParallelOptions`; of cases that are laid out when they are
  /// begun. Empty: all.
  NextIndex next{};
};

/// How a batch runs a case of a model: "side by side with up to 31 others of its shape", or "one by
/// one:" and why.
std::string riding_of(const Model& model);

/// Runs one case as a batch does.
BatchRow run_case(const BatchCase& one);

/// Runs cases in parallel; row i is case i, with the same bits for every number of threads.
std::vector<BatchRow> run_batch(std::span<const BatchCase> cases, const BatchOptions& options = {});

/// Runs cases that are laid out when they are begun and handed over when they are finished, so that
/// memory does not grow with their number. Motions of articulated schemes, and paths at rest under
/// load control, wait, laid out, for others of their shape (as many segments, motions with the same
/// steps and histories, paths with supports, loads and masses at the same segments), at most 64
/// shapes a thread, and no more of them than take a quarter of a gigabyte; a batch that is stopped
/// drops them. A case that the machine has no memory for is rejected (see `check_memory`).
/// @param make  called in the thread that runs the case. @throws InputError for a rejected case
/// @param take  called with each row, one call at a time, from any thread
void run_batch(std::size_t cases, const std::function<BatchCase(std::size_t)>& make,
               const std::function<void(std::size_t, BatchRow&&)>& take,
               const BatchOptions& options = {});

/// Runs one model with many sets of parameter values, and hands each response over when it is
/// there, so that memory does not grow with their number. A case that cannot be run (memory does
/// not suffice for it) has an empty response, NotRun, and the others go on.
/// @param values  (n_cases x n_parameters), row by row, SI
/// @param take  called with each response, one call at a time, from any thread
/// @throws InputError if what runs side by side does not fit into the machine's memory
void run_batch(const Model& model, std::span<const double> values, std::size_t cases,
               const std::function<void(std::size_t, Response&&)>& take,
               const BatchOptions& options = {});

/// Runs one model with many sets of parameter values.
/// @param values  (n_cases x n_parameters), row by row, SI
/// @return the responses (n_cases); empty ones, NotRun, of cases that were not begun or cannot run
std::vector<Response> run_batch(const Model& model, std::span<const double> values,
                                std::size_t cases, const BatchOptions& options = {});

}  // namespace plastica
