#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sweeps/check/claim.hpp"
#include "sweeps/store/sweep_record.hpp"

namespace plastica::sweeps {

/// One of the numbers that a claim is judged by.
struct JudgedNumber {
  std::string of;                  ///< whose: "beam.segments = 5", a fit, a point of a scan
  std::optional<double> number{};  ///< [SI]; none: see the remark
  std::string remark{};
};

/// So many of them a verdict names.
inline constexpr std::size_t kMostJudged = 20;

/// The errors of the group that decides a claim on an order.
struct JudgedErrors {
  std::string over;                             ///< what is refined: "solver.time_step [s]"
  std::vector<std::array<double, 2>> points{};  ///< that [SI], size of the error [1], above 0
};

/// Whether a claim holds, and by which number.
struct ClaimVerdict {
  bool holds = false;
  std::optional<double> number{};  ///< the worst that was found [SI]; none: see the reason
  std::string reason{};            ///< why there is no number
  std::string at{};      ///< whose it is: "at beam.segments = 5"; empty: nothing else is there
  std::string found{};   ///< what was found that is no number: "completed", "265 … 290 MPa"
  std::string beside{};  ///< what else is to be said: "tip, end -0.75 m, reference -0.735 m"
  std::vector<std::string> warnings{};  ///< of the cases that it is about, see `case_warnings`
  /// What it was judged by, the worst first, at most `kMostJudged`; of claims that count cases,
  /// what was counted; of claims that count fits, those of no use.
  std::vector<JudgedNumber> worst{};
  std::size_t judged = 0;  ///< how many of these there are
  JudgedErrors errors{};
  /// What the claim took: the time of what it is about, shared by all claims about that [s].
  double seconds = 0.0;
};

/// Judges a claim by the scans that were run.
ClaimVerdict judge(const Claim& claim, std::span<const stability::StabilityRow> rows);

/// Judges a claim by the sweep that was run.
ClaimVerdict judge(const Claim& claim, const SweepRecord& record);

}  // namespace plastica::sweeps
