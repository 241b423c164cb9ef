#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibrate/report/format.hpp"
#include "calibrate/report/json_values.hpp"
#include "calibrate/report/text.hpp"
#include "calibrate/result/fit_outcome.hpp"

/// Intervals of a fit, of a coupon or through scenes, as reports, tables and pictures show them;
/// not installed.
namespace plastica::calibrate::report {

/// A free parameter beside its intervals; SI.
struct ShownParameter {
  std::string path;
  Dimension dimension = Dimension::None;
  double value = 0.0;
  /// As `FittedParameter`'s; NaN where there is none. Profiles and bootstraps are of scatter.
  double noise_error = 0.0, scatter_error = 0.0, sampling_error = 0.0;
  double degrees_of_freedom = 0.0;  ///< of the noise
};

struct ShownIntervals {
  std::string name;                        ///< of the fit
  std::vector<ShownParameter> parameters;  ///< (n_free)
  const FitIntervals* intervals = nullptr;
};

/// @param fit  must outlive what is returned
ShownIntervals shown_intervals(const FitOutcome& fit, std::string name = {});

DisplayUnit display_unit(const ShownParameter& parameter);

/// Intervals of covariance, profile and bootstrap side by side; empty if only the covariance has
/// any.
std::string intervals_text(const ShownIntervals& shown, const ReportOptions& options);

/// Profiles and bootstraps by parameter; null for what was not asked for.
Json intervals_json(const ShownIntervals& shown);

/// A column that a table has for each parameter where any fit has such an interval.
struct IntervalColumn {
  const char* name;  ///< what follows the parameter's: ".profile_low"
  bool has_unit;     ///< the parameter's; else it holds words
  bool (*there)(const FitIntervals& intervals);
  /// Of a free parameter, by its row among these; empty where the fit has none.
  std::string (*cell)(const FitIntervals& intervals, std::size_t parameter);
};

/// Those that any of the fits has.
std::vector<IntervalColumn> interval_columns(std::span<const FitIntervals* const> fits);

}  // namespace plastica::calibrate::report
