#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "plastica/report/plot_script.hpp"

/// Charts of points over one or two logarithmic axes, said once for a page and for a terminal; not
/// installed.
namespace plastica::sweeps {

using Points = std::vector<std::vector<double>>;  ///< (x, y) each

struct ChartTick {
  double at = 0.0;
  std::string text;
};

struct ChartAxis {
  std::string label;
  bool logarithmic = false;
  std::array<double, 2> range{};   ///< both zero: as far as the points go
  std::vector<ChartTick> ticks{};  ///< none: where gnuplot puts them
};

/// A logarithmic axis around numbers, with a label at each power of ten, or, where it has few of
/// them, also at twice and five times that. @param values  above 0 (n >= 1)
ChartAxis logarithmic_axis(std::string label, const std::vector<double>& values);
/// An axis around numbers with a label at each of them that has room.
/// @param logarithmic  for values above 0
ChartAxis axis_at_values(std::string label, std::vector<double> values, bool logarithmic);

/// How a series of points looks.
struct ChartLook {
  std::string color;
  int symbol = 7;  ///< gnuplot's number of a filled symbol; one less is the same left open
  bool line = true;
  bool symbols = true;
  bool dashed = false;  ///< of references
  double width = 1.4;
  int dashes = 0;  ///< as `FigureCurve::dashes`
};

struct ChartSeries {
  std::string name{};  ///< in the legend; empty: not there
  ChartLook look{};
  Points points{};
  Points hollow{};  ///< open symbols that no line joins
};

struct Chart {
  std::string title;
  std::string subtitle;
  ChartAxis x;
  ChartAxis y;
  std::vector<ChartSeries> series{};
  std::vector<ChartSeries> entries{};  ///< of the legend alone, without points
  std::vector<double> guides{};        ///< y of lines across the picture
};

/// So many looks can be told apart.
inline constexpr std::size_t kLooks = 8;
/// The look of the series of a number; the ninth is as the first.
ChartLook chart_look(std::size_t number);
/// The colour of a place on a scale. @param fraction  0 … 1
std::string ramp_color(double fraction);

report::PlotScript chart_page(const Chart& chart, const report::Sheet& sheet = {});
/// The same as characters, a letter a series.
report::PlotScript chart_terminal(const Chart& chart);

/// The commands of an axis. Labels that would meet are left out.
/// @param letter  'x' or 'y'
/// @param wide    of the panel [units of a page]; 0: every label is kept
std::string axis_commands(const ChartAxis& axis, char letter, double wide = 0.0);

}  // namespace plastica::sweeps
