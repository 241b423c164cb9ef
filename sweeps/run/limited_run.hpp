#pragma once

#include <limits>

#include "plastica/base/stop_flag.hpp"
#include "plastica/run/batch.hpp"

/// Runs that end where they take too much; not installed.
namespace plastica::sweeps {

/// What a run may take.
struct RunLimit {
  double steps = std::numeric_limits<double>::infinity();  ///< that are accepted, > 0
  /// Of Newton's method, > 0. Of a path those up to its last sample are known, and one for each
  /// step since.
  double iterations = std::numeric_limits<double>::infinity();
  /// Since it began; what it comes to hangs on the machine then [s], > 0.
  double seconds = std::numeric_limits<double>::infinity();
};

/// Steps that a path or motion takes where none is cut [1].
double planned_steps(const Setup& setup);

/// A run, and whether it was stopped at its limit.
struct LimitedRun {
  BatchRow row{};  ///< its id is empty; seconds are CPU time
  bool stopped = false;
};

/// Runs a path or motion until it ends or reaches its limit, where its status is Interrupted and
/// the row's reason says how much it has taken. It is asked after each accepted step, so that the
/// last one is taken to its end.
/// @param stop  ends the run without being its limit; may be null
/// @throws InputError for a scene that is refused, or that memory does not suffice for
LimitedRun run_limited(const Setup& setup, const RunLimit& limit, StopFlag stop);

}  // namespace plastica::sweeps
