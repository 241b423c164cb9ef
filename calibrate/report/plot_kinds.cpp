#include "calibrate/report/plot_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/format.hpp"
#include "calibrate/report/plot_parts.hpp"
#include "calibrate/report/summary.hpp"
#include "plastica/base/check.hpp"
#include "plastica/report/scene_figure.hpp"

namespace plastica::calibrate::report {
namespace {

using plastica::report::FigurePanel;
using plastica::report::Stroke;

constexpr std::size_t kMaxCurves = 60;  // of a panel; more are a blot
constexpr std::size_t kMaxFalls = 3;    // of a panel's fits

std::string with_color(std::string_view style, std::string_view color) {
  return fmt::format("{} linecolor rgb '{}'", style, color);
}

/// What a panel of the overview shows.
struct Panel {
  std::vector<const Curve*> measured;
  std::vector<Curve> fits;
  std::vector<std::vector<double>> breaks;
  Curve mean;
};

Panel panel_of(std::span<const FitRecord> records, const std::vector<std::size_t>& members) {
  Panel panel;
  const auto [usable, curves] = curves_of(records, members);
  panel.mean = mean_curve(curves);
  const std::size_t step = (usable.size() + kMaxCurves - 1) / kMaxCurves;
  for (std::size_t k = 0; k < usable.size(); k += step) {
    const FitRecord& record = *usable[k];
    panel.measured.push_back(curves[k]);
    add_break(record, panel.breaks);
    if (!is_fitted(record) || record.result.fitted.size() == 0) continue;
    // The falls of many fits would be a fence in front of the curves.
    panel.fits.push_back(usable.size() <= kMaxFalls ? fitted_with_break(record.result)
                                                    : fitted_until_break(record.result));
  }
  return panel;
}

/// What a panel shows: the group and how many of its specimens, or the specimen if it is alone.
std::string panel_title(std::span<const FitRecord> records, const std::vector<std::size_t>& members,
                        std::size_t drawn, std::size_t room) {
  const Target& first = records[members.front()].target;
  if (members.size() == 1) return cut(first.name, room);
  const std::string count = drawn < members.size()
                                ? fmt::format(", {} of {}", drawn, members.size())
                                : fmt::format(", {}", counted(members.size(), "specimen"));
  std::string group = group_label(first.group);
  if (width_of(group) + width_of(count) > room && !first.group.empty()) {
    group.clear();  // the values alone say enough beside the other panels
    for (const auto& [key, value] : first.group) group += (group.empty() ? "" : ", ") + value;
  }
  return cut(group, room - std::min(room, width_of(count))) + count;
}

/// One scale for all panels, so that groups can be compared.
void set_common_range(PlotScript& script, std::span<const FitRecord> records) {
  if (any_cyclic(records)) return;
  const auto [max_strain, max_stress] = largest_of(records);
  if (!(max_strain > 0.0 && max_stress > 0.0)) return;
  script.command(fmt::format("set xrange [0:{:.6g}]\nset yrange [0:{:.6g}]", 104.0 * max_strain,
                             1.08e-6 * max_stress));
}

/// From 0 on, or from the lowest, to the last break, which may lie beyond the samples [1].
std::pair<double, double> strains_of(const FitRecord& record) {
  double low = 0.0;
  double high = 0.0;
  const auto take = [&](double strain) {
    if (!std::isfinite(strain)) return;
    low = std::min(low, strain);
    high = std::max(high, strain);
  };
  std::ranges::for_each(measured_of(record).strain, take);
  std::ranges::for_each(fitted_with_break(record.result).strain, take);
  std::vector<std::vector<double>> breaks;
  add_break(record, breaks);
  for (const auto& at : breaks) take(0.01 * at[0]);
  if (record.target.loading == Loading::Monotonic) low = 0.0;
  return {low, high};
}

/// The strip of residuals below a curve.
void add_residuals(PlotScript& script, const FitRecord& record) {
  std::vector<std::vector<double>> points;
  const Curve& measured = record.target.corrected;
  const Curve& fitted = record.result.fitted;
  double low = 0.0;
  double high = 0.0;
  for (std::size_t i = 0; i < std::min(measured.size(), fitted.size()); ++i) {
    points.push_back({100.0 * measured.strain[i], 1e-6 * (measured.stress[i] - fitted.stress[i])});
    low = std::min(low, points.back()[1]);
    high = std::max(high, points.back()[1]);
  }
  script.begin_strip(low, high);
  script.set_x_label(strain_label(record.target));
  script.command("set yrange [*:*]\nset offsets graph 0, graph 0, graph 0.08, graph 0.08");
  script.command("set xzeroaxis linecolor rgb '#B8B8B8'");
  script.set_y_label("residual [MPa]");
  script.begin_panel({});
  script.add_series(script.add_points(plastica::report::thinned_dots(points)),
                    with_color("using 1:2 with points pointtype 7 pointsize 0.3", kDark),
                    "measured - fitted");
  script.end_panel();
}

}  // namespace

PlotScript curve_plot(const FitRecord& record, const Sheet& sheet) {
  const Target& target = record.target;
  const Curve& measured = measured_of(record);
  if (measured.size() == 0) {
    throw InputError({}, "--case", target.name, "has no curve to draw: " + reason_of(record));
  }
  PlotScript script(sheet);
  const bool fitted = is_fitted(record) && target.corrected.size() > 0 &&
                      record.result.fitted.size() >= target.corrected.size();
  if (fitted) {
    script.begin_panel_and_strip();
    const auto [low, high] = strains_of(record);
    const double room = 0.03 * (high - low);
    script.command(fmt::format("set xrange [{:.6g}:{:.6g}]", 100.0 * (low < 0.0 ? low - room : low),
                               100.0 * (high + room)));
  } else {
    script.begin_panels(1);
  }
  script.set_x_label(fitted ? "" : strain_label(target));
  script.set_y_label(stress_label(target));
  const bool cyclic = target.loading == Loading::Cyclic;
  if (cyclic) {
    script.command("set xzeroaxis linecolor rgb '#B8B8B8'");
  } else {
    script.command(fitted ? "set yrange [0:*]" : "set xrange [0:*]\nset yrange [0:*]");
    script.command(
        fmt::format("set offsets graph 0, graph {}, graph 0.08, graph 0", fitted ? 0.0 : 0.03));
  }
  std::string facts;
  for (const std::string& fact : facts_of(record)) facts += (facts.empty() ? "" : "    ") + fact;
  script.begin_panel({target.name, facts});
  const bool few = measured.size() < 80 && !cyclic;
  script.add_series(add_curve(script, measured),
                    few ? "using 1:2 with points pointtype 6 pointsize 0.6 linewidth 1.2 linecolor "
                          "rgb '#333333'"
                        : "using 1:2 with lines linewidth 1.6 linecolor rgb '#333333'",
                    "measured");
  if (is_fitted(record) && record.result.fitted.size() > 0) {
    script.add_series(add_curve(script, fitted_with_break(record.result)),
                      with_color("using 1:2 with lines linewidth 2", kVermillion), "fitted");
    if (const auto yield = yield_point(record.result); yield && !cyclic) {
      script.add_series(script.add_points({*yield}),
                        with_color("using 1:2 with points pointtype 7 pointsize 0.8", kVermillion),
                        "yield, fitted");
    }
  }
  std::vector<std::vector<double>> breaks;
  add_break(record, breaks);
  if (!breaks.empty()) {
    script.add_series(
        script.add_points(breaks),
        with_color("using 1:2 with points pointtype 2 pointsize 1.1 linewidth 2", kBlue),
        "break, measured");
  }
  script.end_panel();
  if (fitted) add_residuals(script, record);
  return script;
}

PlotScript residuals_picture(const FitRecord& record, const Sheet& sheet) {
  const Target& target = record.target;
  const Curve& measured = target.corrected;
  const Curve& fitted = record.result.fitted;
  if (!is_fitted(record) || measured.size() == 0 || fitted.size() < measured.size()) {
    throw InputError({}, "--what", "residuals", target.name + " was not fitted");
  }
  std::vector<std::vector<double>> points;
  double largest = 0.0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    points.push_back({100.0 * measured.strain[i], measured.stress[i] - fitted.stress[i]});
    largest = std::max(largest, std::fabs(points.back()[1]));
  }
  const FitResult& result = record.result;
  const double rms = result.noise.value_or(result.misfit_rms);
  const auto unit =
      plastica::report::display_unit(Dimension::Stress, std::max(largest, rms), false);
  for (std::vector<double>& point : points) point[1] /= unit.scale;
  FigurePanel panel;
  std::string facts;
  for (const std::string& fact : facts_of(record)) facts += (facts.empty() ? "" : "   ") + fact;
  panel.title = sheet.terminal ? cut(facts, 36) : facts;
  panel.x_label = strain_label(target);
  panel.y_label = fmt::format("stress, measured - fitted [{}]", unit.name);
  // Below the lines, which many would hide.
  panel.curves.push_back({std::move(points), "residual", kDark, Stroke::Points, 7});
  const auto [low, high] = std::ranges::minmax(measured.strain);
  for (const double side : {rms, -rms}) {
    panel.curves.push_back({{{100.0 * low, side / unit.scale}, {100.0 * high, side / unit.scale}},
                            result.noise ? "noise, as stated" : "rms misfit",
                            kBlue,
                            Stroke::Line});
  }
  const auto yield = yield_point(result);
  if (yield && target.loading == Loading::Monotonic) {
    panel.marks = {yield->front()};
    panel.mark_name = "yield, fitted";
  }
  return drawn({target.name, {std::move(panel)}}, sheet);
}

PlotScript curve_picture(const FitRecord& record, const Sheet& sheet) {
  return sheet.terminal ? curve_terminal(record) : curve_plot(record, sheet);
}

PlotScript overview_picture(std::span<const FitRecord> records, const Sheet& sheet) {
  return sheet.terminal ? overview_terminal(records) : overview_plot(records, sheet);
}

PlotScript parameters_picture(std::span<const FitRecord> records, const Sheet& sheet) {
  return sheet.terminal ? parameters_terminal(records) : parameters_plot(records, sheet);
}

PlotScript overview_plot(std::span<const FitRecord> records, const Sheet& sheet) {
  std::vector<std::vector<std::size_t>> groups = drawable_groups(records);
  PlotScript script(sheet);
  const std::size_t all = groups.size();
  groups.resize(std::min(all, kMaxPanels));
  script.begin_panels(groups.size(), all > groups.size() ? fmt::format("the first {} of {} groups",
                                                                       groups.size(), all)
                                                         : std::string());
  set_common_range(script, records);
  const auto labels_of = [&](const std::vector<std::size_t>& members) {
    return std::pair(label_of_all(records, members, strain_label),
                     label_of_all(records, members, stress_label));
  };
  const auto first = labels_of(groups.front());
  const bool alike =
      std::ranges::all_of(groups, [&](const auto& members) { return labels_of(members) == first; });
  for (const std::vector<std::size_t>& members : groups) {
    const Panel panel = panel_of(records, members);
    const auto [strain, stress] = labels_of(members);
    script.set_x_label(!alike || script.at_bottom() ? strain : "");
    script.set_y_label(!alike || script.at_left() ? stress : "");
    const std::size_t letters = std::min<std::size_t>(script.title_letters(), 70);
    script.begin_panel({panel_title(records, members, panel.measured.size(), letters)});
    const bool few = panel.measured.size() <= kMaxFalls;
    if (!panel.measured.empty()) {
      script.add_series(add_curves(script, panel.measured),
                        few ? with_color("using 1:2 with lines linewidth 1.6", kDark)
                            : with_color("using 1:2 with lines linewidth 1", kGrey),
                        "measured");
    }
    if (!panel.fits.empty()) {
      std::vector<const Curve*> fits;
      for (const Curve& fit : panel.fits) fits.push_back(&fit);
      script.add_series(add_curves(script, fits),
                        with_color(few ? "using 1:2 with lines linewidth 1.6"
                                       : "using 1:2 with lines linewidth 0.8",
                                   kVermillion),
                        "fitted");
    }
    if (panel.mean.size() > 0) {
      script.add_series(add_curve(script, panel.mean),
                        with_color("using 1:2 with lines linewidth 2.2", kBlue),
                        "mean to first break");
    }
    if (!panel.breaks.empty()) {
      script.add_series(
          script.add_points(panel.breaks),
          with_color("using 1:2 with points pointtype 2 pointsize 0.6 linewidth 1.4", kDark),
          "break");
    }
    script.end_panel();
  }
  return script;
}

}  // namespace plastica::calibrate::report
