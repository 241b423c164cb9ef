#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sweeps/report/plot_chart.hpp"
#include "sweeps/store/sweep_record.hpp"

/// Cases as lines of a chart, and how the lines are told apart; not installed.
namespace plastica::sweeps {

/// A sweep and which of its cases are drawn.
struct PlotCases {
  const SweepRecord& record;
  std::vector<bool> picked;  ///< (n_cases)
};

/// A line: cases that differ in one axis, or in what moves with it, alone.
struct CaseLine {
  std::vector<std::size_t> cases;  ///< in the order of the axis
  std::size_t group = 0;           ///< number in SweepRecord::groups, where the axis refines
};

/// The groups of refinement, with the cases that are picked; none that are empty.
std::vector<CaseLine> refinement_lines(const PlotCases& cases);
/// Lines along any axis. @param axis  none of all cases alone: one line
std::vector<CaseLine> lines_along(const PlotCases& cases, std::size_t axis);

/// How lines look, and what the legend says of it.
struct LineLooks {
  std::vector<ChartLook> looks;      ///< (n_lines)
  std::vector<std::string> names;    ///< (n_lines); empty where `entries` tell the lines apart
  std::vector<ChartSeries> entries;  ///< of the legend
};

/// Up to kLooks lines have a look and a name each. Of more, the colour stands for the value of the
/// first axis that differs, the symbol for that of the second; beyond kLooks values colours go
/// along a scale.
/// @param along  the axis that the lines go along
LineLooks looks_of(const SweepRecord& record, const std::vector<CaseLine>& lines,
                   std::size_t along);

/// What tells a case apart on some axes: "energy_momentum, segments 64".
std::string short_setting(const SweepRecord& record, std::size_t index,
                          const std::vector<std::size_t>& axes);

/// The number of a case on an axis; NaN for a word or what is not set.
double number_on(const SweepRecord& record, std::size_t index, std::size_t axis);

/// How numbers are shown: in the unit in which they are read best.
struct ShownNumbers {
  std::string label;   ///< "solver.time_step [s]"
  double scale = 1.0;  ///< shown = SI value / scale
};

ShownNumbers shown_axis(const Axis& axis);
/// @param largest  size of the numbers to be shown [SI]
ShownNumbers shown_value(const SweepRecord& record, double largest);
/// "tip, end against theory:elastica", and what its errors do not have in them.
std::string subtitle_of(const SweepRecord& record);
/// What is not in the errors: axes, or how far the reference itself is off; empty: nothing.
std::string error_limits(const SweepRecord& record);

}  // namespace plastica::sweeps
