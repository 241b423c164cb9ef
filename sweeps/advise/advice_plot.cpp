#include "sweeps/advise/advice_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/picture.hpp"
#include "sweeps/report/plot_chart.hpp"
#include "sweeps/trade/pareto.hpp"

namespace plastica::sweeps {
namespace {

/// Errors of zero have no logarithm, and lie below what rounding leaves.
constexpr double kLeastError = 1e-12;

std::vector<double> place_of(const TriedSetting& one) {
  return {one.cost, 100.0 * std::max(one.error, kLeastError)};
}

bool has_place(const TriedSetting& one) {
  return one.work > 0 && one.cost > 0.0 && std::isfinite(one.error);
}

ChartSeries symbols(std::string name, std::size_t look) {
  ChartSeries series{std::move(name), chart_look(look), {}, {}};
  series.look.line = false;
  return series;
}

ChartSeries front_of(const Advice& advice) {
  std::vector<TradePoint> points;
  for (const TriedSetting& one : advice.tried) {
    points.push_back({one.work > 0 ? one.cost : std::nan(""), one.error});
  }
  // Behind the points.
  ChartSeries front{"Pareto front", {"#C4C4C4", 7, true, false, false, 7.0}, {}, {}};
  for (const std::size_t i : pareto_front(points))
    front.points.push_back(place_of(advice.tried[i]));
  return front;
}

Chart chart_of(const Advice& advice, const AdviceOptions& options, const std::string& name) {
  Chart chart{report::printable(name), {}, {}, {}};
  const bool found = advice.end == AdviceEnd::Found;
  chart.subtitle = options.budget > 0.0
                       ? fmt::format("advice for {:.3g} ms", 1e3 * options.budget)
                       : fmt::format("advice within {:.3g} %", 100.0 * options.within);
  if (found) chart.subtitle += fmt::format(": promised {:.3g} %", 100.0 * advice.promised);
  ChartSeries same = symbols("with the advised words", 0);
  ChartSeries others = symbols("with other words", 4);
  ChartSeries advised = symbols("advised", 1);
  ChartSeries own = symbols("the file's own", 3);
  const auto is_advised = [&](const TriedSetting& one) {
    return found && one.setting == advice.setting && one.words == advice.words &&
           one.fractions == advice.fractions;
  };
  const auto is_own = [&](const TriedSetting& one) {
    return one.setting == advice.own.setting && one.words == advice.own.words &&
           one.fractions.empty();
  };
  for (const TriedSetting& one : advice.tried) {
    if (!has_place(one)) continue;
    ChartSeries& series = is_advised(one)             ? advised
                          : is_own(one)               ? own
                          : one.words == advice.words ? same
                                                      : others;
    series.points.push_back(place_of(one));
  }
  std::vector<double> cost;
  std::vector<double> error;
  chart.series = {front_of(advice), same, others, own, advised};
  std::erase_if(chart.series, [](const ChartSeries& series) { return series.points.empty(); });
  for (const ChartSeries& series : chart.series) {
    for (const auto& point : series.points) {
      cost.push_back(point[0]);
      error.push_back(point[1]);
    }
  }
  if (cost.empty()) {
    throw InputError({}, "--plot", "", "has nothing to draw: no setting has an error");
  }
  if (options.budget <= 0.0) {
    chart.guides.push_back(100.0 * options.within);
    error.push_back(100.0 * options.within);
  }
  chart.x = logarithmic_axis("cost [segment-iterations of a planar elastic chain]", cost);
  chart.y = logarithmic_axis("difference from the finest run [%]", error);
  return chart;
}

}  // namespace

std::string advice_plot_script(const Advice& advice, const AdviceOptions& options,
                               const std::string& name) {
  return chart_page(chart_of(advice, options, name)).text();
}

void draw_advice(const Advice& advice, const AdviceOptions& options, const std::string& name,
                 const std::string& output, std::ostream& standard_output, io::Overwrite overwrite,
                 std::optional<double> width) {
  report::check_picture_output(output);
  const Chart chart = chart_of(advice, options, name);
  const report::Sheet sheet = report::sheet_of(output, width);
  report::draw_picture(sheet.terminal ? chart_terminal(chart) : chart_page(chart, sheet), output,
                       standard_output, overwrite);
}

}  // namespace plastica::sweeps
