#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "plastica/base/stop_flag.hpp"
#include "sweeps/check/verdict.hpp"

namespace plastica::sweeps {

struct CheckOptions {
  int threads = 0;  ///< 0: as many as the machine has
  /// Once raised, no further case is begun, and those under way end within a step of theirs. May be
  /// null.
  StopFlag stop = nullptr;
  /// Called after each case, one call at a time, with the number of those that are done.
  std::function<void(std::size_t done)> progress{};
};

/// Number of cases that a check runs.
std::size_t cases_of(const CheckFile& file);

/// Runs the sweeps of a check file and judges its claims (n_claims); none if it was stopped.
std::vector<ClaimVerdict> run_check(const CheckFile& file, const CheckOptions& options);

}  // namespace plastica::sweeps
