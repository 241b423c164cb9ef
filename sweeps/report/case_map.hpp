#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sweeps/report/plot_classes.hpp"
#include "sweeps/report/plot_lines.hpp"

/// The map of a sweep: its cases over two axes, for all that draw it; not installed.
namespace plastica::sweeps {

/// An axis of a map. Fields end halfway between two values, in factors where it is logarithmic.
struct MapAxis {
  std::size_t axis = 0;        ///< number of the sweep's
  std::string label;           ///< "solver.time_step [s]"
  double scale = 1.0;          ///< shown = SI value / scale
  std::vector<double> values;  ///< as they are shown, rising (n)
  std::vector<double> edges;   ///< of the fields (n + 1)
  bool logarithmic = false;

  /// The number of a value, which is one of `values`.
  std::size_t at(double value) const;
  /// The value of a case, as it is shown; NaN where there is none.
  double of(const SweepRecord& record, std::size_t index) const;
};

/// The cases that have the same values on all other axes.
struct MapPanel {
  std::string title;               ///< these values; empty where there is one panel
  std::vector<std::size_t> cases;  ///< numbers of cases
};

struct CaseMap {
  MapAxis x;
  MapAxis y;
  std::vector<MapPanel> panels;  ///< in the order of the other axes
  CaseClasses classes;
  std::string limits;  ///< what is not in its errors; empty: nothing
};

/// Whether a sweep varies two numbers that are crossed.
bool has_map(const SweepRecord& record);

/// @throws InputError if no case is picked, or the other axes make more panels than a picture has
CaseMap case_map(const PlotCases& cases);

}  // namespace plastica::sweeps
