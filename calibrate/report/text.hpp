#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "calibrate/fit/result.hpp"

namespace plastica::calibrate {

/// How the text reports look.
struct ReportOptions {
  bool color = false;                ///< ANSI colours, for a terminal
  double confidence = 0.95;          ///< of the intervals in the records (FitOptions)
  std::size_t specimens_shown = 60;  ///< rows of the table over specimens; 0: all
  std::size_t groups_shown = 24;     ///< groups whose statistics are shown; 0: all
};

/// The report of one specimen, in engineering units, at most 100 columns wide (UTF-8): what was
/// done to its curve, characteristics, parameters with errors and intervals, how well the model
/// follows, warnings and advice. Ends with a line end.
std::string fit_report(const FitRecord& record, const ReportOptions& options = {});

/// The report of a batch: a table over specimens, statistics per group, every specimen that was
/// rejected, failed or repaired and why; the last line is `fitted N, rejected N, failed N`.
std::string batch_report(std::span<const FitRecord> records, const ReportOptions& options = {});

}  // namespace plastica::calibrate
