#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plastica/model/rules.hpp"
#include "plastica/run/batch.hpp"
#include "sweeps/plan/quantity.hpp"

namespace plastica::sweeps {

/// What a case gave. A case that failed is a row, too: with its status, the reason and its last
/// good state.
struct CaseResult {
  Status status = Status::NotRun;
  std::string reason{};  ///< of a rejected case its error line; of one that failed what to change
  Level level = Level::Auto;
  std::optional<double> value{};  ///< the quantity [SI]; none if the case has none
  std::vector<double> time{};     ///< of a curve [s] (n_samples)
  std::vector<double> curve{};    ///< (n_samples)
  std::int64_t segments = 0;      ///< of a coupon 1
  std::int64_t iterations = 0;    ///< Newton iterations or linear solves; of a coupon samples
  int cutbacks = 0;               ///< steps that were tried again shorter
  /// Of the last good state, of an unstable path its end [s]; of a coupon its samples.
  double last_time = 0.0;
  std::optional<double> last_value{};      ///< of the probe there [SI]
  double energy_balance_error = 0.0;       ///< `Response::energy_balance_error` [1]
  std::optional<double> standard_error{};  ///< of a fitted value, from the noise of the data [SI]
  std::int64_t break_joint = -1;        ///< the first that broke; -1: none did, or it is a coupon
  std::optional<double> break_place{};  ///< of that joint, joints over segments [1]
  double seconds = 0.0;                 ///< CPU time of the run, see BatchCase::timed_runs [s]
  /// What the run shows, of a case that was watched (`case_warnings`); none of others.
  std::optional<std::vector<std::string>> warnings{};

  /// The work of the case, in a measure that no machine changes: segments x iterations.
  std::int64_t segment_iterations() const { return segments * iterations; }
};

/// What a quantity of a run is; `reason` says why there is none.
struct Measured {
  std::optional<double> value{};
  std::string reason{};
};

/// Takes one number of a curve. @param time  [s], rising (n_samples)
Measured take_of(Take take, std::span<const double> time, std::span<const double> values);

/// What a run gave, for any quantity that a run has (not natural frequencies, not fits).
/// @param row  of a case that was run
CaseResult result_of_run(const BatchRow& row, const Quantity& quantity);

}  // namespace plastica::sweeps
