#include "calibrate/report/scene_fit_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/plot_parts.hpp"
#include "calibrate/report/scene_fit_bands.hpp"
#include "calibrate/report/scene_fit_words.hpp"
#include "calibrate/report/scene_population.hpp"
#include "plastica/base/check.hpp"
#include "plastica/report/scene_words.hpp"

namespace plastica::calibrate::report {
namespace {

using plastica::report::FigureCurve;
using plastica::report::FigurePanel;
using plastica::report::kBlue;
using plastica::report::kDark;
using plastica::report::kGrey;
using plastica::report::kVermillion;
using plastica::report::Stroke;
using Points = std::vector<std::vector<double>>;

double largest(std::span<const double> values) {
  double most = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) most = std::fmax(most, std::fabs(value));
  }
  return most;
}

std::string label(const std::string& name, const DisplayUnit& unit) {
  return unit.name.empty() ? name : fmt::format("{} [{}]", name, unit.name);
}

/// The finite points of a curve in the units that are shown.
Points points_of(std::span<const double> x, const DisplayUnit& x_unit, std::span<const double> y,
                 const DisplayUnit& y_unit) {
  Points points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (std::isfinite(x[i]) && std::isfinite(y[i])) {
      points.push_back({x[i] / x_unit.scale, y[i] / y_unit.scale});
    }
  }
  return points;
}

DisplayUnit unit_of(Dimension dimension, std::span<const double> values) {
  return plastica::report::shown_unit(dimension, largest(values));
}

/// "youngs_modulus 205.0 ± 1.2 GPa   yield_stress …", or why there is no fit.
std::string facts_of(const SceneFitRecord& record) {
  if (record.result.status != FitStatus::Fitted) return "failed: " + record.result.reason;
  std::string facts;
  for (const FittedParameter& p : record.result.parameters) {
    const DisplayUnit unit = display_unit(p);
    facts += fmt::format("{}{} {}", facts.empty() ? "" : "   ", short_name(p.path),
                         quantity(value_text(p, unit), unit.name));
  }
  return facts;
}

/// Whether the fit has made something of each target.
bool has_target_fits(const SceneFitRecord& record) {
  return record.result.targets.size() == record.targets.size();
}

std::size_t panels_of(const SceneFitRecord& record) {
  return std::min(record.targets.size(), kMaxPanels);
}

/// A panel of a target without its curves.
FigurePanel panel_of(const SceneFitRecord& record, std::size_t t, const DisplayUnit& x_unit) {
  const SceneTarget& target = record.targets[t];
  FigurePanel panel;
  panel.title = record.targets.size() == 1 ? facts_of(record) : target.name;
  if (has_several_laws(record.result) && has_target_fits(record)) {
    panel.title += fmt::format(": {}", phrase_of(record.result.targets[t].law));
  }
  panel.x_label = label(abscissa_text(target), x_unit);
  if (target.broke) {
    panel.marks = {target.broke->at / x_unit.scale};
    panel.mark_name = "break, measured";
  }
  return panel;
}

std::string title_of(const SceneFitRecord& record) {
  if (record.targets.size() == 1) return record.name;
  std::string more;
  if (record.targets.size() > kMaxPanels) {
    more = fmt::format(", the first {} of {} targets", kMaxPanels, record.targets.size());
  }
  return cut(record.name + more + ": " + facts_of(record), 110);
}

/// @param name  of the residual, on the axis
FigurePanel residual_panel(const SceneFitRecord& record, std::size_t t, const std::string& name) {
  const SceneTarget& target = record.targets[t];
  const TargetFit& of_target = record.result.targets[t];
  std::vector<double> residual(of_target.fitted.size());
  for (std::size_t i = 0; i < residual.size(); ++i)
    residual[i] = target.ordinate[i] - of_target.fitted[i];
  const DisplayUnit x_unit = unit_of(target.abscissa_is, target.abscissa);
  const DisplayUnit y_unit = unit_of(target.ordinate_is, residual);
  FigurePanel panel = panel_of(record, t, x_unit);
  panel.y_label = label(name, y_unit);
  panel.curves.push_back(
      {points_of(target.abscissa, x_unit, residual, y_unit), "residual", kDark, Stroke::Points, 7});
  if (std::isfinite(of_target.noise) && !target.abscissa.empty()) {
    const auto [low, high] = std::ranges::minmax(target.abscissa);
    for (const double noise : {of_target.noise, -of_target.noise}) {
      panel.curves.push_back({{{low / x_unit.scale, noise / y_unit.scale},
                               {high / x_unit.scale, noise / y_unit.scale}},
                              "noise, one standard deviation",
                              kBlue,
                              Stroke::Line});
    }
  }
  return panel;
}

}  // namespace

Figure fit_figure(const SceneFitRecord& record, bool terminal) {
  Figure figure;
  figure.title = title_of(record);
  for (std::size_t t = 0; t < panels_of(record); ++t) {
    const SceneTarget& target = record.targets[t];
    const DisplayUnit x_unit = unit_of(target.abscissa_is, target.abscissa);
    const DisplayUnit y_unit = unit_of(target.ordinate_is, target.ordinate);
    FigurePanel panel = panel_of(record, t, x_unit);
    panel.y_label = label(printable(target.ordinate_probe), y_unit);
    const bool few = target.abscissa.size() <= 400;
    if (has_target_fits(record) && !terminal) {
      panel.curves = bands_of(target, record.result.targets[t], x_unit, y_unit);
    }
    panel.curves.push_back({points_of(target.abscissa, x_unit, target.ordinate, y_unit), "measured",
                            few ? kDark : kGrey, few ? Stroke::Points : Stroke::Line, 6});
    if (has_target_fits(record) && !record.result.targets[t].fitted.empty()) {
      panel.curves.push_back(
          {points_of(target.abscissa, x_unit, record.result.targets[t].fitted, y_unit), "fitted",
           kVermillion, Stroke::Line});
    }
    // A line of letters would cover the letters of points.
    if (terminal) std::reverse(panel.curves.begin(), panel.curves.end());
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

Figure residuals_figure(const SceneFitRecord& record) {
  if (record.result.status != FitStatus::Fitted || !has_target_fits(record)) {
    throw InputError({}, "--what", "residuals", record.name + " was not fitted");
  }
  Figure figure;
  figure.title = title_of(record);
  for (std::size_t t = 0; t < panels_of(record); ++t) {
    const std::string name = printable(record.targets[t].ordinate_probe);
    figure.panels.push_back(residual_panel(record, t, name + ", measured - fitted"));
  }
  return figure;
}

PlotScript fit_picture(const SceneFitRecord& record, const Sheet& sheet) {
  Figure figure = fit_figure(record, sheet.terminal);
  const bool fitted = record.result.status == FitStatus::Fitted && has_target_fits(record);
  if (sheet.terminal || figure.panels.size() != 1 || !fitted ||
      record.result.targets[0].fitted.empty()) {
    return drawn(figure, sheet);
  }
  FigurePanel residuals = residual_panel(record, 0, "residual");
  residuals.marks.clear();
  figure.panels.push_back(std::move(residuals));
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto take = [&](double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  };
  for (const FigurePanel& panel : figure.panels) {
    // A break may lie beyond the samples.
    std::ranges::for_each(panel.marks, take);
    for (const FigureCurve& curve : panel.curves) {
      for (const auto& point : curve.points) take(point[0]);
    }
  }
  for (FigurePanel& panel : figure.panels) {
    panel.x_range = {std::min(low, 0.0), std::max(0.0, high) + 0.02 * (high - std::min(low, 0.0))};
  }
  figure.strip = true;
  return drawn(figure, sheet);
}

Figure starts_figure(const SceneFitRecord& record) {
  const std::vector<double> costs = sorted_costs(record.result);
  if (costs.empty()) {
    throw InputError({}, "--what", "starts", record.name + " has no search that ended anywhere");
  }
  const std::size_t best = count_of_best(costs);
  Points reached, others;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    (i < best ? reached : others).push_back({static_cast<double>(i + 1), costs[i]});
  }
  FigurePanel panel;
  panel.title =
      fmt::format("the best cost from {} of {} starts", best, record.result.starts.size());
  if (costs.size() < record.result.starts.size()) {
    panel.title += fmt::format(", {} without a curve", record.result.starts.size() - costs.size());
  }
  panel.x_label = "starts in rising order of what they found";
  panel.y_label = "cost";
  panel.x_range = {0.5, static_cast<double>(costs.size()) + 0.5};
  if (costs.front() > 0.0) {
    panel.logarithmic = true;
    panel.y_range = {std::pow(10.0, std::floor(std::log10(costs.front()))),
                     std::pow(10.0, std::floor(std::log10(costs.back())) + 1.0)};
  }
  panel.curves.push_back({reached, "the best, to a thousandth", kBlue, Stroke::Points, 7});
  if (!others.empty()) {
    panel.curves.push_back({others, "worse", kVermillion, Stroke::Points, 6});
  }
  return {record.name, {std::move(panel)}};
}

Figure population_figure(std::span<const SceneFitRecord> records) {
  const ScenePopulation population = scene_population(records);
  Figure figure;
  figure.title = counted(records.size(), "fit");
  for (const PopulationParameter& parameter : population.parameters) {
    if (parameter.n == 0 || figure.panels.size() == kMaxPanels) continue;
    const DisplayUnit unit = display_unit_of(parameter.path, parameter.dimension, parameter.mean);
    FigurePanel panel;
    panel.title = label(short_name(parameter.path), unit);
    for (const SceneFitRecord& record : records) panel.x_names.push_back(record.name);
    panel.x_range = {0.5, static_cast<double>(records.size()) + 0.5};
    FigureCurve values{{}, "value and interval", kGrey, Stroke::Bars};
    for (std::size_t i = 0; i < records.size(); ++i) {
      const SceneFitResult& result = records[i].result;
      const auto p = std::ranges::find(result.parameters, parameter.path, &FittedParameter::path);
      if (result.status != FitStatus::Fitted || p == result.parameters.end()) continue;
      if (p->role != ParameterRole::Free) continue;
      if (p->at_bound() || !std::isfinite(p->interval_low) || !std::isfinite(p->interval_high))
        continue;
      const auto number = static_cast<std::size_t>(p - result.parameters.begin());
      const std::optional<double> material =
          parameter.is_of_material ? material_value(result, number) : std::nullopt;
      values.points.push_back({static_cast<double>(i + 1), material.value_or(p->value) / unit.scale,
                               p->interval_low / unit.scale, p->interval_high / unit.scale});
    }
    panel.curves.push_back(std::move(values));
    const auto across = [&](double y, const std::string& name, std::string_view color) {
      panel.curves.push_back(
          {{{panel.x_range[0], y / unit.scale}, {panel.x_range[1], y / unit.scale}},
           name,
           color,
           Stroke::Line});
    };
    across(parameter.mean, "mean", kBlue);
    if (std::isfinite(parameter.specimen_deviation)) {
      const char* name = "specimens' standard deviation, without noise";
      across(parameter.mean - parameter.specimen_deviation, name, kVermillion);
      across(parameter.mean + parameter.specimen_deviation, name, kVermillion);
    }
    // The values lie far from zero; their scatter is what the picture is about.
    double low = parameter.mean / unit.scale, high = low;
    for (const FigureCurve& curve : panel.curves) {
      for (const auto& point : curve.points) {
        low = std::min(low, *std::min_element(point.begin() + 1, point.end()));
        high = std::max(high, *std::max_element(point.begin() + 1, point.end()));
      }
    }
    const double room = high > low ? 0.06 * (high - low) : 0.06 * std::fabs(high);
    panel.y_range = {low - room, high + room};
    figure.panels.push_back(std::move(panel));
  }
  if (figure.panels.empty()) {
    throw InputError({}, "--what", "population", "no fit determines a parameter");
  }
  return figure;
}

PlotScript correlation_plot(const SceneFitRecord& record, const Sheet& sheet) {
  const SceneFitResult& result = record.result;
  const std::size_t n = result.free_count();
  if (n == 0 || result.correlation.size() != n * n) {
    throw InputError({}, "--what", "correlation", record.name + " has no correlations");
  }
  PlotScript script(sheet);
  const bool terminal = sheet.terminal;
  const bool narrow = sheet.width < 600.0;
  const bool turned = !terminal && (narrow || n > 4);
  std::string x_tics, y_tics;
  std::vector<std::vector<double>> cells;
  std::string labels;
  for (std::size_t i = 0; i < n; ++i) {
    const std::string name =
        plastica::report::quoted_tic(cut(short_name(result.parameters[i].path), terminal ? 12
                                                                                : narrow ? 15
                                                                                         : 24));
    x_tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", name, i + 1);
    y_tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", name, n - i);
    for (std::size_t j = 0; j < n; ++j) {
      const double value = result.correlation[i * n + j];
      const auto x = static_cast<double>(j + 1), y = static_cast<double>(n - i);
      cells.push_back({x, y, value});
      labels += fmt::format("set label '{}' at {}, {} center front textcolor rgb '{}'\n",
                            std::isnan(value) ? "-" : fmt::format("{:+.2f}", value), x, y,
                            std::fabs(value) > 0.6 ? "#FFFFFF" : kDark);
    }
  }
  if (terminal) {
    plastica::report::begin_terminal(script);
  } else {
    // Names as long as they may be need room at the left and, where they are turned, below.
    script.begin_panels(1, {}, turned ? (narrow ? 20.0 : 90.0) : 0.0);
    script.command("unset grid\nset tics scale 0");
    script.command(
        fmt::format("set palette defined (-1 '{}', 0 '#FFFFFF', 1 '{}')\n"
                    "set cbrange [-1:1]\nunset colorbox",
                    kBlue, kVermillion));
  }
  script.command(fmt::format("set xtics {}({})\nset ytics ({})",
                             turned ? "rotate by 35 right " : "", x_tics, y_tics));
  const double end = static_cast<double>(n) + 0.5;
  script.command(fmt::format("set xrange [0.5:{0}]\nset yrange [0.5:{0}]", end));
  script.command(labels);
  const std::string title = record.name + ": correlations";
  if (terminal) {
    script.command("set title " + plastica::report::in_quotes({title}, 70) + "\nplot NaN notitle");
    return script;
  }
  script.begin_panel({title});
  script.command(narrow ? "set lmargin at screen 0.35" : "set lmargin at screen 0.25");
  script.add_unnamed(script.add_points(cells), "using 1:2:3 with image");
  script.end_panel();
  return script;
}

}  // namespace plastica::calibrate::report
