#pragma once

#include <string>
#include <vector>

#include "calibrate/inference/segments_error.hpp"
#include "calibrate/report/shown_intervals.hpp"
#include "calibrate/result/fit_outcome.hpp"

/// What tables with a row a fit have of its parameters; not installed.
namespace plastica::calibrate::report {

/// A row's fit; segments: null where it was not repeated with other numbers of them.
struct FitRow {
  const FitOutcome* fit = nullptr;
  const SceneSegments* segments = nullptr;
};

/// Of each parameter that any fit has, in the order in which they come up first: value, errors,
/// bounds, verdict; of fits with other segments the extrapolated value and half its interval;
/// intervals of profile and bootstrap where any fit has them. Titles are "fit.yield_stress [Pa]",
/// "fit.yield_stress.standard_error [Pa]".
class ParameterColumns {
 public:
  explicit ParameterColumns(const std::vector<FitRow>& fits);

  void add_titles(std::vector<std::string>& header) const;
  /// Empty cells for what the fit does not have.
  void add_cells(const FitRow& row, std::vector<std::string>& cells) const;

 private:
  struct Parameter {
    std::string path;
    Dimension dimension = Dimension::None;
  };

  std::vector<Parameter> parameters_;
  std::vector<IntervalColumn> intervals_;
  bool has_segments_ = false;
};

}  // namespace plastica::calibrate::report
