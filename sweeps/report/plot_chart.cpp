#include "sweeps/report/plot_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <string_view>

#include "plastica/report/format.hpp"
#include "plastica/report/scene_figure.hpp"

namespace plastica::sweeps {
namespace {

using report::in_quotes;
using report::PlotScript;

constexpr std::string_view kLetters = "#ox+*%@&";
constexpr std::size_t kTerminalWidth = 76;
constexpr std::size_t kNameWidth = 60;
constexpr double kTickRoom = 0.055;  ///< least distance of labels [fraction of the axis]

/// "10⁻⁶", or "0.001" where that is short.
std::string power_text(int power) {
  constexpr std::array<std::string_view, 10> kRaised{"⁰", "¹", "²", "³", "⁴",
                                                     "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (power >= -3 && power <= 4)
    return fmt::format("{:.{}f}", std::pow(10.0, power), std::max(0, -power));
  std::string text = power < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(power))) {
    text += kRaised[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

std::string tick_text(int power, double factor) {
  if (factor == 1.0) return power_text(power);
  return fmt::format("{:.6g}", factor * std::pow(10.0, power));
}

/// Both ends with a margin.
std::array<double, 2> range_around(double low, double high, bool logarithmic) {
  if (logarithmic) {
    const double room = std::max(1.15, std::pow(high / low, 0.05));
    return {low / room, high * room};
  }
  const double room = high > low ? 0.05 * (high - low) : (high != 0.0 ? 0.1 * std::abs(high) : 1.0);
  return {low - room, high + room};
}

/// As a fraction of the axis.
double place_along(const ChartAxis& axis, double value) {
  const auto [low, high] = axis.range;
  return axis.logarithmic ? std::log(value / low) / std::log(high / low)
                          : (value - low) / (high - low);
}

std::string style_of(const ChartLook& look) {
  const std::string color = fmt::format("linecolor rgb '{}'", look.color);
  const std::string dash = look.dashed ? " dashtype 2" : report::dash_type(look.dashes);
  if (!look.symbols) {
    return fmt::format("using 1:2 with lines linewidth {}{} {}", look.width, dash, color);
  }
  if (!look.line) {
    return fmt::format("using 1:2 with points pointtype {} pointsize 0.8 {}", look.symbol, color);
  }
  return fmt::format("using 1:2 with linespoints linewidth {}{} pointtype {} pointsize 0.8 {}",
                     look.width, dash, look.symbol, color);
}

/// The part of a style from "with" on.
std::string from_with(const std::string& style) { return style.substr(style.find("with ")); }

/// A straight line as dots.
Points dotted(const Chart& chart, const Points& ends) {
  constexpr int kDots = 60;
  const auto between = [](double a, double b, double fraction, bool logarithmic) {
    return logarithmic ? a * std::pow(b / a, fraction) : a + fraction * (b - a);
  };
  Points dots;
  for (int k = 0; k <= kDots; ++k) {
    const double fraction = static_cast<double>(k) / kDots;
    dots.push_back({between(ends[0][0], ends[1][0], fraction, chart.x.logarithmic),
                    between(ends[0][1], ends[1][1], fraction, chart.y.logarithmic)});
  }
  return dots;
}

}  // namespace

ChartAxis logarithmic_axis(std::string label, const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  ChartAxis axis{std::move(label), true, range_around(*low, *high, true), {}};
  const int first = static_cast<int>(std::floor(std::log10(axis.range[0])));
  const int last = static_cast<int>(std::floor(std::log10(axis.range[1])));
  const double decades = std::log10(axis.range[1] / axis.range[0]);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / 12.0)));
  for (int power = first; power <= last; ++power) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      if (factor != 1.0 && decades > 3.2) continue;
      if (factor == 1.0 && power % every != 0) continue;
      const double at = factor * std::pow(10.0, power);
      if (at < axis.range[0] || at > axis.range[1]) continue;
      axis.ticks.push_back({at, tick_text(power, factor)});
    }
  }
  return axis;
}

ChartAxis axis_at_values(std::string label, std::vector<double> values, bool logarithmic) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  ChartAxis axis{
      std::move(label), logarithmic, range_around(values.front(), values.back(), logarithmic), {}};
  const auto place = [&](double value) { return place_along(axis, value); };
  for (const double value : values) {
    const std::string text = fmt::format("{:.5g}", value);
    if (!axis.ticks.empty()) {
      // A longer label takes more room.
      const double room = kTickRoom + 0.005 * static_cast<double>(text.size());
      if (place(value) - place(axis.ticks.back().at) < room) continue;
    }
    axis.ticks.push_back({value, text});
  }
  return axis;
}

ChartLook chart_look(std::size_t number) {
  constexpr std::array<std::string_view, kLooks> kColors{
      report::kBlue, report::kVermillion, "#009E73", "#CC79A7",
      "#E69F00",     "#56B4E9",           "#7A1F1F", report::kDark};
  constexpr std::array<int, kLooks> kSymbols{7, 5, 9, 13, 11, 15, 7, 5};
  return {std::string(kColors[number % kLooks]), kSymbols[number % kLooks]};
}

std::string ramp_color(double fraction) {
  constexpr std::array<std::array<double, 3>, 4> kStops{
      {{0x1B, 0x2A, 0x5E}, {0x2A, 0x7F, 0x9E}, {0x4F, 0xB3, 0x7B}, {0xE9, 0xB8, 0x44}}};
  const double place = std::clamp(fraction, 0.0, 1.0) * (kStops.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
  const double t = place - static_cast<double>(k);
  std::string color = "#";
  for (std::size_t c = 0; c < 3; ++c) {
    color +=
        fmt::format("{:02X}", static_cast<int>(kStops[k][c] * (1.0 - t) + kStops[k + 1][c] * t));
  }
  return color;
}

namespace {

/// Along x, those that have room side by side.
std::vector<ChartTick> ticks_with_room(const ChartAxis& axis, double wide) {
  constexpr double kGap = 8.0;
  std::vector<ChartTick> kept;
  double end = -std::numeric_limits<double>::infinity();
  for (const ChartTick& tick : axis.ticks) {
    const double half =
        0.5 * report::kLetterWidth * static_cast<double>(report::width_of(tick.text));
    const double at = wide * place_along(axis, tick.at);
    if (at - half < end + kGap) continue;
    kept.push_back(tick);
    end = at + half;
  }
  return kept;
}

}  // namespace

std::string axis_commands(const ChartAxis& axis, char letter, double wide) {
  std::string text = fmt::format("set {}label {}\n", letter, in_quotes(axis.label));
  if (axis.logarithmic) text += fmt::format("set logscale {}\n", letter);
  if (axis.range[0] != axis.range[1]) {
    text += fmt::format("set {}range [{:.9g}:{:.9g}]\n", letter, axis.range[0], axis.range[1]);
  }
  if (axis.ticks.empty()) return text;
  std::string ticks;
  for (const ChartTick& tick : wide > 0.0 ? ticks_with_room(axis, wide) : axis.ticks) {
    ticks += fmt::format("{}{} {:.9g}", ticks.empty() ? "" : ", ", report::quoted_tic(tick.text),
                         tick.at);
  }
  return text + fmt::format("set {}tics ({})\n", letter, ticks);
}

PlotScript chart_page(const Chart& chart, const report::Sheet& sheet) {
  PlotScript script(sheet);
  script.begin_panels(1);
  script.command(axis_commands(chart.x, 'x', script.panel_width()) + axis_commands(chart.y, 'y'));
  for (const double y : chart.guides) {
    script.command(fmt::format(
        "set arrow from graph 0, first {0:.9g} to graph 1, first {0:.9g} nohead back linewidth 1 "
        "dashtype 3 linecolor rgb '{1}'",
        y, report::kGrey));
  }
  script.set_x_label(chart.x.label);
  script.set_y_label(chart.y.label);
  script.begin_panel({chart.title, chart.subtitle});
  for (const ChartSeries& series : chart.series) {
    const std::string name = report::cut(series.name, kNameWidth);
    if (!series.points.empty()) {
      const std::string block = script.add_points(series.points);
      if (name.empty()) {
        script.add_unnamed(block, style_of(series.look));
      } else {
        script.add_series(block, style_of(series.look), name);
      }
    } else if (!name.empty()) {
      script.add_entry(from_with(style_of(series.look)), name);
    }
    if (series.hollow.empty()) continue;
    ChartLook open = series.look;
    open.line = false;
    open.symbol -= 1;
    script.add_unnamed(script.add_points(series.hollow), style_of(open));
  }
  for (const ChartSeries& entry : chart.entries) {
    script.add_entry(from_with(style_of(entry.look)), report::cut(entry.name, kNameWidth));
  }
  script.end_panel();
  return script;
}

PlotScript chart_terminal(const Chart& chart) {
  PlotScript script;
  script.command(
      "unset grid\nset border 3\nset tics scale 0.5\nset key outside bottom center horizontal "
      "samplen 3");
  script.terminal_rows = 25;
  script.command(axis_commands(chart.x, 'x') + axis_commands(chart.y, 'y') + "unset ylabel");
  script.command("set title " +
                 in_quotes({chart.title, chart.subtitle + ": " + chart.y.label}, kTerminalWidth));
  std::string plot;
  std::map<std::string, char> letter_of;  // of a colour
  // Letters hide what is behind them: lines without symbols come last.
  std::vector<ChartSeries> all = chart.series;
  std::stable_partition(all.begin(), all.end(),
                        [](const ChartSeries& series) { return series.look.symbols; });
  for (const ChartSeries& series : all) {
    Points points = series.look.line && !series.look.symbols && series.points.size() == 2
                        ? dotted(chart, series.points)
                        : series.points;
    points.insert(points.end(), series.hollow.begin(), series.hollow.end());
    if (points.empty()) continue;
    const char next = kLetters[letter_of.size() % kLetters.size()];
    const char letter =
        series.look.dashed ? '.' : letter_of.emplace(series.look.color, next).first->second;
    plot += fmt::format(
        "{}{} using 1:2 with points pointtype '{}' {}", plot.empty() ? "plot " : ", \\\n     ",
        script.add_points(points), letter,
        series.name.empty() ? "notitle" : "title " + in_quotes(report::cut(series.name, 34)));
  }
  for (const ChartSeries& entry : chart.entries) {
    const auto letter = letter_of.find(entry.look.color);
    if (letter == letter_of.end()) continue;  // letters do not show symbols
    plot += fmt::format(", \\\n     keyentry with points pointtype '{}' title {}", letter->second,
                        in_quotes(report::cut(entry.name, 34)));
  }
  script.command(plot.empty() ? "plot NaN notitle" : plot);
  return script;
}

}  // namespace plastica::sweeps
