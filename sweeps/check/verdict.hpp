#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plastica/base/stop_flag.hpp"
#include "sweeps/check/claim.hpp"
#include "sweeps/store/sweep_record.hpp"

namespace plastica::sweeps {

/// Whether a claim holds, and by which number.
struct ClaimVerdict {
  bool holds = false;
  std::optional<double> number{};  ///< the worst that was found [SI]; none: see the reason
  std::string reason{};            ///< why there is no number
};

/// Judges a claim by the scans that were run.
ClaimVerdict judge(const Claim& claim, std::span<const stability::StabilityRow> rows);

/// Judges a claim by the sweep that was run.
ClaimVerdict judge(const Claim& claim, const SweepRecord& record);

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

/// Runs the sweeps of a check file and judges its claims (n_claims); fewer if it was stopped.
std::vector<ClaimVerdict> run_check(const CheckFile& file, const CheckOptions& options);

}  // namespace plastica::sweeps
