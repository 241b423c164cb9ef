#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "calibrate/report/format.hpp"
#include "calibrate/report/json_values.hpp"
#include "calibrate/result/fit_outcome.hpp"
#include "plastica/report/web/web_blocks.hpp"

/// Parts of pages that all kinds of fits have; not installed.
namespace plastica::calibrate::report {

using plastica::report::WebTable;

/// A table of the parameters of a fit: value, errors, interval, bounds, verdict.
Json parameters_block(const FitOutcome& fit, double confidence);
/// "95 % from": the head of a column of intervals' lower ends.
std::string percent_from(double confidence);
/// A table of the correlations of its free parameters; null without any.
Json correlations_block(const FitOutcome& fit,
                        const std::vector<const FittedParameter*>& parameters);
/// Adds the pictures of profiles and of bootstraps, where the fit has them.
void add_intervals(Json& blocks, const FitOutcome& fit, const std::string& name);

/// Columns of a table over fits: a value and its standard error for each parameter that any has.
class WebParameters {
 public:
  explicit WebParameters(std::span<const FitOutcome* const> fits);

  void add_to(WebTable& table) const;
  void add_cells(const FitOutcome& fit, Json& cells) const;

 private:
  struct Column {
    std::string path;
    Dimension dimension = Dimension::None;
    DisplayUnit unit{};  ///< the same for all rows
  };

  std::vector<Column> columns_;
};

/// A number in a unit; null where there is none.
Json in_unit(std::optional<double> value, const DisplayUnit& unit);

}  // namespace plastica::calibrate::report
