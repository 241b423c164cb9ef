#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "calibrate/result/result.hpp"

namespace plastica::calibrate {

/// How the text reports look.
struct ReportOptions {
  bool color = false;                ///< ANSI colours, for a terminal
  double confidence = 0.95;          ///< of the intervals in the records (FitOptions)
  std::size_t specimens_shown = 60;  ///< rows of the table over specimens; 0: all
  std::size_t groups_shown = 24;     ///< groups whose statistics are shown; 0: all
  /// Resamples of the specimens for the intervals of groups' means, 0: none; and their seed, that
  /// of the fits.
  int specimen_resamples = 0;
  std::uint64_t seed = 1;
};

/// The report of one specimen, in engineering units, at most 100 columns wide (UTF-8): what was
/// done to its curve, characteristics, parameters with errors and intervals, how well the model
/// follows, intervals of profile and bootstrap side by side if there are any, warnings and advice.
/// Ends with a line end.
std::string fit_report(const FitRecord& record, const ReportOptions& options = {});

/// The report of a batch: a table over specimens, statistics per group, every specimen that was
/// rejected, failed or repaired and why; the last line is `fitted N, rejected N, failed N`.
std::string batch_report(std::span<const FitRecord> records, const ReportOptions& options = {});

}  // namespace plastica::calibrate
