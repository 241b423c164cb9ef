#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/report/plot_script.hpp"

/// Pictures of curves, said once for a page and for a terminal; not installed.
namespace plastica::report {

/// How a curve is drawn: a line alone, with a dot at each point, with symbols, as the area between
/// two lines, as points alone, or as points with upright bars.
enum class Stroke { Line, Dots, Symbols, Area, Points, Bars };

/// One curve.
struct FigureCurve {
  std::vector<std::vector<double>>
      points;        ///< (x, y); an area: (x, low, high); bars: (x, y, low, high)
  std::string name;  ///< in the legend
  std::string_view color = kBlue;
  Stroke stroke = Stroke::Line;
  int symbol = 7;  ///< gnuplot's number of the point type of Symbols and Points
  /// Of a Line: 0 whole, else with gaps, through which those behind it are seen: each number with
  /// others than the one before.
  int dashes = 0;
};

/// A text at a point of a panel.
struct FigureNote {
  double x = 0.0;
  double y = 0.0;
  std::string text;
};

struct FigurePanel {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<FigureCurve> curves{};
  std::vector<double> marks{};  ///< x of upright lines
  std::string mark_name{};      ///< of all of them, in the legend
  std::vector<FigureNote> notes{};
  bool logarithmic = false;         ///< y, with a y_range above zero
  std::array<double, 2> x_range{};  ///< both zero: as far as the curves go
  std::array<double, 2> y_range{};
  std::vector<std::string> x_names{};  ///< at 1, 2, … in place of numbers; empty: numbers
};

struct Figure {
  std::string title;  ///< of all panels
  std::vector<FigurePanel> panels;
  bool strip =
      false;  ///< of two panels, whose x_range is one: the second is a strip below the first
};

/// How gnuplot dashes a line (`FigureCurve::dashes`): " dashtype …"; nothing of a whole one.
std::string dash_type(int dashes);

/// A curve of a record among others: colours, and symbols where there are several, tell them apart;
/// the eighth is as the first.
FigureCurve curve_of_record(std::size_t number, std::size_t count, const std::string& name);

/// A curve of so many points that a page cannot show them all, thinned: of each stretch that it
/// shows as one, the lowest and the highest point, and of one that turns back the first and the
/// last along the abscissa, too.
std::vector<std::vector<double>> thinned(const std::vector<std::vector<double>>& points);

/// Points without a line, so thinned that a page looks the same: of those that lie on each other
/// one.
std::vector<std::vector<double>> thinned_dots(const std::vector<std::vector<double>>& points);

PlotScript figure_page(const Figure& figure, const Sheet& sheet = {});
/// The same as characters, a letter a curve, the panels one below the other.
PlotScript figure_terminal(const Figure& figure);

/// For a page or for a terminal.
PlotScript drawn(const Figure& figure, const Sheet& sheet);

/// Switches off what a picture of characters has no room for.
void begin_terminal(PlotScript& script);
/// Points of a polyline so dense that their letters join.
/// @param wide, high  extents of the whole picture
std::vector<std::vector<double>> dense_points(const std::vector<std::vector<double>>& points,
                                              double wide, double high);

}  // namespace plastica::report
