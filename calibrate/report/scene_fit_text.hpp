#pragma once

#include <span>
#include <string>

#include "calibrate/report/text.hpp"
#include "calibrate/result/scene_fit_record.hpp"

namespace plastica::calibrate {

/// The report of one fit through scenes, in engineering units, at most 100 columns wide (UTF-8):
/// what was mended in its curves, parameters with errors, intervals and verdicts, how well the
/// model follows each target, intervals side by side, correlations above 0.95, what the searches
/// found, warnings. Ends with a line end. Of the options colour and confidence count.
std::string scene_fit_report(const SceneFitRecord& record, const ReportOptions& options = {});

/// The report of a file: of a single fit its whole report; of several a table over fits, the
/// population (see scene_population.hpp), every fit that failed and why, every curve that was
/// repaired. The last line is
/// `fitted N, failed N`.
std::string scene_fits_report(std::span<const SceneFitRecord> records,
                              const ReportOptions& options = {});

}  // namespace plastica::calibrate
