#include "plastica/report/scene_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "plastica/report/axis_ticks.hpp"
#include "plastica/report/format.hpp"

namespace plastica::report {
namespace {

constexpr std::size_t kTitleWidth = 76;
constexpr std::size_t kNameWidth = 16;  ///< of names along an axis
constexpr std::string_view kLetters = "#ox+*%@&";
constexpr std::string_view kMarkStyle =
    "linewidth 1 dashtype 3 linecolor rgb '#333333'";  ///< of upright lines

std::string style_of(const FigureCurve& curve) {
  const std::string color = fmt::format("linecolor rgb '{}'", curve.color);
  switch (curve.stroke) {
    case Stroke::Line: return "using 1:2 with lines linewidth 2 " + color + dash_type(curve.dashes);
    case Stroke::Dots:
      return "using 1:2 with linespoints linewidth 1.6 pointtype 7 pointsize 0.4 " + color;
    case Stroke::Symbols:
      return fmt::format("using 1:2 with linespoints linewidth 0.9 pointtype {} pointsize 0.9 {}",
                         curve.symbol, color);
    case Stroke::Area:
      return fmt::format("using 1:2:3 with filledcurves {} fillstyle solid 0.85 noborder", color);
    case Stroke::Points:
      return fmt::format("using 1:2 with points pointtype {} pointsize 0.7 linewidth 1.2 {}",
                         curve.symbol, color);
    case Stroke::Bars:
      return "using 1:2:3:4 with yerrorbars pointtype 7 pointsize 0.5 linewidth 1 " + color;
  }
  return "";
}

/// Room above and below the curves, but none on a side of zero where there is nothing.
std::string offsets_of(const FigurePanel& panel) {
  double low = 0.0;
  double high = 0.0;
  for (const FigureCurve& curve : panel.curves) {
    for (const auto& point : curve.points) {
      low = std::min(low, *std::min_element(point.begin() + 1, point.end()));
      high = std::max(high, *std::max_element(point.begin() + 1, point.end()));
    }
  }
  return fmt::format("set offsets graph 0, graph 0.02, graph {}, graph {}", high > 0.0 ? 0.06 : 0.0,
                     low < 0.0 ? 0.06 : 0.0);
}

/// A logarithmic scale with a label at each power of ten.
std::string decades_of(const std::array<double, 2>& range) {
  constexpr std::array<std::string_view, 10> kRaised{"⁰", "¹", "²", "³", "⁴",
                                                     "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string tics;
  const int last = static_cast<int>(std::floor(std::log10(range[1])));
  for (int power = static_cast<int>(std::ceil(std::log10(range[0]))); power <= last; ++power) {
    std::string raised = power < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(power))) {
      raised += kRaised[static_cast<std::size_t>(digit - '0')];
    }
    tics += fmt::format("{}'10{}' 1e{}", tics.empty() ? "" : ", ", raised, power);
  }
  return "set logscale y\nset ytics (" + tics + ")\n";
}

/// Numbers that differ in their last digits only are long, and so are all of a narrow panel: as
/// many as have room. @param panel  its width [units of a page]
std::string tics_of(const std::array<double, 2>& range, double panel) {
  constexpr double kNarrow = 320.0;
  constexpr double kFewDigits = 1e-3;  // of a value, which gnuplot's own six digits show
  const double wide = range[1] - range[0];
  const double largest = std::max(std::fabs(range[0]), std::fabs(range[1]));
  if (!(wide > 0.0) || (wide > 0.05 * largest && panel > kNarrow)) return "set xtics autofreq\n";
  const std::vector<AxisTick> ticks = ticks_with_room(range, panel);
  // Of a strip's upper panel no numbers are shown, but where they stand.
  if (wide > kFewDigits * largest) {
    return fmt::format("set xtics {:.9g}, {:.9g}, {:.9g}\n", ticks.front().at,
                       ticks[1].at - ticks[0].at, ticks.back().at);
  }
  std::string tics;
  for (const AxisTick& tick : ticks) {
    tics += fmt::format("{}{} {:.12g}", tics.empty() ? "" : ", ", in_quotes(tick.text), tick.at);
  }
  return "set xtics (" + tics + ")\n";
}

/// Has a low panel begin below the one above it.
void begin_strip(PlotScript& script, const FigurePanel& panel) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const FigureCurve& curve : panel.curves) {
    for (const auto& point : curve.points) {
      low = std::min(low, point[1]);
      high = std::max(high, point[1]);
    }
  }
  script.begin_strip(low, high);
}

/// Those that do not lie over one before them; the strongest come first.
std::vector<FigureNote> notes_with_room(const FigurePanel& panel, double wide, double high) {
  constexpr double kLine = 18.0;
  const auto place = [](double at, const std::array<double, 2>& range, bool logarithmic) {
    return logarithmic ? std::log(at / range[0]) / std::log(range[1] / range[0])
                       : (at - range[0]) / (range[1] - range[0]);
  };
  std::vector<FigureNote> kept;
  for (const FigureNote& note : panel.notes) {
    const bool covered = std::ranges::any_of(kept, [&](const FigureNote& other) {
      const double x = place(note.x, panel.x_range, false) - place(other.x, panel.x_range, false);
      const double y = place(note.y, panel.y_range, panel.logarithmic) -
                       place(other.y, panel.y_range, panel.logarithmic);
      const auto letters = static_cast<double>(width_of(note.text) + width_of(other.text));
      return std::fabs(x) * wide < 0.5 * kLetterWidth * letters && std::fabs(y) * high < kLine;
    });
    if (!covered) kept.push_back(note);
  }
  return kept;
}

/// Names of users along an axis, slanted; of so many that they would meet, every second, third, …
std::string named_tics(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 24;
  const std::size_t every = (names.size() + kMost - 1) / kMost;
  std::string tics;
  for (std::size_t i = 0; i < names.size(); i += every) {
    tics +=
        fmt::format("{}{} {}", i == 0 ? "" : ", ", quoted_tic(cut(names[i], kNameWidth)), i + 1);
  }
  return "set xtics rotate by 50 right (" + tics + ")\n";
}

/// The height that slanted names take below a picture.
double name_room(const Figure& figure) {
  std::size_t longest = 0;
  for (const FigurePanel& panel : figure.panels) {
    for (const std::string& name : panel.x_names) longest = std::max(longest, width_of(name));
  }
  return 4.0 * static_cast<double>(std::min(longest, kNameWidth));
}

/// Ranges, scale, upright lines and texts of a panel.
std::string frame_of(const FigurePanel& panel, const PlotScript& script) {
  std::string text = "unset arrow\nunset label\nunset logscale\n";
  if (panel.logarithmic) text += decades_of(panel.y_range);
  const auto range = [&](char axis, const std::array<double, 2>& ends) {
    if (ends[0] == ends[1]) return;
    text += fmt::format("set {}range [{:.12g}:{:.12g}]\n", axis, ends[0], ends[1]);
  };
  range('x', panel.x_range);
  text += panel.x_names.empty() ? tics_of(panel.x_range, script.panel_width())
                                : named_tics(panel.x_names);
  range('y', panel.y_range);
  for (const double x : panel.marks) {
    text += fmt::format("set arrow from {0:.12g}, graph 0 to {0:.12g}, graph 1 nohead front {1}\n",
                        x, kMarkStyle);
  }
  for (const FigureNote& note :
       notes_with_room(panel, script.panel_width(), 0.6 * script.height())) {
    text += fmt::format("set label {} at {:.7g}, {:.7g} offset 0,0.8 center textcolor rgb '{}'\n",
                        in_quotes(note.text), note.x, note.y, kDark);
  }
  return text;
}

}  // namespace

std::string dash_type(int dashes) {
  // Three patterns; colours tell apart what has the same.
  return dashes == 0 ? std::string() : fmt::format(" dashtype (9,{})", 9 * (1 + (dashes - 1) % 3));
}

FigureCurve curve_of_record(std::size_t number, std::size_t count, const std::string& name) {
  constexpr std::array<std::string_view, 7> kColors{kBlue,     kVermillion, "#009E73", "#CC79A7",
                                                    "#E69F00", "#56B4E9",   kDark};
  // Open circles, squares and triangles, then crosses: they can be seen through each other.
  constexpr std::array<int, 7> kSymbols{6, 4, 8, 2, 12, 10, 1};
  return {{},
          name,
          kColors[number % kColors.size()],
          count == 1 ? Stroke::Dots : Stroke::Symbols,
          kSymbols[number % kSymbols.size()]};
}

std::vector<std::vector<double>> thinned(const std::vector<std::vector<double>>& points) {
  constexpr std::size_t kStretches = 1500;
  if (points.size() <= 4 * kStretches) return points;
  const auto less_along = [](const auto& a, const auto& b) { return a.front() < b.front(); };
  const bool turns = !std::ranges::is_sorted(points, less_along);
  std::vector<std::vector<double>> kept{points.front()};
  for (std::size_t k = 0; k < kStretches; ++k) {
    const std::size_t first = 1 + k * (points.size() - 2) / kStretches;
    const std::size_t behind = 1 + (k + 1) * (points.size() - 2) / kStretches;
    std::set<std::size_t> ends;
    const auto take_ends = [&](const auto& value_of) {
      std::size_t low = first, high = first;
      for (std::size_t i = first; i < behind; ++i) {
        if (value_of(points[i]) < value_of(points[low])) low = i;
        if (value_of(points[i]) > value_of(points[high])) high = i;
      }
      ends.insert({low, high});
    };
    take_ends([](const auto& point) { return point.back(); });
    if (turns) take_ends([](const auto& point) { return point.front(); });
    for (const std::size_t i : ends) kept.push_back(points[i]);
  }
  kept.push_back(points.back());
  return kept;
}

std::vector<std::vector<double>> thinned_dots(const std::vector<std::vector<double>>& points) {
  constexpr std::size_t kAlways = 6000;
  constexpr double kAcross = 600.0, kUp = 60.0;  // cells, about as large as a dot
  if (points.size() <= kAlways) return points;
  const auto [left, right] = std::ranges::minmax_element(
      points, {}, [](const std::vector<double>& point) { return point.front(); });
  const auto [low, high] = std::ranges::minmax_element(
      points, {}, [](const std::vector<double>& point) { return point.back(); });
  const auto cell = [](double at, double from, double to, double cells) {
    return to > from ? std::floor(cells * (at - from) / (to - from)) : 0.0;
  };
  std::set<std::pair<double, double>> taken;
  std::vector<std::vector<double>> kept;
  for (const auto& point : points) {
    const bool is_end = &point == &*low || &point == &*high;
    const bool is_new = taken
                            .emplace(cell(point.front(), left->front(), right->front(), kAcross),
                                     cell(point.back(), low->back(), high->back(), kUp))
                            .second;
    if (is_new || is_end) kept.push_back(point);
  }
  return kept;
}

namespace {

/// As a curve is drawn.
std::vector<std::vector<double>> shown_points(const FigureCurve& curve) {
  if (curve.stroke == Stroke::Bars) return curve.points;
  return curve.stroke == Stroke::Points ? thinned_dots(curve.points) : thinned(curve.points);
}

}  // namespace

PlotScript figure_page(const Figure& figure, const Sheet& sheet) {
  PlotScript script(sheet);
  const bool single = figure.panels.size() == 1 || figure.strip;
  if (figure.strip) {
    script.begin_panel_and_strip();
  } else {
    script.begin_panels(figure.panels.size(), single ? std::string() : figure.title,
                        name_room(figure));
  }
  script.command("set xzeroaxis linecolor rgb '#B8B8B8' linetype 1 linewidth 0.8");
  for (const FigurePanel& panel : figure.panels) {
    const bool above_strip = figure.strip && &panel == &figure.panels.front();
    const bool is_strip = figure.strip && !above_strip;
    script.set_x_label(above_strip ? "" : panel.x_label);
    if (is_strip) begin_strip(script, panel);
    script.set_y_label(panel.y_label);
    script.command("set autoscale xfix\n" + offsets_of(panel));
    script.command(frame_of(panel, script));
    script.begin_panel(is_strip ? std::vector<std::string>{}
                       : single ? std::vector{figure.title, panel.title}
                                : std::vector{panel.title});
    for (const FigureCurve& curve : panel.curves) {
      script.add_series(script.add_points(shown_points(curve)), style_of(curve), curve.name);
    }
    if (!panel.marks.empty()) {
      script.add_entry("with lines " + std::string(kMarkStyle), panel.mark_name);
    }
    script.end_panel();
  }
  return script;
}

PlotScript drawn(const Figure& figure, const Sheet& sheet) {
  return sheet.terminal ? figure_terminal(figure) : figure_page(figure, sheet);
}

void begin_terminal(PlotScript& script) {
  script.command(
      "unset grid\nunset border\nset border 3\nset tics scale 0.5\nset key outside bottom center "
      "horizontal samplen 3");
}

std::vector<std::vector<double>> dense_points(const std::vector<std::vector<double>>& points,
                                              double wide, double high) {
  std::vector<std::vector<double>> dense;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double dx = i == 0 ? 0.0 : points[i][0] - points[i - 1][0];
    const double dy = i == 0 ? 0.0 : points[i][1] - points[i - 1][1];
    const double steps = 120.0 * std::max(wide > 0.0 ? std::fabs(dx) / wide : 0.0,
                                          high > 0.0 ? std::fabs(dy) / high : 0.0);
    const int count = std::isfinite(steps) ? std::clamp(static_cast<int>(steps), 0, 500) + 1 : 1;
    for (int k = count - 1; k >= 0; --k) {
      const double back = static_cast<double>(k) / count;
      dense.push_back({points[i][0] - back * dx, points[i][1] - back * dy});
    }
  }
  return dense;
}

PlotScript figure_terminal(const Figure& figure) {
  PlotScript script;
  begin_terminal(script);
  const std::size_t panels = figure.panels.size();
  if (panels > 1) {
    script.terminal_rows = 18 * static_cast<int>(panels);
    script.command(fmt::format("set multiplot layout {},1", panels));
  }
  for (const FigurePanel& panel : figure.panels) {
    double x_low = 0.0;
    double x_high = 0.0;
    double y_low = 0.0;
    double y_high = 0.0;
    for (const FigureCurve& curve : panel.curves) {
      for (const auto& point : curve.points) {
        x_low = std::min(x_low, point[0]);
        x_high = std::max(x_high, point[0]);
        y_low = std::min(y_low, point[1]);
        y_high = std::max(y_high, point[1]);
      }
    }
    const std::string title =
        panel.y_label.empty() ? panel.title : panel.title + ": " + panel.y_label;
    script.command("set title " + in_quotes({figure.title, title}, kTitleWidth));
    script.command("set xlabel " + in_quotes(panel.x_label));
    const auto [first, last] = panel.x_range;
    script.command(first == last ? "set autoscale x"
                                 : fmt::format("set xrange [{:.7g}:{:.7g}]", first, last));
    std::string plot;
    for (std::size_t i = 0; i < panel.curves.size(); ++i) {
      const FigureCurve& curve = panel.curves[i];
      const bool joined = curve.stroke != Stroke::Points && curve.stroke != Stroke::Bars;
      const std::string points = script.add_points(
          joined ? dense_points(thinned(curve.points), x_high - x_low, y_high - y_low)
                 : curve.points);
      plot += fmt::format("{}{} using 1:2 with points pointtype '{}' title {}",
                          plot.empty() ? "plot " : ", \\\n     ", points,
                          kLetters[i % kLetters.size()], in_quotes(cut(curve.name, 30)));
    }
    std::vector<std::vector<double>> marks;
    for (const double x : panel.marks) {
      for (int k = 0; k <= 40; ++k) marks.push_back({x, y_low + k / 40.0 * (y_high - y_low)});
    }
    if (!marks.empty()) {
      plot += fmt::format(", \\\n     {} using 1:2 with points pointtype ':' title {}",
                          script.add_points(marks), in_quotes(panel.mark_name));
    }
    script.command(plot);
  }
  if (panels > 1) script.command("unset multiplot");
  return script;
}

}  // namespace plastica::report
